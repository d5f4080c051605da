#include <gtest/gtest.h>

#include "descriptions.h"

namespace robcogen::model::inertia_test {
namespace {

using test::number;
using test::pi;

Eigen::Matrix3d tensor(double ixx, double iyy, double izz, double ixy, double ixz, double iyz) {
  Eigen::Matrix3d I;
  I << ixx, -ixy, -ixz, -ixy, iyy, -iyz, -ixz, -iyz, izz;
  return I;
}

Eigen::Matrix3d tensor(const RigidBodyInertia& b, std::span<const double> p = {}) {
  return tensor(
      evaluate(b.ixx, p), evaluate(b.iyy, p), evaluate(b.izz, p), evaluate(b.ixy, p), evaluate(b.ixz, p),
      evaluate(b.iyz, p));
}

Eigen::Vector3d vector(const std::array<Quantity, 3>& v, std::span<const double> p = {}) {
  return {evaluate(v[0], p), evaluate(v[1], p), evaluate(v[2], p)};
}

// m (|c|^2 1 - c c')
Eigen::Matrix3d point_mass(double m, const Eigen::Vector3d& c) {
  return m * (c.squaredNorm() * Eigen::Matrix3d::Identity() - c * c.transpose());
}

// An inertia from its ten numbers, followed by the six of its reference, in this order.
Inertia inertia_of(const std::vector<Quantity>& v) {
  Inertia i;
  i.mass = v[0];
  i.com = {v[1], v[2], v[3]};
  i.ixx = v[4], i.iyy = v[5], i.izz = v[6], i.ixy = v[7], i.ixz = v[8], i.iyz = v[9];
  i.reference = Placement{{v[10], v[11], v[12]}, {v[13], v[14], v[15]}};
  return i;
}

// Parameters and constants must give the textbook result, which goes through the centre of mass.
TEST(InLinkFrame, AgreesWithTheRouteThroughTheCentreOfMass) {
  constexpr double kTolerance = 1e-13;  // values of order 10, about ten roundings
  const unsigned seed = 20240;
  std::mt19937_64 engine(seed);
  std::uniform_real_distribution<double> any(-2.0, 2.0);
  for (int round = 0; round < 200; ++round) {
    SCOPED_TRACE("seed " + std::to_string(seed) + ", round " + std::to_string(round));
    std::vector<double> values(16);
    std::vector<Quantity> constants, parameters;
    for (std::size_t k = 0; k < values.size(); ++k) {
      values[k] = any(engine);
      constants.push_back(number(values[k]));
      parameters.push_back(Quantity::parameter(static_cast<int>(k)));
    }
    const Inertia inertia = inertia_of(constants);
    const double m = values[0];
    const Eigen::Vector3d c = vector(inertia.com);
    const Eigen::Matrix3d I_F = tensor(values[4], values[5], values[6], values[7], values[8], values[9]);
    const Eigen::Isometry3d T = test::pose(*inertia.reference);
    const Eigen::Matrix3d I_c = I_F - point_mass(m, c);
    const Eigen::Vector3d c_link = T * c;
    const Eigen::Matrix3d I_link = T.rotation() * I_c * T.rotation().transpose() + point_mass(m, c_link);

    const RigidBodyInertia from_constants = in_link_frame(inertia);
    EXPECT_TRUE(from_constants.ixx.is_constant());
    EXPECT_TRUE(tensor(from_constants).isApprox(I_link, kTolerance));
    EXPECT_TRUE(vector(from_constants.first_moment).isApprox(m * c_link, kTolerance));

    const RigidBodyInertia from_parameters = in_link_frame(inertia_of(parameters));
    EXPECT_TRUE(tensor(from_parameters, values).isApprox(I_link, kTolerance));
    EXPECT_TRUE(vector(from_parameters.first_moment, values).isApprox(m * c_link, kTolerance));
  }
}

TEST(InLinkFrame, KeepsWhatIsGivenInTheLinkFrame) {
  Inertia i = test::ball(2.0, 0.25);
  i.com = {number(0.5), Quantity(), number(-1.0)};
  i.ixy = number(0.01);
  const RigidBodyInertia body = in_link_frame(i);
  EXPECT_EQ(body.mass.number().value(), 2.0);
  EXPECT_EQ(vector(body.first_moment), Eigen::Vector3d(1.0, 0.0, -2.0));
  EXPECT_EQ(body.ixx.number().value(), 0.25);
  EXPECT_EQ(body.ixy.number().value(), 0.01);
}

// Right angles permute and negate numbers without changing their magnitudes.
TEST(InLinkFrame, IsExactForRightAngles) {
  Inertia i;
  i.mass = number(3.0);
  i.com = {number(0.1), number(0.2), number(0.3)};
  i.ixx = number(0.7), i.iyy = number(0.8), i.izz = number(0.9);
  i.ixy = number(0.01), i.ixz = number(0.02), i.iyz = number(0.03);
  i.reference = Placement{{}, {pi(1, 2), pi(-1, 2), pi(1)}};
  const RigidBodyInertia body = in_link_frame(i);
  // R = Rx(90) Ry(-90) Rz(180), computed by Eigen and rounded to integers.
  const Eigen::Matrix3d R = test::pose(*i.reference).rotation().array().round().matrix();
  const Eigen::Matrix3d expected = R * tensor(0.7, 0.8, 0.9, 0.01, 0.02, 0.03) * R.transpose();
  EXPECT_EQ(tensor(body), expected);
  EXPECT_EQ(
      vector(body.first_moment),
      R * Eigen::Vector3d(3.0 * 0.1, 3.0 * 0.2, (Quantity(3.0) * number(0.3)).number().value()));
}

TEST(InLinkFrame, FoldsWhatAParametricInertiaLeavesConstant) {
  Inertia i = test::ball();
  i.mass = Quantity::parameter(0);
  i.reference = Placement{{}, {Quantity(), pi(1, 2), Quantity()}};
  const RigidBodyInertia body = in_link_frame(i);
  EXPECT_TRUE(body.first_moment[0].is_zero());
  EXPECT_TRUE(body.ixx.is_constant());
  EXPECT_TRUE(body.ixy.is_zero());
}

TEST(RotationMatrix, IsExactForRightAngles) {
  const auto R = rotation_matrix({{}, {pi(1, 2), pi(1), pi(-3, 2)}});
  const Eigen::Matrix3d expected = test::pose({{}, {pi(1, 2), pi(1), pi(-3, 2)}}).rotation().array().round().matrix();
  for (std::size_t i = 0; i < 3; ++i) EXPECT_EQ(vector(R[i]), expected.row(static_cast<int>(i)).transpose());
}

}  // namespace
}  // namespace robcogen::model::inertia_test
