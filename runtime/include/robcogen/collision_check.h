// Whether a robot touches itself or an obstacle, in one state or in several, one in each lane. A check ends as soon as
// the answer is known, and shapes are placed and looked at only where spheres around them are near something.
//
// The header <name>/collision_check.h of a robot has its shapes and functions that call these.
#pragma once

#include <array>
#include <cstddef>
#include <cstring>
#include <type_traits>

#include "robcogen/lanes.h"

#if defined(__GNUC__)
#define ROBCOGEN_INLINE inline __attribute__((always_inline))
#else
#define ROBCOGEN_INLINE inline
#endif

namespace robcogen {

// The tables of a robot's shapes.
namespace collision {

// The most spheres of a group.
inline constexpr std::size_t kMaxSpheres = 4;

// A sphere (m) around its members: groups of spheres of a part, or spheres of a group.
struct Group {
  int first, count;
  double radius;
};
// Two parts.
struct Pair {
  int a, b;
};

// As in lanes.h: the linker must not replace a function for one processor by that for another.
namespace {

// Sets of lanes: a bit for each. A number has one lane.
using LaneSet = unsigned;

template <class Scalar>
constexpr int kLaneCount = 1;
template <class Scalar, int kSize>
constexpr int kLaneCount<Lanes<Scalar, kSize>> = kSize;

template <class Scalar>
constexpr LaneSet kAllLanes = (LaneSet(2) << (kLaneCount<Scalar> - 1)) - 1;

// The lanes in which x is negative, or not a number: a state without meaning is not free.
template <class Scalar>
ROBCOGEN_INLINE LaneSet negative(const Scalar& x) noexcept {
  return !(x >= Scalar(0)) ? 1u : 0u;
}

template <class Scalar, int kSize>
ROBCOGEN_INLINE LaneSet negative(const Lanes<Scalar, kSize>& x) noexcept {
  static_assert(kSize <= 32, "a bit for each lane");
  if constexpr (kSize == 1) {
    return negative(x[0]);
  } else if constexpr (kSize > lanes::kInRegister<Scalar>) {
    return negative(x.low()) | negative(x.high()) << (kSize / 2);
  } else {
#if ROBCOGEN_HAS_VECTORS && defined(__AVX__)
    using Vector = lanes::Vector<Scalar, kSize>;
    [[maybe_unused]] Vector signs;  // of lanes that are free
    if constexpr (kSize * sizeof(Scalar) == 32) {
      const auto is_free = x.vector() >= Vector{};
      std::memcpy(&signs, &is_free, sizeof(signs));
    }
    if constexpr (std::is_same_v<Scalar, float> && kSize == 8)
      return kAllLanes<Lanes<float, 8>> & ~static_cast<LaneSet>(__builtin_ia32_movmskps256(signs));
    if constexpr (std::is_same_v<Scalar, double> && kSize == 4)
      return kAllLanes<Lanes<double, 4>> & ~static_cast<LaneSet>(__builtin_ia32_movmskpd256(signs));
#endif
    LaneSet result = 0;
    for (int i = 0; i < kSize; ++i) result |= negative(x[i]) << i;
    return result;
  }
}

constexpr std::size_t at(int k) noexcept {
  return static_cast<std::size_t>(k);
}

// Of two points, m^2.
template <class Scalar>
ROBCOGEN_INLINE Scalar squared_distance(const Scalar* a, const Scalar* b) noexcept {
  const Scalar x = a[0] - b[0], y = a[1] - b[1], z = a[2] - b[2];
  return x * x + y * y + z * z;
}

// The lanes in which the points a and b (m) are nearer to each other than this distance.
template <class Scalar>
ROBCOGEN_INLINE LaneSet nearer(const Scalar* a, const Scalar* b, double distance) noexcept {
  return negative(squared_distance(a, b) - Scalar(distance * distance));
}

// Whether any lane is hit: the check ends with the first one.
struct AnyLane {
  LaneSet hit = 0;
  ROBCOGEN_INLINE bool matter(LaneSet lanes) const noexcept { return lanes != 0; }
  ROBCOGEN_INLINE bool end(LaneSet lanes) noexcept {
    hit = lanes;
    return lanes != 0;
  }
};

// Which lanes are hit: the check ends when all are.
struct EachLane {
  LaneSet all, hit = 0;
  ROBCOGEN_INLINE bool matter(LaneSet lanes) const noexcept { return (lanes & ~hit) != 0; }
  ROBCOGEN_INLINE bool end(LaneSet lanes) noexcept {
    hit |= lanes;
    return hit == all;
  }
};

// No obstacles.
struct Nothing {
  template <class Scalar>
  constexpr LaneSet operator()(const Scalar&, const Scalar&, const Scalar&, double) const noexcept {
    return 0;
  }
};

// The type of the numbers in the lanes of a scalar.
template <class Scalar>
struct NumberIn {
  using type = Scalar;
};
template <class Scalar, int kSize>
struct NumberIn<Lanes<Scalar, kSize>> {
  using type = Scalar;
};

// Distances between centres at which parts may touch, squared.
template <class Shapes, class Number>
constexpr auto kPartDistances = [] {
  std::array<Number, Shapes::kPairs.size()> result{};
  for (std::size_t k = 0; k < result.size(); ++k) {
    const Pair& pair = Shapes::kPairs[k];
    const double distance = Shapes::kParts[at(pair.a)].radius + Shapes::kParts[at(pair.b)].radius;
    result[k] = static_cast<Number>(distance * distance);
  }
  return result;
}();

// Spheres of a group that are chosen one by one, without a branch.
class Chosen {
 public:
  ROBCOGEN_INLINE void add(int sphere, bool is_chosen) noexcept {
    list_[count_] = sphere;
    count_ += is_chosen ? 1 : 0;
  }
  ROBCOGEN_INLINE const int* begin() const noexcept { return list_; }
  ROBCOGEN_INLINE const int* end() const noexcept { return list_ + count_; }

 private:
  int list_[kMaxSpheres + 1];
  std::size_t count_ = 0;
};

// The centres of all spheres of a state, as far as they are placed. What contains one member alone is this member.
template <class Shapes, class Scalar>
class Places {
 public:
  ROBCOGEN_INLINE explicit Places(const Scalar* q) noexcept : q_(q) { Shapes::place_parts(q, workspace_, parts_); }
  ROBCOGEN_INLINE const Scalar* part(int p) const noexcept { return parts_ + 3 * p; }
  ROBCOGEN_INLINE const Scalar* group(int p, int g) noexcept {
    if (Shapes::kParts[at(p)].count == 1) return part(p);
    if (!are_groups_placed_[p]) {
      are_groups_placed_[p] = true;
      Shapes::place_groups(p, q_, workspace_, groups_);
    }
    return groups_ + 3 * g;
  }
  // The spheres of the group, one after another.
  ROBCOGEN_INLINE const Scalar* spheres(int p, int g) noexcept {
    const Group& of = Shapes::kGroups[at(g)];
    if (of.count == 1) return group(p, g);
    if (!are_spheres_placed_[g]) {
      are_spheres_placed_[g] = true;
      Shapes::place_spheres(g, q_, workspace_, spheres_);
    }
    return spheres_ + 3 * of.first;
  }

 private:
  const Scalar* q_;
  bool are_groups_placed_[Shapes::kPartCount] = {};
  bool are_spheres_placed_[Shapes::kGroupCount] = {};
  Scalar workspace_[Shapes::kWorkspace];
  Scalar parts_[3 * Shapes::kPartCount];
  Scalar groups_[3 * Shapes::kGroupCount];
  Scalar spheres_[3 * Shapes::kSphereCount];
};

template <class Shapes, class Scalar, class Obstacles, class Found>
class Check {
 public:
  ROBCOGEN_INLINE Check(const Scalar* q, const Obstacles& obstacles, Found& found) noexcept
      : obstacles_(obstacles), found_(found), places_(q) {}

  ROBCOGEN_INLINE void run() noexcept {
    if constexpr (!std::is_same_v<Obstacles, Nothing>)
      for (int p = Shapes::kPartCount - 1; p >= 0; --p)  // a hand meets more obstacles than the base
        if (obstacle_ends(p)) return;
    pairs_end();
  }

 private:
  using Number = typename NumberIn<Scalar>::type;

  const Obstacles& obstacles_;
  Found& found_;
  Places<Shapes, Scalar> places_;

  ROBCOGEN_INLINE LaneSet at_obstacle(const Scalar* center, double radius) const noexcept {
    return static_cast<LaneSet>(obstacles_(center[0], center[1], center[2], radius));
  }

  // A sphere around one member is this member, and is not looked at twice.
  bool obstacle_ends(int p) noexcept {
    const Group& part = Shapes::kParts[at(p)];
    LaneSet near = at_obstacle(places_.part(p), part.radius);
    if (!found_.matter(near)) return false;
    for (int g = part.first; g < part.first + part.count; ++g) {
      const Group& group = Shapes::kGroups[at(g)];
      if (part.count > 1) near = at_obstacle(places_.group(p, g), group.radius);
      if (!found_.matter(near)) continue;
      if (group.count == 1) {
        if (found_.end(near)) return true;
        continue;
      }
      const Scalar* sphere = places_.spheres(p, g);
      for (int s = 0; s < group.count; ++s)
        if (found_.end(at_obstacle(sphere + 3 * s, Shapes::kRadii[at(group.first + s)]))) return true;
    }
    return false;
  }

  bool pairs_end() noexcept {
    for (std::size_t k = 0; k < Shapes::kPairs.size(); ++k) {
      const Pair& pair = Shapes::kPairs[k];
      const Scalar distance(kPartDistances<Shapes, Number>[k]);
      if (found_.matter(negative(squared_distance(places_.part(pair.a), places_.part(pair.b)) - distance)) &&
          pair_ends(pair))
        return true;
    }
    return false;
  }

  // The larger sphere of two is taken apart first.
  bool pair_ends(const Pair& pair) noexcept {
    const bool is_first = Shapes::kParts[at(pair.a)].radius > Shapes::kParts[at(pair.b)].radius;
    const int outer = is_first ? pair.a : pair.b, inner = is_first ? pair.b : pair.a;
    const Group &large = Shapes::kParts[at(outer)], &small = Shapes::kParts[at(inner)];
    const Scalar* center = places_.part(inner);
    for (int g = large.first; g < large.first + large.count; ++g) {
      const Group& group = Shapes::kGroups[at(g)];
      if (large.count > 1 && !found_.matter(nearer(places_.group(outer, g), center, group.radius + small.radius)))
        continue;
      const Scalar* sphere = places_.spheres(outer, g);
      Chosen near;
      for (int s = 0; s < group.count; ++s)
        near.add(s, found_.matter(nearer(sphere + 3 * s, center, Shapes::kRadii[at(group.first + s)] + small.radius)));
      for (const int s : near)
        if (sphere_ends(sphere + 3 * s, Shapes::kRadii[at(group.first + s)], inner)) return true;
    }
    return false;
  }

  bool sphere_ends(const Scalar* sphere, double radius, int p) noexcept {
    const Group& part = Shapes::kParts[at(p)];
    for (int g = part.first; g < part.first + part.count; ++g) {
      const Group& group = Shapes::kGroups[at(g)];
      if ((part.count > 1 || group.count == 1) &&
          !found_.matter(nearer(sphere, places_.group(p, g), radius + group.radius)))
        continue;
      const Scalar* other = places_.spheres(p, g);
      LaneSet hit = 0;
      for (int s = 0; s < group.count; ++s)
        hit |= nearer(sphere, other + 3 * s, radius + Shapes::kRadii[at(group.first + s)]);
      if (found_.end(hit)) return true;
    }
    return false;
  }
};

}  // namespace
}  // namespace collision

namespace {

// Whether the robot with these shapes touches itself or an obstacle. `q`: a number for each position, or a value with
// lanes: then true if it does in any lane. `obstacles(x, y, z, radius)` tells in which lanes the sphere touches one: a
// bit for each lane, or, if only one answer for all lanes is asked for, a bool.
template <class Shapes, class Scalar, class Obstacles>
ROBCOGEN_INLINE bool in_collision(const Scalar* q, const Obstacles& obstacles) noexcept {
  collision::AnyLane found;
  collision::Check<Shapes, Scalar, Obstacles, collision::AnyLane>(q, obstacles, found).run();
  return found.hit != 0;
}

template <class Shapes, class Scalar>
ROBCOGEN_INLINE bool self_collision(const Scalar* q) noexcept {
  return in_collision<Shapes>(q, collision::Nothing());
}

// The lanes in which it does, a bit for each.
template <class Shapes, class Scalar, class Obstacles>
ROBCOGEN_INLINE collision::LaneSet lanes_in_collision(const Scalar* q, const Obstacles& obstacles) noexcept {
  collision::EachLane found{collision::kAllLanes<Scalar>};
  collision::Check<Shapes, Scalar, Obstacles, collision::EachLane>(q, obstacles, found).run();
  return found.hit;
}

}  // namespace
}  // namespace robcogen

#undef ROBCOGEN_INLINE
