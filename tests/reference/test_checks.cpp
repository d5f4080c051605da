// The checks themselves: they pass for correct code, and each mistake of a kind that such generators have made fails
// the checks that are meant to find it.
#include "right_subject.h"

namespace robcogen::reference::checks_test {
namespace {

TEST(Checks, PassWhatIsRight) {
  EXPECT_EQ(failures<RightDerivatives>(false), "");
  EXPECT_EQ(failures<RightDerivatives>(true), "");
}

TEST(Checks, FindGravityOfTheWrongSign) {
  struct Wrong : Right {
    using Right::Right;
    Vector<double> gravity_forces(const Vector<double>& q, const Arguments& arguments) const override {
      return -Right::gravity_forces(q, arguments);
    }
  };
  expect_found<Wrong>({"gravity_forces ", "gravity_forces (gravity)", "P3: gravity_forces = gradient"});
}

TEST(Checks, FindGravityFixedAtCompileTime) {
  struct Wrong : Right {
    using Right::Right;
    Vector<double> bias_forces(const Motion<double>& m, const Arguments& arguments) const override {
      return Right::bias_forces(m, {nullptr, arguments.external});
    }
  };
  expect_found<Wrong>({"bias_forces (gravity)", "bias_forces (gravity, wrenches)"});
}

TEST(Checks, FindDroppedExternalWrenches) {
  struct Wrong : Right {
    using Right::Right;
    Vector<double> inverse_dynamics(const Motion<double>& m, const Arguments& arguments) const override {
      return Right::inverse_dynamics(m, {arguments.gravity, nullptr});
    }
    Vector<double> inverse_dynamics_fully_actuated(const Motion<double>& m, const Arguments& arguments) const override {
      return Right::inverse_dynamics_fully_actuated(m, {arguments.gravity, nullptr});
    }
  };
  expect_found<Wrong>({"inverse_dynamics", "P1: ID(FD(tau)) = tau (wrenches)", "P1: FD(ID(qdd)) = qdd (wrenches)"});
}

// The external wrench of one link is in the base frame's axes.
TEST(Checks, FindAnExternalWrenchInTheWrongFrame) {
  struct Wrong : Right {
    using Right::Right;
    Vector<double> forward_dynamics(const Motion<double>& m, const Vector<double>& tau, const Arguments& arguments)
        const override {
      if (arguments.external == nullptr) return Right::forward_dynamics(m, tau, arguments);
      std::vector<Vector<double>> turned = *arguments.external;
      const Matrix<double> R = rotation_of(link_poses(robot_, m.q)[2]);
      turned[2] = stacked(R * turned[2].head(3), R * turned[2].tail(3));
      return Right::forward_dynamics(m, tau, {arguments.gravity, &turned});
    }
  };
  expect_found<Wrong>({"forward_dynamics (wrenches)", "P1: FD(ID(qdd)) = qdd (gravity, wrenches)"});
}

// The classical acceleration of the base origin in place of the spatial one.
TEST(Checks, FindAClassicalBaseAcceleration) {
  struct Wrong : Right {
    using Right::Right;
    Vector<double> forward_dynamics(const Motion<double>& m, const Vector<double>& tau, const Arguments& arguments)
        const override {
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
    Vector<double> coriolis_forces(const Motion<double>& m) const override { return 0.5 * Right::coriolis_forces(m); }
  };
  expect_found<Wrong>({"coriolis_forces", "P3: v'C = v'(dH/dt)v/2"});
}

TEST(Checks, FindAnAsymmetricInertiaMatrix) {
  struct Wrong : Right {
    using Right::Right;
    Matrix<double> joint_space_inertia(const Vector<double>& q) const override {
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
    Matrix<double> joint_space_inertia(const Vector<double>& q) const override {
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
    Matrix<double> joint_space_inertia(const Vector<double>& q) const override {
      return -Right::joint_space_inertia(q);
    }
  };
  expect_found<Wrong>(
      {"joint_space_inertia", "P2: H positive definite", "P2: columns of H", "P3: v'Hv/2 = kinetic energy"});
}

// A subject with one of its factor results changed.
template <class Change>
struct WrongFactor : Right {
  using Right::Right;
  FactorResults inertia_factor(const Vector<double>& q, const Vector<double>& x) const override {
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
      f.solution = f.L * f.solution;  // only the substitution with L^T
      f.inverse = f.inverse_L;
    }
  };
  expect_found<WrongFactor<Change>>({"H^-1 x", "inverse of H", "H^-1 (tau - bias forces) = forward_dynamics"});
}

TEST(Checks, FindSwappedForms) {
  struct Wrong : Right {
    using Right::Right;
    TransformForms transform(int index, const Vector<double>& q) const override {
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
    TransformForms transform(int index, const Vector<double>& q) const override {
      if (index != 1) return Right::transform(index, q);
      const Matrix<double> X = inverse_of(Right::transform(index, q).homogeneous);
      return {X, motion_form(X), force_form(X)};
    }
  };
  expect_found<Wrong>({"transforms::homogeneous", "P5: composition", "P5: inverse pairs"});
}

TEST(Checks, FindForcesOfNoWrench) {
  struct Wrong : Right {
    using Right::Right;
    TransformForms transform(int index, const Vector<double>& q) const override {
      TransformForms X = Right::transform(index, q);
      X.force(0, 4) += 1e-9;
      return X;
    }
  };
  expect_found<Wrong>({"transforms::force", "P5: force = inverse transpose of motion"});
}

// The forces are right, but the matrix lacks the skew part that passivity needs.
TEST(Checks, FindACoriolisMatrixThatIsNotPassive) {
  struct Wrong : Right {
    using Right::Right;
    Matrix<double> coriolis_matrix(const Motion<double>& m) const override {
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
    Matrix<double> coriolis_matrix(const Motion<double>& m) const override {
      return transpose(Right::coriolis_matrix(m));
    }
  };
  expect_found<Wrong>({"coriolis_matrix times velocity"});
}

TEST(Checks, FindAMomentumWhoseRateLacksCoriolisForces) {
  struct Wrong : Right {
    using Right::Right;
    MomentumAndRate generalized_momentum(const Motion<double>& m, const Arguments& arguments) const override {
      MomentumAndRate result = Right::generalized_momentum(m, arguments);
      result.rate = -1 * bias_forces(m, arguments);
      return result;
    }
  };
  expect_found<Wrong>({"rate of generalized_momentum", "rate of generalized_momentum (gravity)"});
}

TEST(Checks, FindPathDynamicsWithoutCoriolisForces) {
  struct Wrong : Right {
    using Right::Right;
    PathTerms path_dynamics(const Motion<double>& m, const Arguments& arguments) const override {
      PathTerms terms = Right::path_dynamics(m, arguments);
      terms.b = joint_space_inertia(m.q) * m.qdd;
      return terms;
    }
  };
  expect_found<Wrong>({"path_dynamics", "path_dynamics (gravity)"}, {false});
}

// A NaN is not a pass.
TEST(Checks, FindWhatIsNoNumber) {
  struct Wrong : Right {
    using Right::Right;
    Vector<double> inverse_dynamics_fully_actuated(const Motion<double>& m, const Arguments& arguments) const override {
      Vector<double> result = Right::inverse_dynamics_fully_actuated(m, arguments);
      result(result.rows() - 1) = std::nan("");
      return result;
    }
    TransformForms transform(int index, const Vector<double>& q) const override {
      TransformForms X = Right::transform(index, q);
      X.homogeneous(0, 0) = std::nan("");
      return X;
    }
  };
  expect_found<Wrong>({"inverse_dynamics", "P2: columns of H", "transforms::homogeneous", "P5: composition"});
}

}  // namespace
}  // namespace robcogen::reference::checks_test
