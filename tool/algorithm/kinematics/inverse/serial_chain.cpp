#include "algorithm/kinematics/inverse/serial_chain.h"

#include <algorithm>
#include <cmath>

#include "algorithm/kinematics/path.h"

namespace robcogen::algorithm::inversion {
namespace {

using model::PrimitiveTransform;

constexpr NumberMatrix kIdentity = {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};

double snapped(double x) {
  constexpr double kRounding = 1e-13;
  static const double known[] = {0.0, 1.0, 0.5, std::sqrt(0.5), std::sqrt(0.75)};
  for (const double value : known)
    if (std::abs(std::abs(x) - value) < kRounding) return std::copysign(value, value == 0.0 ? 1.0 : x);
  return x;
}

// Rotation about a unit axis (Rodrigues).
Numbers3 turned(const Numbers3& v, const Numbers3& h, const SineCosine& a) {
  return a.cosine * v + a.sine * cross(h, v) + ((1.0 - a.cosine) * dot(h, v)) * h;
}

void move(NumberPose& here, const PrimitiveTransform& primitive, std::span<const double> parameter_values) {
  const auto axis = static_cast<std::size_t>(primitive.axis);
  const double amount = model::evaluate(primitive.amount, parameter_values);
  if (!primitive.rotation) {
    here.position = here.position + amount * here.rotation[axis];
    return;
  }
  // Exact for multiples of a quarter turn.
  const SineCosine angle = {
      model::evaluate(sin(primitive.amount), parameter_values),
      model::evaluate(cos(primitive.amount), parameter_values)};
  // Only the columns across the axis: otherwise, each rotation triples the error of its length.
  Numbers3 &a = here.rotation[(axis + 1) % 3], &b = here.rotation[(axis + 2) % 3];
  const Numbers3 last = a;
  a = angle.cosine * a + angle.sine * b;
  b = angle.cosine * b - angle.sine * last;
}

bool depends_on_parameters(const PrimitiveTransform& primitive) {
  return !model::parameters_of(primitive.amount).empty();
}

// What the last amounts do along the axis of the tool, and about it, commutes with the freedom of the task.
void take_tool_slides(SerialChain& chain) {
  const Numbers3 axis = folded(chain.rotation[2]);
  for (int k = chain.size(); k-- > 0 && chain.is_parametric(k);) {
    const ChainAxis& last = chain.axis(k);
    const bool is_along = are_parallel(last.direction, axis);
    if (last.turns && !(is_along && norm(cross(last.point - chain.position, axis)) < chain.same_point)) return;
    if (!is_along) continue;
    if (!last.turns) chain.tool_slides.push_back({last.amount, dot(last.direction, axis) < 0.0 ? -1.0 : 1.0});
    chain.axes.erase(chain.axes.begin() + k);
  }
}

void add_freedoms(SerialChain& chain) {
  const auto add = [&](bool turns, const Numbers3& direction) {
    chain.axes.push_back(
        {-1, turns, direction, chain.position, "free" + std::to_string(chain.size() - chain.joints + 1)});
  };
  switch (chain.task.kind) {
    case model::InverseTask::Kind::pose:
      break;
    case model::InverseTask::Kind::point:
      for (const Numbers3& e : kIdentity) add(true, e);
      break;
    case model::InverseTask::Kind::axis:
      add(true, folded(chain.rotation[2]));
      break;
    case model::InverseTask::Kind::orientation:
      for (const Numbers3& e : kIdentity) add(false, e);
      break;
  }
}

}  // namespace

Numbers3 operator+(const Numbers3& a, const Numbers3& b) {
  return {a[0] + b[0], a[1] + b[1], a[2] + b[2]};
}

Numbers3 operator*(double k, const Numbers3& a) {
  return {k * a[0], k * a[1], k * a[2]};
}

Numbers3 operator*(const NumberMatrix& columns, const Numbers3& a) {
  return a[0] * columns[0] + a[1] * columns[1] + a[2] * columns[2];
}

Numbers3 folded(const Numbers3& direction) {
  return {snapped(direction[0]), snapped(direction[1]), snapped(direction[2])};
}

Numbers3 without_rounding(const SerialChain& chain, Numbers3 x) {
  constexpr double kRounding = 1e-13 / kSameDirection;
  for (double& element : x)
    if (std::abs(element) < kRounding * chain.same_point) element = 0.0;
  return x;
}

bool are_parallel(const Numbers3& a, const Numbers3& b) {
  return norm(cross(a, b)) < kSameDirection;
}

std::string obstacle(const model::KinematicTree& tree, const model::FramePair& frames) {
  std::vector<int> passed;
  for (const PathSegment& segment : path_between(tree, frames)) {
    for (const JointOnPath& on_path : segment.joints) {
      const model::Joint& joint = tree.joints[at(on_path.joint)];
      const std::string name = "joint '" + joint.declared_name() + "'";
      if (joint.type == model::JointType::helical) return name + " is helical";
      if (joint.type == model::JointType::spherical) return name + " is spherical";
      if (tree.coupling_of(on_path.joint)) return name + " follows other joints";
      passed.push_back(on_path.joint);
    }
  }
  return passed.empty() ? "no joint is between them" : "";
}

SerialChain serial_chain(
    const model::KinematicTree& tree,
    const model::FramePair& frames,
    const model::InverseTask& task,
    std::span<const double> parameter_values) {
  SerialChain chain;
  chain.task = task;
  NumberPose here{kIdentity, {}};
  int amounts = 0;
  for (const PathSegment& segment : path_between(tree, frames)) {
    const std::size_t constant = segment.primitives.size() - segment.joints.size();
    for (std::size_t k = 0; k < constant; ++k) {
      const PrimitiveTransform& primitive = segment.primitives[k];
      if (parameter_values.empty() && depends_on_parameters(primitive))
        chain.axes.push_back(
            {-1, primitive.rotation, folded(here.rotation[static_cast<std::size_t>(primitive.axis)]), here.position,
             print(primitive.amount, tree.parameters), amounts++});
      else
        move(here, primitive, parameter_values);
    }
    for (const auto& [joint, backward] : segment.joints) {
      if (joint == task.given) chain.given = chain.size();
      chain.axes.push_back(
          {joint, model::turns(tree.joints[at(joint)].type),
           folded(backward ? -1.0 * here.rotation[2] : here.rotation[2]), here.position,
           tree.joints[at(joint)].declared_name()});
    }
  }
  for (std::size_t k = 0; k < 3; ++k) chain.rotation[k] = folded(here.rotation[k]);
  chain.position = here.position;
  if (task.kind == model::InverseTask::Kind::axis) take_tool_slides(chain);
  chain.joints = chain.size();
  double reach = norm(chain.position - chain.axes.back().point);
  for (std::size_t k = 1; k < chain.axes.size(); ++k) reach += norm(chain.axes[k].point - chain.axes[k - 1].point);
  chain.same_point *= std::max(reach, 1.0);
  // The point of an axis that is nearest to the origin has few elements other than zero.
  for (ChainAxis& axis : chain.axes)
    axis.point = without_rounding(chain, axis.point - dot(axis.direction, axis.point) * axis.direction);
  add_freedoms(chain);
  return chain;
}

bool SerialChain::has_parameters() const {
  return std::any_of(axes.begin(), axes.end(), [](const ChainAxis& axis) { return axis.amount >= 0; });
}

std::vector<model::Quantity> parametric_amounts(const model::KinematicTree& tree, const model::FramePair& frames) {
  std::vector<model::Quantity> amounts;
  for (const PathSegment& segment : path_between(tree, frames))
    for (const PrimitiveTransform& primitive : segment.primitives)
      if (depends_on_parameters(primitive)) amounts.push_back(primitive.amount);
  return amounts;
}

SerialChain orientation_chain(const SerialChain& chain, int begin, int end) {
  SerialChain part = chain;
  part.axes.assign(chain.axes.begin() + begin, chain.axes.begin() + end);
  part.joints = end - begin;
  part.rotation = kIdentity;
  part.position = {};
  part.task = {model::InverseTask::Kind::orientation};
  part.given = -1;
  add_freedoms(part);
  return part;
}

NumberPose pose(const SerialChain& chain, const std::vector<SineCosine>& joints) {
  NumberPose result{chain.rotation, chain.position};
  for (int k = chain.joints; k-- > 0;) {
    const ChainAxis& axis = chain.axis(k);
    const SineCosine& joint = joints[at(k)];
    if (!axis.turns) {
      result.position = result.position + joint.sine * axis.direction;
      continue;
    }
    for (Numbers3& column : result.rotation) column = turned(column, axis.direction, joint);
    result.position = axis.point + turned(result.position - axis.point, axis.direction, joint);
  }
  return result;
}

double task_error(const SerialChain& chain, const NumberPose& a, const NumberPose& b) {
  const double displacement = norm(a.position - b.position);
  if (chain.task.kind == model::InverseTask::Kind::point) return displacement;
  if (chain.task.kind == model::InverseTask::Kind::axis)
    return std::max(displacement, norm(a.rotation[2] - b.rotation[2]));
  double square = 0.0;
  for (std::size_t k = 0; k < 3; ++k) square += dot(a.rotation[k] - b.rotation[k], a.rotation[k] - b.rotation[k]);
  const double turn = std::sqrt(square / 2.0);
  return chain.task.kind == model::InverseTask::Kind::orientation ? turn : std::max(displacement, turn);
}

}  // namespace robcogen::algorithm::inversion
