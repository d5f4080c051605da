#include "limbed_document.h"

#include <array>
#include <charconv>
#include <cmath>
#include <random>
#include <vector>

namespace robcogen::test {
namespace {

using Vector = std::array<double, 3>;

constexpr double kPi = 3.141592653589793;

// A link and the joint that moves it; the same in every copy except for signs.
struct Part {
  bool revolute = true;
  int parent = -1;  // index of a part of the same limb; -1 for the link that carries the limb
  Vector translation{}, rotation{}, com{}, moments{};
  std::array<bool, 3> in_decimals{};  // angles that are written as decimals: 1.5707963267948966, not PI/2
  double mass = 1.0;
  std::string length_parameter, mass_parameter;  // for all copies, or empty
};

using Limb = std::vector<Part>;

// The signs of a mirror for the components of a vector. The sign of an angle about an axis is the product of the other
// two.
using Signs = std::array<int, 3>;

class Document {
 public:
  explicit Document(std::uint64_t seed) : random_(seed) {}

  std::string make() {
    const bool floating = pick(2) == 0, has_trunk = pick(3) == 0;
    with_parameters_ = pick(5) == 0;
    most_joints_ = pick(4) == 0 ? 16 : 9;
    is_rounded_ = pick(3) == 0;
    std::string children;
    if (has_trunk) ++last_id_;
    for (int set = pick(3) == 0 ? 2 : 1; set > 0; --set) children += limbs(5);
    std::string base_children = children;
    if (has_trunk) {
      Limb trunk = {part(-1)};
      add(trunk.front(), 1, "trunk", "waist", children, Signs{1, 1, 1});
      base_children = child("trunk", "waist");
    }
    std::string text = "Robot Limbs {\nRobotBase base " + std::string(floating ? "floating " : "") + "{\n";
    if (floating) text += inertia(part(-1), Signs{1, 1, 1});
    return text + "children {\n" + base_children + "}\n}\n" + links_ + joints_ + "}\n";
  }

 private:
  std::mt19937_64 random_;
  bool with_parameters_ = false, is_rounded_ = false;
  int most_joints_ = 0, sets_ = 0, joint_count_ = 0, last_id_ = 0;
  std::string links_, joints_;

  int pick(int n) { return static_cast<int>(random_() % static_cast<std::uint64_t>(n)); }
  // Values have three decimals, as in most documents.
  double between(double low, double high) {
    return std::round((low + (high - low) * pick(10001) / 10000.0) * 1e3) / 1e3;
  }

  static std::string number(double value) {
    std::array<char, 32> text{};
    const auto result = std::to_chars(text.data(), text.data() + text.size(), value);
    return {text.data(), result.ptr};
  }

  static std::string child(const std::string& link, const std::string& joint) { return link + " via " + joint + "\n"; }

  double length() {
    switch (pick(6)) {
      case 0:
      case 1:
        return 0.0;
      case 2:
        return pick(2) == 0 ? 1.0 : 1e-17;
      default:
        return between(-0.5, 0.5);
    }
  }

  double angle() {
    // Right angles after conversions and rounding, as they are found in files.
    constexpr std::array<double, 12> kNear = {
        1e-16,   1e-9,     1e-5,    -1e-12,  1.57075,           -1.57075,
        4.63e-5, 3.141592, 3.14159, -1.5708, 1.570796324648725, 3.141592653559515};
    switch (is_rounded_ ? pick(2) * 6 : pick(6)) {
      case 0:
        return kNear[static_cast<std::size_t>(pick(12))];
      case 1:
        return between(-3, 3);
      default:
        return (pick(4) - 1) * kPi / 2;
    }
  }

  Part part(int parent) {
    Part p;
    p.revolute = pick(4) != 0;
    p.parent = parent;
    for (std::size_t i = 0; i < 3; ++i) {
      p.translation[i] = length();
      p.rotation[i] = pick(2) == 0 ? 0.0 : angle();
      p.com[i] = pick(2) == 0 ? 0.0 : between(-0.1, 0.1);
      p.moments[i] = between(0.5, 0.9);
    }
    p.mass = between(0.5, 2);
    return p;
  }

  // Adds a set of limbs and returns the text that names them as children. `longest` limits the joints of a limb.
  std::string limbs(int longest) {
    const std::string set = "s" + std::to_string(sets_++) + "_";
    constexpr std::array<int, 8> kCounts = {2, 2, 2, 4, 4, 4, 3, 6};
    const int copies = kCounts[static_cast<std::size_t>(pick(8))];
    int length = 1 + pick(longest);
    while (length > 1 && joint_count_ + copies * length > most_joints_) --length;
    Limb limb;
    for (int k = 0; k < length; ++k) {
      limb.push_back(part(pick(4) == 0 ? pick(k + 1) - 1 : k - 1));
      if (!with_parameters_) continue;
      if (pick(2) == 0) limb.back().length_parameter = set + "length" + std::to_string(k);
      if (pick(2) == 0) limb.back().mass_parameter = set + "mass" + std::to_string(k);
    }
    joint_count_ += copies * length;
    std::string children;
    for (int i = 0; i < copies; ++i) children += copy(limb, set + std::to_string(i), i);
    return children;
  }

  std::string copy(Limb limb, const std::string& name, int number) {
    const Signs signs = {number % 4 >= 2 ? -1 : 1, number % 2 == 1 ? -1 : 1, 1};
    const int difference = pick(5);
    std::vector<std::string> children(limb.size());
    std::string roots;
    for (std::size_t k = 0; k < limb.size(); ++k) {
      const std::string part_name = name + "_" + std::to_string(k), joint = "j" + part_name, link = "l" + part_name;
      (limb[k].parent < 0 ? roots : children[static_cast<std::size_t>(limb[k].parent)]) += child(link, joint);
      vary(limb[k], difference);
    }
    const int first_id = last_id_ + 1;  // ids in sequence, parents first
    last_id_ += static_cast<int>(limb.size());
    // The last link may carry a hand with fingers of one shape.
    const bool carries = number < 2 && joint_count_ + 4 < most_joints_ && pick(6) == 0;
    if (carries) children.back() += limbs(2);
    for (std::size_t k = 0; k < limb.size(); ++k) {
      const std::string part_name = name + "_" + std::to_string(k);
      add(limb[k], first_id + static_cast<int>(k), "l" + part_name, "j" + part_name, children[k], signs);
    }
    return roots;
  }

  void vary(Part& part, int difference) {
    for (std::size_t i = 0; i < 3; ++i) {
      if (difference == 0 && pick(2) == 0) part.translation[i] *= 1.0 + 1e-15;
      if (difference == 0 && pick(3) == 0) part.rotation[i] = std::round(part.rotation[i] * 1e6) / 1e6;
      if (difference == 0) part.in_decimals[i] = pick(2) == 0;
      if (difference == 1 && pick(4) == 0) part.translation[i] = pick(2) == 0 ? 0.0 : between(-0.3, 0.3);
      if (difference == 1 && pick(4) == 0) part.com[i] = 0.0;
      if (difference == 1 && pick(is_rounded_ ? 2 : 6) == 0) part.rotation[i] = angle();
      if (difference == 2 && pick(4) == 0) part.rotation[i] = -part.rotation[i];
    }
  }

  static std::string vector(const Vector& values) {
    return "(" + number(values[0]) + ", " + number(values[1]) + ", " + number(values[2]) + ")";
  }

  // A multiple of a right angle is written as such.
  static std::string angle_text(double angle, bool in_decimals) {
    const double quarters = angle / (kPi / 2);
    if (in_decimals || angle == 0.0 || std::round(quarters) * (kPi / 2) != angle) return number(angle);
    return number(quarters) + " * PI/2.0";
  }

  std::string inertia(const Part& part, const Signs& signs) {
    const double m = part.mass;
    Vector c = part.com;
    for (std::size_t i = 0; i < 3; ++i) c[i] *= signs[i];
    const auto moment = [&](std::size_t i) {
      const double a = c[(i + 1) % 3], b = c[(i + 2) % 3];
      return number(part.moments[i] + m * (a * a + b * b));
    };
    const auto product = [&](std::size_t i, std::size_t j) { return number(m * c[i] * c[j]); };
    const std::string mass = part.mass_parameter.empty() ? number(m) : part.mass_parameter + "[" + number(m) + "]";
    return "inertia_params {\nmass = " + mass + "\nCoM = " + vector(c) + "\nIx = " + moment(0) + " Iy = " + moment(1) +
           " Iz = " + moment(2) + "\nIxy = " + product(0, 1) + " Ixz = " + product(0, 2) + " Iyz = " + product(1, 2) +
           "\n}\n";
  }

  void add(
      const Part& part,
      int id,
      const std::string& link,
      const std::string& joint,
      const std::string& children,
      const Signs& signs) {
    links_ += "link " + link + " {\nid = " + std::to_string(id) + "\n" + inertia(part, signs) + "children {\n" +
              children + "}\n}\n";
    std::array<std::string, 3> translation, rotation;
    for (std::size_t i = 0; i < 3; ++i) {
      translation[i] = number(part.translation[i] * signs[i]);
      rotation[i] = angle_text(part.rotation[i] * signs[(i + 1) % 3] * signs[(i + 2) % 3], part.in_decimals[i]);
    }
    if (!part.length_parameter.empty()) translation[0] = (signs[0] < 0 ? "-" : "") + part.length_parameter + "[0.25]";
    const auto list = [](const std::array<std::string, 3>& t) { return "(" + t[0] + ", " + t[1] + ", " + t[2] + ")"; };
    joints_ += std::string(part.revolute ? "r" : "p") + "_joint " + joint +
               " {\nref_frame {\ntranslation = " + list(translation) + "\nrotation = " + list(rotation) + "\n}\n}\n";
  }
};

}  // namespace

std::string limbed_document(std::uint64_t seed) {
  return Document(seed).make();
}

}  // namespace robcogen::test
