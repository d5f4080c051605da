// Poses of products of primitive transforms are right and cheap.
#include "algorithm/kinematics/joint_poses.h"

#include <Eigen/Geometry>

#include "model/descriptions.h"
#include "values.h"

namespace robcogen::algorithm::pose_test {
namespace {

using model::Axis;
using model::PrimitiveTransform;
using model::Quantity;
using test::evaluate;

class PoseOf : public testing::Test {
 protected:
  Pose pose(const std::vector<PrimitiveTransform>& primitives) { return pose_of(trace, primitives, q); }
  double value(const Expression& e) const { return evaluate(trace.graph, at, {e}).front(); }

  Eigen::Isometry3d matrix_of(const Pose& p) const {
    Eigen::Matrix3d r;
    for (int k = 0; k < 3; ++k) {
      Vector3 axis;
      axis[static_cast<std::size_t>(k)] = graph().one();
      r.col(k) = Eigen::Vector3d(evaluate(graph(), at, test::flat(to_parent(p.rotation, axis))).data());
    }
    const Eigen::Vector3d offset(evaluate(graph(), at, test::flat(p.offset)).data());
    Eigen::Isometry3d t = Eigen::Isometry3d::Identity();
    t.translate(offset).rotate(r).translate(Eigen::Vector3d(0, 0, value(p.slide)));
    return t;
  }

  Eigen::Isometry3d product(const std::vector<PrimitiveTransform>& primitives) const {
    Eigen::Isometry3d t = Eigen::Isometry3d::Identity();
    for (const PrimitiveTransform& p : primitives) {
      const Eigen::Vector3d axis = Eigen::Vector3d::Unit(static_cast<int>(p.axis));
      const double amount = model::evaluate(p.amount, {}, at);
      if (p.rotation)
        t.rotate(Eigen::AngleAxisd(amount, axis));
      else
        t.translate(amount * axis);
    }
    return t;
  }

  Graph& graph() const { return trace.graph; }

  // Only the names of the joints matter, because they are the variables.
  static model::KinematicTree three_joints() {
    model::KinematicTree tree;
    for (const char* name : {"A", "B", "C"}) tree.joints.push_back({name, {}, -1, -1, {}, {}});
    return tree;
  }

  model::KinematicTree tree = three_joints();
  mutable Trace trace{tree};
  std::vector<Expression> q = trace.joint_input("q", symbolic::Role::joint_position);
  std::vector<double> at{0.7, -1.1, 0.4};
};

Quantity pi(std::int64_t num, std::int64_t den = 1) {
  return Quantity(Number::pi_multiple(num, den));
}
PrimitiveTransform turn(Axis axis, const Quantity& angle) {
  return {true, axis, angle};
}
PrimitiveTransform shift(Axis axis, const Quantity& length) {
  return {false, axis, length};
}
const Quantity A = Quantity::variable(0), B = Quantity::variable(1);

TEST_F(PoseOf, IsTheProductOfThePrimitives) {
  const std::vector<Quantity> angles = {
      pi(1, 2),         pi(-1, 2), pi(1), pi(3, 2), pi(1, 4), pi(1, 3),     pi(7, 2),  Quantity(0.3),
      Quantity(-0.3),   A,         -A,    B,        A + B,    A - pi(1, 2), pi(1) - B, B + Quantity(0.2),
      Quantity(2.0) * A};
  for (unsigned seed = 0; seed < 1000; ++seed) {
    std::mt19937 random(seed);
    const auto pick = [&](std::size_t n) { return std::uniform_int_distribution<std::size_t>(0, n - 1)(random); };
    std::vector<PrimitiveTransform> primitives;
    for (std::size_t k = pick(9); k > 0; --k)
      primitives.push_back({pick(2) == 0, static_cast<Axis>(pick(3)), angles[pick(angles.size())]});
    const Eigen::Isometry3d expected = product(primitives), actual = matrix_of(pose(primitives));
    // Ten rotations, and translations of a few metres.
    ASSERT_TRUE(actual.isApprox(expected, 1e-13)) << "seed " << seed << "\n"
                                                  << actual.matrix() << "\n\n"
                                                  << expected.matrix();
  }
}

TEST_F(PoseOf, NothingIsTheIdentity) {
  const Pose p = pose({});
  EXPECT_TRUE(p.rotation.planes.empty());
  EXPECT_TRUE(is_zero(p.offset));
  EXPECT_TRUE(p.slide.is_zero());
}

TEST_F(PoseOf, QuarterTurnsGoLeft) {
  // Ry(A) Rx(90): in the turned axes, the y axis becomes -z.
  const Pose p = pose({turn(Axis::y, A), turn(Axis::x, pi(1, 2))});
  const QuarterTurns x = quarter_turn(0, 1);
  EXPECT_EQ(p.rotation.quarter.image, x.image);
  EXPECT_EQ(p.rotation.quarter.sign, x.sign);
  ASSERT_EQ(p.rotation.planes.size(), 1u);
  EXPECT_EQ(p.rotation.planes[0].axis, 2);
  EXPECT_EQ(p.rotation.planes[0].c, cos(q[0]));
  EXPECT_EQ(p.rotation.planes[0].s, -sin(q[0]));
}

TEST_F(PoseOf, AQuarterTurnAboutTheJointsAxisCostsNothing) {
  const Pose p = pose({turn(Axis::z, pi(-1, 2)), turn(Axis::z, A)});
  ASSERT_EQ(p.rotation.planes.size(), 1u);
  EXPECT_EQ(p.rotation.planes[0].c, cos(q[0]));
  EXPECT_EQ(p.rotation.quarter.image, quarter_turn(2, 3).image);
}

TEST_F(PoseOf, AConstantTurnAboutTheJointsAxisAddsToItsAngle) {
  const Expression sum = q[0] + graph().constant(0.3);
  for (const auto& primitives :
       {std::vector{turn(Axis::z, Quantity(0.3)), turn(Axis::z, A)},
        std::vector{turn(Axis::z, A), turn(Axis::z, Quantity(0.3))}, std::vector{turn(Axis::z, A + Quantity(0.3))}}) {
    const Pose p = pose(primitives);
    ASSERT_EQ(p.rotation.planes.size(), 1u);
    EXPECT_EQ(p.rotation.planes[0].c, cos(sum));
    EXPECT_EQ(p.rotation.planes[0].s, sin(sum));
  }
}

TEST_F(PoseOf, AConstantTurnMergesThroughAQuarterTurn) {
  // Ry(0.3) Rx(90) Rz(A): in the turned axes, y is -z.
  const Pose p = pose({turn(Axis::y, Quantity(0.3)), turn(Axis::x, pi(1, 2)), turn(Axis::z, A)});
  ASSERT_EQ(p.rotation.planes.size(), 1u);
  EXPECT_EQ(p.rotation.planes[0].axis, 2);
  EXPECT_EQ(p.rotation.planes[0].c, cos(q[0] - graph().constant(0.3)));
}

TEST_F(PoseOf, OppositeTurnsVanish) {
  const Pose p = pose(
      {turn(Axis::x, Quantity(0.3)), turn(Axis::y, A), turn(Axis::y, -A), turn(Axis::x, Quantity(-0.3)),
       turn(Axis::z, B)});
  ASSERT_EQ(p.rotation.planes.size(), 1u);
  EXPECT_EQ(p.rotation.planes[0].axis, 2);
}

// Multiples of PI far beyond a full turn, up to the exact range of a Number.
TEST_F(PoseOf, ManyTurns) {
  for (const std::int64_t halves : {std::int64_t{1000000000000000001}, INT64_MAX, -INT64_MAX}) {
    const Pose p = pose({turn(Axis::z, pi(halves, 2))});
    const QuarterTurns expected = quarter_turn(2, static_cast<int>(halves % 4));
    EXPECT_TRUE(p.rotation.planes.empty());
    EXPECT_EQ(p.rotation.quarter.image, expected.image) << halves;
    EXPECT_EQ(p.rotation.quarter.sign, expected.sign) << halves;
    const Pose whole = pose({turn(Axis::z, pi(halves))});
    EXPECT_TRUE(whole.rotation.planes.empty());
    EXPECT_EQ(whole.rotation.quarter.sign, quarter_turn(2, 2).sign) << halves;
  }
}

TEST_F(PoseOf, AnOffsetAlongTheChildsAxisSlides) {
  // The child's z axis is the parent's x axis.
  const Pose p =
      pose({shift(Axis::x, Quantity(0.5)), shift(Axis::y, Quantity(0.2)), turn(Axis::y, pi(1, 2)), turn(Axis::z, A)});
  EXPECT_EQ(p.slide, graph().constant(0.5));
  EXPECT_TRUE(p.offset[0].is_zero());
  EXPECT_EQ(p.offset[1], graph().constant(0.2));
}

TEST_F(PoseOf, APrismaticJointSlides) {
  const Pose p = pose({shift(Axis::x, Quantity(0.5)), shift(Axis::z, A)});
  EXPECT_EQ(p.slide, q[0]);
  EXPECT_EQ(p.offset[0], graph().constant(0.5));
  EXPECT_TRUE(p.offset[2].is_zero());
}

TEST_F(PoseOf, JointPosesFollowTheModel) {
  Diagnostics diagnostics;
  model::Description d = model::test::two_links();
  d.joints[0].placement.translation = {Quantity(0.1), Quantity(0.2), Quantity(0.3)};
  d.joints[0].placement.rotation = {Quantity(0.4), Quantity(0.5), Quantity(0.6)};
  d.joints[1].type = model::JointType::prismatic;
  d.joints[1].placement.rotation = {pi(1, 2), Quantity(), Quantity(0.7)};
  const auto two = model::build(d, diagnostics);
  ASSERT_TRUE(two);
  Trace other(*two);
  const auto positions = other.joint_input("q", symbolic::Role::joint_position);
  const std::vector<Pose> poses = joint_poses(other, positions);
  ASSERT_EQ(poses.size(), 2u);
  for (std::size_t j = 0; j < 2; ++j) {
    const Eigen::Isometry3d motion = two->joints[j].type == model::JointType::revolute
                                         ? Eigen::Isometry3d(Eigen::AngleAxisd(at[j], Eigen::Vector3d::UnitZ()))
                                         : Eigen::Isometry3d(Eigen::Translation3d(0, 0, at[j]));
    const Eigen::Isometry3d expected = model::test::pose(two->joints[j].placement) * motion;
    std::vector<double> here{at[0], at[1]};
    for (int k = 0; k < 3; ++k) {
      Vector3 axis;
      axis[static_cast<std::size_t>(k)] = other.graph.one();
      const Eigen::Vector3d column(evaluate(other.graph, here, test::flat(to_parent(poses[j].rotation, axis))).data());
      EXPECT_TRUE(column.isApprox(expected.linear().col(k), test::kTolerance)) << j << k;
    }
    const Vector3 origin =
        poses[j].offset + to_parent(poses[j].rotation, Vector3{Expression(), Expression(), poses[j].slide});
    const Eigen::Vector3d p(evaluate(other.graph, here, test::flat(origin)).data());
    EXPECT_TRUE(p.isApprox(expected.translation(), test::kTolerance)) << j;
  }
}

}  // namespace
}  // namespace robcogen::algorithm::pose_test
