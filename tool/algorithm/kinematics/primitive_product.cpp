#include "algorithm/kinematics/primitive_product.h"

#include <stdexcept>

#include "algorithm/spatial/trace.h"

namespace robcogen::algorithm {

PrimitiveProduct primitive_product(
    const model::KinematicTree& tree,
    const model::FramePair& frames,
    model::MovedFramePosition position) {
  const auto transform =
      model::transform_between(model::motions_of(tree), frames.left.name, frames.right.name, position);
  if (!transform) throw std::logic_error("the motions of a robot do not connect its frames");
  Trace trace(tree);
  const auto q = trace.joint_input("q", symbolic::Role::joint_position);
  std::vector<Expression> amounts;
  for (const model::PrimitiveTransform& primitive : transform->primitives)
    amounts.push_back(trace.lift(primitive.amount, q));
  trace.output("amounts", symbolic::Role::value, amounts);
  return {transform->primitives, trace.program("amounts_" + frames.left.name + "_X_" + frames.right.name)};
}

}  // namespace robcogen::algorithm
