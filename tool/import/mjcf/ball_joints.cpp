// Ball joints that move loops become three hinges, because the model has no spherical joints in loops.
#include <fmt/format.h>

#include <cmath>
#include <utility>

#include "import/mjcf/anchors.h"
#include "import/mjcf/read.h"
#include "import/mjcf/vector3.h"
#include "support/index.h"

namespace robcogen::import::from_mjcf {

namespace {

using Axes = std::array<Vector3, 3>;

Vector3 vector_of(const std::array<model::Quantity, 3>& quantities) {
  Vector3 result;
  for (std::size_t i = 0; i < 3; ++i) result[i] = model::evaluate(quantities[i]);
  return result;
}

Pose pose_of_ball(const Joint& joint) {
  return {(joint.frame * Pose{quantities(joint.pos), {}}).translation, {}};
}

// Right-handed orthogonal axes, in the frame of the body. The last one points to the anchor: the links of a rod spin
// about it, which moves no loop. The hinges are singular where the second is at a right angle.
Axes axes_towards(const Vector3& direction) {
  constexpr double kAlong = 1e-9;
  const double length = std::sqrt(dot(direction, direction));
  std::size_t largest = 0;
  for (std::size_t i = 1; i < 3; ++i)
    if (std::abs(direction[i]) > std::abs(direction[largest])) largest = i;
  Axes unit = {};
  for (std::size_t i = 0; i < 3; ++i) unit[i][i] = 1.0;
  // Along an axis of the body, the axes are those of the body.
  const double across = std::hypot(direction[(largest + 1) % 3], direction[(largest + 2) % 3]);
  if (across <= kAlong * length) return {unit[(largest + 1) % 3], unit[(largest + 2) % 3], unit[largest]};
  Vector3 last = direction;
  for (double& element : last) element /= length;
  Vector3 second = cross(last, unit[(largest + 1) % 3]);
  const double norm = std::sqrt(dot(second, second));
  for (double& element : second) element /= norm;
  return {cross(second, last), second, last};
}

// The angles of R = Rx Ry Rz in these axes.
std::vector<double> angles_of(const std::vector<double>& q, const Axes& axes) {
  const double n = std::sqrt(q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3]);
  if (n == 0.0) return {};
  const double w = q[0] / n;
  const Vector3 v = {q[1] / n, q[2] / n, q[3] / n};
  const auto turned = [&](const Vector3& a) {
    const Vector3 once = cross(v, a), twice = cross(v, once);
    return Vector3{
        a[0] + 2 * (w * once[0] + twice[0]), a[1] + 2 * (w * once[1] + twice[1]), a[2] + 2 * (w * once[2] + twice[2])};
  };
  const auto element = [&](std::size_t row, std::size_t column) { return dot(axes[row], turned(axes[column])); };
  return {
      std::atan2(-element(1, 2), element(2, 2)), std::atan2(element(0, 2), std::hypot(element(1, 2), element(2, 2))),
      std::atan2(-element(0, 1), element(0, 0))};
}

class Splitter {
 public:
  Splitter(Document& document, Diagnostics& diagnostics) : document_(document), diagnostics_(diagnostics) {}

  void run() {
    for (const Loop& loop : document_.loops) {
      const std::size_t ancestor = common_ancestor(document_, loop.ends[0].body, loop.ends[1].body);
      for (const Anchor& end : loop.ends)
        for (const std::size_t b : path(document_, end.body, ancestor)) split(b, end, loop);
    }
  }

 private:
  Document& document_;
  Diagnostics& diagnostics_;

  void split(std::size_t b, const Anchor& end, const Loop& loop) {
    std::vector<Joint>& joints = document_.bodies[b].joints;
    for (std::size_t j = 0; j < joints.size(); ++j) {
      if (joints[j].type != model::JointType::spherical) continue;
      const Joint ball = joints[j];
      const Vector3 center = vector_of(pose_of_ball(ball).translation);
      const bool is_rod = end.body == b && j + 1 == joints.size();
      const Vector3 direction = is_rod ? vector_of(end.pose.translation) - center : Vector3{0.0, 0.0, 1.0};
      mention(ball, loop);
      joints.erase(joints.begin() + static_cast<std::ptrdiff_t>(j));
      const bool is_centered = dot(direction, direction) == 0.0;
      const std::vector<Joint> hinges = hinges_of(ball, axes_towards(is_centered ? Vector3{0.0, 0.0, 1.0} : direction));
      joints.insert(joints.begin() + static_cast<std::ptrdiff_t>(j), hinges.begin(), hinges.end());
      j += 2;
    }
  }

  std::vector<Joint> hinges_of(const Joint& ball, const Axes& axes) {
    const std::vector<double> angles = ball.key.size() == 4 ? angles_of(ball.key, axes) : std::vector<double>();
    std::vector<Joint> hinges;
    for (std::size_t i = 0; i < 3; ++i) {
      Joint hinge = ball;
      hinge.type = model::JointType::revolute;
      if (!ball.name.text.empty()) hinge.name.text += fmt::format("_{}", i + 1);
      if (!ball.written.text.empty()) hinge.written.text += fmt::format("_{}", i + 1);
      hinge.frame = pose_of_ball(ball);
      hinge.pos = {};
      for (std::size_t k = 0; k < 3; ++k) hinge.axis[k] = Number(axes[i][k]);
      hinge.key.clear();
      if (!angles.empty()) hinge.key = {angles[i]};
      hinges.push_back(std::move(hinge));
    }
    return hinges;
  }

  void mention(const Joint& ball, const Loop& loop) {
    const bool has_drive = !ball.drive.damping.is_zero() || !ball.drive.armature.is_zero();
    diagnostics_.note(
        "ball-in-loop", ball.name.place,
        fmt::format(
            "this ball joint moves loop '{}' and becomes three hinges; they have no inverse where the second is at a "
            "right angle{}",
            loop.name, has_drive ? ", and its damping and armature act on each of them" : ""));
  }
};

}  // namespace

void split_ball_joints(Document& document, Diagnostics& diagnostics) {
  Splitter(document, diagnostics).run();
}

}  // namespace robcogen::import::from_mjcf
