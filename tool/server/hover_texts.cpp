#include "server/hover_texts.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "model/coordinate_transforms.h"
#include "support/number.h"

namespace robcogen::server {
namespace {

// Prints six digits, and 0 for values that are rounding noise.
std::string text_of_number(double value) {
  if (std::isnan(value)) return "?";
  return fmt::format("{:.6g}", std::abs(value) < 1e-12 ? 0.0 : value);
}

std::string text_of_vector(const Vector3& v) {
  return fmt::format("({}, {}, {})", text_of_number(v[0]), text_of_number(v[1]), text_of_number(v[2]));
}

std::string text_of_degrees(const Vector3& radians) {
  constexpr double kDegrees = 180.0 / std::numbers::pi;
  return text_of_vector({radians[0] * kDegrees, radians[1] * kDegrees, radians[2] * kDegrees});
}

// Prints a motion as in a document: `rotz(swing) trx(slide + 1.5)`.
std::string text_of_motion(const model::CoordinateTransform& transform, const model::RigidMotions& motions) {
  std::string text;
  for (const model::PrimitiveTransform& p : transform.primitives) {
    text += fmt::format("{}{}", text.empty() ? "" : " ", p.rotation ? "rot" : "tr");
    text += p.quaternion.empty() ? fmt::format(
                                       "{}({})", "xyz"[static_cast<std::size_t>(p.axis)],
                                       model::print(p.amount, motions.parameters, motions.variables))
                                 : "(quaternion)";
  }
  return text;
}

}  // namespace

std::string RobotText::unknown_parameters() const {
  for (const model::Parameter& p : tree_.parameters)
    if (!p.default_value) return "\n- ? depends on parameters without a default";
  return "";
}

std::string RobotText::link(int l) const {
  const model::Link& link = tree_.links[static_cast<std::size_t>(l)];
  std::string text = fmt::format("**link** `{}`", link.name);
  if (link.parent_joint >= 0) {
    // The child of a spherical joint is repeated between its components.
    int parent = link.parent_joint;
    while (tree_.links[static_cast<std::size_t>(tree_.joints[static_cast<std::size_t>(parent)].parent)].is_repeated)
      parent = tree_.parent_joint_of(parent);
    const model::Joint& joint = tree_.joints[static_cast<std::size_t>(parent)];
    text += fmt::format(
        ", child of `{}` via `{}`", tree_.links[static_cast<std::size_t>(joint.parent)].name, joint.declared_name());
  } else {
    text += tree_.floating_base ? ", the floating base" : ", the base";
  }
  if (link.inertia) {
    text += fmt::format("\n\n- mass {} kg", text_of_number(resting_.mass(l)));
    text += fmt::format("\n- centre of mass {} m, in the link frame", text_of_vector(resting_.com(l)));
    text += fmt::format(
        "\n- principal moments {} kg m², about the centre of mass", text_of_vector(resting_.principal_moments(l)));
  } else {
    text += "\n\n- massless";
  }
  const Carried& carried = resting_.carried(l);
  if (carried.mass != 0.0 && !link.child_joints.empty())
    text += fmt::format(
        "\n- with all it carries: {} kg, centre of mass {} m {}", text_of_number(carried.mass),
        text_of_vector(carried.com), in_base());
  return text + unknown_parameters();
}

std::string RobotText::joint(int j) const {
  const model::Joint& joint = tree_.joints[static_cast<std::size_t>(j)];
  const char* type = joint.type == model::JointType::revolute    ? "revolute"
                     : joint.type == model::JointType::prismatic ? "prismatic"
                     : joint.type == model::JointType::helical   ? "helical"
                                                                 : "spherical";
  const bool turns = model::turns(joint.type);
  std::string text = fmt::format(
      "**{} joint** `{}`, from `{}` to `{}`\n\n", type, joint.declared_name(),
      tree_.links[static_cast<std::size_t>(joint.parent)].name,
      tree_.links[static_cast<std::size_t>(joint.child)].name);
  text += joint.type == model::JointType::spherical
              ? "- turns in any way about the origin of its frame"
              : fmt::format("- axis {} {}", text_of_vector(resting_.axis(j)), in_base());
  if (joint.type == model::JointType::helical)
    text += fmt::format("\n- pitch {} m/rad", text_of_number(resting_.value(joint.pitch)));
  const model::JointLimits& limits = joint.limits;
  if (std::isfinite(limits.lower) || std::isfinite(limits.upper))
    text += fmt::format(
        "\n- limits {} to {} {}", text_of_number(limits.lower), text_of_number(limits.upper), turns ? "rad" : "m");
  if (std::isfinite(limits.velocity))
    text += fmt::format("\n- velocity up to {} {}", text_of_number(limits.velocity), turns ? "rad/s" : "m/s");
  if (std::isfinite(limits.effort))
    text += fmt::format("\n- effort up to {} {}", text_of_number(limits.effort), turns ? "N m" : "N");
  if (tree_.coupling_of(j) != nullptr)
    text += tree_.coupling_of(j)->is_linear() ? "\n- coupled to other joints: no coordinate of its own"
                                              : "\n- follows through a loop: no coordinate of its own";
  return text + unknown_parameters();
}

std::string RobotText::loop(std::size_t l) const {
  const model::LoopJoint& loop = tree_.loops[l];
  std::string text =
      fmt::format("**loop** `{}`, {}", loop.name, model::kLoopTypes[static_cast<std::size_t>(loop.type)]);
  if (loop.type == model::LoopType::distance) text += fmt::format(" {} m", text_of_number(resting_.value(loop.length)));
  const char* separator = "\n\n- frame";
  for (const model::LoopEnd& end : loop.ends) {
    const std::string& link = tree_.links[static_cast<std::size_t>(end.link)].name;
    text += fmt::format("{} `{}` of link `{}`", std::exchange(separator, " and"), end.frame, link);
  }
  for (const model::Closure& closure : tree_.closures) {
    if (std::find(closure.loops.begin(), closure.loops.end(), static_cast<int>(l)) == closure.loops.end()) continue;
    for (const int j : closure.dependents)
      text += fmt::format("\n- `{}` follows", tree_.joints[static_cast<std::size_t>(j)].declared_name());
  }
  return text + unknown_parameters();
}

std::string RobotText::frame(const model::Frame& frame) const {
  const Pose pose = resting_.frame(frame);
  const std::string& link = tree_.links[static_cast<std::size_t>(tree_.link_of(frame))].name;
  return fmt::format(
             "**frame** `{}` of link `{}`\n\n- origin {} m {}\n- rotation {}° about x, y', z''", frame.name, link,
             text_of_vector(pose.translation), in_base(), text_of_degrees(angles_of(pose))) +
         unknown_parameters();
}

std::string RobotText::in_base() const {
  const bool is_elsewhere = std::any_of(tree_.joints.begin(), tree_.joints.end(), [](const model::Joint& joint) {
    return joint.assembled_position() != 0.0;
  });
  return is_elsewhere ? "in the base, where loops are assembled" : "in the base at q = 0";
}

std::string text_of_frame(const model::RigidMotions& motions, const std::string& frame) {
  const model::MotionGraph graph(motions);
  for (const model::Motion& motion : motions.motions) {
    const std::string& first = motion.from;
    const auto path = graph.transform_between(first, frame);
    if (!path) continue;
    const std::string start = fmt::format("**frame** `{}` of model `{}`", frame, motions.name);
    if (frame == first) return start;
    const Pose pose = pose_of(*path, motions);
    return start + fmt::format(
                       "\n\n- origin {0} m in `{1}` where variables are zero\n- rotation {2}° about x, y', z''\n"
                       "- from `{1}`: {3}",
                       text_of_vector(pose.translation), first, text_of_degrees(angles_of(pose)),
                       text_of_motion(*path, motions));
  }
  return "";
}

std::string text_of(const model::Parameter& p) {
  const char* kind = p.kind == model::ParameterKind::length  ? "a length (m)"
                     : p.kind == model::ParameterKind::angle ? "an angle (rad)"
                     : p.kind == model::ParameterKind::ratio ? "a ratio"
                                                             : "a mass or drive property";
  return fmt::format(
      "**parameter** `{}`, {}{}\n\n- default {}", p.name, kind, p.is_in_masses_too ? ", in mass properties too" : "",
      p.default_value ? print_double(*p.default_value) : "none");
}

}  // namespace robcogen::server
