#include "algorithm/search/frame_candidates.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "algorithm/dynamics/traced_robot.h"
#include "support/index.h"

namespace robcogen::algorithm {
namespace {

using model::Quantity;

constexpr double kSame = 1e-9;     // rad, m: candidates closer than this count as one
constexpr double kNothing = 1e-9;  // a vector smaller than this share of its possible size has no direction
constexpr double kQuarter = std::numbers::pi / 2;

// An angle, exact if it is a multiple of 90 degrees.
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

// Candidates under construction. Each call stands for a rule, whether it adds a candidate or not.
class CandidateList {
 public:
  std::vector<Candidate> list;

  void skip(int rules = 1) { next_ += rules; }
  void add(const Quantity& q) {
    const auto known = std::find_if(list.begin(), list.end(), [&](const Candidate& other) {
      const Quantity& o = other.value;
      return q.is_constant() && o.is_constant() && std::abs(q.number().value() - o.number().value()) < kSame;
    });
    if (known == list.end())
      list.push_back({next_, q});
    else
      known->other_rules.push_back(next_);
    ++next_;
  }
  // Adds a direction and its normal.
  void add_direction(double a) {
    const double within = std::remainder(a, 2 * kQuarter);
    add(angle(within));
    add(angle(within + kQuarter));
  }

 private:
  int next_ = 0;
};

std::optional<MassNumbers> numbers_of(const MassProperties& m) {
  MassNumbers result;
  bool known = m.mass.is_constant();
  result.mass = known ? m.mass.number() : Number();
  const auto take = [&](const Expression& e, Number& number) {
    known = known && e.is_constant();
    if (known) number = e.number();
  };
  for (std::size_t i = 0; i < 3; ++i) {
    take(m.first_moment[i], result.first_moment[i]);
    for (std::size_t k = 0; k < 3; ++k) take(m.pseudo_inertia[i][k], result.pseudo_inertia[i][k]);
  }
  if (!known) return std::nullopt;
  return result;
}

}  // namespace

const Candidate* find_rule(const std::vector<Candidate>& candidates, int rule) {
  const auto found = std::find_if(candidates.begin(), candidates.end(), [&](const Candidate& c) {
    return c.rule == rule || std::find(c.other_rules.begin(), c.other_rules.end(), rule) != c.other_rules.end();
  });
  return found == candidates.end() ? nullptr : &*found;
}

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
  axis.is_parallel = std::hypot(r(0, 2), r(1, 2)) < kParallel;
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
    : tree_(tree), masses_(tree.links.size()), extents_(model::extents(tree)) {
  for (const model::Joint& joint : tree.joints) axes_.push_back(axis_of(joint));
  Trace trace(tree);
  Formulation plain = formulation;
  plain.frames.clear();
  const TracedRobot robot(trace, trace.joint_input("q", symbolic::Role::joint_position), plain);
  for (std::size_t l = 0; l < masses_.size(); ++l) masses_[l] = numbers_of(robot.masses[l]);
}

std::shared_ptr<const LinkNumbers> FrameCandidates::numbers() const {
  if (!tree_.parameters.empty()) return nullptr;
  LinkNumbers result{axis_placements(tree_), {}};
  for (const std::optional<MassNumbers>& mass : masses_) result.masses.push_back(mass.value());
  return std::make_shared<const LinkNumbers>(std::move(result));
}

std::vector<Candidate> FrameCandidates::turns(int joint, const LinkFrames& frames) const {
  const LinkFrame& now = frames[at(joint)];
  const int link = tree_.joints[at(joint)].child;
  CandidateList turns;
  turns.add(now.turn);
  turns.add(Quantity());
  const auto direction = [&](bool exists, double x, double y, double divisor = 1.0) {
    if (exists)
      turns.add_direction(std::atan2(y, x) / divisor);
    else
      turns.skip(2);
  };
  const auto& mass = masses_[at(link)];
  const auto h = [&](std::size_t i) { return mass->first_moment[i].value(); };
  const auto s = [&](std::size_t i, std::size_t k) { return mass->pseudo_inertia[i][k].value(); };
  const model::Extent& extent = extents_[at(link)];
  if (mass) {
    direction(std::hypot(h(0), h(1)) > kNothing * extent.mass * extent.length, h(0), h(1));
    direction(std::abs(s(0, 1)) > kNothing * extent.inertia, s(0, 0) - s(1, 1), 2 * s(0, 1), 2.0);
    const double slide = now.slide.is_constant() ? now.slide.number().value() : 0.0;
    const double xz = s(0, 2) - slide * h(0), yz = s(1, 2) - slide * h(1);
    direction(std::hypot(xz, yz) > kNothing * extent.inertia, xz, yz);
  } else {
    turns.skip(6);
  }
  const Axis& own = axes_[at(joint)];
  if (own.is_known) {
    const int parent = tree_.parent_joint_of(joint);
    double offset = own.twist;
    if (own.is_parallel && parent >= 0 && frames[at(parent)].turn.is_constant())
      offset -= own.sign * frames[at(parent)].turn.number().value();
    turns.add(angle(-std::remainder(offset, kQuarter)));
  } else {
    turns.skip();
  }
  for (const int child : tree_.links[at(link)].child_joints) {
    const Axis& axis = axes_[at(child)];
    direction(axis.is_known && (!axis.is_parallel || axis.has_offset), std::cos(axis.normal), std::sin(axis.normal));
  }
  return turns.list;
}

std::vector<Candidate> FrameCandidates::slides(int joint, const Quantity& turn, const LinkFrames& frames) const {
  const int link = tree_.joints[at(joint)].child;
  CandidateList slides;
  const auto add = [&](const Quantity& slide) {
    if (slide.is_constant() && std::abs(slide.number().value()) > extents_[0].length)
      slides.skip();
    else
      slides.add(slide);
  };
  add(frames[at(joint)].slide);
  add(Quantity());
  const Axis& own = axes_[at(joint)];
  const int parent = tree_.parent_joint_of(joint);
  if (!own.is_known) {
    slides.skip();
  } else if (own.is_parallel) {
    const Quantity parents = parent >= 0 ? frames[at(parent)].slide : Quantity();
    const Quantity way = parents - own.foot;
    add(own.sign < 0 ? -way : way);
  } else {
    add(-own.along);
  }
  const auto& mass = masses_[at(link)];
  if (mass && turn.is_constant()) {
    const double c = std::cos(turn.number().value()), s = std::sin(turn.number().value());
    const double x = mass->first_moment[0].value(), y = mass->first_moment[1].value();
    const double zx = mass->pseudo_inertia[0][2].value(), zy = mass->pseudo_inertia[1][2].value();
    const double hx = c * x + s * y, hy = c * y - s * x;
    const double xz = c * zx + s * zy, yz = c * zy - s * zx;
    const model::Extent& extent = extents_[at(link)];
    const double least = kNothing * extent.mass * extent.length;
    const auto vanishing = [&](double product, double moment) {
      if (std::abs(moment) > least)
        add(length(product / moment));
      else
        slides.skip();
    };
    vanishing(xz, hx);
    vanishing(yz, hy);
  } else {
    slides.skip(2);
  }
  for (const int child : tree_.links[at(link)].child_joints) {
    if (axes_[at(child)].is_known)
      add(axes_[at(child)].foot);
    else
      slides.skip();
  }
  return slides.list;
}

}  // namespace robcogen::algorithm
