// A robot while a program of its dynamics is traced: the poses and the mass properties of its links.
#pragma once

#include <string>
#include <vector>

#include "algorithm/dynamics/loads.h"
#include "algorithm/formulation/formulation.h"
#include "algorithm/spatial/joint.h"

namespace robcogen::algorithm {

struct TracedRobot {
  // Uses the mass properties of the model or, with a formulation, others that give the same dynamics at less cost.
  TracedRobot(Trace& trace, const std::vector<Expression>& q, const RepresentativeLinks& representative = {});
  TracedRobot(Trace& trace, const std::vector<Expression>& q, const Formulation& formulation);

  Trace& trace;
  std::vector<Pose> poses;             // by joint: child link in parent link
  std::vector<MassProperties> masses;  // by link
  std::vector<Pose> frames_of_model;   // by link: the model's link frame in the formulation's; empty if equal

  const model::KinematicTree& tree() const { return trace.tree; }
  bool floating() const { return trace.tree.floating_base; }
  const std::string& link_name(int link) const { return tree().links[at(link)].name; }
  const Pose& pose(int joint) const { return poses[at(joint)]; }
  const MassProperties& mass(int link) const { return masses[at(link)]; }
  Joint joint(int index) const { return joint_of(trace, index); }
  std::vector<Joint> children(int link) const;
  // The joint that carries a link other than the base.
  Joint parent_joint(int link) const { return joint(tree().links[at(link)].parent_joint); }
  bool is_base(int link) const { return tree().links[at(link)].parent_joint < 0; }
  // False for children of a fixed base: nothing needs their wrench.
  bool parent_matters(int link) const;

  // Subtracts the external wrench on this link, if there is one, from the wrench that the link needs.
  void subtract_external(const LoadInputs& loads, int link, Force& wrench) const;

 private:
  void move_into(FramedLinks&& framed);
  void fold_like(const RepresentativeLinks& representative);
};

// The representative numbers of congruent limbs (representative_limbs.h) for the poses and mass properties that such a
// robot starts from, before any mass properties turn with a joint. For robots without parameters; empty if congruent
// limbs fold in the same way.
RepresentativeLinks representative_links(const model::KinematicTree& tree, const Formulation& formulation);
// The same for a robot without formulation.
RepresentativeLinks representative_links(const model::KinematicTree& tree);

}  // namespace robcogen::algorithm
