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
  const auto transform = model::transform_between(model::motions_of(tree), frames.left.name, frames.right.name);
  if (!transform) throw std::logic_error("the motions of a robot do not connect its frames");
  std::vector<Stretch> stretches(1);
  for (const PrimitiveTransform& primitive : transform->primitives) {
    stretches.back().primitives.push_back(primitive);
    stretches.back().motor = motor_of(primitive);
    if (stretches.back().motor) stretches.emplace_back();
  }
  return stretches;
}

Pose pose_of(Trace& trace, const Stretch& stretch, const std::vector<Expression>& q) {
  if (stretch.motor) {
    const std::string& joint = trace.tree.joints[static_cast<std::size_t>(stretch.motor->joint)].name;
    trace.section(joint, "past joint " + joint);
  } else {
    trace.section("end", "to the last frame");
  }
  return pose_of(trace, stretch.primitives, q);
}

Reached walk(
    Trace& trace,
    const std::vector<Stretch>& chain,
    const std::vector<Expression>& q,
    const std::function<void(const Motor&, const Reached&)>& at_joint,
    int moment_from) {
  Reached here = start(trace.graph, moment_from);
  for (const Stretch& stretch : chain) {
    advance(here, pose_of(trace, stretch, q));
    if (!stretch.motor) continue;
    at_joint(*stretch.motor, here);
    name_reached(trace.graph, here, trace.tree.joints[static_cast<std::size_t>(stretch.motor->joint)].name);
  }
  return here;
}

}  // namespace robcogen::algorithm
