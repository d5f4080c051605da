#include "inertia_reference.h"

#include <Eigen/Geometry>

#include "linear_algebra.h"

namespace robcogen::model::test {
namespace {

Eigen::Matrix3d skew(const Eigen::Vector3d& v) {
  Eigen::Matrix3d m;
  m << 0, -v.z(), v.y(), v.z(), 0, -v.x(), -v.y(), v.x(), 0;
  return m;
}

}  // namespace

Eigen::MatrixXd inertia_matrix(const Description& d, const std::vector<int>& parents, const Eigen::VectorXd& q) {
  const int n = static_cast<int>(d.joints.size()), b = d.floating_base ? 6 : 0;
  std::vector<Eigen::Isometry3d> world = {Eigen::Isometry3d::Identity()};
  std::vector<Eigen::MatrixXd> jacobians = {Eigen::MatrixXd::Zero(6, b + n)};  // of the link origin: angular, linear
  if (b != 0) jacobians[0].leftCols(6).setIdentity();
  Eigen::MatrixXd H = Eigen::MatrixXd::Zero(b + n, b + n);
  for (int i = 0; i <= n; ++i) {
    if (i > 0) {
      const DescribedJoint& joint = d.joints[static_cast<std::size_t>(i - 1)];
      const int p = parents[static_cast<std::size_t>(i - 1)];
      const bool turns = model::turns(joint.type);
      const double slide = joint.type == JointType::prismatic ? 1.0 : evaluate(joint.pitch);
      const Eigen::Vector3d z = Eigen::Vector3d::UnitZ();
      const Eigen::Isometry3d travel =
          Eigen::AngleAxisd(turns ? q[i - 1] : 0.0, z) * Eigen::Translation3d(slide * q[i - 1] * z);
      const Eigen::Isometry3d parent = world[static_cast<std::size_t>(p)];
      world.push_back(parent * pose(joint.placement) * travel);
      Eigen::MatrixXd J = jacobians[static_cast<std::size_t>(p)];
      J.bottomRows(3) -= skew(world.back().translation() - parent.translation()) * J.topRows(3);
      const Eigen::Vector3d axis = world.back().linear() * z;
      if (turns) J.topRows(3).col(b + i - 1) += axis;
      J.bottomRows(3).col(b + i - 1) += slide * axis;
      jacobians.push_back(J);
    }
    const DescribedLink& link = described_link(d, static_cast<std::size_t>(i));
    if (!link.inertia) continue;
    const Inertia& body = *link.inertia;
    const double m = evaluate(body.mass);
    const Eigen::Vector3d c(evaluate(body.com[0]), evaluate(body.com[1]), evaluate(body.com[2]));
    const Eigen::Vector3d about_origin(evaluate(body.ixx), evaluate(body.iyy), evaluate(body.izz));
    const Eigen::Matrix3d R = world[static_cast<std::size_t>(i)].linear();
    Eigen::Matrix3d I_c = about_origin.asDiagonal();
    I_c(0, 1) = I_c(1, 0) = -evaluate(body.ixy);
    I_c(0, 2) = I_c(2, 0) = -evaluate(body.ixz);
    I_c(1, 2) = I_c(2, 1) = -evaluate(body.iyz);
    I_c += m * skew(c) * skew(c);  // from the origin to the centre of mass
    const Eigen::MatrixXd& J = jacobians[static_cast<std::size_t>(i)];
    const Eigen::MatrixXd angular = J.topRows(3);
    const Eigen::MatrixXd linear = J.bottomRows(3) - skew(R * c) * angular;
    H += m * linear.transpose() * linear + angular.transpose() * R * I_c * R.transpose() * angular;
  }
  return H;
}

int nullity(const Eigen::MatrixXd& H) {
  // All numbers are of order one or zero, so an absolute limit is sufficient.
  constexpr double kZero = 1e-9;
  if (H.size() == 0) return 0;
  const Eigen::VectorXd values = robcogen::test::eigenvalues(H);
  return static_cast<int>((values.array() < kZero).count());
}

}  // namespace robcogen::model::test
