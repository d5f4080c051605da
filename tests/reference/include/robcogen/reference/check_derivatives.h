// Checks of derivatives of the dynamics against differences of the reference. Each function records the errors of one
// sample.
#pragma once

#include "robcogen/reference/check_identities.h"
#include "robcogen/reference/loops.h"

namespace robcogen::reference {

inline constexpr Tolerance kDerivative{
    "kDerivative", 1e-10, "a fourth-order difference of 3e-5 rad of the reference, rounded as far as double has it"};

// Random directions in which the variables of a motion change, one for each block of columns.
struct Directions {
  Vector<double> q, qd, last;  // by joint; the last are qdd, or tau
  Vector<double> base_rotation, base_velocity, base_acceleration;

  explicit Directions(const Case& c) {
    constexpr std::uint64_t kSeed = 17;
    std::mt19937_64 engine(kSeed + static_cast<std::uint64_t>(c.index));
    const int n = c.robot.dof();
    for (Vector<double>* v : {&q, &qd, &last}) *v = uniform_vector(engine, n, 1);
    base_rotation = uniform_vector(engine, 3, 1);
    base_velocity = uniform_vector(engine, 6, 1);
    base_acceleration = uniform_vector(engine, 6, 1);
  }
};

// A motion, and the loads and forces that act in it.
struct Situation {
  Motion<Real> motion;
  Loads<Real> loads;
  Vector<Real> tau;  // for forward dynamics
};

// Returns f(robot, situation), for the robot whose followers move in the proportions of that situation.
template <class F>
Vector<Real> in_situation(const Case& c, Situation s, const F& f) {
  if (c.loops == nullptr || c.motion.of_loops.empty()) return f(c.robot, s);
  const AtLoops there = c.loops->near(s.motion);
  return f(there.robot(), s);
}

// The derivative of f(step) at 0.
template <class F>
Vector<Real> difference(const F& f) {
  constexpr Real kStep = 3e-5L;
  return 1 / (12 * kStep) * (Real(8) * (f(kStep) - f(-kStep)) - (f(2 * kStep) - f(-2 * kStep)));
}

// Gravity in the coordinates of a base that has rotated by the small vector `turn`: exp(-[turn]x) g.
inline Vector<Real> seen_from_turned_base(const Vector<Real>& gravity, const Vector<Real>& turn) {
  Vector<Real> term = gravity, sum = gravity;
  for (int k = 1; k <= 8; ++k) {
    term = Real(-1) / static_cast<Real>(k) * cross(turn, term);
    sum += term;
  }
  return sum;
}

// Differences take time: all blocks are compared in the overload with all loads, and only `d_q` in the others.
enum class Blocks { all, d_q };

inline Blocks blocks_of(const Overload& o) {
  return o.arguments.gravity != nullptr && o.arguments.external != nullptr ? Blocks::all : Blocks::d_q;
}

// Checks the blocks that one function has. `value` computes its result in a situation; `terms` are the sizes of the
// terms that the elements of the result sum.
template <class Value>
void check_blocks(
    const std::string& name,
    const Case& c,
    const Derivatives& actual,
    const Situation& at,
    const Vector<Real>& terms,
    const Value& value,
    Blocks blocks,
    Checks& checks) {
  const Directions u(c);
  const auto compare = [&](const std::string& block, const Matrix<double>& columns, const Vector<double>& direction,
                           const auto& change) {
    if (columns.empty()) return;
    const Vector<Real> along = direction.template cast<Real>();
    const Vector<Real> expected = difference([&](Real step) {
      Situation changed = at;
      change(changed, step * along);
      return in_situation(c, changed, value);
    });
    const Matrix<Real> found = columns.template cast<Real>();
    const Vector<Real> sizes = terms + magnitude(found) * magnitude(along);
    const Vector<Real> product = found * along;
    const Real error = blockwise_error(c.floating, product.template cast<double>(), expected, sizes);
    checks.record(name + ": " + block, kDerivative, error, c.index);
  };
  const bool is_forward = at.tau.rows() > 0;
  compare(
      "d_q", actual.q, u.q, [&](Situation& s, const Vector<Real>& d) { s.motion.q = moved(c.robot, s.motion.q, d); });
  if (blocks == Blocks::d_q) return;
  compare("d_qd", actual.qd, u.qd, [](Situation& s, const Vector<Real>& d) { s.motion.qd += d; });
  if (is_forward)
    compare("d_tau", actual.last, u.last, [](Situation& s, const Vector<Real>& d) { s.tau += d; });
  else
    compare("d_qdd", actual.last, u.last, [](Situation& s, const Vector<Real>& d) { s.motion.qdd += d; });
  if (!c.floating) return;
  compare("d_base_rotation", actual.base_rotation, u.base_rotation, [](Situation& s, const Vector<Real>& d) {
    s.loads.gravity = seen_from_turned_base(s.loads.gravity, d);
  });
  compare("d_base_velocity", actual.base_velocity, u.base_velocity, [](Situation& s, const Vector<Real>& d) {
    s.motion.base_velocity += d;
  });
  compare(
      "d_base_acceleration", actual.base_acceleration, u.base_acceleration,
      [](Situation& s, const Vector<Real>& d) { s.motion.base_acceleration += d; });
}

template <class Subject>
void check_inverse_dynamics_derivatives(const Subject& subject, const Case& c, Checks& checks) {
  const std::string name = c.floating ? "inverse_dynamics_fully_actuated_derivatives" : "inverse_dynamics_derivatives";
  for (const Overload& o : overloads(c.sample)) {
    const Derivatives actual = subject.inverse_dynamics_fully_actuated_derivatives(c.sample.motion, o.arguments);
    const Expected forces = expected_forces(c, c.sample.motion, o.loads);
    checks.record(name + o.suffix, kForce, error_of(c, actual.value, forces), c.index);
    const auto value = [&](const Robot& robot, const Situation& s) {
      return cut(c.floating, generalized_forces(robot, s.motion, s.loads));
    };
    check_blocks(name + o.suffix, c, actual, {c.motion, o.loads, {}}, forces.terms, value, blocks_of(o), checks);
  }
}

// With a free base.
template <class Subject>
void check_free_inverse_dynamics_derivatives(const Subject& subject, const Case& c, Checks& checks) {
  if (!c.floating) return;
  const std::string name = "inverse_dynamics_derivatives";
  for (const Overload& o : overloads(c.sample)) {
    const Derivatives actual = subject.inverse_dynamics_derivatives(c.sample.motion, o.arguments);
    Expected expected = expected_free_motion(c, o.loads);
    checks.record(name + o.suffix, kForce, error_of(c, actual.value, expected), c.index);
    const auto value = [&](const Robot& robot, const Situation& s) {
      const InverseDynamics<Real> result = inverse_dynamics(robot, s.motion, s.loads);
      return stacked(result.base_acceleration, result.tau);
    };
    const int n = c.robot.dof();
    const Matrix<Real> composite = c.H.block(0, 0, 6, 6), coupling = magnitude(c.H.block(6, 0, n, 6));
    const Matrix<Real> inverse = magnitude(solve(composite, Matrix<Real>::identity(6)));
    const Vector<Real> loss = inverse * (magnitude(composite) * expected.terms.head(6));
    expected.terms += stacked(loss, coupling * loss);
    check_blocks(name + o.suffix, c, actual, {c.motion, o.loads, {}}, expected.terms, value, blocks_of(o), checks);
  }
}

template <class Subject>
void check_forward_dynamics_derivatives(const Subject& subject, const Case& c, Checks& checks) {
  const std::string name = "forward_dynamics_derivatives";
  for (const Overload& o : overloads(c.sample)) {
    const Vector<double> tau = inverse_dynamics(c.robot, c.motion, o.loads).tau.template cast<double>();
    const Derivatives actual = subject.forward_dynamics_derivatives(c.sample.motion, tau, o.arguments);
    Expected expected = expected_accelerations(c, tau, o.loads);
    checks.record(name + o.suffix, kAcceleration, error_of(c, actual.value, expected), c.index);
    const auto value = [&](const Robot& robot, const Situation& s) {
      const Accelerations<Real> result = forward_dynamics(robot, s.motion, s.tau, s.loads);
      return coordinates(c.floating, result.base_acceleration, result.qdd);
    };
    expected.terms += c.inverse_magnitude * (inertia_magnitude(c) * expected.terms);
    check_blocks(
        name + o.suffix, c, actual, {c.motion, o.loads, tau.template cast<Real>()}, expected.terms, value, blocks_of(o),
        checks);
  }
}

// The gradient of weights times (base wrench, tau), along the directions of the other checks. The subject returns each
// block as a column.
template <class Subject>
void check_inverse_dynamics_gradient(const Subject& subject, const Case& c, Checks& checks) {
  std::mt19937_64 engine(static_cast<std::uint64_t>(c.index));
  const Vector<double> weights = uniform_vector(engine, c.H.rows(), 1);
  const Matrix<Real> transposed_weights = transpose(weights.cast<Real>());
  for (const Overload& o : overloads(c.sample)) {
    const Derivatives actual = subject.inverse_dynamics_gradient(c.sample.motion, weights, o.arguments);
    const Expected forces = expected_forces(c, c.sample.motion, o.loads);
    const std::string name = "inverse_dynamics_gradient" + o.suffix;
    checks.record(name, kForce, error_of(c, actual.value, forces), c.index);
    const Directions u(c);
    const Real terms = (magnitude(transposed_weights) * forces.terms)(0);
    const auto compare = [&](const char* block, const Matrix<double>& gradient, const Vector<double>& direction,
                             const auto& change) {
      if (gradient.empty()) return;
      const Vector<Real> along = direction.template cast<Real>();
      const Vector<Real> expected = difference([&](Real step) {
        Situation changed{c.motion, o.loads, {}};
        change(changed, step * along);
        return in_situation(c, changed, [&](const Robot& robot, const Situation& s) {
          return transposed_weights * cut(c.floating, generalized_forces(robot, s.motion, s.loads));
        });
      });
      const Matrix<Real> row = transpose(gradient.template cast<Real>());
      const Real size = terms + (magnitude(row) * magnitude(along))(0);
      checks.record(name + ": " + block, kDerivative, std::abs((row * along)(0) - expected(0)) / size, c.index);
    };
    using Along = Vector<Real>;
    compare("d_q", actual.q, u.q, [&](Situation& s, const Along& d) { s.motion.q = moved(c.robot, s.motion.q, d); });
    if (blocks_of(o) == Blocks::d_q) continue;
    compare("d_qd", actual.qd, u.qd, [](Situation& s, const Along& d) { s.motion.qd += d; });
    compare("d_qdd", actual.last, u.last, [](Situation& s, const Along& d) { s.motion.qdd += d; });
    compare("d_base_velocity", actual.base_velocity, u.base_velocity, [](Situation& s, const Along& d) {
      s.motion.base_velocity += d;
    });
    compare("d_base_acceleration", actual.base_acceleration, u.base_acceleration, [](Situation& s, const Along& d) {
      s.motion.base_acceleration += d;
    });
  }
}

// Derivatives with respect to q and to a rotation of the base only.
template <class Subject>
void check_gravity_forces_derivative(const Subject& subject, const Case& c, Checks& checks) {
  const Motion<double> rest = at_rest(c.robot, c.sample.motion.q);
  const Overload standard = overloads(c.sample)[0], gravity = overloads(c.sample)[1];
  for (Overload o : {standard, gravity}) {
    o.loads.passive = false;
    Derivatives actual = subject.gravity_forces_derivative(rest.q, o.arguments);
    const int rows = actual.q.rows(), n = c.robot.dof();
    actual.qd = actual.last = Matrix<double>(rows, 0);
    const Expected forces = expected_forces(c, rest, o.loads);
    const auto value = [&](const Robot& robot, const Situation& s) {
      return cut(c.floating, generalized_forces(robot, s.motion, s.loads));
    };
    check_blocks(
        "gravity_forces_derivative" + o.suffix, c, actual, {cast<Real>(rest), o.loads, {}}, forces.terms, value,
        Blocks::all, checks);
    if (c.floating) continue;
    // Rotations about two axes of a spherical joint do not commute, so the matrix is not symmetric there.
    const auto commute = [&](int i, int j) {
      return c.robot.joints[i].type != JointType::spherical || c.robot.joints[i].child != c.robot.joints[j].child;
    };
    Real skew = 0;
    for (int i = 0; i < n; ++i)
      for (int j = 0; j < i; ++j)
        if (commute(i, j)) skew = std::max(skew, static_cast<Real>(std::abs(actual.q(i, j) - actual.q(j, i))));
    checks.record("gravity_forces_derivative is symmetric", kExact, skew, c.index);
  }
}

}  // namespace robcogen::reference
