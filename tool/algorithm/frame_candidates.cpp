#include "algorithm/frame_candidates.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "algorithm/setup.h"

namespace robcogen::algorithm {
namespace {

using model::Quantity;

constexpr double kSame = 1e-9;     // rad, m: candidates closer than this are one
constexpr double kNothing = 1e-9;  // shares of a vector or matrix smaller than this have no direction
constexpr double kQuarter = std::numbers::pi / 2;

std::size_t at(int index) {
  return static_cast<std::size_t>(index);
}

// Exact where it is a multiple of 90 degrees.
Quantity angle(double value) {
  const double turned = std::remainder(value, 4 * kQuarter);
  const double quarters = std::round(turned / kQuarter);
  if (std::abs(turned - quarters * kQuarter) < 1e-12)
    return Quantity(Number::pi_multiple(static_cast<std::int64_t>(quarters), 2));
  return Quantity(turned);
}

Quantity length(double value) {
  return Quantity(*Number::parse(print_double(std::abs(value) < 1e-14 ? 0.0 : value)));
}

void add(std::vector<Quantity>& list, const Quantity& q) {
  const bool known = std::any_of(list.begin(), list.end(), [&](const Quantity& other) {
    return q.is_constant() && other.is_constant() && std::abs(q.number().value() - other.number().value()) < kSame;
  });
  if (!known) list.push_back(q);
}

double value(const Expression& e) {
  return e.number().value();
}

bool is_constant(const MassProperties& m) {
  const auto constant = [](const Vector3& v) { return v[0].is_constant() && v[1].is_constant() && v[2].is_constant(); };
  return constant(m.first_moment) && constant(m.pseudo_inertia[0]) && constant(m.pseudo_inertia[1]) &&
         constant(m.pseudo_inertia[2]);
}

}  // namespace

FrameCandidates::Axis FrameCandidates::axis_of(const model::Joint& joint) {
  Axis axis;
  for (const Quantity& q : joint.placement.rotation)
    if (!q.is_constant()) return axis;
  axis.is_known = true;
  const auto matrix = model::rotation_matrix(joint.placement);
  const auto r = [&](std::size_t i, std::size_t k) { return matrix[i][k].number().value(); };
  const AxisPlacement placement = axis_placement(joint.placement);
  for (const model::PrimitiveTransform& p : placement.to_axis)
    if (!p.rotation && p.axis == model::Axis::z) axis.foot = p.amount;
  axis.along = placement.along;
  axis.sign = r(2, 2) < 0 ? -1.0 : 1.0;
  axis.is_parallel = std::hypot(r(0, 2), r(1, 2)) < 1e-12;
  if (axis.is_parallel) {
    axis.twist = std::atan2(axis.sign * r(1, 0), r(0, 0));
    const auto& t = joint.placement.translation;
    if (t[0].is_constant() && t[1].is_constant()) {
      const double x = t[0].number().value(), y = t[1].number().value();
      axis.has_offset = std::hypot(x, y) > kNothing;
      axis.normal = std::atan2(y, x);
    }
    return axis;
  }
  const double x = -r(1, 2), y = r(0, 2), size = std::hypot(x, y);
  axis.normal = std::atan2(y, x);
  // Components of the child's x axis along the normal and along z x normal.
  const double along = (r(0, 0) * x + r(1, 0) * y) / size;
  const double across = (-r(0, 0) * r(2, 2) * y + r(1, 0) * r(2, 2) * x + r(2, 0) * (r(0, 2) * y - r(1, 2) * x)) / size;
  axis.twist = std::atan2(across, along);
  return axis;
}

FrameCandidates::FrameCandidates(const model::KinematicTree& tree, const Formulation& formulation)
    : tree_(tree), masses_(tree.links.size()) {
  for (const model::Joint& joint : tree.joints) axes_.push_back(axis_of(joint));
  Trace trace(tree);
  Formulation plain = formulation;
  plain.frames.clear();
  const Setup setup(trace, trace.joint_input("q", symbolic::Role::joint_position), plain);
  for (std::size_t l = 0; l < masses_.size(); ++l) {
    if (!is_constant(setup.masses[l])) continue;
    masses_[l].is_known = true;
    for (std::size_t i = 0; i < 3; ++i) {
      masses_[l].h[i] = value(setup.masses[l].first_moment[i]);
      for (std::size_t k = 0; k < 3; ++k) masses_[l].s[i][k] = value(setup.masses[l].pseudo_inertia[i][k]);
    }
  }
}

std::vector<Quantity> FrameCandidates::turns(int joint, const LinkFrames& frames) const {
  const LinkFrame& now = frames[at(joint)];
  const int link = tree_.joints[at(joint)].child;
  std::vector<Quantity> list{now.turn};
  const auto add_both = [&](double a) {
    const double within = std::remainder(a, 2 * kQuarter);
    add(list, angle(within));
    add(list, angle(within + kQuarter));
  };
  add(list, Quantity());
  for (const int child : tree_.links[at(link)].child_joints) {
    const Axis& axis = axes_[at(child)];
    if (axis.is_known && (!axis.is_parallel || axis.has_offset)) add_both(axis.normal);
  }
  const Mass& mass = masses_[at(link)];
  if (mass.is_known) {
    const double h = std::hypot(mass.h[0], mass.h[1]);
    if (h > 0) add_both(std::atan2(mass.h[1], mass.h[0]));
    if (mass.s[0][1] != 0) add_both(0.5 * std::atan2(2 * mass.s[0][1], mass.s[0][0] - mass.s[1][1]));
    const double slide = now.slide.is_constant() ? now.slide.number().value() : 0.0;
    const double xz = mass.s[0][2] - slide * mass.h[0], yz = mass.s[1][2] - slide * mass.h[1];
    if (std::hypot(xz, yz) > kNothing * std::hypot(mass.s[0][2], mass.s[1][2])) add_both(std::atan2(yz, xz));
  }
  const Axis& own = axes_[at(joint)];
  if (own.is_known) {
    const int parent = tree_.parent_joint_of(joint);
    double offset = own.twist;
    if (own.is_parallel && parent >= 0 && frames[at(parent)].turn.is_constant())
      offset -= own.sign * frames[at(parent)].turn.number().value();
    add(list, angle(-std::remainder(offset, kQuarter)));
  }
  return list;
}

std::vector<Quantity> FrameCandidates::slides(int joint, const Quantity& turn, const LinkFrames& frames) const {
  const LinkFrame& now = frames[at(joint)];
  const int link = tree_.joints[at(joint)].child;
  std::vector<Quantity> list{now.slide};
  add(list, Quantity());
  for (const int child : tree_.links[at(link)].child_joints)
    if (axes_[at(child)].is_known) add(list, axes_[at(child)].foot);
  const Axis& own = axes_[at(joint)];
  const int parent = tree_.parent_joint_of(joint);
  if (own.is_known) {
    if (own.is_parallel) {
      const Quantity parents = parent >= 0 ? frames[at(parent)].slide : Quantity();
      const Quantity way = parents - own.foot;
      add(list, own.sign < 0 ? -way : way);
    } else {
      add(list, -own.along);
    }
  }
  const Mass& mass = masses_[at(link)];
  if (mass.is_known && turn.is_constant()) {
    const double c = std::cos(turn.number().value()), s = std::sin(turn.number().value());
    const double hx = c * mass.h[0] + s * mass.h[1], hy = c * mass.h[1] - s * mass.h[0];
    const double xz = c * mass.s[0][2] + s * mass.s[1][2], yz = c * mass.s[1][2] - s * mass.s[0][2];
    const double least = kNothing * std::hypot(hx, hy);
    if (std::abs(hx) > least) add(list, length(xz / hx));
    if (std::abs(hy) > least) add(list, length(yz / hy));
  }
  return list;
}

}  // namespace robcogen::algorithm
