#include "algorithm/setup.h"

#include "algorithm/regroup.h"

namespace robcogen::algorithm {

using symbolic::Role;

namespace {

// What an algorithm does next.
void begin_base(Trace& trace) {
  const std::string& base = trace.tree.links[0].name;
  trace.section(base, "base " + base + ": motion");
}

MassProperties mass_properties_of(Trace& trace, const model::Link& link) {
  trace.section(link.name, "link " + link.name + ": mass properties");
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

Setup::Setup(Trace& t, const std::vector<Expression>& q, const TypicalLinks& typical)
    : trace(t), poses(joint_poses(t, q)) {
  for (const model::Link& link : tree().links) masses.push_back(mass_properties_of(trace, link));
  see_among_typical(typical);
  begin_base(trace);
}

Setup::Setup(Trace& t, const std::vector<Expression>& q, const Formulation& formulation) : trace(t) {
  if (formulation.is_draft) trace.graph.forget_names();
  if (formulation.numbers) {
    for (const MassNumbers& numbers : formulation.numbers->masses) masses.push_back(lift(trace, numbers));
    move_into(in_frames(trace, formulation.frames, formulation.numbers->placements, q, masses));
    return;
  }
  poses = joint_poses(trace, q);
  for (const model::Link& link : tree().links) masses.push_back(mass_properties_of(trace, link));
  if (formulation.regroup) masses = regrouped(trace, poses, masses);
  if (formulation.frames.empty())
    see_among_typical(formulation.typical);
  else
    move_into(in_frames(trace, formulation.frames, axis_placements(tree()), q, masses, formulation.typical));
  begin_base(trace);
}

TypicalLinks typical_links(const model::KinematicTree& tree, const Formulation& formulation) {
  Trace trace(tree);
  Formulation plain = formulation;
  plain.is_draft = true;
  for (LinkFrame& frame : plain.frames) frame.turns_with_joint = true;
  const Setup setup(trace, trace.joint_input("q", Role::joint_position), plain);
  return typical_links(tree, setup.poses, setup.masses);
}

TypicalLinks typical_links(const model::KinematicTree& tree) {
  Trace trace(tree);
  const Setup setup(trace, trace.joint_input("q", Role::joint_position));
  return typical_links(tree, setup.poses, setup.masses);
}

void Setup::move_into(FramedLinks&& framed) {
  poses = std::move(framed.poses);
  masses = std::move(framed.masses);
  frames_of_model = std::move(framed.frames_of_model);
}

void Setup::see_among_typical(const TypicalLinks& typical) {
  for (std::size_t j = 0; j < typical.size(); ++j) {
    see_among(trace, typical[j], poses[j]);
    see_among(trace, typical[j], masses[static_cast<std::size_t>(tree().joints[j].child)]);
  }
}

std::vector<JointView> Setup::children(int link) const {
  std::vector<JointView> result;
  for (int j : tree().links[static_cast<std::size_t>(link)].child_joints) {
    const model::Joint& joint = tree().joints[static_cast<std::size_t>(j)];
    result.push_back({j, joint.child, joint.type == model::JointType::revolute});
  }
  return result;
}

bool Setup::parent_matters(int link) const {
  const int joint = tree().links[static_cast<std::size_t>(link)].parent_joint;
  if (joint < 0) return false;
  return floating() || tree().joints[static_cast<std::size_t>(joint)].parent != 0;
}

LoadInputs::LoadInputs(Trace& trace, Loads loads) {
  // As the decimal that it is: products with exact numbers of the model stay exact.
  const Number g = *Number::parse(print_double(kStandardGravity));
  gravity = loads == Loads::standard_gravity ? Vector3{Expression(), Expression(), trace.graph.constant(-g)}
                                             : trace.vector_input("gravity", Role::gravity);
  if (loads == Loads::gravity_and_external) external = trace.link_wrench_input();
}

void LoadInputs::subtract_external(const Setup& setup, int link, Spatial& wrench) const {
  if (external.empty()) return;
  const auto l = static_cast<std::size_t>(link);
  wrench -= setup.frames_of_model.empty() ? external[l] : to_parent(setup.frames_of_model[l], external[l]);
}

LinkMotion base_motion(const Vector3& gravity) {
  return {{}, -gravity};
}

LinkMotion base_motion(const Spatial& velocity, const Spatial& acceleration, const Vector3& gravity) {
  const Vector3 free = acceleration.linear - gravity;
  return {{velocity.angular, acceleration.angular}, free + cross(velocity.angular, velocity.linear)};
}

std::vector<Expression> solve(std::vector<std::vector<Expression>> a, std::vector<Expression> b) {
  const std::size_t n = b.size();
  std::vector<Expression> inverse(n);
  std::vector<std::vector<Expression>> factor(n, std::vector<Expression>(n));
  for (std::size_t k = n; k-- > 0;) {
    inverse[k] = a[k][k].graph()->one() / a[k][k];
    for (std::size_t i = 0; i < k; ++i) factor[k][i] = a[k][i] * inverse[k];
    for (std::size_t i = 0; i < k; ++i) {
      for (std::size_t j = 0; j <= i; ++j) a[i][j] -= factor[k][i] * a[k][j];
      b[i] -= factor[k][i] * b[k];
    }
  }
  std::vector<Expression> x(n);
  for (std::size_t k = 0; k < n; ++k) {
    x[k] = b[k] * inverse[k];
    for (std::size_t i = 0; i < k; ++i) x[k] -= factor[k][i] * x[i];
  }
  return x;
}

}  // namespace robcogen::algorithm
