#include "algorithm/kinematics/inverse/target_loop.h"

#include <algorithm>
#include <array>
#include <utility>

namespace robcogen::algorithm::inversion {
namespace {

using Kind = Feature::Kind;

}  // namespace

TargetLoop::TargetLoop(Graph& graph, const SerialChain& chain, Target target)
    : graph_(graph), chain_(chain), target_(std::move(target)) {
  for (const ChainAxis& axis : chain.axes) bases_.push_back(basis_of(axis.direction));
}

Vector3 TargetLoop::constant(const Numbers3& v) const {
  return {graph_.constant(v[0]), graph_.constant(v[1]), graph_.constant(v[2])};
}

// Two unit vectors across h, with few elements other than zero.
TargetLoop::Basis TargetLoop::basis_of(const Numbers3& h) const {
  std::optional<std::array<Numbers3, 2>> best;
  int least = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    Numbers3 e{};
    e[k] = 1.0;
    Numbers3 u = e - h[k] * h;
    if (norm(u) < 0.5) continue;
    u = without_rounding(chain_, (1.0 / norm(u)) * u);
    const Numbers3 w = without_rounding(chain_, cross(h, u));
    const auto is_other = [](double x) { return x != 0.0; };
    const auto count =
        static_cast<int>(std::count_if(u.begin(), u.end(), is_other) + std::count_if(w.begin(), w.end(), is_other));
    if (best && count >= least) continue;
    best = {u, w};
    least = count;
  }
  return {constant((*best)[0]), constant((*best)[1]), constant(h)};
}

TargetLoop::Item TargetLoop::item(const Feature& f) const {
  const bool is_direction = f.kind == Kind::direction;
  return {constant(is_direction ? f.direction : f.point), is_direction};
}

TargetLoop::Item TargetLoop::past(int joint, const Item& x, const JointValues& values, bool inverse) const {
  const ChainAxis& axis = chain_.axis(joint);
  if (!axis.turns && x.is_direction) return x;  // also where the joint is not known
  const JointValue& value = *values[at(joint)];
  const Basis& basis = bases_[at(joint)];
  if (!axis.turns) return {x.v + (inverse ? -value.sine : value.sine) * basis.h, false};
  const Vector3 origin = axis_point(joint), v = x.is_direction ? x.v : x.v - origin;
  const Expression s = inverse ? -value.sine : value.sine, &c = value.cosine;
  const Expression a = dot(basis.u, v), b = dot(basis.w, v), along = dot(basis.h, v);
  const Expression turned_a = difference_of_products(a, c, b, s), turned_b = sum_of_products(a, s, b, c);
  const Vector3 turned = turned_a * basis.u + turned_b * basis.w + along * basis.h;
  return {x.is_direction ? turned : turned + origin, x.is_direction};
}

// E_begin … E_(end - 1) x, or the inverse of this product times x.
TargetLoop::Item TargetLoop::along(Item x, int begin, int end, const JointValues& values, bool inverse) const {
  if (inverse)
    for (int k = begin; k < end; ++k) x = past(k, x, values, true);
  else
    for (int k = end; k-- > begin;) x = past(k, x, values, false);
  return x;
}

// The motion of the last link, X M^-1.
TargetLoop::Item TargetLoop::by_target(const Item& x, bool inverse) const {
  const Vector3 start = constant(chain_.position);
  Vector3 v = x.v;
  if (inverse) {
    if (!x.is_direction) v = v - target_.position;
    v = multiply(transposed(target_.rotation), v);
    Vector3 moved;
    for (std::size_t k = 0; k < 3; ++k) moved += v[k] * constant(chain_.rotation[k]);
    return {x.is_direction ? moved : moved + start, x.is_direction};
  }
  if (!x.is_direction) v = v - start;
  Vector3 in_frame;
  for (std::size_t k = 0; k < 3; ++k) in_frame[k] = dot(constant(chain_.rotation[k]), v);
  const Vector3 moved = multiply(target_.rotation, in_frame);
  return {x.is_direction ? moved : moved + target_.position, x.is_direction};
}

TargetLoop::Item TargetLoop::around(const Item& b, const Step& step, const JointValues& values) const {
  const Item x = by_target(along(b, step.b.end, chain_.size(), values, true), false);
  return along(x, 0, step.a.begin, values, true);
}

TargetLoop::Item TargetLoop::next_to_joint(
    const Item& x,
    bool is_a,
    const Step& step,
    const JointValues& values,
    bool direct) const {
  const int m = step.joint, end = chain_.size();
  if (m >= step.a.end && m < step.b.begin)
    return is_a ? along(x, step.a.end, m, values, true) : along(x, m + 1, step.b.begin, values, false);
  if (m < step.a.begin) {
    if (is_a) return along(x, m + 1, step.a.begin, values, false);
    if (direct) return along(x, m, step.b.begin, values, false);
    return along(by_target(along(x, step.b.end, end, values, true), false), 0, m, values, true);
  }
  if (!is_a) return along(x, step.b.end, m, values, true);
  if (direct) return along(x, step.a.end, m + 1, values, true);
  return along(by_target(along(x, 0, step.a.begin, values, false), true), m + 1, end, values, false);
}

TargetLoop::Sides TargetLoop::sides(const Step& step, const JointValues& values, bool direct) const {
  Sides s;
  s.is_a_left = step.joint >= step.a.end && step.joint < step.b.begin;
  s.a = next_to_joint(item(step.a), true, step, values, direct);
  s.b = next_to_joint(item(step.b), false, step, values, direct);
  const bool is_a_plane = step.a.kind == Kind::plane;
  if (is_a_plane || step.b.kind == Kind::plane) {
    const Item normal = {constant(is_a_plane ? step.a.direction : step.b.direction), true};
    s.normal = next_to_joint(normal, is_a_plane, step, values, direct);
  }
  return s;
}

Vector3 TargetLoop::difference(const Feature& feature, int cut, const JointValues& values) const {
  const Item x = item(feature);
  const int begin = feature.begin, end = feature.end, last = chain_.size();
  if (cut <= begin) {
    const Item far = by_target(along(x, end, last, values, true), false);
    return along(x, cut, begin, values, false).v - along(far, 0, cut, values, true).v;
  }
  const Item far = by_target(along(x, 0, begin, values, false), true);
  return along(x, end, cut, values, true).v - along(far, cut, last, values, false).v;
}

}  // namespace robcogen::algorithm::inversion
