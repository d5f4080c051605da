// The checks of transforms, Jacobians, frame motions and centroidal quantities find the mistakes that they are meant to
// find.
#include "robcogen/reference/check_kinematics.h"

#include "right_subject.h"
#include "robcogen/reference/check_frame_motion.h"
#include "robcogen/reference/compiled_robot.h"

namespace robcogen::reference::check_kinematics_test {
namespace {

// A library whose matrices are stored by rows, although its kernels write columns.
struct StoredByRows {
  using Scalar = double;
  using JointState = Eigen::Matrix<double, 1, 1>;
  static constexpr bool kFloatingBase = false;
  template <int kRows, int kColumns>
  using Matrix = Eigen::Matrix<double, kRows, kColumns, Eigen::RowMajor>;
};

// Numbers its elements in the order in which a kernel writes them.
template <int kCount>
void numbered(const double*, double* elements) noexcept {
  for (int i = 0; i < kCount; ++i) elements[i] = i;
}

// The checks read elements by their indices, as users do.
TEST(Checks, FindMatricesStoredByRows) {
  static constexpr reflection::Transform kTransforms[] = {{"A_X_B", 0, 1, &numbered<16>, &numbered<36>, &numbered<36>}};
  static constexpr reflection::Jacobian kJacobians[] = {{"A_J_B", 0, 1, nullptr, 2, &numbered<12>}};
  Robot tables = {};
  tables.transforms = {kTransforms, 1};
  tables.jacobians = {kJacobians, 1};
  const CompiledRobot<StoredByRows> robot(tables);
  const TransformForms X = robot.transform(0, Vector<double>(1));
  EXPECT_EQ(X.homogeneous(0, 1), 1);
  EXPECT_EQ(X.motion(0, 1), 1);
  EXPECT_EQ(X.force(0, 1), 1);
  EXPECT_EQ(robot.jacobian(0, Vector<double>(1))(0, 1), 1);
}

// The columns of a chain towards the base have the opposite sign.
TEST(Checks, FindAJacobianOfTheWrongSign) {
  struct Wrong : Right {
    using Right::Right;
    Matrix<double> jacobian(int index, const Vector<double>& q) const override {
      Matrix<double> J = Right::jacobian(index, q);
      if (index == 1) J.set_block(0, 0, -J.col(0));
      return J;
    }
  };
  expect_found<Wrong>({"jacobians", "P4: J qd = velocity"});
}

// A fixed base must not contribute to the mass that moves.
TEST(Checks, FindAFixedBaseInTheCenterOfMass) {
  struct Wrong : Right {
    using Right::Right;
    Vector<double> center_of_mass(const Vector<double>& q) const override {
      const double base = robot_.links[0].mass, moving = moving_mass(robot_);
      return moving / (moving + base) * Right::center_of_mass(q);
    }
    double potential_energy(const Vector<double>& q, const Arguments& arguments) const override {
      return Right::potential_energy(q, arguments) + 1e-9;
    }
  };
  expect_found<Wrong>({"center_of_mass", "potential_energy ", "potential_energy (gravity)"});
}

// The momentum is about the base origin instead of the centre of mass.
TEST(Checks, FindMomentumAboutTheWrongPoint) {
  struct Wrong : Right {
    using Right::Right;
    Matrix<double> centroidal_momentum_matrix(const Vector<double>& q) const override {
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
    Matrix<double> center_of_mass_jacobian(const Vector<double>& q) const override {
      Matrix<double> J = Right::center_of_mass_jacobian(q);
      J.set_block(0, J.cols() - 1, Vector<double>(3));
      return J;
    }
    double kinetic_energy(const Motion<double>& m) const override { return 2 * Right::kinetic_energy(m); }
  };
  expect_found<Wrong>({"center_of_mass_jacobian", "kinetic_energy"});
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

// The linear part belongs to another point.
TEST(Checks, FindTwistsAboutTheWrongPoint) {
  struct Wrong : Right {
    using Right::Right;
    Matrix<double> frame_function(int index, const Motion<double>& m) const override {
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

// The classical acceleration of the point at the origin, which moves on, is not the derivative of the twist.
TEST(Checks, FindAClassicalAcceleration) {
  struct Wrong : Right {
    using Right::Right;
    Matrix<double> frame_function(int index, const Motion<double>& m) const override {
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
}  // namespace robcogen::reference::check_kinematics_test
