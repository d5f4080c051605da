// What every dynamics algorithm starts from: poses, mass properties, the motion of the base, the loads.
#pragma once

#include <optional>
#include <vector>

#include "algorithm/dynamics.h"
#include "algorithm/formulation.h"
#include "algorithm/newton_euler.h"

namespace robcogen::algorithm {

// A joint as the recursions see it.
struct JointView {
  int index = 0;
  int child = 0;  // link
  bool revolute = true;
};

struct Setup {
  // The mass properties of the model; with a formulation, those that make the same dynamics cheap.
  Setup(Trace& trace, const std::vector<Expression>& q, const TypicalLinks& typical = {});
  Setup(Trace& trace, const std::vector<Expression>& q, const Formulation& formulation);

  Trace& trace;
  std::vector<Pose> poses;             // by joint: child link in parent link
  std::vector<MassProperties> masses;  // by link
  std::vector<Pose> frames_of_model;   // by link: the model's link frame, where the formulation has another; or empty

  const model::KinematicTree& tree() const { return trace.tree; }
  bool floating() const { return trace.tree.floating_base; }
  const std::string& link_name(int link) const { return tree().links[static_cast<std::size_t>(link)].name; }
  const Pose& pose(int joint) const { return poses[static_cast<std::size_t>(joint)]; }
  const MassProperties& mass(int link) const { return masses[static_cast<std::size_t>(link)]; }
  std::vector<JointView> children(int link) const;
  // Whether what a link passes to its parent matters: a fixed base takes everything.
  bool parent_matters(int link) const;

 private:
  void move_into(FramedLinks&& framed);
  void see_among_typical(const TypicalLinks& typical);
};

// What is typical of the numbers that such a setup takes from a robot without parameters, before any turns with a
// joint; empty where equal limbs fold alike as they are.
TypicalLinks typical_links(const model::KinematicTree& tree, const Formulation& formulation);
// The same for a setup without formulation.
TypicalLinks typical_links(const model::KinematicTree& tree);

// Gravity and external wrenches of a program. Declares its inputs: call after all other inputs.
struct LoadInputs {
  LoadInputs(Trace& trace, Loads loads);

  Vector3 gravity;
  std::vector<Spatial> external;  // by link; empty when there are none

  // Takes the external wrench on this link off the wrench that the link needs.
  void subtract_external(const Setup& setup, int link, Spatial& wrench) const;
};

// Base at rest, or moving: its classical acceleration minus gravity.
LinkMotion base_motion(const Vector3& gravity);
LinkMotion base_motion(const Spatial& velocity, const Spatial& acceleration, const Vector3& gravity);

// Solution of A x = b for a symmetric positive definite A, by L^T L-style elimination from the last row up: zeros of A
// cost nothing. A is destroyed.
std::vector<Expression> solve(std::vector<std::vector<Expression>> a, std::vector<Expression> b);

}  // namespace robcogen::algorithm
