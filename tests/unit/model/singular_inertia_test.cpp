// Joints that meet no inertia: the signs and axes of the geometry that decides this.
#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <string>
#include <utility>

#include "inertia_reference.h"

namespace robcogen::model::singular_inertia_test {
namespace {

using test::number;
using test::pi;

// Joints that meet no inertia: `a` while the joints beyond it are free, `a!` while they are locked, too; `base` for the
// base.
using Found = std::vector<std::string>;

Found found(const Description& d) {
  Diagnostics diagnostics;
  const std::optional<KinematicTree> tree = build(d, diagnostics);
  EXPECT_TRUE(tree.has_value()) << diagnostics.render();
  Found result;
  for (const auto& [joint, locked] : tree->inertia_defects.joints)
    result.push_back(tree->joints[static_cast<std::size_t>(joint)].name + (locked ? "!" : ""));
  if (tree->inertia_defects.free_base) result.push_back("base");
  return result;
}

Inertia point_mass(double x, double y, double z) {
  Inertia i = test::ball(1.0, 0.0);
  i.com = {number(x), number(y), number(z)};
  i.ixx = number(y * y + z * z), i.iyy = number(x * x + z * z), i.izz = number(x * x + y * y);
  i.ixy = number(x * y), i.ixz = number(x * z), i.iyz = number(y * z);
  return i;
}

// A massless first link, and a second joint at `place`, turned by `quarters` right angles about axis `turn`.
Description elbow(const std::array<double, 3>& place, std::size_t turn, int quarters) {
  Description d = test::two_links();
  d.links[0].inertia.reset();
  for (std::size_t i = 0; i < 3; ++i) d.joints[1].placement.translation[i] = number(place[i]);
  d.joints[1].placement.rotation[turn] = pi(quarters, 2);
  return d;
}

// The second axis points along x or y of the first link, or in the opposite direction. A point mass on it lies on the
// first axis if its distance along the second axis cancels the offset, and only then.
TEST(SingularInertia, DependsOnTheSidesOfOffsetsAndTurns) {
  for (const std::size_t turn : {std::size_t{0}, std::size_t{1}}) {
    for (const int quarters : {-1, 1}) {
      for (const double offset : {-1.0, 1.0}) {
        for (const double along : {-1.0, 1.0}) {
          SCOPED_TRACE(testing::Message() << turn << " " << quarters << " " << offset << " " << along);
          // R_x(90) z = -y, R_y(90) z = x
          const double direction = turn == 0 ? -quarters : quarters;
          std::array<double, 3> place = {0.0, 0.0, 0.25};
          place[1 - turn] = offset;
          Description d = elbow(place, turn, quarters);
          d.links[1].inertia = point_mass(0.0, 0.0, along);
          const bool meets = offset + direction * along == 0.0;
          EXPECT_EQ(found(d), meets ? (Found{"a!", "b!"}) : Found{"b!"});
        }
      }
    }
  }
}

// The inertia of a joint's drive is enough for a massless link.
TEST(SingularInertia, DrivesAreInertia) {
  Description d = test::two_links();
  d.links[1].inertia.reset();
  EXPECT_EQ(found(d), Found{"b!"});
  d.joints[1].drive.armature = number(0.01);
  EXPECT_EQ(found(d), Found{});
  d.joints[1].drive.armature = Quantity();
  d.joints[1].drive.rotor = Rotor{number(1e-4), number(10.0)};
  EXPECT_EQ(found(d), Found{});
  // The drive of the other joint does not help.
  std::swap(d.joints[0].drive, d.joints[1].drive);
  EXPECT_EQ(found(d), Found{"b!"});
}

TEST(SingularInertia, DrivesAloneMakeDynamics) {
  Description d = test::two_links();
  for (DescribedLink& link : d.links) link.inertia.reset();
  for (DescribedJoint& joint : d.joints) joint.drive.armature = number(0.01);
  Diagnostics diagnostics;
  const std::optional<KinematicTree> tree = build(d, diagnostics);
  ASSERT_TRUE(tree.has_value());
  EXPECT_FALSE(tree->inertia_defects.no_inertia);
  EXPECT_FALSE(tree->inertia_defects.is_singular());
}

// A point mass off the second axis circles about it. The first axis meets its inertia wherever it is, unless both axes
// are one.
TEST(SingularInertia, IsOfTheFirstJointWhereBothAxesAreOne) {
  for (const int quarters : {0, 1, 2, 3}) {
    SCOPED_TRACE(quarters);
    Description d = elbow({0.0, 0.0, -0.5}, 0, quarters);
    d.links[1].inertia = point_mass(0.3, -0.2, 0.1);
    EXPECT_EQ(found(d), quarters % 2 == 0 ? Found{"a"} : Found{}) << "axes in line, either way round";
    d.joints[1].placement.translation[1] = number(0.5);
    EXPECT_EQ(found(d), Found{}) << "parallel axes";
  }
}

// Two thin rods on one line have no inertia about it; the products of inertia say on which diagonal the first one lies.
TEST(SingularInertia, FollowsTheProductsOfInertia) {
  for (std::size_t axis = 0; axis < 3; ++axis) {
    for (const int side : {-1, 1}) {
      for (const int eighths : {-1, 1}) {
        SCOPED_TRACE(testing::Message() << axis << " " << side << " " << eighths);
        // The base lies along the diagonal of two axes, of which the second is reversed for side -1.
        const std::size_t j = (axis + 1) % 3, k = (axis + 2) % 3;
        std::array<double, 3> u = {0.0, 0.0, 0.0};
        u[j] = 1.0, u[k] = side;
        Description d;
        d.name = "rods";
        d.floating_base = true;
        d.base = test::massless("base", {{"one", "a", {}, {}}});
        d.base.inertia = point_mass(u[0], u[1], u[2]);
        d.base.inertia->com = {};
        d.links = {test::link("one")};
        d.links[0].inertia = test::ball(1.0, 0.0);
        d.links[0].inertia->ixx = d.links[0].inertia->iyy = number(0.2);
        // The other rod slides along itself. Turning z by an angle about x gives (0, -sin, cos), about y (sin, 0, cos).
        d.joints = {test::joint("a", JointType::prismatic)};
        std::array<Quantity, 3>& rotation = d.joints[0].placement.rotation;
        bool in_line = false;
        if (axis == 0) {
          rotation[0] = pi(eighths, 4);
          in_line = side == -eighths;
        } else if (axis == 1) {
          rotation[1] = pi(eighths, 4);
          in_line = side == eighths;
        } else {
          rotation[0] = pi(eighths, 2), rotation[1] = pi(1, 4);  // maps z to (1, -sin of the first, 0)
          in_line = side == -eighths;
        }
        EXPECT_EQ(found(d), in_line ? Found{"base"} : Found{});
      }
    }
  }
}

// A sliding joint meets mass and a turning joint meets inertia, each along or about its own axis.
TEST(SingularInertia, IsThatOfTheJointsOwnMotion) {
  Description d = test::two_links();
  d.links[1].inertia = Inertia();
  d.links[1].inertia->izz = number(0.1);
  EXPECT_EQ(found(d), Found{});
  d.joints[1].type = JointType::prismatic;
  EXPECT_EQ(found(d), Found{"b!"});
  d.links[1].inertia = Inertia();
  d.links[1].inertia->ixx = d.links[1].inertia->iyy = number(0.1);
  d.joints[1].type = JointType::revolute;
  EXPECT_EQ(found(d), Found{"b!"});
  // Two slides in the same direction: the first meets no inertia while the second is free.
  d = elbow({0.3, -0.2, 0.1}, 0, 2);
  for (DescribedJoint& joint : d.joints) joint.type = JointType::prismatic;
  EXPECT_EQ(found(d), Found{"a"});
  d.joints[1].placement.rotation[0] = pi(1, 2);
  EXPECT_EQ(found(d), Found{});
}

// --- random robots, joint by joint, against ranks of parts of the matrix -------------------------------------------

struct RandomRobot {
  Description description;
  std::vector<int> parents;  // links: 0 is the base
};

class RandomRobots {
 public:
  explicit RandomRobots(std::uint64_t seed) : engine_(seed) {}

  RandomRobot make() {
    RandomRobot r;
    Description& d = r.description;
    d.name = "random";
    d.floating_base = pick(3) == 0;
    d.base = test::massless("base");
    d.base.inertia = inertia();
    const int n = 1 + pick(5);
    for (int i = 0; i < n; ++i) {
      const std::string name = std::to_string(i);
      const int parent = pick(4) == 0 ? pick(i + 1) : i;
      r.parents.push_back(parent);
      (parent == 0 ? d.base : d.links[static_cast<std::size_t>(parent - 1)])
          .children.push_back({"l" + name, "j" + name, {}, {}});
      d.links.push_back(test::massless("l" + name));
      d.links.back().inertia = inertia();
      Placement placement;
      // Right angles and half right angles, so that axes coincide or meet; most placements turn about one axis only.
      placement.rotation[static_cast<std::size_t>(pick(3))] = pi(pick(8) - 3, 4);
      if (pick(3) == 0) placement.rotation[static_cast<std::size_t>(pick(3))] = pi(pick(4) - 1, 2);
      for (Quantity& length : placement.translation) length = number(pick(2) == 0 ? 0.0 : pick(3) - 1.0);
      const int type = pick(6);
      d.joints.push_back(test::joint(
          "j" + name,
          type < 2   ? JointType::prismatic
          : type > 2 ? JointType::revolute
                     : JointType::helical,
          placement));
      if (type == 2) d.joints.back().pitch = number(pick(2) == 0 ? -1.0 : 0.25);
    }
    return r;
  }

  Eigen::VectorXd position(std::size_t joints) {
    std::uniform_real_distribution<double> any(-2.5, 2.5);
    return Eigen::VectorXd::NullaryExpr(static_cast<int>(joints), [&] { return any(engine_); });
  }

 private:
  std::mt19937_64 engine_;

  int pick(int below) { return static_cast<int>(engine_() % static_cast<unsigned>(below)); }

  // Returns no inertia, a point mass, a thin rod along an axis or a diagonal, or a ball.
  std::optional<Inertia> inertia() {
    switch (pick(5)) {
      case 0:
      case 1:
        return std::nullopt;
      case 2:
        return point_mass(pick(3) - 1.0, pick(3) - 1.0, pick(3) - 1.0);
      case 3: {
        std::array<double, 3> u = {0.0, 0.0, 0.0};
        u[static_cast<std::size_t>(pick(3))] = 1.0;
        u[static_cast<std::size_t>(pick(3))] = pick(2) == 0 ? 1.0 : -1.0;
        Inertia rod = point_mass(u[0], u[1], u[2]);  // two halves, one on each side
        rod.com = {};
        return rod;
      }
      default:
        return test::ball();
    }
  }
};

// H in several positions: if it is singular in all of them, it is singular in every position.
using Matrices = std::vector<Eigen::MatrixXd>;

int nullity(const Matrices& matrices, const std::vector<int>& rows) {
  const auto n = static_cast<Eigen::Index>(rows.size());
  int least = static_cast<int>(n);
  for (const Eigen::MatrixXd& H : matrices)
    least = std::min(least, test::nullity(Eigen::MatrixXd::NullaryExpr(n, n, [&](Eigen::Index r, Eigen::Index c) {
                       return H(rows[static_cast<std::size_t>(r)], rows[static_cast<std::size_t>(c)]);
                     })));
  return least;
}

// A joint meets no inertia if its motion adds a direction without inertia to the motions of the joints beyond it.
Found expected(const RandomRobot& r, const Matrices& H) {
  const int n = static_cast<int>(r.parents.size()), base = r.description.floating_base ? 6 : 0;
  Found result;
  std::vector<int> joints;
  for (int j = 0; j < n; ++j) {
    std::vector<int> beyond;
    for (int k = j + 1; k < n; ++k) {
      int link = k + 1;
      while (link > j + 1) link = r.parents[static_cast<std::size_t>(link - 1)];
      if (link == j + 1) beyond.push_back(base + k);
    }
    std::vector<int> with_own = beyond;
    with_own.push_back(base + j);
    joints.push_back(base + j);
    if (nullity(H, with_own) == nullity(H, beyond)) continue;
    result.push_back("j" + std::to_string(j) + (nullity(H, {base + j}) == 1 ? "!" : ""));
  }
  std::vector<int> all = joints;
  for (int k = 0; k < base; ++k) all.push_back(k);
  if (nullity(H, all) > nullity(H, joints)) result.push_back("base");
  return result;
}

TEST(SingularInertia, IsThatOfTheRanksOfPartsOfTheMatrixOnRandomRobots) {
  constexpr std::uint64_t kSeed = 2112;
  constexpr int kRounds = ROBCOGEN_TEST_EVERYTHING ? 3000 : 800;
  RandomRobots robots(kSeed);
  int singular = 0, free = 0, whole = 0;
  for (int round = 0; round < kRounds; ++round) {
    SCOPED_TRACE("seed " + std::to_string(kSeed) + ", round " + std::to_string(round));
    const RandomRobot r = robots.make();
    Matrices matrices;
    for (int position = 0; position < 3; ++position)
      matrices.push_back(test::inertia_matrix(r.description, r.parents, robots.position(r.parents.size())));
    const Found wanted = expected(r, matrices);
    ASSERT_EQ(found(r.description), wanted);
    singular += !wanted.empty();
    free +=
        std::any_of(wanted.begin(), wanted.end(), [](const std::string& s) { return s[0] == 'j' && s.back() != '!'; });
    whole += !wanted.empty() && wanted.back() == "base";
  }
  // Each outcome must be frequent for the comparison to mean anything.
  EXPECT_GT(singular, kRounds / 5);
  EXPECT_LT(singular, kRounds * 9 / 10);
  EXPECT_GT(free, kRounds / 100);
  EXPECT_GT(whole, kRounds / 50);
}

}  // namespace
}  // namespace robcogen::model::singular_inertia_test
