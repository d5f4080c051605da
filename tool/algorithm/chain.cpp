#include "algorithm/chain.h"

#include <stdexcept>

#include "model/rigid_motions.h"

namespace robcogen::algorithm {
namespace {

using model::PrimitiveTransform;

std::optional<Motor> motor_of(const PrimitiveTransform& primitive) {
  const model::Quantity& amount = primitive.amount;
  if (amount.op() == model::Quantity::Op::variable) return Motor{amount.index(), false, primitive.rotation};
  if (amount.op() == model::Quantity::Op::negate && amount.left().op() == model::Quantity::Op::variable)
    return Motor{amount.left().index(), true, primitive.rotation};
  return std::nullopt;
}

}  // namespace

std::vector<Stretch> chain(const model::KinematicTree& tree, const model::FramePair& frames) {
  const model::RigidMotions motions = model::motions_of(tree);
  return chain(tree, model::MotionGraph(motions), frames);
}

std::vector<Stretch> chain(
    const model::KinematicTree& tree,
    const model::MotionGraph& motions,
    const model::FramePair& frames) {
  const auto transform = motions.transform_between(frames.left.name, frames.right.name);
  if (!transform) throw std::logic_error("the motions of a robot do not connect its frames");
  std::vector<Stretch> way(1);
  for (const PrimitiveTransform& primitive : transform->primitives) {
    way.back().primitives.push_back(primitive);
    way.back().motor = motor_of(primitive);
    if (!way.back().motor) continue;
    way.back().subject = tree.joints[static_cast<std::size_t>(way.back().motor->joint)].name;
    way.back().passed = "joint " + way.back().subject;
    way.emplace_back();
  }
  return way;
}

int behind_last_turn(const std::vector<Stretch>& way) {
  int number = 0;
  for (std::size_t i = 0; i < way.size(); ++i)
    for (const PrimitiveTransform& primitive : way[i].primitives)
      if (primitive.rotation) number = static_cast<int>(i);
  const std::vector<PrimitiveTransform>& last = way[static_cast<std::size_t>(number)].primitives;
  const bool ends_by_turning = !last.empty() && last.back().rotation;
  return ends_by_turning && static_cast<std::size_t>(number) + 1 < way.size() ? number + 1 : number;
}

Pose pose_of(ProgramTrace& trace, const Stretch& stretch, const std::vector<Expression>& variables) {
  if (stretch.subject.empty())
    trace.section("end", "to the last frame");
  else
    trace.section(stretch.subject, "past " + stretch.passed);
  return pose_of(trace, stretch.primitives, variables);
}

Reached walk(
    ProgramTrace& trace,
    const std::vector<Stretch>& way,
    const std::vector<Expression>& variables,
    const std::function<void(const Stretch&, const Reached&)>& behind,
    int moment_from) {
  Reached here = start(trace.graph, moment_from);
  for (const Stretch& stretch : way) {
    advance(here, pose_of(trace, stretch, variables));
    if (stretch.subject.empty()) continue;
    behind(stretch, here);
    name_reached(trace.graph, here, stretch.subject);
  }
  return here;
}

symbolic::Program transform_along(
    const model::KinematicTree& tree,
    const std::vector<Stretch>& way,
    TransformForm form,
    const std::string& name) {
  return cheapest_transform(form, behind_last_turn(way), [&](int moment_from) {
    Trace trace(tree);
    const auto q = trace.joint_input("q", symbolic::Role::joint_position);
    output_transform(trace, way, q, form, moment_from);
    return trace.program(name);
  });
}

void output_transform(
    ProgramTrace& trace,
    const std::vector<Stretch>& way,
    const std::vector<Expression>& variables,
    TransformForm form,
    int moment_from) {
  const auto nothing = [](const Stretch&, const Reached&) {};
  output_transform(trace, walk(trace, way, variables, nothing, moment_from), form);
}

}  // namespace robcogen::algorithm
