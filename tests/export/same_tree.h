// Compares two models part by part: joints, links, frames, couplings and numbers.
#pragma once

#include <gtest/gtest.h>

#include <array>
#include <map>
#include <vector>

#include "model/kinematic_tree.h"

namespace robcogen::test {

using model::KinematicTree;
using model::Quantity;

class SameTree {
  using Vector = std::array<Quantity, 3>;

 public:
  SameTree(const KinematicTree& found, const KinematicTree& expected) : found_(found), expected_(expected) {
    for (std::size_t i = 0; i < expected.parameters.size(); ++i) values_.push_back(0.3 + 0.17 * static_cast<double>(i));
  }

  void expect() const {
    EXPECT_EQ(found_.name, expected_.name);
    EXPECT_EQ(found_.floating_base, expected_.floating_base);
    ASSERT_EQ(found_.parameters.size(), expected_.parameters.size());
    for (std::size_t i = 0; i < expected_.parameters.size(); ++i) {
      EXPECT_EQ(found_.parameters[i].name, expected_.parameters[i].name);
      EXPECT_EQ(found_.parameters[i].kind, expected_.parameters[i].kind);
      EXPECT_EQ(found_.parameters[i].default_value, expected_.parameters[i].default_value);
    }
    expect_links();
    expect_joints();
    expect_couplings();
    expect_tendons();
    expect_frames();
  }

 private:
  void expect_links() const {
    ASSERT_EQ(found_.links.size(), expected_.links.size());
    for (std::size_t i = 0; i < expected_.links.size(); ++i) {
      const model::Link &found = found_.links[i], &expected = expected_.links[i];
      SCOPED_TRACE(expected.name);
      EXPECT_EQ(found.name, expected.name);
      EXPECT_EQ(found.parent_joint, expected.parent_joint);
      EXPECT_EQ(found.child_joints, expected.child_joints);
      EXPECT_EQ(found.is_repeated, expected.is_repeated);
      ASSERT_EQ(found.inertia.has_value(), expected.inertia.has_value());
      if (expected.inertia) expect_same(*found.inertia, *expected.inertia);
    }
  }

  void expect_joints() const {
    ASSERT_EQ(found_.joints.size(), expected_.joints.size());
    for (std::size_t i = 0; i < expected_.joints.size(); ++i) {
      const model::Joint &found = found_.joints[i], &expected = expected_.joints[i];
      SCOPED_TRACE(expected.name);
      EXPECT_EQ(found.name, expected.name);
      EXPECT_EQ(found.type, expected.type);
      EXPECT_EQ(found.parent, expected.parent);
      EXPECT_EQ(found.child, expected.child);
      expect_same(found.placement, expected.placement);
      EXPECT_TRUE(found.limits == expected.limits);
      expect_same(found.drive, expected.drive);
      expect_same(found.pitch, expected.pitch);
      EXPECT_EQ(found.spherical, expected.spherical);
      EXPECT_EQ(found.axis, expected.axis);
    }
  }

  void expect_couplings() const {
    ASSERT_EQ(found_.couplings.size(), expected_.couplings.size());
    for (std::size_t i = 0; i < expected_.couplings.size(); ++i) {
      const model::Coupling &found = found_.couplings[i], &expected = expected_.couplings[i];
      EXPECT_EQ(found.joint, expected.joint);
      ASSERT_EQ(found.is_linear(), expected.is_linear());
      ASSERT_EQ(found.terms.size(), expected.terms.size());
      for (std::size_t k = 0; k < expected.terms.size(); ++k) {
        EXPECT_EQ(found.terms[k].joint, expected.terms[k].joint);
        expect_same(found.terms[k].factor, expected.terms[k].factor);
      }
      expect_same(found.offset, expected.offset);
    }
  }

  void expect_tendons() const {
    ASSERT_EQ(found_.tendons.size(), expected_.tendons.size());
    for (std::size_t i = 0; i < expected_.tendons.size(); ++i) {
      const model::Tendon &found = found_.tendons[i], &expected = expected_.tendons[i];
      EXPECT_EQ(found.name, expected.name);
      ASSERT_EQ(found.terms.size(), expected.terms.size());
      for (std::size_t k = 0; k < expected.terms.size(); ++k) {
        EXPECT_EQ(found.terms[k].joint, expected.terms[k].joint);
        expect_same(found.terms[k].factor, expected.terms[k].factor);
      }
      expect_same(
          Vector{found.stiffness, found.damping, found.rest},
          Vector{expected.stiffness, expected.damping, expected.rest});
    }
  }

  void expect_same(const model::Drive& found, const model::Drive& expected) const {
    expect_same(found.damping, expected.damping);
    expect_same(
        Vector{found.friction, found.friction_velocity, found.armature},
        Vector{expected.friction, expected.friction_velocity, expected.armature});
    expect_same(found.stiffness, expected.stiffness);
    expect_same(found.rest, expected.rest);
    ASSERT_EQ(found.rotor.has_value(), expected.rotor.has_value());
    if (!expected.rotor) return;
    expect_same(found.rotor->inertia, expected.rotor->inertia);
    expect_same(found.rotor->ratio, expected.rotor->ratio);
    EXPECT_EQ(found.rotor->carrier, expected.rotor->carrier);
    ASSERT_EQ(found.rotor->axis.has_value(), expected.rotor->axis.has_value());
    if (expected.rotor->axis) expect_same(*found.rotor->axis, *expected.rotor->axis);
  }

  // Frames are compared by name, because a document lists them link by link.
  void expect_frames() const {
    std::map<std::string, const model::UserFrame*> all;
    for (const model::UserFrame& frame : found_.user_frames) all[frame.name] = &frame;
    ASSERT_EQ(all.size(), expected_.user_frames.size());
    for (const model::UserFrame& expected : expected_.user_frames) {
      SCOPED_TRACE(expected.name);
      ASSERT_TRUE(all.contains(expected.name));
      const model::UserFrame& found = *all.at(expected.name);
      EXPECT_EQ(found.link, expected.link);
      EXPECT_EQ(found.hidden, expected.hidden);
      expect_same(found.placement, expected.placement);
    }
  }

  void expect_same(const model::Inertia& found, const model::Inertia& expected) const {
    ASSERT_EQ(found.reference.has_value(), expected.reference.has_value());
    if (expected.reference) expect_same(*found.reference, *expected.reference);
    expect_same(found.mass, expected.mass);
    expect_same(found.com, expected.com);
    expect_same(Vector{found.ixx, found.iyy, found.izz}, Vector{expected.ixx, expected.iyy, expected.izz});
    expect_same(Vector{found.ixy, found.ixz, found.iyz}, Vector{expected.ixy, expected.ixz, expected.iyz});
  }

  void expect_same(const model::Placement& found, const model::Placement& expected) const {
    expect_same(found.translation, expected.translation);
    expect_same(found.rotation, expected.rotation);
  }

  void expect_same(const Vector& found, const Vector& expected) const {
    for (std::size_t i = 0; i < 3; ++i) expect_same(found[i], expected[i]);
  }

  // Expects the same double, and the same multiple of PI.
  void expect_same(const Quantity& found, const Quantity& expected) const {
    EXPECT_EQ(evaluate(found, values_), evaluate(expected, values_));
    ASSERT_EQ(found.is_constant(), expected.is_constant());
    if (!expected.is_constant() || !expected.number().is_pi_multiple()) return;
    EXPECT_TRUE(found.number() == expected.number()) << print(found.number()) << ", not " << print(expected.number());
  }

  const KinematicTree& found_;
  const KinematicTree& expected_;
  std::vector<double> values_;  // of the parameters
};

}  // namespace robcogen::test
