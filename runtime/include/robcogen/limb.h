// Limbs of a robot: the instances of parts in its document, for code that loops over legs.
//
//     for (const robcogen::Limb& leg : quadruped::limbs)
//       for (const robcogen::LimbElement& joint : leg.joints) tau[joint.index] -= damping * qd[joint.index];
//     static_assert(quadruped::limbs[index(quadruped::Limb::LF)].joint("KFE") == 2);
#pragma once

#include <string_view>
#include <type_traits>

namespace robcogen {

// A link, joint or frame of a limb: its name in the part, and its index in the robot.
struct LimbElement {
  const char* own;
  int index;
};

struct LimbElements {
  const LimbElement* data;
  int size;

  constexpr const LimbElement& operator[](int i) const { return data[i]; }
  constexpr const LimbElement* begin() const { return data; }
  constexpr const LimbElement* end() const { return data + size; }
  // Returns the index in the robot of the element with this name in the part, or -1 if there is none.
  constexpr int find(std::string_view own) const {
    for (const LimbElement& element : *this)
      if (own == element.own) return element.index;
    return -1;
  }
};

struct Limb {
  const char* name;  // the names of its elements begin with it
  const char* part;
  int first_link;
  LimbElements links;
  LimbElements joints;  // indices are those of elements of qd; joints that follow others are left out
  LimbElements frames;  // user frames

  // Return the index in the robot of the element with this name in the part, or -1 if there is none. `foot` also finds
  // the frame `fr_foot`.
  constexpr int link(std::string_view own) const { return links.find(own); }
  constexpr int joint(std::string_view own) const { return joints.find(own); }
  constexpr int frame(std::string_view own) const {
    constexpr std::string_view kPrefix = "fr_";
    const int exact = frames.find(own);
    if (exact >= 0) return exact;
    for (const LimbElement& element : frames) {
      const std::string_view text = element.own;
      if (text.substr(0, kPrefix.size()) == kPrefix && text.substr(kPrefix.size()) == own) return element.index;
    }
    return -1;
  }
};

struct Limbs {
  const Limb* data = nullptr;
  int size = 0;

  constexpr const Limb& operator[](int i) const { return data[i]; }
  constexpr const Limb* begin() const { return data; }
  constexpr const Limb* end() const { return data + size; }
};

namespace detail {

template <class Robot, class = void>
struct LimbsOf {
  static constexpr Limbs list() { return {}; }
};

template <class Robot>
struct LimbsOf<Robot, std::void_t<decltype(Robot::limbs)>> {
  static constexpr Limbs list() { return {Robot::limbs.data(), static_cast<int>(Robot::limbs.size())}; }
};

}  // namespace detail

// Limbs of the generated type of a robot, for generic code; empty if its document has no parts.
template <class Robot>
constexpr Limbs limbs_of() {
  return detail::LimbsOf<Robot>::list();
}

}  // namespace robcogen
