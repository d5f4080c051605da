// Planar loops as pivots, compared with frames in space.
#include "algorithm/spatial/planar_loop.h"

#include "algorithm/spatial/trace.h"
#include "model/descriptions.h"
#include "values.h"

namespace robcogen::algorithm::planar_loop_test {
namespace {

using model::test::number;

model::Placement placement(double x, double y, double z, double turn_x, double turn_y = 0.0) {
  model::Placement result;
  result.translation = {number(x), number(y), number(z)};
  result.rotation = {number(turn_x), number(turn_y), {}};
  return result;
}

// base -a-> crank -b-> rod, base -c-> rocker. The axes are tilted, the axis of c has the opposite direction, and b
// slides across. The loop is closed at q = 0.
model::Description linkage() {
  model::Description d;
  d.name = "linkage";
  d.base = model::test::link("base", {{"crank", "a", {}, {}}, {"rocker", "c", {}, {}}});
  d.links = {model::test::link("crank", {{"rod", "b", {}, {}}}), model::test::link("rod"), model::test::link("rocker")};
  const double tilt = 0.3, pi = 3.14159265358979323846;
  d.joints = {
      model::test::joint("a", model::JointType::revolute, placement(0.1, 0.2, 0.0, tilt)),
      model::test::joint("b", model::JointType::prismatic, placement(0.4, 0.1, 0.2, 0.0, pi / 2)),
      model::test::joint("c", model::JointType::revolute, placement(1.0, 0.1, 0.3, tilt + pi))};
  d.links[2].frames = {{"end", placement(0.1, 0.5, 0.0, 0.0), {}}};
  using model::test::pose;
  const Eigen::Vector3d end = pose(d.joints[2].placement) * pose(d.links[2].frames[0].placement).translation();
  const Eigen::Vector3d tip = (pose(d.joints[0].placement) * pose(d.joints[1].placement)).inverse() * end;
  d.links[1].frames = {{"tip", placement(tip.x(), tip.y(), tip.z(), 0.0), {}}};
  d.loops = {{"loop", {}, model::LoopType::point, {"tip", "end"}, {}}};
  return d;
}

class LinkagePivots : public testing::Test {
 protected:
  void SetUp() override {
    Diagnostics diagnostics;
    auto built = model::build(linkage(), diagnostics);
    ASSERT_TRUE(built) << testing::PrintToString(model::test::codes(diagnostics));
    ASSERT_EQ(built->closures.size(), 1u);
    ASSERT_EQ(built->closures[0].method, model::Closure::Method::planar);
    tree = std::move(*built);
  }

  const model::Closure& closure() const { return tree.closures.front(); }

  Eigen::Vector2d in_plane(const Eigen::Vector3d& v) const {
    const auto along = [&](std::size_t k) {
      return Eigen::Map<const Eigen::Vector3d>(closure().plane[k].data()).dot(v);
    };
    return {along(0), along(1)};
  }

  // Returns the frames of the joints of an end, then the frame of the end, all in the base.
  std::vector<Eigen::Isometry3d> frames(std::size_t e, const std::vector<double>& q) const {
    const model::LoopEnd& end = tree.loops[0].ends[e];
    std::vector<Eigen::Isometry3d> result;
    Eigen::Isometry3d link = Eigen::Isometry3d::Identity();
    for (const int j : end.joints) {
      const model::Joint& joint = tree.joints[at(j)];
      result.push_back(link * model::test::pose(joint.placement));
      link = result.back();
      if (joint.type == model::JointType::prismatic)
        link.translate(Eigen::Vector3d(0, 0, q[at(j)]));
      else
        link.rotate(Eigen::AngleAxisd(q[at(j)], Eigen::Vector3d::UnitZ()));
    }
    result.push_back(link * model::test::pose(end.placement));
    return result;
  }

  model::KinematicTree tree;
};

TEST_F(LinkagePivots, KnowTheirJoints) {
  Trace trace(tree);
  const PlanarLoop loop = planar_loop(trace, closure());
  int dependents = 0;
  for (std::size_t e = 0; e < 2; ++e) {
    const std::vector<int>& joints = tree.loops[0].ends[e].joints;
    ASSERT_EQ(loop[e].size(), joints.size() + 1);
    for (std::size_t k = 0; k < joints.size(); ++k) {
      EXPECT_EQ(loop[e][k].joint, joints[k]);
      EXPECT_EQ(loop[e][k].is_dependent, tree.coupling_of(joints[k]) != nullptr);
      EXPECT_EQ(loop[e][k].sense == 0, tree.joints[at(joints[k])].type == model::JointType::prismatic);
      dependents += loop[e][k].is_dependent ? 1 : 0;
    }
    EXPECT_EQ(loop[e].back().joint, -1);
    EXPECT_FALSE(loop[e].back().is_dependent);
  }
  EXPECT_EQ(dependents, 2);
  EXPECT_EQ(loop[0][0].sense, -loop[1][0].sense);
}

TEST_F(LinkagePivots, AreWhereTheFramesAre) {
  const std::vector<double> q = {0.7, -0.4, 1.3};
  Trace trace(tree);
  std::vector<Expression> symbols;
  for (int joint = 0; joint < 3; ++joint) symbols.push_back(trace.graph.input(joint));
  const PlanarLoop loop = planar_loop(trace, closure());
  const auto value = [&](const Vector2& v) {
    const std::vector<double> numbers = test::evaluate(trace.graph, q, {v.x, v.y});
    return Eigen::Vector2d(numbers[0], numbers[1]);
  };
  for (std::size_t e = 0; e < 2; ++e) {
    const Posture found = posture({trace.graph, loop[e], symbols});
    const std::vector<Eigen::Isometry3d> expected = frames(e, q);
    ASSERT_EQ(found.origins.size(), expected.size());
    for (std::size_t k = 0; k < expected.size(); ++k)
      EXPECT_TRUE(value(found.origins[k]).isApprox(in_plane(expected[k].translation()), test::kTolerance)) << e << k;
    for (std::size_t k = 0; k + 1 < expected.size(); ++k) {
      const Eigen::Vector3d step = expected[k + 1].translation() - expected[k].translation();
      EXPECT_TRUE(value(found.steps[k]).isApprox(in_plane(step), test::kTolerance)) << e << k;
      if (loop[e][k].sense != 0) continue;
      EXPECT_TRUE(value(found.directions[k]).isApprox(in_plane(expected[k].linear().col(2)), test::kTolerance));
    }
  }
}

// A chain turns by its joints that do not follow, and reaches from one following joint to the next.
TEST(PlanarChain, TurnsAndReachesByGivenJoints) {
  test::Numbers numbers;
  const auto vector = [&](double x, double y) { return Vector2{numbers.expression(x), numbers.expression(y)}; };
  const std::vector<Pivot> pivots = {
      {0, 1, false, vector(1.0, 0.0)},
      {1, 1, true, vector(2.0, 0.0)},
      {2, -1, false, vector(0.5, 0.0)},
      {3, 0, false, vector(0.25, 0.0), vector(0.0, 1.0)},
      {-1, 0, false, vector(3.0, 0.0)}};
  const double right = 1.57079632679489661923;
  const std::vector<Expression> q = {
      numbers.expression(right), Expression(), numbers.expression(right), numbers.expression(0.125)};
  const PlanarChain chain = {numbers.graph, pivots, q};
  const auto expect_near = [&](const Vector2& v, double x, double y) {
    EXPECT_NEAR(numbers.value(v.x), x, test::kTolerance);
    EXPECT_NEAR(numbers.value(v.y), y, test::kTolerance);
  };
  expect_near(chain.turn(0, 2), 0.0, 1.0);
  expect_near(chain.turn(0, 4), 1.0, 0.0);
  expect_near(chain.turn(2, 4), 0.0, -1.0);
  EXPECT_TRUE(chain.turn(1, 2).x.is_one());
  expect_near(chain.reach(-1, 1), 1.0, 2.0);
  // After joint 1: half a metre, a quarter turn back with a quarter of a metre, the slide, and three metres.
  expect_near(chain.reach(1, 4), 0.5 + 0.125, -3.25);
}

}  // namespace
}  // namespace robcogen::algorithm::planar_loop_test
