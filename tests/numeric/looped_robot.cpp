#include "looped_robot.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <utility>
#include <vector>

#include "dice.h"
#include "import/kinematics.h"
#include "language/kinematics/document.h"

namespace robcogen::numeric {
namespace {

constexpr double kPi = 3.14159265358979323846;

struct Point {
  double x = 0.0, y = 0.0;
};

double length(const Point& a, const Point& b) {
  return std::hypot(b.x - a.x, b.y - a.y);
}
double direction(const Point& a, const Point& b) {
  return std::atan2(b.y - a.y, b.x - a.x);
}

class Writer {
 public:
  explicit Writer(std::uint64_t seed) : dice_(seed * 7919 + 17) {}

  std::string run() {
    std::string carrier = "base";
    for (int k = dice_.below(3); k > 0; --k) carrier = carried(carrier, "arm" + std::to_string(k));
    for (int k = 1 + dice_.below(2); k > 0; --k) mechanism(carrier, std::string(1, static_cast<char>('a' + k)));
    std::string text = fmt::format(
        "Robot looped {{\nRobotBase base {} {{ {} children {{ {} }} {} }}\n", dice_.chance(0.3) ? "floating" : "",
        body(), children_of("base"), frames_of("base"));
    for (const Link& link : links_)
      text += fmt::format(
          "link {} {{ id = {} {} children {{ {} }} {} }}\n", link.name, ++ids_, body(), children_of(link.name),
          frames_of(link.name));
    text += joints_;
    if (!couplings_.empty()) text += "couplings { " + couplings_ + "}\n";
    return text + "loops {\n" + loops_ + "}\nindependent { " + independent_ + " }\n}\n";
  }

 private:
  struct Link {
    std::string name, parent, joint;
  };
  struct Frame {
    std::string link, text;
  };

  Dice dice_;
  int ids_ = 0;
  std::vector<Link> links_;
  std::vector<Frame> frames_;
  std::string joints_, couplings_, loops_, independent_;

  std::string body() {
    const double m = dice_.between(0.3, 2.0), s = dice_.between(0.002, 0.02);
    return fmt::format(
        "inertia_params {{ mass = {} CoM = ({}, {}, {}) Ix = {} Iy = {} Iz = {} Ixy = {} Ixz = {} Iyz = {} }}", m,
        dice_.between(-0.1, 0.1), dice_.between(-0.1, 0.1), dice_.between(-0.1, 0.1), 3 * m * s, 2.5 * m * s,
        3.5 * m * s, 0.2 * m * s, -0.1 * m * s, 0.15 * m * s);
  }

  std::string children_of(const std::string& parent) const {
    std::string text;
    for (const Link& link : links_)
      if (link.parent == parent) text += link.name + " via " + link.joint + " ";
    return text;
  }
  std::string frames_of(const std::string& link) const {
    std::string text;
    for (const Frame& frame : frames_)
      if (frame.link == link) text += frame.text;
    return text.empty() ? "" : "frames { " + text + "}";
  }

  // Adds a joint of this type and the link that it moves.
  void add(
      const std::string& parent,
      const std::string& name,
      const std::string& type,
      const std::string& translation,
      const std::string& rotation) {
    std::string drive;
    if (dice_.chance(0.2)) drive += fmt::format(" damping = {}", dice_.between(0.1, 1.0));
    if (dice_.chance(0.2)) drive += fmt::format(" armature = {}", dice_.between(0.01, 0.1));
    if (dice_.chance(0.2)) drive += fmt::format(" spring {{ stiffness = {} rest = 0.1 }}", dice_.between(1.0, 5.0));
    links_.push_back({"l_" + name, parent, name});
    joints_ += fmt::format(
        "{} {} {{ ref_frame {{ translation = ({}) rotation = ({}) }}{} }}\n", type, name, translation, rotation, drive);
  }

  std::string triple(double size) {
    return fmt::format(
        "{}, {}, {}", dice_.between(-size, size), dice_.between(-size, size), dice_.between(-size, size));
  }

  std::string carried(const std::string& parent, const std::string& name) {
    add(parent, name, dice_.chance(0.7) ? "r_joint" : "p_joint", triple(0.3), triple(1.0));
    lead(name);
    return "l_" + name;
  }

  void lead(const std::string& joint) { independent_ += (independent_.empty() ? "" : ", ") + joint; }

  // ---- The plane of a mechanism, in axes of the link that carries it; in the other links the joint axes are along z.

  struct Plane {
    std::string tilt;  // the first two angles
    double ax[3], ay[3], az[3];
  };

  Plane plane() {
    double rx = 0.0, ry = 0.0;
    std::string tilt = "0.0, 0.0";
    switch (dice_.below(5)) {
      case 0:
        rx = kPi / 2, tilt = "PI/2.0, 0.0";
        break;
      case 1:
        ry = kPi / 2, tilt = "0.0, PI/2.0";
        break;
      case 2:
        rx = kPi, tilt = "PI, 0.0";
        break;
      case 3:
        rx = dice_.between(-1, 1), ry = dice_.between(-1, 1), tilt = fmt::format("{}, {}", rx, ry);
        break;
      default:
        break;
    }
    const double cx = std::cos(rx), sx = std::sin(rx), cy = std::cos(ry), sy = std::sin(ry);
    return {tilt, {cy, sx * sy, -cx * sy}, {0.0, cx, sx}, {sy, -sx * cy, cx * cy}};
  }

  std::string at(const Plane& p, const Point& point, double z) {
    std::string text;
    for (int i = 0; i < 3; ++i)
      text += fmt::format("{}{}", i > 0 ? ", " : "", point.x * p.ax[i] + point.y * p.ay[i] + z * p.az[i]);
    return text;
  }

  double z() { return dice_.between(-0.05, 0.05); }
  double noise() { return dice_.between(-0.1, 0.1); }

  // ---- Mechanisms. Joints are placed so that the loop nearly closes at q = 0.

  void mechanism(const std::string& carrier, const std::string& name) {
    switch (dice_.below(5)) {
      case 0:
      case 1:
        return four_bar(carrier, name);
      case 2:
        return slider(carrier, name);
      case 3:
        return cylinder(carrier, name);
      default:
        return rod(carrier, name);
    }
  }

  void frame(const std::string& link, const std::string& name, double x, double height, const std::string& rotation) {
    frames_.push_back(
        {link, fmt::format("{} {{ translation = ({}, 0.0, {}) rotation = ({}) }} ", name, x, height, rotation)});
  }

  void close(const std::string& name, const std::string& type) {
    loops_ += fmt::format("  {0} {{ frames = {0}_left ~ {0}_right {1} }}\n", name, type);
  }

  std::string planar_type() { return dice_.chance(0.5) ? "type = hinge" : "type = point"; }

  // A crank and a rocker on the carrier, and a rod on the crank; sometimes a second rod makes it a five-bar.
  void four_bar(const std::string& carrier, const std::string& name) {
    const Plane p = plane();
    const Point ground = {0.0, 0.0}, other = {dice_.between(0.35, 0.5), noise()};
    const double turn = dice_.between(0.9, 1.6), crank = dice_.between(0.2, 0.3);
    const Point tip = {crank * std::cos(turn), crank * std::sin(turn)};
    const Point top = {other.x + dice_.between(-0.05, 0.1), dice_.between(0.4, 0.5)};
    const double low = z(), step = z(), rise = low + step;
    add(carrier, name + "1", "r_joint", at(p, ground, low), p.tilt + fmt::format(", {}", turn));
    const std::string length_of_crank =
        dice_.chance(0.3) ? fmt::format("{}_crank[{}]", name, crank) : fmt::format("{}", crank);
    add("l_" + name + "1", name + "2", "r_joint", fmt::format("{}, 0.0, {}", length_of_crank, step),
        fmt::format("0.0, 0.0, {}", direction(tip, top) - turn + noise()));
    frame("l_" + name + "2", name + "_left", length(tip, top), 0.0, "0.0, 0.0, 0.3");
    const bool five = dice_.chance(0.3);
    const Point knee = {other.x + 0.15, 0.2};
    const double base = five ? direction(other, knee) : direction(other, top) + noise();
    add(carrier, name + "3", "r_joint", at(p, other, rise), p.tilt + fmt::format(", {}", base));
    if (five) {
      add("l_" + name + "3", name + "4", "r_joint", fmt::format("{}, 0.0, 0.0", length(other, knee)),
          fmt::format("0.0, 0.0, {}", direction(knee, top) - base + noise()));
      frame("l_" + name + "4", name + "_right", length(knee, top), 0.0, "0.0, 0.0, 0.0");
    } else {
      frame("l_" + name + "3", name + "_right", length(other, top), 0.0, "PI, 0.0, 0.0");
    }
    close(name, planar_type());
    const std::string leaders[] = {"1", "2", "3"};
    lead(name + (five ? "1" : leaders[dice_.below(3)]));
    if (five) lead(name + (dice_.chance(0.5) ? "3" : "4"));
    if (dice_.chance(0.3)) {
      add("l_" + name + "1", name + "c", "r_joint", triple(0.1), triple(1.0));
      couplings_ += fmt::format("{0}c = 0.5 * {0}d + 0.2 ", name);
      add("l_" + name + "3", name + "d", "r_joint", triple(0.1), triple(1.0));
      lead(name + "d");
    }
  }

  // A crank, a rod and a piston that slides in the carrier. In a tilted plane a rocker takes the place of the piston.
  void slider(const std::string& carrier, const std::string& name) {
    const Plane p = plane();
    const double turn = dice_.between(0.9, 1.6), crank = dice_.between(0.15, 0.25), rise = z();
    const Point tip = {crank * std::cos(turn), crank * std::sin(turn)}, pin = {dice_.between(0.4, 0.6), noise()};
    add(carrier, name + "1", "r_joint", at(p, {0.0, 0.0}, 0.0), p.tilt + fmt::format(", {}", turn));
    add("l_" + name + "1", name + "2", "r_joint", fmt::format("{}, 0.0, {}", crank, rise),
        fmt::format("0.0, 0.0, {}", direction(tip, pin) - turn + noise()));
    frame("l_" + name + "2", name + "_left", length(tip, pin), 0.0, "0.0, 0.0, 0.0");
    // Where the plane of the mechanism is the x-y plane of the carrier, the piston slides along x.
    const bool plain = p.tilt == "0.0, 0.0";
    const std::string along = plain ? "0.0, PI/2.0, 0.0" : "";
    if (plain) {
      add(carrier, name + "3", "p_joint", at(p, {pin.x - 0.05, pin.y}, rise), along);
      frames_.push_back(
          {"l_" + name + "3", fmt::format(
                                  "{}_right {{ translation = (0.0, 0.0, {}) rotation = (0.0, -PI/2.0, 0.0) }} ", name,
                                  0.05 + 0.3 * noise())});
    } else {
      add(carrier, name + "3", "r_joint", at(p, {pin.x, -0.2}, rise), p.tilt + fmt::format(", {}", kPi / 2 + noise()));
      frame("l_" + name + "3", name + "_right", pin.y + 0.2, 0.0, "0.0, 0.0, 0.0");
    }
    close(name, planar_type());
    lead(name + (plain && dice_.chance(0.5) ? "3" : "1"));
  }

  // A rocker that a cylinder moves: the tube turns, and the rod slides in it.
  void cylinder(const std::string& carrier, const std::string& name) {
    const Plane p = plane();
    const Point other = {dice_.between(0.3, 0.4), noise()};
    const double turn = dice_.between(1.0, 1.5), rocker = dice_.between(0.2, 0.3);
    const Point tip = {rocker * std::cos(turn), rocker * std::sin(turn)};
    const double tube = direction(other, tip), whole = length(other, tip);
    add(carrier, name + "1", "r_joint", at(p, {0.0, 0.0}, 0.02), p.tilt + fmt::format(", {}", turn));
    frame("l_" + name + "1", name + "_left", rocker, 0.0, "0.0, 0.0, 0.0");
    add(carrier, name + "2", "r_joint", at(p, other, 0.02), p.tilt + fmt::format(", {}", tube + noise()));
    add("l_" + name + "2", name + "3", "p_joint", fmt::format("0.1, {}, 0.0", 0.2 * noise()), "0.0, PI/2.0, 0.0");
    frames_.push_back(
        {"l_" + name + "3",
         fmt::format(
             "{}_right {{ translation = (0.0, 0.0, {}) rotation = (0.0, -PI/2.0, 0.0) }} ", name, whole - 0.1)});
    close(name, planar_type());
    lead(name + (dice_.chance(0.5) ? "1" : "3"));
  }

  // Two arms whose tips keep a constant distance, nearly in a plane.
  void rod(const std::string& carrier, const std::string& name) {
    const double turn = dice_.between(0.9, 1.6), bend = dice_.between(-0.3, 0.3), third = dice_.between(1.4, 2.0);
    const Point left = {
        0.2 * std::cos(turn) + 0.1 * std::cos(turn + bend), 0.2 * std::sin(turn) + 0.1 * std::sin(turn + bend)};
    const Point right = {0.5 + 0.2 * std::cos(third), 0.05 + 0.2 * std::sin(third)};
    const bool first_slides = dice_.chance(0.2), last_slides = dice_.chance(0.3);
    add(carrier, name + "1", "r_joint", "0.0, 0.0, 0.0", fmt::format("{}, {}, {}", noise(), noise(), turn));
    add("l_" + name + "1", name + "2", first_slides ? "p_joint" : "r_joint", "0.2, 0.0, 0.0",
        fmt::format("{}, {}, {}", noise(), noise(), bend));
    frame("l_" + name + "2", name + "_left", 0.1, 0.05, "0.0, 0.0, 0.0");
    // If the last joint slides, it does so towards the first arm.
    if (last_slides)
      add(carrier, name + "3", "p_joint", fmt::format("{}, {}, 0.05", right.x, right.y),
          fmt::format("{}, PI/2.0, 0.0", noise()));
    else
      add(carrier, name + "3", "r_joint", "0.5, 0.05, 0.0", fmt::format("{}, {}, {}", noise(), noise(), third));
    frame("l_" + name + "3", name + "_right", last_slides ? 0.01 : 0.2, 0.02, "0.0, 0.0, 0.0");
    close(name, fmt::format("distance = {}", length(left, right)));
    lead(name + "2");
    lead(name + (dice_.chance(0.5) ? "1" : "3"));
  }
};

}  // namespace

std::string looped_document(std::uint64_t seed) {
  return Writer(seed).run();
}

std::optional<model::KinematicTree> looped_tree(std::uint64_t seed) {
  Diagnostics diagnostics;
  const auto source = std::make_shared<const Source>("looped.kindsl", looped_document(seed));
  auto tree = import::kinematic_tree(language::kinematics::parse(source, diagnostics), diagnostics);
  for (const Diagnostic& d : diagnostics.all()) {
    const bool is_expected = d.severity != Severity::error || d.code == "loop-cannot-close";
    EXPECT_TRUE(is_expected) << seed << "\n" << diagnostics.render() << looped_document(seed);
  }
  return tree;
}

std::vector<double> values_near_defaults(const model::KinematicTree& tree) {
  std::vector<double> values;
  for (const model::Parameter& p : tree.parameters) values.push_back(1.02 * p.default_value.value_or(0.0));
  return values;
}

}  // namespace robcogen::numeric
