#include "algorithm/dynamics/traced_robot.h"

#include "algorithm/formulation/base_parameters.h"
#include "algorithm/kinematics/joint_poses.h"

namespace robcogen::algorithm {

using symbolic::Role;

namespace {

void begin_base(Trace& trace) {
  const std::string& base = trace.tree.links[0].name;
  trace.section(base, "base ", ": motion");
}

MassProperties mass_properties_of(Trace& trace, const model::Link& link) {
  trace.section(link.name, "link ", ": mass properties");
  return mass_properties(trace, link);
}

MassProperties lift(Trace& trace, const MassNumbers& numbers) {
  MassProperties m;
  m.mass = trace.graph.constant(numbers.mass);
  for (std::size_t i = 0; i < 3; ++i) {
    m.first_moment[i] = trace.graph.constant(numbers.first_moment[i]);
    for (std::size_t k = 0; k < 3; ++k) m.pseudo_inertia[i][k] = trace.graph.constant(numbers.pseudo_inertia[i][k]);
  }
  return m;
}

}  // namespace

TracedRobot::TracedRobot(Trace& t, const std::vector<Expression>& q, const RepresentativeLinks& representative)
    : trace(t), poses(joint_poses(t, q)) {
  for (const model::Link& link : tree().links) masses.push_back(mass_properties_of(trace, link));
  fold_like(representative);
  begin_base(trace);
}

TracedRobot::TracedRobot(Trace& t, const std::vector<Expression>& q, const Formulation& formulation) : trace(t) {
  if (formulation.is_draft) trace.graph.forget_names();
  if (formulation.numbers) {
    for (const MassNumbers& numbers : formulation.numbers->masses) masses.push_back(lift(trace, numbers));
    move_into(in_frames(trace, formulation.frames, formulation.numbers->placements, q, masses));
    return;
  }
  poses = joint_poses(trace, q);
  for (const model::Link& link : tree().links) masses.push_back(mass_properties_of(trace, link));
  if (formulation.base_parameters) masses = with_base_parameters(trace, poses, masses);
  if (formulation.frames.empty())
    fold_like(formulation.representative);
  else
    move_into(in_frames(trace, formulation.frames, axis_placements(tree()), q, masses, formulation.representative));
  begin_base(trace);
}

RepresentativeLinks representative_links(const model::KinematicTree& tree, const Formulation& formulation) {
  Trace trace(tree);
  Formulation plain = formulation;
  plain.is_draft = true;
  for (LinkFrame& frame : plain.frames) frame.turns_with_joint = true;
  const TracedRobot robot(trace, trace.joint_input("q", Role::joint_position), plain);
  return representative_links(tree, robot.poses, robot.masses);
}

RepresentativeLinks representative_links(const model::KinematicTree& tree) {
  Trace trace(tree);
  const TracedRobot robot(trace, trace.joint_input("q", Role::joint_position));
  return representative_links(tree, robot.poses, robot.masses);
}

void TracedRobot::move_into(FramedLinks&& framed) {
  poses = std::move(framed.poses);
  masses = std::move(framed.masses);
  frames_of_model = std::move(framed.frames_of_model);
}

void TracedRobot::fold_like(const RepresentativeLinks& representative) {
  for (std::size_t j = 0; j < representative.size(); ++j) {
    algorithm::fold_like(trace, representative[j], poses[j]);
    algorithm::fold_like(trace, representative[j], masses[at(tree().joints[j].child)]);
  }
}

std::vector<Joint> TracedRobot::children(int link) const {
  std::vector<Joint> result;
  for (const int j : tree().links[at(link)].child_joints) result.push_back(joint(j));
  return result;
}

bool TracedRobot::parent_matters(int link) const {
  const int joint = tree().links[at(link)].parent_joint;
  if (joint < 0) return false;
  return floating() || tree().joints[at(joint)].parent != 0;
}

void TracedRobot::subtract_external(const LoadInputs& loads, int link, Force& wrench) const {
  if (loads.external.empty()) return;
  const Force& external = loads.external[at(link)];
  wrench -= frames_of_model.empty() ? external : to_parent(frames_of_model[at(link)], external);
}

}  // namespace robcogen::algorithm
