#include "algorithm/formulation/link_frames.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <string>

#include "algorithm/spatial/named.h"
#include "support/index.h"

namespace robcogen::algorithm {
namespace {

using model::Axis;
using model::Placement;
using model::PrimitiveTransform;
using model::Quantity;

// The rounding error of a sum that should be zero, relative to its terms.
constexpr double kRounding = 1e-14;

bool is_quarter_turn(const Quantity& angle) {
  if (!angle.is_constant()) return false;
  const Number& n = angle.number();
  return n.is_zero() || (n.is_pi_multiple() && 2 % n.ratio()->den == 0);
}

bool are_constant(const std::array<Quantity, 3>& q) {
  return std::all_of(q.begin(), q.end(), [](const Quantity& e) { return e.is_constant(); });
}

void append(std::vector<PrimitiveTransform>& list, bool rotation, Axis axis, const Quantity& amount) {
  if (!amount.is_zero()) list.push_back({rotation, axis, amount});
}

std::vector<PrimitiveTransform> primitives_of(
    const std::array<Quantity, 3>& translation,
    const std::array<Quantity, 3>& rotation) {
  std::vector<PrimitiveTransform> list;
  for (const Axis axis : {Axis::x, Axis::y, Axis::z})
    append(list, false, axis, translation[static_cast<std::size_t>(axis)]);
  for (const Axis axis : {Axis::x, Axis::y, Axis::z})
    append(list, true, axis, rotation[static_cast<std::size_t>(axis)]);
  return list;
}

// The split of a placement with quarter turns only: exact for any translation.
AxisPlacement split_at_right_angle(const Placement& placement, std::size_t axis, bool opposite) {
  std::array<Quantity, 3> rest = placement.translation;
  const Quantity along = opposite ? -rest[axis] : rest[axis];
  rest[axis] = Quantity();
  return {primitives_of(rest, placement.rotation), along};
}

// The split in the general case, in numbers: with z = R e_z and x the common normal, R = Rz(gamma) Rx(alpha) Rz(theta)
// and p = epsilon e_z + a x + d z (Khalil, Kleinfinger 1986, for trees).
AxisPlacement split_numerically(const Placement& placement, const std::array<std::array<double, 3>, 3>& r) {
  std::array<double, 3> p{};
  double size = 0.0;
  for (std::size_t i = 0; i < 3; ++i) {
    p[i] = placement.translation[i].number().value();
    size += std::abs(p[i]);
  }
  const double sine = std::hypot(r[0][2], r[1][2]), cosine = r[2][2];
  double x[2] = {-r[1][2] / sine, r[0][2] / sine};
  if (x[0] < 0 || (x[0] == 0 && x[1] < 0)) {
    x[0] = -x[0];
    x[1] = -x[1];
  }
  // z = sin(alpha) (x[1], -x[0]) + cos(alpha) e_z; the child's x axis is cos(theta) x + sin(theta) (z x x).
  const double signed_sine = r[0][2] * x[1] - r[1][2] * x[0];
  const double along_x = r[0][0] * x[0] + r[1][0] * x[1];
  const double across[3] = {-r[2][2] * x[1], r[2][2] * x[0], r[0][2] * x[1] - r[1][2] * x[0]};
  const double along_y = r[0][0] * across[0] + r[1][0] * across[1] + r[2][0] * across[2];
  const double normal = p[0] * x[0] + p[1] * x[1];
  const double d = (p[0] * x[1] - p[1] * x[0]) / signed_sine;
  const double epsilon = p[2] - d * cosine;
  const auto length = [&](double value) {
    return std::abs(value) <= kRounding * size / sine ? Quantity() : Quantity(value);
  };
  // A multiple of 90 degrees up to the rounding of this function becomes exact, because such turns are free. Angles of
  // the model that are only close to one are kept.
  const auto angle = [](double value) {
    constexpr double kQuarter = std::numbers::pi / 2, kRoundingOfQuarter = 4.5e-16;
    const double quarters = std::round(value / kQuarter);
    if (std::abs(value - quarters * kQuarter) > (quarters == 0.0 ? kRounding : kRoundingOfQuarter))
      return Quantity(value);
    return Quantity(Number::pi_multiple(static_cast<std::int64_t>(quarters), 2));
  };
  AxisPlacement result;
  append(result.to_axis, false, Axis::z, length(epsilon));
  append(result.to_axis, true, Axis::z, angle(std::atan2(x[1], x[0])));
  append(result.to_axis, false, Axis::x, length(normal));
  append(result.to_axis, true, Axis::x, angle(std::atan2(signed_sine, cosine)));
  append(result.to_axis, true, Axis::z, angle(std::atan2(along_y, along_x)));
  result.along = length(d);
  return result;
}

// Whether the path over the foot of the common normal is much longer than the placement's own offset, so that its parts
// cancel.
bool is_detour(const AxisPlacement& split, const Placement& placement) {
  constexpr double kMaxReach = 4.0;
  const auto magnitude = [](const Quantity& q) { return std::abs(q.number().value()); };
  double size = 0.0, longest = magnitude(split.along);
  for (const Quantity& q : placement.translation) size += magnitude(q);
  for (const PrimitiveTransform& p : split.to_axis)
    if (!p.rotation) longest = std::max(longest, magnitude(p.amount));
  return longest > kMaxReach * size;
}

// Rz(rho) * pose.
Pose turned(const PlaneRotation& rho, const Pose& pose) {
  Pose result = pose;
  result.offset = to_parent(Rotation{{}, {rho}}, pose.offset);
  // When it is moved behind the quarter turns Q, the turn is about Q' z.
  const QuarterTurns back = inverse(pose.rotation.quarter);
  PlaneRotation moved = rho;
  for (int i = 0; i < 3; ++i) {
    if (back.image[at(i)] != 2) continue;
    moved.axis = i;
    if (back.sign[at(i)] < 0) {
      moved.s = -moved.s;
      moved.angle = -moved.angle;
    }
  }
  std::vector<PlaneRotation>& planes = result.rotation.planes;
  if (planes.empty() || planes.front().axis != moved.axis) {
    planes.insert(planes.begin(), moved);
    return result;
  }
  PlaneRotation& first = planes.front();
  const Expression c = difference_of_products(moved.c, first.c, moved.s, first.s);
  first.s = sum_of_products(moved.s, first.c, moved.c, first.s);
  first.c = c;
  first.angle = moved.angle + first.angle;
  return result;
}

// Removes the rounding errors that are left of zeros after turns by any angle.
void drop_rounding(Vector3& v, double scale) {
  for (Expression& e : v.element)
    if (e.is_constant() && std::abs(e.number().value()) <= kRounding * scale) e = Expression();
}

// Makes the slide part of the offset if that leaves fewer numbers.
void join_slide(Pose& pose, double scale) {
  const auto count = [](const Vector3& v) {
    return std::count_if(v.element.begin(), v.element.end(), [](const Expression& e) { return !e.is_zero(); });
  };
  if (pose.slide.is_zero()) return;
  Vector3 whole = pose.offset + to_parent(pose.rotation, {Expression(), Expression(), pose.slide});
  drop_rounding(whole, scale);
  if (count(whole) > count(pose.offset)) return;
  pose.offset = whole;
  pose.slide = Expression();
}

double magnitude(const Expression& e) {
  return e.is_constant() ? std::abs(e.number().value()) : 0.0;
}
double magnitude(const Vector3& v) {
  return magnitude(v[0]) + magnitude(v[1]) + magnitude(v[2]);
}

class LinkFrameBuilder {
 public:
  LinkFrameBuilder(
      Trace& trace,
      const LinkFrames& frames,
      const std::vector<AxisPlacement>& placements,
      const std::vector<Expression>& q,
      const RepresentativeLinks& representative)
      : trace_(trace),
        frames_(frames),
        placements_(placements),
        q_(q),
        representative_(representative),
        turned_by_(trace.tree.links.size()) {}

  FramedLinks run(const std::vector<MassProperties>& masses) {
    const model::KinematicTree& tree = trace_.tree;
    FramedLinks result{std::vector<Pose>(tree.joints.size()), masses, std::vector<Pose>(tree.links.size())};
    for (const int j : tree.topological()) {
      const model::Joint& joint = tree.joints[at(j)];
      const std::string& name = tree.links[at(joint.child)].name;
      trace_.section(joint.name, "joint ", ": placement");
      result.poses[at(j)] = pose(j);
      trace_.section(
          name, "link ",
          frames_[at(j)].turns_with_joint ? ": mass properties" : ": mass properties in the parent's axes");
      Pose& model = result.frames_of_model[at(joint.child)];
      model = pose_of(trace_, model_in_frame(frames_[at(j)]), {});
      MassProperties& mass = result.masses[at(joint.child)];
      mass = placed(model, frames_[at(j)], mass);
      if (!representative_.empty()) fold_like(trace_, representative_[at(j)], mass);
      const std::optional<PlaneRotation>& rho = turned_by_[at(joint.child)];
      if (!rho) continue;
      model = turned(*rho, model);
      mass = described(name, to_parent(Pose{{}, Rotation{{}, {*rho}}, {}}, mass));
    }
    return result;
  }

 private:
  Trace& trace_;
  const LinkFrames& frames_;
  const std::vector<AxisPlacement>& placements_;
  const std::vector<Expression>& q_;
  const RepresentativeLinks& representative_;
  std::vector<std::optional<PlaneRotation>> turned_by_;  // by link: from its frame to the recursion's, when they differ

  static std::vector<PrimitiveTransform> model_in_frame(const LinkFrame& frame) {
    std::vector<PrimitiveTransform> list;
    append(list, false, Axis::z, -frame.slide);
    append(list, true, Axis::z, -frame.turn);
    return list;
  }

  // The rotation of a spherical joint, given its first component.
  PrimitiveTransform quaternion_of(int joint) const {
    const model::ElementaryMotion turn = model::spherical_motion(trace_.tree, joint);
    return {turn.rotation, turn.axis, turn.amount, turn.quaternion};
  }

  MassProperties placed(const Pose& model, const LinkFrame& frame, const MassProperties& mass) {
    if (frame.turn.is_zero() && frame.slide.is_zero()) return mass;
    MassProperties result = to_parent(model, mass);
    const double slide = frame.slide.is_constant() ? std::abs(frame.slide.number().value()) : 0.0;
    const double moment = magnitude(mass.first_moment) + magnitude(mass.mass) * slide;
    drop_rounding(result.first_moment, moment);
    double second = moment * slide;
    for (const Vector3& row : mass.pseudo_inertia.row) second += magnitude(row);
    const Expression x = result.pseudo_inertia[0][0], y = result.pseudo_inertia[1][1];
    for (Vector3& row : result.pseudo_inertia.row) drop_rounding(row, second);
    // The inertia about the axis may be all that the joint moves, however small it is.
    if (result.pseudo_inertia[0][0].is_zero() && result.pseudo_inertia[1][1].is_zero()) {
      result.pseudo_inertia[0][0] = x;
      result.pseudo_inertia[1][1] = y;
    }
    return result;
  }

  Pose pose(int j) {
    const model::Joint& joint = trace_.tree.joints[at(j)];
    const int parent_joint = trace_.tree.parent_joint_of(j);
    const AxisPlacement& placement = placements_[at(j)];
    const LinkFrame& frame = frames_[at(j)];
    const bool turns = model::turns(joint.type);
    const Quantity slide = model::slide_of(joint) * Quantity::variable(j);
    std::vector<PrimitiveTransform> list;
    if (parent_joint >= 0) list = model_in_frame(frames_[at(parent_joint)]);
    list.insert(list.end(), placement.to_axis.begin(), placement.to_axis.end());
    if (!joint.spherical.empty()) {
      if (joint.is_first()) list.push_back(quaternion_of(j));
    } else if (turns) {
      append(list, true, Axis::z, Quantity::variable(j));
    }
    append(list, true, Axis::z, frame.turn);
    append(list, false, Axis::z, placement.along + frame.slide);
    append(list, false, Axis::z, slide);
    Pose result = pose_of(trace_, list, q_);
    double scale = 0.0;
    for (const PrimitiveTransform& p : list)
      if (!p.rotation && p.amount.is_constant()) scale += std::abs(p.amount.number().value());
    drop_rounding(result.offset, scale);
    if (slide.is_zero()) join_slide(result, scale);
    if (!representative_.empty()) fold_like(trace_, representative_[at(j)], result);
    if (const auto& rho = turned_by_[at(joint.parent)]) result = turned(*rho, result);
    std::vector<PlaneRotation>& planes = result.rotation.planes;
    if (!frame.turns_with_joint && !planes.empty() && planes.back().axis == 2) {
      turned_by_[at(joint.child)] = planes.back();
      planes.pop_back();
    }
    return result;
  }
};

}  // namespace

std::string description(const model::KinematicTree& tree, const LinkFrames& frames) {
  const auto amount = [&](const Quantity& q) {
    return q.is_constant() ? fmt::format("{:.4g}", q.number().value()) : model::print(q, tree.parameters);
  };
  std::string placed, turning;
  for (std::size_t j = 0; j < frames.size(); ++j) {
    const std::string& link = tree.links[at(tree.joints[j].child)].name;
    const LinkFrame& frame = frames[j];
    if (!frame.turn.is_zero() || !frame.slide.is_zero()) {
      placed += (placed.empty() ? "" : "; ") + link;
      if (!frame.turn.is_zero()) placed += " rotated by " + amount(frame.turn) + " rad";
      if (!frame.slide.is_zero()) placed += " moved by " + amount(frame.slide) + " m";
    }
    if (!frame.turns_with_joint) turning += (turning.empty() ? "" : ", ") + link;
  }
  std::string text;
  if (!placed.empty()) text = "Link frames that make products vanish: " + placed + ".";
  if (turning.empty()) return text;
  if (!text.empty()) text += " ";
  return text + turning + ": inertia expressed in the parent's axes (cheaper than rotating the motion vectors).";
}

AxisPlacement axis_placement(const Placement& placement) {
  AxisPlacement whole{primitives_of(placement.translation, placement.rotation), Quantity()};
  if (!are_constant(placement.rotation)) return whole;
  const auto matrix = model::rotation_matrix(placement);
  std::array<std::array<double, 3>, 3> r{};
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t k = 0; k < 3; ++k) r[i][k] = matrix[i][k].number().value();
  const bool exact = std::all_of(placement.rotation.begin(), placement.rotation.end(), is_quarter_turn);
  for (std::size_t i = 0; exact && i < 2; ++i)
    if (r[i][2] != 0.0) return split_at_right_angle(placement, i, r[i][2] < 0);
  if (std::hypot(r[0][2], r[1][2]) < kParallel || !are_constant(placement.translation)) return whole;
  AxisPlacement split = split_numerically(placement, r);
  return is_detour(split, placement) ? whole : split;
}

std::vector<AxisPlacement> axis_placements(const model::KinematicTree& tree) {
  std::vector<AxisPlacement> placements;
  for (const model::Joint& joint : tree.joints) {
    const model::Placement& placement = joint.placement;
    if (joint.spherical.empty())
      placements.push_back(axis_placement(placement));
    else
      placements.push_back({primitives_of(placement.translation, placement.rotation), Quantity()});
  }
  return placements;
}

FramedLinks in_frames(
    Trace& trace,
    const LinkFrames& frames,
    const std::vector<AxisPlacement>& placements,
    const std::vector<Expression>& q,
    const std::vector<MassProperties>& masses,
    const RepresentativeLinks& representative) {
  return LinkFrameBuilder(trace, frames, placements, q, representative).run(masses);
}

}  // namespace robcogen::algorithm
