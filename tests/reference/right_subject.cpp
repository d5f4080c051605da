#include "right_subject.h"

#include <numeric>

#include "robcogen/reference/check_derivatives.h"
#include "robcogen/reference/check_functions.h"

namespace robcogen::reference {

Vector<double> Right::inverse_dynamics(const Motion<double>& m, const Arguments& arguments) const {
  const auto [tau, base_acceleration] = reference::inverse_dynamics(robot_, m, loads(arguments));
  return coordinates(robot_.floating_base, base_acceleration, tau);
}

Vector<double> Right::inverse_dynamics_fully_actuated(const Motion<double>& m, const Arguments& arguments) const {
  return joined(reference::inverse_dynamics_fully_actuated(robot_, m, loads(arguments)));
}

Vector<double> Right::forward_dynamics(const Motion<double>& m, const Vector<double>& tau, const Arguments& arguments)
    const {
  const auto [qdd, base_acceleration] = reference::forward_dynamics(robot_, m, tau, loads(arguments));
  return coordinates(robot_.floating_base, base_acceleration, qdd);
}

Vector<double> Right::bias_forces(const Motion<double>& m, const Arguments& arguments) const {
  return joined(reference::bias_forces(robot_, m, loads(arguments)));
}

Vector<double> Right::gravity_forces(const Vector<double>& q, const Arguments& arguments) const {
  return joined(reference::gravity_forces(robot_, q, loads(arguments).gravity));
}

Vector<double> Right::coriolis_forces(const Motion<double>& m) const {
  return joined(reference::coriolis_forces(robot_, m));
}

Matrix<double> Right::joint_space_inertia(const Vector<double>& q) const {
  const Matrix<double> H = reference::joint_space_inertia(robot_, q);
  return 0.5 * (H + transpose(H));  // generated code writes both elements of a pair from one value
}

// Eliminates coordinates from the deepest ones up.
FactorResults Right::inertia_factor(const Vector<double>& q, const Vector<double>& x) const {
  const Matrix<double> H = Right::joint_space_inertia(q);
  const int n = H.rows();
  const auto depth = [&](int i) {
    int count = 0;
    for (int k = 0; k < n; ++k) count += carries(robot_, k, i);
    return count;
  };
  std::vector<int> order(static_cast<std::size_t>(n));
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(), [&](int a, int b) { return depth(a) > depth(b); });
  Matrix<double> rest = H, L(n, n);
  for (const int i : order) {
    for (int j = 0; j < n; ++j)
      if (carries(robot_, j, i)) L(i, j) = rest(i, j) / std::sqrt(rest(i, i));
    for (int j = 0; j < n; ++j)
      for (int k = 0; k < n; ++k) rest(j, k) -= L(i, j) * L(i, k);
  }
  const Matrix<double> unit = Matrix<double>::identity(n);
  Matrix<double> inverse = solve(H, unit), inverse_L = solve(L, unit);
  for (int i = 0; i < n; ++i) {
    for (int j = 0; j < i; ++j) inverse(i, j) = inverse(j, i);
    for (int j = 0; j < n; ++j)
      if (!carries(robot_, j, i)) inverse_L(i, j) = 0;  // where pivoting left rounding noise
  }
  return {L, inverse_L, inverse, solve(H, x)};
}

// Column by column, from unit velocities.
Matrix<double> Right::centroidal_momentum_matrix(const Vector<double>& q) const {
  Matrix<double> A(6, coordinates(robot_.floating_base, Vector<double>(6), q).rows());
  for (int k = 0; k < A.cols(); ++k) {
    const Vector<double> p = momentum(robot_, unit_motion(q, k)), linear = p.tail(3);
    A.set_block(0, k, stacked(p.head(3) - cross(Right::center_of_mass(q), linear), linear));
  }
  return A;
}

Vector<double> Right::center_of_mass(const Vector<double>& q) const {
  return 1 / moving_mass(robot_) * first_moment(robot_, q);
}

Matrix<double> Right::center_of_mass_jacobian(const Vector<double>& q) const {
  const Matrix<double> A = Right::centroidal_momentum_matrix(q);
  return 1 / moving_mass(robot_) * A.block(3, 0, 3, A.cols());
}

double Right::kinetic_energy(const Motion<double>& m) const {
  return reference::kinetic_energy(robot_, m);
}

double Right::potential_energy(const Vector<double>& q, const Arguments& arguments) const {
  return reference::potential_energy(robot_, q, loads(arguments).gravity);
}

// Of all valid matrices, the one that is easiest to make: half of dH/dt, plus the skew matrix that adds the rest of
// the forces.
Matrix<double> Right::coriolis_matrix(const Motion<double>& m) const {
  constexpr Real kStep = 1e-5L;
  const Motion<Real> motion = cast<Real>(m);
  const auto inertia = [&](Real step) -> Matrix<Real> {
    const Vector<Real> q = motion.q + step * motion.qd;
    return reference::joint_space_inertia(robot_, q);
  };
  const Matrix<Real> half = Real(1) / (24 * kStep) *
                            (Real(8) * (inertia(kStep) - inertia(-kStep)) - (inertia(2 * kStep) - inertia(-2 * kStep)));
  const Vector<Real> v = coordinates(robot_.floating_base, motion.base_velocity, motion.qd);
  const Forces<Real> forces = reference::coriolis_forces(robot_, motion);
  const Vector<Real> rest = coordinates(robot_.floating_base, forces.base_wrench, forces.tau) - half * v;
  const Matrix<Real> skew = 1 / dot(v, v) * (rest * transpose(v) - v * transpose(rest));
  return (half + skew).cast<double>();
}

MomentumAndRate Right::generalized_momentum(const Motion<double>& m, const Arguments& arguments) const {
  const Vector<double> v = coordinates(robot_.floating_base, m.base_velocity, m.qd);
  const Matrix<double> C = Right::coriolis_matrix(m);
  const Vector<double> bias = Right::bias_forces(m, arguments);
  return {Right::joint_space_inertia(m.q) * v, (C + transpose(C)) * v - bias};
}

PathTerms Right::path_dynamics(const Motion<double>& m, const Arguments& arguments) const {
  Motion<double> still = m, steady = m;
  still.qd = Vector<double>(m.qd.rows());
  still.qdd = still.qd;
  steady.qdd = still.qd;
  const Vector<double> c = Right::inverse_dynamics_fully_actuated(still, arguments);
  const Matrix<double> H = Right::joint_space_inertia(m.q);
  return {H * m.qd, H * m.qdd + Right::coriolis_forces(steady), c};
}

TransformForms Right::transform(int index, const Vector<double>& q) const {
  const reflection::Transform& t = robot_.transforms[index];
  const Matrix<double> X = reference::transform(robot_, q, t.left, t.right);
  return {X, motion_form(X), force_form(X)};
}

Matrix<double> Right::jacobian(int index, const Vector<double>& q) const {
  return reference::jacobian(robot_, q, robot_.jacobians[index]);
}

Matrix<double> Right::frame_function(int index, const Motion<double>& m) const {
  const FrameFunction& f = robot_.frame_functions[index];
  const Matrix<Real> all = frame_quantity(robot_, cast<Real>(m), f.quantity, f.left, f.right);
  if (!reflection::is_jacobian(f.quantity)) return all.cast<double>();
  Matrix<Real> J(6, f.column_count);
  for (int k = 0; k < f.column_count; ++k) J.set_block(0, k, all.col(f.columns[k]));
  return J.cast<double>();
}

Loads<double> Right::loads(const Arguments& arguments) {
  Loads<double> result;
  if (arguments.gravity != nullptr) result.gravity = *arguments.gravity;
  if (arguments.external != nullptr) result.external = *arguments.external;
  return result;
}

Vector<double> Right::joined(const Forces<double>& forces) const {
  return coordinates(robot_.floating_base, forces.base_wrench, forces.tau);
}

Motion<double> Right::unit_motion(const Vector<double>& q, int coordinate) const {
  const int first = robot_.floating_base ? 6 : 0;
  Motion<double> m = at_rest(q);
  if (coordinate < first) m.base_velocity(coordinate) = 1;
  if (coordinate >= first) m.qd(coordinate - first) = 1;
  return m;
}

namespace {

template <class Value>
Derivatives derivatives(const Motion<double>& m, const Loads<Real>& acting, const Value& value) {
  const Motion<Real> motion = cast<Real>(m);
  const auto columns = [&](int count, const auto& change) {
    Matrix<double> result(value(motion, acting).rows(), count);
    for (int k = 0; k < count; ++k) {
      const Vector<Real> column = difference([&](Real step) {
        Motion<Real> changed = motion;
        Loads<Real> loads_there = acting;
        Vector<Real> along(count);
        along(k) = step;
        change(changed, loads_there, along);
        return value(changed, loads_there);
      });
      result.set_block(0, k, column.cast<double>());
    }
    return result;
  };
  using Along = Vector<Real>;
  const int n = m.q.rows();
  Derivatives d;
  d.value = value(motion, acting).template cast<double>();
  d.q = columns(n, [](auto& s, auto&, const Along& a) { s.q += a; });
  d.qd = columns(n, [](auto& s, auto&, const Along& a) { s.qd += a; });
  d.last = columns(n, [](auto& s, auto&, const Along& a) { s.qdd += a; });
  d.base_rotation = columns(3, [](auto&, auto& l, const Along& a) { l.gravity = seen_from_turned_base(l.gravity, a); });
  d.base_velocity = columns(6, [](auto& s, auto&, const Along& a) { s.base_velocity += a; });
  d.base_acceleration = columns(6, [](auto& s, auto&, const Along& a) { s.base_acceleration += a; });
  return d;
}

// Of functions that have this acceleration among their results.
Derivatives without_base_acceleration(Derivatives d) {
  d.base_acceleration = Matrix<double>(d.q.rows(), 0);
  return d;
}

}  // namespace

Derivatives RightDerivatives::inverse_dynamics_fully_actuated_derivatives(
    const Motion<double>& m,
    const Arguments& arguments) const {
  const auto value = [&](const Motion<Real>& motion, const Loads<Real>& acting) {
    return cut(robot_.floating_base, generalized_forces(robot_, motion, acting));
  };
  return derivatives(m, loads(arguments).cast<Real>(), value);
}

Derivatives RightDerivatives::inverse_dynamics_derivatives(const Motion<double>& m, const Arguments& arguments) const {
  const auto value = [&](const Motion<Real>& motion, const Loads<Real>& acting) {
    const InverseDynamics<Real> result = reference::inverse_dynamics(robot_, motion, acting);
    return stacked(result.base_acceleration, result.tau);
  };
  return without_base_acceleration(derivatives(m, loads(arguments).cast<Real>(), value));
}

Derivatives RightDerivatives::forward_dynamics_derivatives(
    const Motion<double>& m,
    const Vector<double>& tau,
    const Arguments& arguments) const {
  // The joint forces take the place of the accelerations.
  Motion<double> forces = m;
  forces.qdd = tau;
  const auto value = [&](const Motion<Real>& motion, const Loads<Real>& acting) {
    const Accelerations<Real> result = reference::forward_dynamics(robot_, motion, motion.qdd, acting);
    return coordinates(robot_.floating_base, result.base_acceleration, result.qdd);
  };
  return without_base_acceleration(derivatives(forces, loads(arguments).cast<Real>(), value));
}

Derivatives RightDerivatives::inverse_dynamics_gradient(
    const Motion<double>& m,
    const Vector<double>& weights,
    const Arguments& arguments) const {
  const Derivatives d = RightDerivatives::inverse_dynamics_fully_actuated_derivatives(m, arguments);
  const auto weighed = [&](const Matrix<double>& block) { return transpose(block) * weights; };
  return {d.value,
          weighed(d.q),
          weighed(d.qd),
          weighed(d.last),
          {},
          weighed(d.base_velocity),
          weighed(d.base_acceleration)};
}

Derivatives RightDerivatives::gravity_forces_derivative(const Vector<double>& q, const Arguments& arguments) const {
  Derivatives d =
      RightDerivatives::inverse_dynamics_fully_actuated_derivatives(at_rest(q), {arguments.gravity, nullptr});
  for (int i = 0; !robot_.floating_base && i < d.q.rows(); ++i)
    for (int j = 0; j < i; ++j) d.q(i, j) = d.q(j, i);  // generated code writes each pair from one value
  d.base_velocity = d.base_acceleration = Matrix<double>(d.q.rows(), 0);
  return d;
}

Tables sample(bool floating) {
  Tables tables = crooked_tree(floating);
  for (int left = 0; left < 3; ++left) {
    for (int right = 0; right < 3; ++right)
      tables.add_transform(std::to_string(left) + "_X_" + std::to_string(right), left, right);
  }
  tables.add_jacobian("trunk_J_hand", 0, 1, {1, 0, 3});
  tables.add_jacobian("hand_J_foot", 1, 2, {3, 0, 1, 4, 2});
  using Q = FrameQuantity;
  for (const Q quantity : {Q::jacobian_in_target, Q::spatial_jacobian, Q::jacobian_derivative})
    tables.add_frame_function(name_of(quantity), quantity, 1, 2, {3, 0, 1, 4, 2});
  for (const Q quantity : {Q::frame_bias_acceleration, Q::frame_velocity, Q::frame_acceleration})
    tables.add_frame_function(name_of(quantity), quantity, 1, 2, {});
  return tables;
}

std::string failures(const Right& subject, const Robot& robot) {
  const auto* const derivatives = dynamic_cast<const RightDerivatives*>(&subject);
  Checks checks;
  std::mt19937_64 engine(30);
  for (int i = 0; i < 3; ++i) {
    const Sample s = random_sample(engine, robot);
    const Case c(robot, s, i);
    check_functions(subject, c, checks);
    if (derivatives != nullptr) {
      check_inverse_dynamics_derivatives(*derivatives, c, checks);
      check_free_inverse_dynamics_derivatives(*derivatives, c, checks);
      check_forward_dynamics_derivatives(*derivatives, c, checks);
      check_gravity_forces_derivative(*derivatives, c, checks);
      check_inverse_dynamics_gradient(*derivatives, c, checks);
    }
  }
  return checks.failure_report();
}

}  // namespace robcogen::reference
