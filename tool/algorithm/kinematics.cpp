#include "algorithm/kinematics.h"

#include <optional>
#include <stdexcept>

#include "algorithm/geometry.h"

namespace robcogen::algorithm {
namespace {

using model::PrimitiveTransform;
using symbolic::Program;
using symbolic::Role;

std::vector<PrimitiveTransform> chain(const model::KinematicTree& tree, const model::FramePair& frames) {
  const auto transform = model::transform_between(model::motions_of(tree), frames.left.name, frames.right.name);
  if (!transform) throw std::logic_error("the motions of a robot do not connect its frames");
  return transform->primitives;
}

// A primitive that a joint moves, and which way: the chain passes the joint from parent to child, or back.
struct Motor {
  int joint;
  bool backward;
};

std::optional<Motor> motor_of(const PrimitiveTransform& primitive) {
  const model::Quantity& amount = primitive.amount;
  if (amount.op() == model::Quantity::Op::variable) return Motor{amount.index(), false};
  if (amount.op() == model::Quantity::Op::negate && amount.left().op() == model::Quantity::Op::variable)
    return Motor{amount.left().index(), true};
  return std::nullopt;
}

// Where a chain has got to: R and p of the frame reached, in the first frame.
struct Reached {
  Matrix3 rotation;
  Vector3 position;
};

Vector3 column(const Matrix3& m, std::size_t k) {
  return {m[0][k], m[1][k], m[2][k]};
}

void turn(Matrix3& m, const PlaneRotation& plane) {
  const auto i = static_cast<std::size_t>((plane.axis + 1) % 3), j = static_cast<std::size_t>((plane.axis + 2) % 3);
  for (std::size_t r = 0; r < 3; ++r) {
    const Expression a = m[r][i], b = m[r][j];
    m[r][i] = sum_of_products(plane.c, a, plane.s, b);
    m[r][j] = difference_of_products(plane.c, b, plane.s, a);
  }
}

void turn(Matrix3& m, const QuarterTurns& quarter) {
  const Matrix3 before = m;
  for (std::size_t r = 0; r < 3; ++r)
    for (std::size_t k = 0; k < 3; ++k) {
      const Expression& e = before[r][k];
      m[r][static_cast<std::size_t>(quarter.image[k])] = quarter.sign[k] < 0 ? -e : e;
    }
}

// Walks a chain, stretch by stretch: a stretch ends with the primitive that a joint moves, so that constant turns merge
// with the joint's and each joint costs one sine and cosine.
class Walk {
 public:
  Walk(Trace& trace, const std::vector<Expression>& q) : trace_(trace), q_(q) {
    for (std::size_t i = 0; i < 3; ++i) here.rotation[i][i] = trace.graph.one();
  }

  // Calls at_joint(motor, primitive) with `here` in front of the joint's own motion.
  template <class AtJoint>
  void along(const std::vector<PrimitiveTransform>& primitives, AtJoint at_joint) {
    std::vector<PrimitiveTransform> stretch;
    for (const PrimitiveTransform& primitive : primitives) {
      stretch.push_back(primitive);
      const std::optional<Motor> motor = motor_of(primitive);
      if (!motor) continue;
      const model::Joint& joint = trace_.tree.joints[static_cast<std::size_t>(motor->joint)];
      trace_.section(joint.name, "past joint " + joint.name);
      advance(stretch);
      at_joint(*motor, primitive);
      name_here(joint.name);
      stretch.clear();
    }
    trace_.section("end", "to the last frame");
    advance(stretch);
  }

  Reached here;

 private:
  Trace& trace_;
  const std::vector<Expression>& q_;

  void advance(const std::vector<PrimitiveTransform>& stretch) {
    const Pose pose = pose_of(trace_, stretch, q_);
    here.position += multiply(here.rotation, pose.offset);
    turn(here.rotation, pose.rotation.quarter);
    for (const PlaneRotation& plane : pose.rotation.planes) turn(here.rotation, plane);
    here.position += pose.slide * column(here.rotation, 2);
  }

  void name_here(const std::string& joint) {
    const char* axes = "xyz";
    for (std::size_t r = 0; r < 3; ++r)
      for (std::size_t c = 0; c < 3; ++c) trace_.graph.name(here.rotation[r][c], joint + "_R" + axes[r] + axes[c]);
    algorithm::name(trace_.graph, here.position, joint + "_p");
  }
};

std::vector<Expression> by_columns(const std::vector<std::vector<Expression>>& rows) {
  std::vector<Expression> values;
  for (std::size_t c = 0; c < rows.front().size(); ++c)
    for (const std::vector<Expression>& row : rows) values.push_back(row[c]);
  return values;
}

std::vector<Expression> homogeneous(Trace& trace, const Reached& x) {
  std::vector<std::vector<Expression>> rows(4, std::vector<Expression>(4));
  for (std::size_t r = 0; r < 3; ++r) {
    for (std::size_t c = 0; c < 3; ++c) rows[r][c] = x.rotation[r][c];
    rows[r][3] = x.position[r];
  }
  rows[3][3] = trace.graph.one();
  return by_columns(rows);
}

// [p]x R stands below the diagonal of the motion form, above that of the force form.
std::vector<Expression> spatial(const Reached& x, bool motion) {
  std::vector<std::vector<Expression>> rows(6, std::vector<Expression>(6));
  for (std::size_t c = 0; c < 3; ++c) {
    const Vector3 r = column(x.rotation, c), moment = cross(x.position, r);
    for (std::size_t k = 0; k < 3; ++k) {
      rows[k][c] = rows[3 + k][3 + c] = r[k];
      (motion ? rows[3 + k][c] : rows[k][3 + c]) = moment[k];
    }
  }
  return by_columns(rows);
}

}  // namespace

Program coordinate_transform(
    const model::KinematicTree& tree,
    const model::FramePair& frames,
    TransformForm form,
    const std::string& name) {
  Trace trace(tree);
  const auto q = trace.joint_input("q", Role::joint_position);
  Walk walk(trace, q);
  walk.along(chain(tree, frames), [](const Motor&, const PrimitiveTransform&) {});
  switch (form) {
    case TransformForm::homogeneous:
      trace.output("X", Role::homogeneous, 4, 4, homogeneous(trace, walk.here));
      break;
    case TransformForm::spatial_motion:
      trace.output("X", Role::spatial_motion, 6, 6, spatial(walk.here, true));
      break;
    case TransformForm::spatial_force:
      trace.output("X", Role::spatial_force, 6, 6, spatial(walk.here, false));
      break;
  }
  return trace.program(name);
}

Program geometric_jacobian(const model::KinematicTree& tree, const model::FramePair& frames, const std::string& name) {
  struct Axis {
    Vector3 direction;
    Vector3 point;
    bool revolute;
  };
  Trace trace(tree);
  const auto q = trace.joint_input("q", Role::joint_position);
  Walk walk(trace, q);
  std::vector<Axis> axes;
  walk.along(chain(tree, frames), [&](const Motor& motor, const PrimitiveTransform& primitive) {
    // Turning about an axis, or sliding along it, leaves the axis where it is.
    const Vector3 z = column(walk.here.rotation, 2);
    axes.push_back({motor.backward ? -z : z, walk.here.position, primitive.rotation});
  });
  std::vector<Expression> columns;
  for (std::size_t k = 0; k < axes.size(); ++k) {
    const Vector3 none;
    const Vector3 angular = axes[k].revolute ? axes[k].direction : none;
    const Vector3 linear =
        axes[k].revolute ? cross(axes[k].direction, walk.here.position - axes[k].point) : axes[k].direction;
    for (const Vector3& part : {angular, linear})
      for (std::size_t i = 0; i < 3; ++i) columns.push_back(part[i]);
  }
  trace.output("J", Role::jacobian, 6, static_cast<int>(axes.size()), columns);
  return trace.program(name);
}

std::vector<int> chain_joints(const model::KinematicTree& tree, const model::FramePair& frames) {
  std::vector<int> joints;
  for (const PrimitiveTransform& primitive : chain(tree, frames))
    if (const auto motor = motor_of(primitive)) joints.push_back(motor->joint);
  return joints;
}

}  // namespace robcogen::algorithm
