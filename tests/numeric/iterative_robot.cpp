#include "iterative_robot.h"

#include <cmath>

namespace robcogen::numeric {
namespace {

std::string inertia(double mass, double x, double y, double z) {
  const auto text = [](double v) { return std::to_string(v); };
  return " inertia_params { mass = " + text(mass) + " CoM = (" + text(x) + ", " + text(y) + ", " + text(z) +
         ") Ix = 0.06 Iy = 0.065 Iz = 0.07 Ixy = 0.001 Ixz = -0.002 Iyz = 0.0015 } ";
}

std::string at(const std::string& translation, const std::string& rotation = "0.0, 0.0, 0.0") {
  return " { translation = (" + translation + ") rotation = (" + rotation + ") } ";
}

// A crank and a rocker about axes that are not parallel. The rod is attached to the crank by a universal joint and to
// the rocker by a ball joint.
std::string spatial_four_bar(const std::string& leaders) {
  return "Robot Spatial { RobotBase base { children { crank via a rocker via c } } link crank { id = 1 " +
         inertia(1, 0.1, 0.02, 0.1) + "children { rod via u } } link rod { id = 2 " + inertia(0.5, 0.2, 0.01, 0) +
         "children {} frames { end" + at("0.0, 0.6, 0.0") + "} } link rocker { id = 3 " + inertia(0.7, 0.2, 0.01, 0) +
         "children {} frames { pin" + at("0.3, 0.0, 0.1") + "} } r_joint a { ref_frame" +
         at("0.0, 0.0, 0.0", "0.1, 0.2, 0.3") + "armature = 0.1 } u_joint u { ref_frame" +
         at("0.2, 0.0, 0.05", "0.0, 0.2, -0.6 - PI/2.0") + "} r_joint c { ref_frame" +
         at("0.7, 0.1, 0.0", "-1.2, 0.3, 1.746") + "} loops { ball { frames = end ~ pin type = point } } " + leaders +
         "}";
}

// Three arms carry a platform by rods of fixed length. The platform slides along three axes.
std::string delta(const std::string& leaders) {
  std::string arms, frames, joints, loops, children;
  for (int k = 0; k < 3; ++k) {
    const std::string n = std::to_string(k), turn = std::to_string(k) + ".0 * 2.0 PI/3.0";
    const double angle = 2 * 3.14159265358979323846 * k / 3;
    const auto around = [&](double r) {
      return std::to_string(r * std::cos(angle)) + ", " + std::to_string(r * std::sin(angle)) + ", 0.0";
    };
    children += " hub" + n + " via turn" + n;
    arms += "link hub" + n + " { id = " + std::to_string(4 + k) + inertia(0.4, 0.1, 0, 0) + "children {} frames { tip" +
            n + at("0.25, 0.0, 0.0") + "} } ";
    frames += "pin" + n + at(around(0.05));
    joints +=
        "r_joint turn" + n + " { ref_frame" + at(around(0.12), "-PI/2.0, " + turn + ", 0.3") + "armature = 0.01 } ";
    loops += "rod" + n + " { frames = tip" + n + " ~ pin" + n + " distance = 0.6 } ";
  }
  return "Robot Delta { RobotBase base { children { sx via x" + children +
         " } } link sx { id = 1 children { sy via y } } link sy { id = 2 children { sz via z } } link sz { id = 3 " +
         inertia(0.5, 0, 0, -0.02) + "children {} frames { " + frames + "} } " + arms + "p_joint x { ref_frame" +
         at("0.0, 0.0, -0.55", "0.0, PI/2.0, 0.0") + "} p_joint y { ref_frame" +
         at("0.0, 0.0, 0.0", "-PI/2.0, 0.0, 0.0") + "} p_joint z { ref_frame" +
         at("0.0, 0.0, 0.0", "0.0, -PI/2.0, -PI/2.0") + "} " + joints + "loops { " + loops + "} " + leaders + "}";
}

// A slotted lever: a block on the crank's pin slides along the lever and turns with it.
std::string slotted(const std::string& leaders) {
  return "Robot Slot { RobotBase base floating { " + inertia(3, 0, 0.1, 0) +
         "children { crank via a lever via c } } link crank { id = 1 " + inertia(1, 0.1, 0.02, 0.1) +
         "children { block via b } } link block { id = 2 " + inertia(0.5, 0.01, 0, 0) + "children {} frames { end" +
         at("0.0, 0.0, 0.0", "0.0, PI/2.0, 0.0") + "} } link lever { id = 3 " + inertia(0.7, 0.2, 0.01, 0) +
         "children {} frames { slot" + at("0.1, 0.0, 0.0", "0.0, PI/2.0, 0.0") + "} } r_joint a { ref_frame" +
         at("0.0, 0.0, 0.0", "0.0, 0.0, 1.2") + "} r_joint b { ref_frame" + at("0.2, 0.0, 0.0", "0.0, 0.0, -1.0") +
         "} r_joint c { ref_frame" + at("-0.4, 0.1, 0.0", "0.0, 0.0, 0.2") +
         "} loops { slide { frames = slot ~ end type = slider } } " + leaders + "}";
}

}  // namespace

std::string cut_rod(const std::string& leaders, const std::string& turned) {
  return "Robot Bar { RobotBase base { children { crank via a rocker via c } } link crank { id = 1 " +
         inertia(1, 0.1, 0.02, 0.1) + "children { first via b } } link first { id = 2 " + inertia(0.5, 0.1, 0, 0) +
         "children {} frames { end" + at("0.3, 0.0, 0.0", "0.0, PI/2.0, 0.0") + "} } link rocker { id = 3 " +
         inertia(0.7, 0.2, 0.01, 0) + "children { second via d } } link second { id = 4 " + inertia(0.4, 0.1, 0, 0.05) +
         "children {} frames { pin" + at("0.25, 0.0, 0.0", turned) + "} } r_joint a { ref_frame" +
         at("0.0, 0.0, 0.0", "0.0, 0.0, 1.2") + "} r_joint b { ref_frame" + at("0.2, 0.0, 0.0", "0.0, 0.0, -0.8") +
         "} r_joint c { ref_frame" + at("0.5, 0.0, 0.0", "0.0, 0.0, 1.4") + "} r_joint d { ref_frame" +
         at("0.4, 0.0, 0.0", "0.0, 0.0, 2.0") + "damping = 0.3 } loops { cut { frames = end ~ pin type = weld } } " +
         leaders + "}";
}

void PrintTo(const IterativeRobot& robot, std::ostream* out) {
  *out << robot.name;
}

const std::vector<IterativeRobot>& iterative_robots() {
  static const std::vector<IterativeRobot> all = {
      {"WeldedRod", cut_rod("independent { a }"), {"a"}, {"b", "c", "d"}},
      {"SpatialFromTheCrank", spatial_four_bar(""), {"a"}, {"u_turn_x", "u_turn_z", "c"}},
      {"SpatialFromTheRocker", spatial_four_bar("independent { c }"), {"c"}, {"a", "u_turn_x", "u_turn_z"}},
      {"DeltaByItsMotors", delta(""), {"turn0", "turn1", "turn2"}, {"x", "y", "z"}},
      {"DeltaMixed", delta("independent { turn0, turn1, z }"), {"z", "turn0", "turn1"}, {"x", "y", "turn2"}},
      {"Slot", slotted("independent { a }"), {"a"}, {"b", "c"}}};
  return all;
}

}  // namespace robcogen::numeric
