// Robots of random shape, for properties that hold for every robot.
#pragma once

#include <string>

#include "bodies.h"
#include "hand_robots.h"

namespace robcogen::algorithm::test {

// Revolute and prismatic joints at right angles, parallel or in skew places, in a chain or in a tree in which each link
// is attached to any earlier link.
inline model::KinematicTree random_robot(Numbers& n, int joints, bool is_chain) {
  const auto angle = [&]() -> model::Quantity {
    const int kind = n.pick(4);
    if (kind == 0) return model::Quantity(n.real());
    return kind == 1 ? model::test::pi(n.pick(2) == 0 ? 1 : -1, 2) : model::Quantity();
  };
  model::Description d;
  d.name = "random";
  d.base = model::test::link("base");
  for (int k = 0; k < joints; ++k) {
    const std::string number = std::to_string(k);
    const int parent = is_chain ? k : n.pick(k + 1);
    (parent == 0 ? d.base : d.links[static_cast<std::size_t>(parent - 1)])
        .children.push_back({"l" + number, "j" + number, {}, {}});
    d.links.push_back(model::test::link("l" + number));
    d.links.back().inertia = Cloud::random(n).document();
    model::Placement placement;
    for (std::size_t i = 0; i < 3; ++i) {
      if (n.pick(2) == 0) placement.translation[i] = model::Quantity(n.real());
      placement.rotation[i] = angle();
    }
    const bool slides = n.pick(4) == 0;
    d.joints.push_back(
        model::test::joint("j" + number, slides ? model::JointType::prismatic : model::JointType::revolute, placement));
  }
  return built(d);
}

// A body with two legs, each with a hip and a knee. The shanks' centres of mass are at (0.25, y, 0), with y of each
// leg.
inline model::KinematicTree two_legs(double left_y, double right_y) {
  model::Description d;
  d.name = "two_legs";
  d.base = model::test::link("body", {{"L_thigh", "L_hip", {}, {}}, {"R_thigh", "R_hip", {}, {}}});
  for (const std::string side : {"L", "R"}) {
    const double y = side == "L" ? left_y : right_y;
    d.links.push_back(model::test::link(side + "_thigh", {{side + "_shank", side + "_knee", {}, {}}}));
    d.links.back().inertia = point_mass_on_x(2.0, 0.25);
    d.links.push_back(model::test::link(side + "_shank"));
    Cloud shank;  // its centre of mass is at (0.25, y, 0)
    shank.mass = {0.5, 0.5};
    shank.at = {{0.25, y, 0.125}, {0.25, y, -0.125}};
    d.links.back().inertia = shank.document();
    model::Placement hip, knee;
    hip.translation[1] = model::Quantity(side == "L" ? 0.5 : -0.5);
    hip.rotation[0] = model::test::pi(1, 2);
    knee.translation[0] = model::Quantity(0.5);
    d.joints.push_back(model::test::joint(side + "_hip", model::JointType::revolute, hip));
    d.joints.push_back(model::test::joint(side + "_knee", model::JointType::revolute, knee));
  }
  return built(d);
}

}  // namespace robcogen::algorithm::test
