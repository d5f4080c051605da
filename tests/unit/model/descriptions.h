// Descriptions of small robots, built by hand, and their geometry in plain matrices.
#pragma once

#include <Eigen/Geometry>
#include <random>
#include <string>
#include <vector>

#include "model/description.h"

namespace robcogen::model::test {

inline Quantity number(double value) {
  return Quantity(value);
}
inline Quantity pi(std::int64_t num, std::int64_t den = 1) {
  return Quantity(Number::pi_multiple(num, den));
}

// A ball: a mass with the same moment of inertia about every axis through its centre.
inline Inertia ball(double mass = 1.0, double moment = 0.1) {
  Inertia i;
  i.mass = number(mass);
  i.ixx = i.iyy = i.izz = number(moment);
  return i;
}

inline DescribedLink link(const std::string& name, std::vector<DescribedChild> children = {}) {
  DescribedLink result;
  result.name = name;
  result.inertia = ball();
  result.children = std::move(children);
  return result;
}

inline DescribedLink massless(const std::string& name, std::vector<DescribedChild> children = {}) {
  DescribedLink result = link(name, std::move(children));
  result.inertia.reset();
  return result;
}

inline DescribedJoint joint(
    const std::string& name,
    JointType type = JointType::revolute,
    const Placement& placement = {}) {
  return {name, {}, type, placement};
}

// base -a-> one -b-> two
inline Description two_links() {
  Description d;
  d.name = "two_links";
  d.base = link("base", {{"one", "a", {}, {}}});
  d.links = {link("one", {{"two", "b", {}, {}}}), link("two")};
  d.joints = {joint("a"), joint("b")};
  return d;
}

// base -j0-> l0 -j1-> l1 ...: `length` joints, each 1 m beyond the previous one.
inline Description chain(int length) {
  Description d;
  d.name = "chain";
  d.base = link("base");
  for (int i = 0; i < length; ++i) {
    const std::string name = std::to_string(i);
    Placement placement;
    placement.translation[0] = number(1.0);
    (i == 0 ? d.base : d.links.back()).children.push_back({"l" + name, "j" + name, {}, {}});
    d.links.push_back(link("l" + name));
    d.joints.push_back(joint("j" + name, JointType::revolute, placement));
  }
  return d;
}

// The codes of all diagnostics, in the order of their report.
inline std::vector<std::string> codes(const Diagnostics& diagnostics) {
  std::vector<std::string> result;
  for (const Diagnostic& d : diagnostics.all()) result.push_back(d.code);
  return result;
}

// The codes that building this robot reports.
inline std::vector<std::string> codes_of(const Description& d) {
  Diagnostics diagnostics;
  build(d, diagnostics);
  return codes(diagnostics);
}

// parent_T_frame, computed by Eigen.
inline Eigen::Isometry3d pose(const Placement& placement, std::span<const double> parameters = {}) {
  const auto value = [&](const Quantity& q) { return evaluate(q, parameters); };
  const auto turn = [&](int axis) {
    const double angle = value(placement.rotation[static_cast<std::size_t>(axis)]);
    return Eigen::AngleAxisd(angle, Eigen::Vector3d::Unit(axis));
  };
  const Eigen::Vector3d t(
      value(placement.translation[0]), value(placement.translation[1]), value(placement.translation[2]));
  return Eigen::Translation3d(t) * turn(0) * turn(1) * turn(2);
}

}  // namespace robcogen::model::test
