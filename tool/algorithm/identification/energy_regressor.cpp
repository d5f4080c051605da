// Energies as linear functions of the inertial parameters.
#include <functional>

#include "algorithm/identification/regressor.h"
#include "algorithm/spatial/named.h"

namespace robcogen::algorithm {
namespace {

using symbolic::Program;
using symbolic::Role;

// Gravity in link axes, and minus the potential energy of a mass of 1 kg at the origin of the link (J).
struct LinkGravity {
  Vector3 gravity;
  Expression height;
};

LinkGravity to_child(const Pose& X_PC, const LinkGravity& parent) {
  LinkGravity child;
  child.gravity = algorithm::to_child(X_PC.rotation, parent.gravity);
  child.height = parent.height + dot(parent.gravity, X_PC.offset);
  child.height += child.gravity[2] * X_PC.slide;
  return child;
}

// The coefficients of m v v / 2 + h (v x w) + w I w / 2.
std::array<Expression, kParametersOfLink> kinetic(const Motion& twist) {
  const Vector3 &w = twist.angular, &v = twist.linear;
  const Vector3 moment = cross(v, w);
  const Vector3 half{0.5 * w[0], 0.5 * w[1], 0.5 * w[2]};
  return {0.5 * dot(v, v), moment[0],      moment[1],      moment[2],      half[0] * w[0],
          half[1] * w[1],  half[2] * w[2], -(w[0] * w[1]), -(w[0] * w[2]), -(w[1] * w[2])};
}

}  // namespace

Program energy_regressor(
    const model::KinematicTree& tree,
    const std::string& name,
    Loads loads,
    const RepresentativeLinks& representative) {
  Trace trace(tree);
  const StateInputs in(trace, {State::position, State::velocity, State::base_velocity});
  const LoadInputs load(trace, loads);
  const TracedRobot robot(trace, in.q, representative);
  const int first = first_moving_link(tree);
  std::vector<Expression> Y(at(2 * inertial_parameter_count(tree)));
  const std::function<void(int, const Motion&, const LinkGravity&)> visit = [&](int link, const Motion& twist,
                                                                                const LinkGravity& of_link) {
    if (link >= first && !tree.links[at(link)].is_repeated) {
      const std::array<Expression, kParametersOfLink> of_twist = kinetic(twist);
      std::size_t place = at(2 * kParametersOfLink * (link - first));
      for (std::size_t p = 0; p < of_twist.size(); ++p, place += 2) Y[place] = of_twist[p];
      place = at(2 * kParametersOfLink * (link - first)) + 1;
      Y[place] = -of_link.height;
      for (std::size_t i = 0; i < 3; ++i) Y[place + 2 * (i + 1)] = -of_link.gravity[i];
    }
    for (const Joint& joint : robot.children(link)) {
      const std::string& child = robot.link_name(joint.child);
      trace.section(child, "link ", ": velocity, gravity and energies");
      const Pose& X_PC = robot.pose(joint.index);
      const Motion moved = named(child, across_joint(joint, X_PC, twist, in.qd));
      const LinkGravity of_child = to_child(X_PC, of_link);
      described("g", child, of_child.gravity);
      described("height", child, of_child.height);
      visit(joint.child, moved, of_child);
    }
  };
  visit(0, in.base_velocity, {load.gravity, Expression()});
  trace.output("Y", Role::matrix, 2, inertial_parameter_count(tree), Y);
  return trace.program(name);
}

}  // namespace robcogen::algorithm
