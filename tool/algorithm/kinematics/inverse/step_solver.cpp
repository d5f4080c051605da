// An equation l . R(h, angle) r = D is A cos + B sin = D - (l . h)(r . h), with A = l . r - (l . h)(r . h) and
// B = l . (h x r). Its roots lie symmetrically about the angle of (A, B): the sine and cosine follow without an arc
// tangent. Where there is no root, the joint turns as far towards one as it can.
#include "algorithm/kinematics/inverse/step_solver.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace robcogen::algorithm::inversion {
namespace {

using Equation = Step::Equation;
using Kind = Feature::Kind;

// Keeps 0 / 0 away; it is below the rounding of lengths and angles, and its square is normal in float. It is multiplied
// by a value that is not constant, so that it never folds with a constant that would absorb it.
constexpr double kTiny = 0x1p-60;
// The weight of the reference where a joint has no effect. It changes a pose by 1.5e-14 at most.
constexpr double kHold = 0x1p-46;
// Constants below are zero but for rounding.
constexpr double kRounding = 1e-12;

bool is_almost_zero(const Expression& e) {
  return e.is_constant() && std::abs(e.number().value()) < kRounding;
}

Expression square(const Expression& a) {
  return a * a;
}

Expression magnitude(const Expression& a) {
  return sqrt(a * a);
}

symbolic::Quantity of_joint(const SerialChain& chain, int joint, const char* symbol) {
  symbolic::Quantity quantity;
  quantity.subject = chain.axis(joint).name;
  quantity.symbol = symbol;
  return quantity;
}

// A value that passes leave alone, so that no sum of it with a small term is rearranged.
Expression kept(Graph& graph, const Expression& e, const SerialChain& chain, int joint, const char* symbol) {
  graph.name(e, of_joint(chain, joint, symbol));
  return e;
}

}  // namespace

StepSolver::StepSolver(
    Graph& graph,
    const SerialChain& chain,
    Target target,
    std::vector<Expression> references,
    std::vector<bool> lengths_agree,
    double margin)
    : graph_(graph),
      chain_(chain),
      loop_(graph, chain, std::move(target)),
      references_(std::move(references)),
      lengths_agree_(std::move(lengths_agree)),
      margin_(margin) {
  lengths_agree_.resize(chain.axes.size());
  const auto turning =
      std::find_if(chain.axes.begin(), chain.axes.end(), [](const ChainAxis& axis) { return axis.turns; });
  const int first = static_cast<int>(turning - chain.axes.begin());
  const Expression& corner = loop_.target().rotation[0][0];
  const bool has_rotation = !corner.is_constant();
  if (has_rotation || first < chain.joints)
    tiny_ = kTiny * (graph.constant(2.0) + (has_rotation ? corner : sin(references_[at(first)])));
  graph.describe(tiny_, of_joint(chain, 0, "tiny"));
}

Expression StepSolver::positive(const Expression& discriminant, const Expression& largest) const {
  if (margin_ == 0.0) return 0.5 * (discriminant + magnitude(discriminant));
  const Expression least = graph_.constant(margin_) * largest, least_square = square(least);
  return 0.5 * (discriminant + sqrt(square(discriminant) + least_square));
}

std::optional<SolvedJoint> StepSolver::two_roots(
    int joint,
    const Vector3& left,
    const Vector3& right,
    const Expression& value,
    const Expression& sign,
    const std::optional<Discriminant>& discriminant) {
  const Basis& e = loop_.basis(joint);
  const Expression lu = dot(e.u, left), lw = dot(e.w, left), lh = dot(e.h, left);
  const Expression ru = dot(e.u, right), rw = dot(e.w, right), rh = dot(e.h, right);
  Expression A = sum_of_products(lu, ru, lw, rw), B = difference_of_products(lw, ru, lu, rw);
  Expression D = value - lh * rh;
  const Expression left_square = square(lu) + square(lw), right_square = square(ru) + square(rw);
  if (is_almost_zero(left_square) || is_almost_zero(right_square)) return std::nullopt;
  const bool is_radius_constant = left_square.is_constant() && right_square.is_constant();
  if (is_almost_zero(D)) {
    // There is a root for every target.
    Expression radius_square = is_radius_constant ? left_square * right_square : Expression();
    if (!is_radius_constant) {
      A = A - kHold * sin(references_[at(joint)]);
      B = B + kHold * cos(references_[at(joint)]);
      radius_square = square(A) + square(B);
    }
    const Expression radius = sqrt(radius_square), inverse = graph_.one() / radius;
    return SolvedJoint{{sign * (A * inverse), -(sign * (B * inverse))}, sign * radius};
  }
  Expression radius_square;
  if (is_radius_constant) {
    radius_square = left_square * right_square;
  } else {
    A = kept(graph_, A, chain_, joint, "A") + tiny_;
    D = kept(graph_, D, chain_, joint, "D") + tiny_;
    radius_square = square(A) + square(B);
  }
  const Expression rest = discriminant ? discriminant->lengths - square(discriminant->k) : radius_square - square(D);
  const Expression square_of_root = positive(rest, radius_square), root = sign * sqrt(square_of_root);
  const Expression radius = sqrt(radius_square), far = sqrt(square(D) + square_of_root);
  const Expression inverse = graph_.one() / (radius * far);
  SolvedJoint found;
  found.value.cosine = difference_of_products(A, D, B, root) * inverse;
  found.value.sine = sum_of_products(B, D, A, root) * inverse;
  found.root = root;
  return found;
}

// The rotation that turns `from` towards `to`.
std::optional<SolvedJoint> StepSolver::turned(int joint, const Vector3& from, const Vector3& to, bool is_backward) {
  const Basis& e = loop_.basis(joint);
  const Expression au = dot(e.u, to), aw = dot(e.w, to), bu = dot(e.u, from), bw = dot(e.w, from);
  Expression c = sum_of_products(au, bu, aw, bw), s = difference_of_products(aw, bu, au, bw);
  const Expression a_square = square(au) + square(aw), b_square = square(bu) + square(bw);
  if (is_almost_zero(a_square) || is_almost_zero(b_square)) return std::nullopt;
  lengths_.push_back({joint, a_square, b_square});
  const auto result = [&](const Expression& inverse) {
    const Expression sine = s * inverse;
    return SolvedJoint{{is_backward ? -sine : sine, c * inverse}, {}};
  };
  const bool is_one_constant = a_square.is_constant() || b_square.is_constant();
  if (lengths_agree_[at(joint)]) {
    if (is_one_constant) return result(graph_.one() / (a_square.is_constant() ? a_square : b_square));
    const Expression tiny_square = square(tiny_);
    c += tiny_square;
    return result(graph_.one() / (b_square + tiny_square));
  }
  if (is_one_constant) {
    c = kept(graph_, c, chain_, joint, "C") + tiny_;
  } else {
    const Expression hold = kHold * sqrt(b_square + square(tiny_));
    const Expression sine = sin(references_[at(joint)]);
    s += hold * (is_backward ? -sine : sine);
    c += hold * cos(references_[at(joint)]);
  }
  const Expression length = sqrt(square(c) + square(s));
  if (length.is_constant()) return std::nullopt;
  return result(graph_.one() / length);
}

std::optional<SolvedJoint> StepSolver::by_vector(const Step& step, const JointValues& values) {
  const int m = step.joint;
  const Feature& f = step.b;
  const bool is_backward = m >= f.begin;
  const Item x = loop_.item(f);
  Item from, to;
  if (!is_backward) {
    from = loop_.along(x, m + 1, f.begin, values, false);
    to = loop_.along(loop_.by_target(loop_.along(x, f.end, chain_.size(), values, true), false), 0, m, values, true);
  } else {
    // Seen from the other side, the joint turns by the opposite angle.
    from = loop_.along(x, f.end, m, values, true);
    to = loop_.along(
        loop_.by_target(loop_.along(x, 0, f.begin, values, false), true), m + 1, chain_.size(), values, false);
  }
  if (!chain_.axis(m).turns) {
    const Expression distance = dot(loop_.basis(m).h, to.v - from.v);
    return SolvedJoint{{is_backward ? -distance : distance, graph_.one()}, {}};
  }
  if (x.is_direction) return turned(m, from.v, to.v, is_backward);
  const Vector3 origin = loop_.axis_point(m);
  return turned(m, from.v - origin, to.v - origin, is_backward);
}

StepSolver::Discriminant StepSolver::of_aligned(
    int joint,
    const Vector3& a,
    const Vector3& b,
    const Vector3& a_far,
    const Vector3& b_far,
    const Expression& value) const {
  const Vector3& h = loop_.basis(joint).h;
  const Expression ah = dot(h, a), bh = dot(h, b);
  const Vector3 across = cross(a, h);
  const Expression across_square = ah.is_constant() ? graph_.one() - square(ah) : dot(across, across);
  Expression far_square;
  if (a_far[0].is_constant() && a_far[1].is_constant() && a_far[2].is_constant()) {
    const auto number = [](const Expression& e) { return e.is_zero() ? 0.0 : e.number().value(); };
    const Basis e = loop_.basis_of({number(a_far[0]), number(a_far[1]), number(a_far[2])});
    far_square = square(dot(e.u, b_far)) + square(dot(e.w, b_far));
  } else {
    const Vector3 far = cross(a_far, b_far);
    far_square = dot(far, far);
  }
  return {across_square * far_square, bh - ah * value};
}

std::optional<SolvedJoint> StepSolver::by_angle(const Step& step, const JointValues& values, const Expression& sign) {
  const int m = step.joint;
  const Sides s = loop_.sides(step, values, false);
  const Vector3 a0 = loop_.item(step.a).v, &left = s.is_a_left ? s.a.v : s.b.v, &right = s.is_a_left ? s.b.v : s.a.v;
  const Item b = loop_.item(step.b);
  const Vector3 b_far =
      s.is_a_left ? loop_.around(b, step, values).v : loop_.along(b, step.a.end, step.b.begin, values, false).v;
  const Expression value = dot(a0, b_far);
  const Vector3& h = loop_.basis(m).h;
  std::optional<Discriminant> discriminant;
  if (!is_almost_zero(value - dot(h, left) * dot(h, right)))
    discriminant = of_aligned(m, s.a.v, s.b.v, a0, b_far, value);
  return two_roots(m, left, right, value, sign, discriminant);
}

std::optional<SolvedJoint> StepSolver::by_distance(
    const Step& step,
    const JointValues& values,
    const Expression& sign) {
  const int m = step.joint;
  const Sides s = loop_.sides(step, values, false);
  const Item b = loop_.item(step.b);
  const Item b_far =
      s.is_a_left ? loop_.around(b, step, values) : loop_.along(b, step.a.end, step.b.begin, values, false);
  const Vector3 d = b_far.v - loop_.item(step.a).v;
  Vector3 left = s.is_a_left ? s.a.v : s.b.v, right = s.is_a_left ? s.b.v : s.a.v;
  if (!chain_.axis(m).turns) {
    // |left - (right + h t)|^2 = |d|^2
    const Vector3 between = left - right;
    const Expression middle = dot(loop_.basis(m).h, between);
    const Expression far_square = dot(d, d), rest = square(middle) - dot(between, between) + far_square;
    const Expression root = sign * sqrt(positive(rest, far_square));
    return SolvedJoint{{middle + root, graph_.one()}, root};
  }
  const Vector3 origin = loop_.axis_point(m);
  left -= origin;
  right -= origin;
  Expression value;
  if (step.equation == Equation::distance_in_plane) {
    const Basis plane = loop_.basis_of(step.normal), &own = loop_.basis(m);
    const auto in_plane = [](const Basis& e, const Vector3& v) { return square(dot(e.u, v)) + square(dot(e.w, v)); };
    value =
        0.5 * (in_plane(own, left) + in_plane(own, right) - in_plane(plane, d)) + dot(own.h, left) * dot(own.h, right);
  } else {
    value = 0.5 * (dot(left, left) + dot(right, right) - dot(d, d));
  }
  return two_roots(m, left, right, value, sign, {});
}

std::optional<SolvedJoint> StepSolver::by_height(const Step& step, const JointValues& values, const Expression& sign) {
  const int m = step.joint;
  const bool is_a_plane = step.a.kind == Kind::plane;
  const Feature& plane = is_a_plane ? step.a : step.b;
  const bool is_neighbour =
      plane.end - plane.begin == 1 && std::abs(plane.begin - m) == 1 && chain_.axis(plane.begin).turns;
  if (chain_.axis(m).turns && is_neighbour)
    if (const auto meeting = common_point(chain_, std::min(plane.begin, m), std::max(plane.begin, m) + 1))
      return at_meeting_axes(step, values, sign, without_rounding(chain_, *meeting));

  const Sides s = loop_.sides(step, values, false);
  const auto seen = [&](const Item& b) {
    return s.is_a_left ? loop_.around(b, step, values) : loop_.along(b, step.a.end, step.b.begin, values, false);
  };
  const Vector3 a0 = loop_.item(step.a).v, b_far = seen(loop_.item(step.b)).v;
  const Expression height = is_a_plane ? dot(loop_.constant(plane.direction), b_far - a0)
                                       : dot(seen({loop_.constant(plane.direction), true}).v, a0 - b_far);
  const Vector3 &point = is_a_plane ? s.b.v : s.a.v, &of_plane = is_a_plane ? s.a.v : s.b.v;
  const bool is_normal_left = is_a_plane == s.is_a_left;
  const Vector3& normal = s.normal.v;
  if (!chain_.axis(m).turns) {
    const Expression slope = dot(normal, loop_.basis(m).h);
    if (is_almost_zero(slope)) return std::nullopt;
    // The joint moves what is on the right: the point, or the plane.
    const Expression position = (height - dot(normal, point - of_plane)) / (is_normal_left ? slope : -slope);
    return SolvedJoint{{position, graph_.one()}, {}};
  }
  const Vector3 origin = loop_.axis_point(m);
  const Expression value = height + dot(normal, of_plane - origin);
  const Vector3 arm = point - origin;
  return is_normal_left ? two_roots(m, normal, arm, value, sign, {}) : two_roots(m, arm, normal, value, sign, {});
}

// The axis of the joint and the normal of the plane meet: from there, the point is equally far both ways.
std::optional<SolvedJoint> StepSolver::at_meeting_axes(
    const Step& step,
    const JointValues& values,
    const Expression& sign,
    const Numbers3& meeting) {
  const int m = step.joint;
  const bool is_a_plane = step.a.kind == Kind::plane, is_a_left = m >= step.a.end && m < step.b.begin;
  const Vector3 normal = loop_.constant(is_a_plane ? step.a.direction : step.b.direction),
                origin = loop_.constant(meeting);
  const Item point = loop_.item(is_a_plane ? step.b : step.a);
  const Vector3 arm = loop_.next_to_joint(point, !is_a_plane, step, values, false).v - origin;
  Item far;
  if (is_a_plane)
    far = is_a_left ? loop_.around(point, step, values) : loop_.along(point, step.a.end, step.b.begin, values, false);
  else if (is_a_left)
    far = loop_.along(
        loop_.by_target(loop_.along(point, 0, step.a.begin, values, false), true), step.b.end, chain_.size(), values,
        false);
  else
    far = loop_.along(point, step.a.end, step.b.begin, values, true);
  const Vector3 far_arm = far.v - origin;
  const Expression value = dot(normal, far_arm);
  const Discriminant discriminant = of_aligned(m, normal, arm, normal, far_arm, value);
  return is_a_plane == is_a_left ? two_roots(m, normal, arm, value, sign, discriminant)
                                 : two_roots(m, arm, normal, value, sign, discriminant);
}

std::optional<SolvedJoint> StepSolver::solve(const Step& step, const JointValues& values, const Expression& sign) {
  const std::optional<SolvedJoint> found = solved(step, values, sign);
  if (!found || !graph_.keeps_names()) return found;
  graph_.describe(found->value.sine, of_joint(chain_, step.joint, chain_.axis(step.joint).turns ? "sin" : "position"));
  graph_.describe(found->value.cosine, of_joint(chain_, step.joint, "cos"));
  graph_.describe(found->root, of_joint(chain_, step.joint, "root"));
  return found;
}

std::optional<SolvedJoint> StepSolver::solved(const Step& step, const JointValues& values, const Expression& sign) {
  switch (step.equation) {
    case Equation::vector:
      return by_vector(step, values);
    case Equation::angle:
      return by_angle(step, values, sign);
    case Equation::height:
      return by_height(step, values, sign);
    default:
      return by_distance(step, values, sign);
  }
}

Expression StepSolver::root(const Step& step, const JointValues& values) const {
  const int m = step.joint;
  const Basis& e = loop_.basis(m);
  const JointValue& joint = *values[at(m)];
  const Sides s = loop_.sides(step, values, true);
  const bool is_a_plane = step.a.kind == Kind::plane;
  if (!chain_.axis(m).turns) {
    const Vector3 between = s.is_a_left ? s.a.v - s.b.v : s.b.v - s.a.v;
    return joint.sine - dot(e.h, between);
  }
  const Vector3 origin = loop_.axis_point(m);
  const auto arm = [&](const Item& x, bool is_plane) {
    return is_plane ? s.normal.v : x.is_direction ? x.v : x.v - origin;
  };
  const Vector3 a = arm(s.a, is_a_plane), b = arm(s.b, step.b.kind == Kind::plane);
  const Vector3 &left = s.is_a_left ? a : b, &right = s.is_a_left ? b : a;
  const Expression lu = dot(e.u, left), lw = dot(e.w, left), ru = dot(e.u, right), rw = dot(e.w, right);
  return difference_of_products(
      sum_of_products(lu, ru, lw, rw), joint.sine, difference_of_products(lw, ru, lu, rw), joint.cosine);
}

}  // namespace robcogen::algorithm::inversion
