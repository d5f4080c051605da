// Small robots whose equations of motion are in every textbook, and one robot without any special structure.
#pragma once

#include <gtest/gtest.h>

#include "robcogen/reference/energy.h"
#include "robcogen/reference/rounding.h"
#include "robcogen/reference/samples.h"
#include "tables.h"

namespace robcogen::reference {

inline constexpr double kPi = 3.14159265358979323846;

// A point mass; its inertia about the link origin follows.
inline Tables::Body point_mass(double mass, const Triple& at) {
  const auto [x, y, z] = at;
  return {
      mass,
      at,
      {mass * (y * y + z * z), mass * (x * x + z * z), mass * (x * x + y * y),  //
       mass * x * y, mass * x * z, mass * y * z}};
}

// A body with central moments of inertia in link axes.
inline Tables::Body body(double mass, const Triple& com, const Triple& central) {
  Tables::Body result = point_mass(mass, com);
  for (std::size_t k = 0; k < 3; ++k) result.inertia[k] += central[k];
  return result;
}

// A rod whose centre of mass is `length` below the joint at q = 0. It swings in the x-z plane, towards +x.
inline Tables pendulum(double mass, double length, double central_moment) {
  Tables t("pendulum");
  t.add_link("base", {});
  t.add_link("rod", body(mass, {0, -length, 0}, {0, 0, central_moment}));
  t.add_joint("hinge", JointType::revolute, 0, 1, {}, {kPi / 2, 0, 0});  // x = base x, y = base z, z = -base y
  return t;
}

// Two point masses on massless rods l1, l2 in the x-z plane; q2 is relative. The pendulum hangs at q = 0.
inline Tables double_pendulum(double m1, double l1, double m2, double l2) {
  Tables t("double_pendulum");
  t.add_link("base", {});
  t.add_link("upper", point_mass(m1, {0, -l1, 0}));
  t.add_link("lower", point_mass(m2, {0, -l2, 0}));
  t.add_joint("shoulder", JointType::revolute, 0, 1, {}, {kPi / 2, 0, 0});
  t.add_joint("elbow", JointType::revolute, 1, 2, {0, -l1, 0});
  return t;
}

// A cart of mass m_cart along base x, with a point mass on a rod of length l. The pole angle is zero when the pole
// hangs, and positive towards +x.
inline Tables cart_pole(double m_cart, double m_pole, double length) {
  Tables t("cart_pole");
  t.add_link("base", {});
  t.add_link("cart", point_mass(m_cart, {}));
  t.add_link("pole", point_mass(m_pole, {0, -length, 0}));
  t.add_joint(
      "slide", JointType::prismatic, 0, 1, {}, {0, kPi / 2, 0});  // cart axes: z = base x, x = -base z, y = base y
  // Pole axes at q = 0: x = base x, y = base z, z = -base y, in cart axes.
  t.add_joint("pivot", JointType::revolute, 1, 2, {}, {kPi / 2, 0, kPi / 2});
  return t;
}

inline Tables free_body(double mass, const Triple& com, const Triple& central) {
  Tables t("free_body", true);
  t.add_link("body", body(mass, com, central));
  return t;
}

// A branched tree of both joint types with skew frames and full inertias.
inline Tables crooked_tree(bool floating_base) {
  Tables t("crooked_tree", floating_base);
  const auto crooked = [](double mass, const Triple& com) {
    Tables::Body b = body(mass, com, {0.05 * mass, 0.04 * mass, 0.03 * mass});
    b.inertia[3] += 0.002 * mass;
    b.inertia[4] -= 0.003 * mass;
    b.inertia[5] += 0.004 * mass;
    return b;
  };
  t.add_link("trunk", crooked(7.0, {0.02, -0.03, 0.05}));
  t.add_link("a1", crooked(2.0, {0.1, 0.02, -0.04}));
  t.add_link("a2", crooked(1.5, {0.0, 0.12, 0.03}));
  t.add_link("a3", crooked(0.7, {0.05, -0.02, 0.09}));
  t.add_link("b1", crooked(1.8, {-0.03, 0.06, 0.11}));
  t.add_link("b2", crooked(0.4, {0.02, 0.02, 0.2}));
  // Declared out of tree order, as documents may.
  t.add_joint("A2", JointType::prismatic, 1, 2, {0.3, -0.1, 0.05}, {0.4, -0.8, 1.1});
  t.add_joint("A1", JointType::revolute, 0, 1, {0.2, 0.1, -0.1}, {0.3, 0.5, -0.7});
  t.add_joint("B2", JointType::revolute, 4, 5, {0.0, 0.25, 0.1}, {kPi / 2, 0.0, 0.2});
  t.add_joint("A3", JointType::revolute, 2, 3, {0.1, 0.2, 0.3}, {-1.2, 0.3, 0.9});
  t.add_joint("B1", JointType::revolute, 0, 4, {-0.2, 0.1, 0.15}, {-0.6, 0.2, 2.1});
  t.add_frame("fr_trunk", 0);
  t.add_frame("hand", 3, {0.05, 0.06, 0.07}, {0.1, 0.2, 0.3});
  t.add_frame("foot", 5, {-0.04, 0.01, 0.3}, {-0.5, 0.4, -0.3});
  t.add_frame("knee", 4, {0.1, 0.0, 0.2}, {0.0, 0.7, 0.0});
  return t;
}

inline Motion<double> random_motion(std::mt19937_64& engine, const Robot& robot) {
  return random_sample(engine, robot).motion;
}

// Expects that each of these checks fails in the report.
inline void expect_failures(const std::string& report, const std::vector<std::string>& names) {
  for (const std::string& name : names) EXPECT_NE(report.find("FAIL  " + name), std::string::npos) << report;
}

}  // namespace robcogen::reference
