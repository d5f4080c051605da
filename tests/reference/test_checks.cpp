// The checks themselves: they pass for correct code, and each mistake of a kind that tools like this one have made
// fails the checks that are there to find it.
#include <gtest/gtest.h>

#include <numeric>
#include <type_traits>

#include "robcogen/reference/check_control.h"
#include "robcogen/reference/check_derivatives.h"
#include "robcogen/reference/check_factor.h"
#include "robcogen/reference/check_frame_motion.h"
#include "robcogen/reference/check_identities.h"
#include "robcogen/reference/check_kinematics.h"
#include "sample_robots.h"

namespace robcogen::reference {
namespace {

// The reference in double precision, as the subject of checks.
class Right {
 public:
  explicit Right(const Robot& robot) : robot_(robot) {}

  Vector<double> inverse_dynamics(const Motion<double>& m, const Arguments& arguments) const {
    const auto [tau, base_acceleration] = reference::inverse_dynamics(robot_, m, loads(arguments));
    return coordinates(robot_.floating_base, base_acceleration, tau);
  }
  Vector<double> inverse_dynamics_fully_actuated(const Motion<double>& m, const Arguments& arguments) const {
    return joined(reference::inverse_dynamics_fully_actuated(robot_, m, loads(arguments)));
  }
  Vector<double> forward_dynamics(const Motion<double>& m, const Vector<double>& tau, const Arguments& arguments)
      const {
    const auto [qdd, base_acceleration] = reference::forward_dynamics(robot_, m, tau, loads(arguments));
    return coordinates(robot_.floating_base, base_acceleration, qdd);
  }
  Vector<double> bias_forces(const Motion<double>& m, const Arguments& arguments) const {
    return joined(reference::bias_forces(robot_, m, loads(arguments)));
  }
  Vector<double> gravity_forces(const Vector<double>& q, const Arguments& arguments) const {
    return joined(reference::gravity_forces(robot_, q, loads(arguments).gravity));
  }
  Vector<double> coriolis_forces(const Motion<double>& m) const {
    return joined(reference::coriolis_forces(robot_, m));
  }
  Matrix<double> joint_space_inertia(const Vector<double>& q) const {
    const Matrix<double> H = reference::joint_space_inertia(robot_, q);
    return 0.5 * (H + transpose(H));  // generated code writes each element of a pair from one value
  }
  // Elimination from the deepest coordinates up.
  FactorResults inertia_factor(const Vector<double>& q, const Vector<double>& x) const {
    const Matrix<double> H = joint_space_inertia(q);
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
        if (!carries(robot_, j, i)) inverse_L(i, j) = 0;  // where pivoting left rounding
    }
    return {L, inverse_L, inverse, solve(H, x)};
  }
  // Column by column, from unit velocities.
  Matrix<double> centroidal_momentum_matrix(const Vector<double>& q) const {
    Matrix<double> A(6, coordinates(robot_.floating_base, Vector<double>(6), q).rows());
    for (int k = 0; k < A.cols(); ++k) {
      const Vector<double> p = momentum(robot_, unit_motion(q, k)), linear = p.tail(3);
      A.set_block(0, k, stacked(p.head(3) - cross(center_of_mass(q), linear), linear));
    }
    return A;
  }
  Vector<double> center_of_mass(const Vector<double>& q) const {
    return 1 / moving_mass(robot_) * first_moment(robot_, q);
  }
  Matrix<double> center_of_mass_jacobian(const Vector<double>& q) const {
    const Matrix<double> A = centroidal_momentum_matrix(q);
    return 1 / moving_mass(robot_) * A.block(3, 0, 3, A.cols());
  }
  double kinetic_energy(const Motion<double>& m) const { return reference::kinetic_energy(robot_, m); }
  double potential_energy(const Vector<double>& q, const Arguments& arguments) const {
    return reference::potential_energy(robot_, q, loads(arguments).gravity);
  }
  // Of all matrices that will do, the one that is made easily: half of dH/dt, and the skew matrix that adds the rest of
  // the forces.
  Matrix<double> coriolis_matrix(const Motion<double>& m) const {
    constexpr Real kStep = 1e-5L;
    const Motion<Real> motion = cast<Real>(m);
    const auto inertia = [&](Real step) -> Matrix<Real> {
      const Vector<Real> q = motion.q + step * motion.qd;
      return reference::joint_space_inertia(robot_, q);
    };
    const Matrix<Real> half =
        Real(1) / (24 * kStep) *
        (Real(8) * (inertia(kStep) - inertia(-kStep)) - (inertia(2 * kStep) - inertia(-2 * kStep)));
    const Vector<Real> v = coordinates(robot_.floating_base, motion.base_velocity, motion.qd);
    const Forces<Real> forces = reference::coriolis_forces(robot_, motion);
    const Vector<Real> rest = coordinates(robot_.floating_base, forces.base_wrench, forces.tau) - half * v;
    const Matrix<Real> skew = 1 / dot(v, v) * (rest * transpose(v) - v * transpose(rest));
    return (half + skew).cast<double>();
  }
  TransformForms transform(int index, const Vector<double>& q) const {
    const reflection::Transform& t = robot_.transforms[index];
    const Matrix<double> X = reference::transform(robot_, q, t.left, t.right);
    return {X, motion_form(X), force_form(X)};
  }
  Matrix<double> jacobian(int index, const Vector<double>& q) const {
    return reference::jacobian(robot_, q, robot_.jacobians[index]);
  }
  Matrix<double> frame_function(int index, const Motion<double>& m) const {
    const FrameFunction& f = robot_.frame_functions[index];
    const Matrix<Real> all = frame_quantity(robot_, cast<Real>(m), f.quantity, f.left, f.right);
    if (!reflection::is_jacobian(f.quantity)) return all.cast<double>();
    Matrix<Real> J(6, f.column_count);
    for (int k = 0; k < f.column_count; ++k) J.set_block(0, k, all.col(f.columns[k]));
    return J.cast<double>();
  }

 protected:
  static Loads<double> loads(const Arguments& arguments) {
    Loads<double> result;
    if (arguments.gravity != nullptr) result.gravity = *arguments.gravity;
    if (arguments.external != nullptr) result.external = *arguments.external;
    return result;
  }
  Vector<double> joined(const Forces<double>& forces) const {
    return coordinates(robot_.floating_base, forces.base_wrench, forces.tau);
  }

  Motion<double> unit_motion(const Vector<double>& q, int coordinate) const {
    const int first = robot_.floating_base ? 6 : 0;
    Motion<double> m = at_rest(q);
    if (coordinate < first) m.base_velocity(coordinate) = 1;
    if (coordinate >= first) m.qd(coordinate - first) = 1;
    return m;
  }

  Robot robot_;
};

// The same with derivatives: differences, column by column, which take their time.
class RightDerivatives : public Right {
 public:
  using Right::Right;

  Derivatives inverse_dynamics_fully_actuated_derivatives(const Motion<double>& m, const Arguments& arguments) const {
    const auto value = [&](const Motion<Real>& motion, const Loads<Real>& acting) {
      return cut(robot_.floating_base, generalized_forces(robot_, motion, acting));
    };
    return derivatives(m, loads(arguments).cast<Real>(), value);
  }
  Derivatives inverse_dynamics_derivatives(const Motion<double>& m, const Arguments& arguments) const {
    const auto value = [&](const Motion<Real>& motion, const Loads<Real>& acting) {
      const InverseDynamics<Real> result = reference::inverse_dynamics(robot_, motion, acting);
      return stacked(result.base_acceleration, result.tau);
    };
    Derivatives d = derivatives(m, loads(arguments).cast<Real>(), value);
    d.base_acceleration = Matrix<double>(d.q.rows(), 0);
    return d;
  }
  Derivatives forward_dynamics_derivatives(
      const Motion<double>& m,
      const Vector<double>& tau,
      const Arguments& arguments) const {
    // The joint forces stand where accelerations do otherwise.
    Motion<double> forces = m;
    forces.qdd = tau;
    const auto value = [&](const Motion<Real>& motion, const Loads<Real>& acting) {
      const Accelerations<Real> result = reference::forward_dynamics(robot_, motion, motion.qdd, acting);
      return coordinates(robot_.floating_base, result.base_acceleration, result.qdd);
    };
    Derivatives d = derivatives(forces, loads(arguments).cast<Real>(), value);
    d.base_acceleration = Matrix<double>(d.q.rows(), 0);
    return d;
  }
  Derivatives inverse_dynamics_gradient(
      const Motion<double>& m,
      const Vector<double>& weights,
      const Arguments& arguments) const {
    const Derivatives d = inverse_dynamics_fully_actuated_derivatives(m, arguments);
    const auto weighed = [&](const Matrix<double>& block) { return transpose(block) * weights; };
    return {d.value,
            weighed(d.q),
            weighed(d.qd),
            weighed(d.last),
            {},
            weighed(d.base_velocity),
            weighed(d.base_acceleration)};
  }
  Derivatives gravity_forces_derivative(const Vector<double>& q, const Arguments& arguments) const {
    Derivatives d = inverse_dynamics_fully_actuated_derivatives(at_rest(q), {arguments.gravity, nullptr});
    for (int i = 0; !robot_.floating_base && i < d.q.rows(); ++i)
      for (int j = 0; j < i; ++j) d.q(i, j) = d.q(j, i);  // generated code writes each pair from one value
    d.base_velocity = d.base_acceleration = Matrix<double>(d.q.rows(), 0);
    return d;
  }

 private:
  template <class Value>
  Derivatives derivatives(const Motion<double>& m, const Loads<Real>& acting, const Value& value) const {
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
    d.base_rotation =
        columns(3, [](auto&, auto& l, const Along& a) { l.gravity = seen_from_turned_base(l.gravity, a); });
    d.base_velocity = columns(6, [](auto& s, auto&, const Along& a) { s.base_velocity += a; });
    d.base_acceleration = columns(6, [](auto& s, auto&, const Along& a) { s.base_acceleration += a; });
    return d;
  }
};

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

// The report of failures for a subject made of the tables.
template <class Subject>
std::string failures(bool floating) {
  const Tables tables = sample(floating);
  const Robot robot = tables.robot();
  const Subject subject(robot);
  Checks checks;
  std::mt19937_64 engine(30);
  for (int i = 0; i < 3; ++i) {
    const Sample s = random_sample(engine, robot);
    const Case c(robot, s, i);
    check_inverse_dynamics(subject, c, checks);
    check_bias_forces(subject, c, checks);
    check_gravity_gradient(subject, c, checks);
    check_forward_dynamics(subject, c, checks);
    check_round_trips(subject, c, checks);
    check_inertia_matrix(subject, c, checks);
    check_inertia_structure(subject, c, checks);
    check_inertia_columns(subject, c, checks);
    check_energy(subject, c, checks);
    check_power(subject, c, checks);
    check_inertia_factor(subject, c, checks);
    check_factor_dynamics(subject, c, checks);
    check_coriolis_matrix(subject, c, checks);
    if constexpr (std::is_base_of_v<RightDerivatives, Subject>) {
      check_inverse_dynamics_derivatives(subject, c, checks);
      check_free_inverse_dynamics_derivatives(subject, c, checks);
      check_forward_dynamics_derivatives(subject, c, checks);
      check_gravity_forces_derivative(subject, c, checks);
      check_inverse_dynamics_gradient(subject, c, checks);
    }
    check_center_of_mass(subject, c, checks);
    check_centroidal_momentum(subject, c, checks);
    check_free_fall(subject, c, checks);
    check_energies(subject, c, checks);
    check_transforms(subject, c, checks);
    check_jacobians(subject, c, checks);
    check_frame_motions(subject, c, checks);
  }
  return checks.failure_report();
}

// For both bases, all of the named checks fail.
template <class Wrong>
void expect_found(const std::vector<std::string>& names, const std::vector<bool>& bases = {false, true}) {
  for (const bool floating : bases) {
    const std::string report = failures<Wrong>(floating);
    for (const std::string& name : names) EXPECT_NE(report.find("FAIL  " + name), std::string::npos) << report;
  }
}

TEST(Checks, PassWhatIsRight) {
  EXPECT_EQ(failures<RightDerivatives>(false), "");
  EXPECT_EQ(failures<RightDerivatives>(true), "");
}

TEST(Checks, FindGravityOfTheWrongSign) {
  struct Wrong : Right {
    using Right::Right;
    Vector<double> gravity_forces(const Vector<double>& q, const Arguments& arguments) const {
      return -Right::gravity_forces(q, arguments);
    }
  };
  expect_found<Wrong>({"gravity_forces ", "gravity_forces (gravity)", "P3: gravity_forces = gradient"});
}

TEST(Checks, FindGravityFixedAtCompileTime) {
  struct Wrong : Right {
    using Right::Right;
    Vector<double> bias_forces(const Motion<double>& m, const Arguments& arguments) const {
      return Right::bias_forces(m, {nullptr, arguments.external});
    }
  };
  expect_found<Wrong>({"bias_forces (gravity)", "bias_forces (gravity, wrenches)"});
}

TEST(Checks, FindDroppedExternalWrenches) {
  struct Wrong : Right {
    using Right::Right;
    Vector<double> inverse_dynamics(const Motion<double>& m, const Arguments& arguments) const {
      return Right::inverse_dynamics(m, {arguments.gravity, nullptr});
    }
    Vector<double> inverse_dynamics_fully_actuated(const Motion<double>& m, const Arguments& arguments) const {
      return Right::inverse_dynamics_fully_actuated(m, {arguments.gravity, nullptr});
    }
  };
  expect_found<Wrong>({"inverse_dynamics", "P1: ID(FD(tau)) = tau (wrenches)", "P1: FD(ID(qdd)) = qdd (wrenches)"});
}

// The external wrench of one link in the base frame's axes.
TEST(Checks, FindAnExternalWrenchInTheWrongFrame) {
  struct Wrong : Right {
    using Right::Right;
    Vector<double> forward_dynamics(const Motion<double>& m, const Vector<double>& tau, const Arguments& arguments)
        const {
      if (arguments.external == nullptr) return Right::forward_dynamics(m, tau, arguments);
      std::vector<Vector<double>> turned = *arguments.external;
      const Matrix<double> R = rotation_of(link_poses(robot_, m.q)[2]);
      turned[2] = stacked(R * turned[2].head(3), R * turned[2].tail(3));
      return Right::forward_dynamics(m, tau, {arguments.gravity, &turned});
    }
  };
  expect_found<Wrong>({"forward_dynamics (wrenches)", "P1: FD(ID(qdd)) = qdd (gravity, wrenches)"});
}

// The classical acceleration of the base origin where the spatial one is meant.
TEST(Checks, FindAClassicalBaseAcceleration) {
  struct Wrong : Right {
    using Right::Right;
    Vector<double> forward_dynamics(const Motion<double>& m, const Vector<double>& tau, const Arguments& arguments)
        const {
      Vector<double> result = Right::forward_dynamics(m, tau, arguments);
      const Vector<double> extra = cross(m.base_velocity.head(3), m.base_velocity.tail(3));
      for (int k = 0; k < 3; ++k) result(3 + k) += extra(k);
      return result;
    }
  };
  expect_found<Wrong>({"forward_dynamics ", "P1: FD(ID(qdd)) = qdd "}, {true});
}

TEST(Checks, FindCoriolisForcesOfHalfSize) {
  struct Wrong : Right {
    using Right::Right;
    Vector<double> coriolis_forces(const Motion<double>& m) const { return 0.5 * Right::coriolis_forces(m); }
  };
  expect_found<Wrong>({"coriolis_forces", "P3: v'C = v'(dH/dt)v/2"});
}

TEST(Checks, FindAnAsymmetricInertiaMatrix) {
  struct Wrong : Right {
    using Right::Right;
    Matrix<double> joint_space_inertia(const Vector<double>& q) const {
      Matrix<double> H = Right::joint_space_inertia(q);
      H(0, 1) *= 1 + 1e-14;
      return H;
    }
  };
  expect_found<Wrong>({"P2: H = H'"});
}

TEST(Checks, FindAStrayElementBetweenBranches) {
  struct Wrong : Right {
    using Right::Right;
    Matrix<double> joint_space_inertia(const Vector<double>& q) const {
      Matrix<double> H = Right::joint_space_inertia(q);
      const int a = H.rows() - 1, b = H.rows() - 2;  // joints B1 and A3
      H(a, b) = H(b, a) = 1e-17;
      return H;
    }
  };
  expect_found<Wrong>({"P2: structural zeros"});
}

TEST(Checks, FindAnIndefiniteInertiaMatrix) {
  struct Wrong : Right {
    using Right::Right;
    Matrix<double> joint_space_inertia(const Vector<double>& q) const { return -Right::joint_space_inertia(q); }
  };
  expect_found<Wrong>(
      {"joint_space_inertia", "P2: H positive definite", "P2: columns of H", "P3: v'Hv/2 = kinetic energy"});
}

// The subject with one of the results changed.
template <class Change>
struct WrongFactor : Right {
  using Right::Right;
  FactorResults inertia_factor(const Vector<double>& q, const Vector<double>& x) const {
    FactorResults results = Right::inertia_factor(q, x);
    Change()(results);
    return results;
  }
};

TEST(Checks, FindTheFactorOfTheOtherProduct) {
  struct Change {
    void operator()(FactorResults& f) const { f.L = transpose(f.L); }
  };
  expect_found<WrongFactor<Change>>({"L'L = H", "structural zeros of L", "L^-1 L = 1"});
}

TEST(Checks, FindAFactorOfTheWrongSign) {
  struct Change {
    void operator()(FactorResults& f) const { f.L = -f.L; }
  };
  expect_found<WrongFactor<Change>>({"diagonal of L is positive", "L^-1 L = 1"});
}

TEST(Checks, FindWhatFillsInBetweenBranches) {
  struct Change {
    void operator()(FactorResults& f) const {
      const int a = f.L.rows() - 1, b = f.L.rows() - 2;  // joints B1 and A3
      f.L(a, b) = 1e-17;
      f.inverse(a, b) = 1e-17;
    }
  };
  expect_found<WrongFactor<Change>>({"structural zeros of L", "H^-1 is symmetric"});
  expect_found<WrongFactor<Change>>({"structural zeros of H^-1"}, {false});
}

TEST(Checks, FindASolutionOfHalfTheWay) {
  struct Change {
    void operator()(FactorResults& f) const {
      f.solution = f.L * f.solution;  // the substitution with L^T alone
      f.inverse = f.inverse_L;
    }
  };
  expect_found<WrongFactor<Change>>({"H^-1 x", "inverse of H", "H^-1 (tau - bias forces) = forward_dynamics"});
}

TEST(Checks, FindSwappedForms) {
  struct Wrong : Right {
    using Right::Right;
    TransformForms transform(int index, const Vector<double>& q) const {
      TransformForms X = Right::transform(index, q);
      std::swap(X.motion, X.force);
      return X;
    }
  };
  expect_found<Wrong>({"transforms::motion", "transforms::force", "P5: motion form of the homogeneous one"});
}

TEST(Checks, FindAnInverseTransform) {
  struct Wrong : Right {
    using Right::Right;
    TransformForms transform(int index, const Vector<double>& q) const {
      if (index != 1) return Right::transform(index, q);
      const Matrix<double> X = inverse_of(Right::transform(index, q).homogeneous);
      return {X, motion_form(X), force_form(X)};
    }
  };
  expect_found<Wrong>({"transforms::homogeneous", "P5: composition", "P5: inverse pairs"});
}

// The wrench on a link that moves with a joint, in axes that do not.
TEST(Checks, FindDerivativesUnderWrenchesThatDoNotMove) {
  struct Wrong : RightDerivatives {
    using RightDerivatives::RightDerivatives;
    Derivatives inverse_dynamics_fully_actuated_derivatives(const Motion<double>& m, const Arguments& arguments) const {
      Derivatives d = RightDerivatives::inverse_dynamics_fully_actuated_derivatives(m, arguments);
      d.q = RightDerivatives::inverse_dynamics_fully_actuated_derivatives(m, {arguments.gravity, nullptr}).q;
      return d;
    }
  };
  for (const char* name : {"inverse_dynamics", "inverse_dynamics_fully_actuated"}) {
    const bool floating = std::string(name) != "inverse_dynamics";
    expect_found<Wrong>({std::string(name) + "_derivatives (wrenches): d_q"}, {floating});
  }
}

TEST(Checks, FindABaseThatTurnsWithGravity) {
  struct Wrong : RightDerivatives {
    using RightDerivatives::RightDerivatives;
    Derivatives inverse_dynamics_fully_actuated_derivatives(const Motion<double>& m, const Arguments& arguments) const {
      Derivatives d = RightDerivatives::inverse_dynamics_fully_actuated_derivatives(m, arguments);
      d.base_rotation = -d.base_rotation;
      d.qd.set_block(0, 0, 0.5 * d.qd.col(0));
      return d;
    }
  };
  const std::string name = "inverse_dynamics_fully_actuated_derivatives";
  expect_found<Wrong>({name + " (gravity, wrenches): d_base_rotation", name + " (gravity, wrenches): d_qd"}, {true});
}

TEST(Checks, FindAForwardDynamicsOfTheWrongSign) {
  struct Wrong : RightDerivatives {
    using RightDerivatives::RightDerivatives;
    Derivatives forward_dynamics_derivatives(
        const Motion<double>& m,
        const Vector<double>& tau,
        const Arguments& arguments) const {
      Derivatives d = RightDerivatives::forward_dynamics_derivatives(m, tau, arguments);
      d.q = -d.q;
      d.last.set_block(0, 0, 1.001 * d.last.col(0));
      return d;
    }
    Derivatives gravity_forces_derivative(const Vector<double>& q, const Arguments& arguments) const {
      Derivatives d = RightDerivatives::gravity_forces_derivative(q, arguments);
      d.q.set_block(0, 0, 1.001 * d.q.col(0));
      return d;
    }
  };
  expect_found<Wrong>(
      {"forward_dynamics_derivatives: d_q", "forward_dynamics_derivatives (gravity, wrenches): d_tau",
       "gravity_forces_derivative: d_q"});
}

TEST(Checks, FindAGradientOfOtherWeights) {
  struct Wrong : RightDerivatives {
    using RightDerivatives::RightDerivatives;
    Derivatives inverse_dynamics_gradient(
        const Motion<double>& m,
        const Vector<double>& weights,
        const Arguments& arguments) const {
      return RightDerivatives::inverse_dynamics_gradient(m, 1.001 * weights, arguments);
    }
  };
  const std::string all = "inverse_dynamics_gradient (gravity, wrenches)";
  expect_found<Wrong>({"inverse_dynamics_gradient: d_q", all + ": d_qd", all + ": d_qdd"});
}

TEST(Checks, FindABaseThatIsHeldInDerivatives) {
  struct Wrong : RightDerivatives {
    using RightDerivatives::RightDerivatives;
    Derivatives inverse_dynamics_derivatives(const Motion<double>& m, const Arguments& arguments) const {
      Derivatives d = RightDerivatives::inverse_dynamics_derivatives(m, arguments);
      d.q = RightDerivatives::inverse_dynamics_fully_actuated_derivatives(m, arguments).q;
      return d;
    }
  };
  expect_found<Wrong>({"inverse_dynamics_derivatives: d_q"}, {true});
}

TEST(Checks, FindForcesOfNoWrench) {
  struct Wrong : Right {
    using Right::Right;
    TransformForms transform(int index, const Vector<double>& q) const {
      TransformForms X = Right::transform(index, q);
      X.force(0, 4) += 1e-9;
      return X;
    }
  };
  expect_found<Wrong>({"transforms::force", "P5: force = inverse transpose of motion"});
}

// The columns of an up-going chain have the other sign.
TEST(Checks, FindAJacobianOfTheWrongSign) {
  struct Wrong : Right {
    using Right::Right;
    Matrix<double> jacobian(int index, const Vector<double>& q) const {
      Matrix<double> J = Right::jacobian(index, q);
      if (index == 1) J.set_block(0, 0, -J.col(0));
      return J;
    }
  };
  expect_found<Wrong>({"jacobians", "P4: J qd = velocity"});
}

// Right forces, but not the skew part that passivity needs.
TEST(Checks, FindACoriolisMatrixThatIsNotPassive) {
  struct Wrong : Right {
    using Right::Right;
    Matrix<double> coriolis_matrix(const Motion<double>& m) const {
      const Vector<double> v = coordinates(robot_.floating_base, m.base_velocity, m.qd);
      return 1 / dot(v, v) *
             (coordinates(
                  robot_.floating_base, reference::coriolis_forces(robot_, m).base_wrench,
                  reference::coriolis_forces(robot_, m).tau) *
              transpose(v));
    }
  };
  expect_found<Wrong>({"dH/dt - 2 C is skew symmetric"});
}

TEST(Checks, FindACoriolisMatrixTransposed) {
  struct Wrong : Right {
    using Right::Right;
    Matrix<double> coriolis_matrix(const Motion<double>& m) const { return transpose(Right::coriolis_matrix(m)); }
  };
  expect_found<Wrong>({"coriolis_matrix times velocity"});
}

// A fixed base has a part in nothing that moves.
TEST(Checks, FindAFixedBaseInTheCenterOfMass) {
  struct Wrong : Right {
    using Right::Right;
    Vector<double> center_of_mass(const Vector<double>& q) const {
      const double base = robot_.links[0].mass, moving = moving_mass(robot_);
      return moving / (moving + base) * Right::center_of_mass(q);
    }
    double potential_energy(const Vector<double>& q, const Arguments& arguments) const {
      return Right::potential_energy(q, arguments) + 1e-9;
    }
  };
  expect_found<Wrong>({"center_of_mass", "potential_energy ", "potential_energy (gravity)"});
}

// About the base origin instead of the centre of mass.
TEST(Checks, FindMomentumAboutTheWrongPoint) {
  struct Wrong : Right {
    using Right::Right;
    Matrix<double> centroidal_momentum_matrix(const Vector<double>& q) const {
      Matrix<double> A = Right::centroidal_momentum_matrix(q);
      for (int k = 0; k < A.cols(); ++k) A.set_block(0, k, momentum(robot_, unit_motion(q, k)));
      return A;
    }
  };
  expect_found<Wrong>({"centroidal_momentum_matrix (angular)"});
  expect_found<Wrong>({"P3: free fall"}, {true});
}

TEST(Checks, FindACenterOfMassThatRidesOnAJoint) {
  struct Wrong : Right {
    using Right::Right;
    Matrix<double> center_of_mass_jacobian(const Vector<double>& q) const {
      Matrix<double> J = Right::center_of_mass_jacobian(q);
      J.set_block(0, J.cols() - 1, Vector<double>(3));
      return J;
    }
    double kinetic_energy(const Motion<double>& m) const { return 2 * Right::kinetic_energy(m); }
  };
  expect_found<Wrong>({"center_of_mass_jacobian", "kinetic_energy"});
}

// A NaN is not a pass.
TEST(Checks, FindWhatIsNoNumber) {
  struct Wrong : Right {
    using Right::Right;
    Vector<double> inverse_dynamics_fully_actuated(const Motion<double>& m, const Arguments& arguments) const {
      Vector<double> result = Right::inverse_dynamics_fully_actuated(m, arguments);
      result(result.rows() - 1) = std::nan("");
      return result;
    }
    TransformForms transform(int index, const Vector<double>& q) const {
      TransformForms X = Right::transform(index, q);
      X.homogeneous(0, 0) = std::nan("");
      return X;
    }
  };
  expect_found<Wrong>({"inverse_dynamics", "P2: columns of H", "transforms::homogeneous", "P5: composition"});
}

// A Jacobian that leaves out a joint of its chain agrees with the columns that it lists, but not with the velocity.
TEST(Checks, FindAMissingColumn) {
  Tables tables = crooked_tree(false);
  tables.add_jacobian("trunk_J_hand", 0, 1, {1, 3});
  const Robot robot = tables.robot();
  std::mt19937_64 engine(30);
  const Sample s = random_sample(engine, robot);
  Checks checks;
  check_jacobians(Right(robot), Case(robot, s, 0), checks);
  EXPECT_EQ(checks.failure_report().find("FAIL  jacobians"), std::string::npos);
  EXPECT_NE(checks.failure_report().find("FAIL  P4: J qd = velocity"), std::string::npos);
}

// The linear part of another point.
TEST(Checks, FindTwistsAboutTheWrongPoint) {
  struct Wrong : Right {
    using Right::Right;
    Matrix<double> frame_function(int index, const Motion<double>& m) const {
      const FrameFunction& f = robot_.frame_functions[index];
      const Matrix<double> found = Right::frame_function(index, m);
      const Vector<double> p = origin_of(reference::transform(robot_, m.q, f.left, f.right));
      return stacked(found.head(3), found.tail(3) + skew(p) * found.head(3));
    }
  };
  expect_found<Wrong>(
      {"jacobians::in_target", "jacobians::spatial", "jacobians: Jd ", "jacobians: Jd_qd", "velocities",
       "accelerations"});
}

// The acceleration of the point that is at the origin, which moves on, is not the derivative of the twist.
TEST(Checks, FindAClassicalAcceleration) {
  struct Wrong : Right {
    using Right::Right;
    Matrix<double> frame_function(int index, const Motion<double>& m) const {
      const FrameFunction& f = robot_.frame_functions[index];
      const Matrix<double> found = Right::frame_function(index, m);
      if (f.quantity != FrameQuantity::frame_acceleration) return found;
      const Vector<double> V =
          frame_quantity(robot_, cast<Real>(m), FrameQuantity::frame_velocity, f.left, f.right).cast<double>();
      return stacked(found.head(3), found.tail(3) + cross(V.head(3), V.tail(3)));
    }
  };
  expect_found<Wrong>({"accelerations"});
}

// A derivative that leaves out a joint of its chain.
TEST(Checks, FindColumnsOfOtherJoints) {
  Tables tables = crooked_tree(false);
  tables.add_frame_function("trunk_Jd_hand", FrameQuantity::jacobian_derivative, 0, 1, {1, 3});
  const Robot robot = tables.robot();
  std::mt19937_64 engine(30);
  const Sample s = random_sample(engine, robot);
  Checks checks;
  check_frame_motions(Right(robot), Case(robot, s, 0), checks);
  EXPECT_NE(checks.failure_report().find("FAIL  columns"), std::string::npos);
}

}  // namespace
}  // namespace robcogen::reference
