// Inverse kinematics in closed form, interpreted: chains of each class with random lengths, at random, singular and
// moved poses, compared with the reference.
#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "document_tree.h"
#include "inverted.h"
#include "linear_algebra.h"
#include "model/named_frame.h"
#include "volume.h"

namespace robcogen::numeric::inverse_kinematics_test {
namespace {

// rad, m: of branches that exist.
constexpr double kExists = 1e-9;
constexpr double kRandom = 1e-11;
// The rounding of a pose and of arc tangents, by which the error of a branch may exceed its misfit.
constexpr double kRounding = 1e-13;

// A joint in the frame of the one before: quarter turns about x, y and z after the translation.
struct Placed {
  char type;
  double x, y, z;
  int turn_x, turn_y, turn_z;
  double off_x = 0, off_y = 0, off_z = 0;  // rad, added to them
};

struct Chain {
  std::string name;
  std::vector<Placed> joints;
  Placed tool;
  InverseTask::Kind kind = InverseTask::Kind::pose;
  int given = -1;
  int branches = 8;
  bool by_swivel = false;
  double tolerance = 0.0;
};

// `parameters`: lengths other than zero are parameters, whose names begin with this, instead of constants, and the
// first joint is canted.
std::string placement(const Placed& p, const std::string& parameters) {
  const auto quarter = [](int turns, double off) {
    const std::string text = turns == 0 ? "0.0" : std::to_string(turns) + ".0 * PI / 2.0";
    return off == 0.0 ? text : text + " + (" + std::to_string(off) + ")";
  };
  const auto length = [&](const char* name, double value) {
    const bool is_constant = parameters.empty() || value == 0.0;
    return is_constant ? std::to_string(value) : parameters + name + "[" + std::to_string(value) + "]";
  };
  const std::string cant = parameters == "l1_" && p.turn_x == 0 ? "cant[0.3]" : quarter(p.turn_x, p.off_x);
  return "translation = (" + length("x", p.x) + ", " + length("y", p.y) + ", " + length("z", p.z) + ") rotation = (" +
         cant + ", " + quarter(p.turn_y, p.off_y) + ", " + quarter(p.turn_z, p.off_z) + ")";
}

KinematicTree tree_of(const Chain& chain, bool has_parameters = false) {
  const auto named = [&](const std::string& name) { return has_parameters ? name : ""; };
  std::string text = "Robot chain {\nRobotBase base { children { L1 via J1 } }\n";
  const std::size_t n = chain.joints.size();
  for (std::size_t k = 1; k <= n; ++k) {
    const std::string next = std::to_string(k + 1), own = std::to_string(k);
    text += "link L" + own + " { id = " + own + " children {";
    if (k < n) text += " L" + next + " via J" + next;
    text += " } ";
    if (k == n) text += "frames { tool { " + placement(chain.tool, named("tool_")) + " } }";
    text += " }\n";
  }
  for (std::size_t k = 1; k <= n; ++k) {
    text += std::string(1, chain.joints[k - 1].type) + "_joint J" + std::to_string(k) + " { ref_frame { " +
            placement(chain.joints[k - 1], named("l" + std::to_string(k) + "_")) + " } }\n";
  }
  return tree_of_text(text + "}\n");
}

// The classes, with random lengths.
std::vector<Chain> chains(std::uint64_t seed) {
  Dice dice(seed);
  const auto length = [&] { return dice.sign() * dice.between(0.1, 0.6); };
  using Kind = InverseTask::Kind;
  const auto with = [](std::vector<Placed> joints, const std::vector<Placed>& more) {
    joints.insert(joints.end(), more.begin(), more.end());
    return joints;
  };
  const auto turn = [](double x, double y, double z, int quarters = 0) { return Placed{'r', x, y, z, quarters, 0, 0}; };
  const std::vector<Placed> arm = {turn(0, 0, length()), turn(length(), length(), 0, -1), turn(length(), 0, length())};
  const std::vector<Placed> upright = {turn(0, 0, length()), turn(0, 0, 0, -1), turn(length(), 0, 0)};
  const std::vector<Placed> shoulder = {turn(0, 0, length()), turn(0, 0, 0, -1), turn(0, 0, 0, 1)};
  const std::vector<Placed> wrist = {turn(length(), length(), 0, 1), turn(0, 0, length(), -1), turn(0, 0, 0, 1)};
  const std::vector<Placed> wrist_in_line = {turn(0, 0, length()), turn(0, 0, 0, -1), turn(0, 0, 0, 1)};
  const std::vector<Placed> elbow_and_wrist = {
      turn(0, 0, length(), -1), turn(0, length(), 0, 1), turn(0, 0, 0, -1), turn(0, 0, 0, 1)};
  const Placed tool = turn(length(), 0, length());
  return {
      {"wrist", with(arm, wrist), tool},
      {"wrist, 1 and 2 meet", with(upright, wrist), turn(0, 0, length())},
      {"2, 3, 4 parallel", with(upright, {turn(length(), 0, 0), turn(0, 0, length(), 1), turn(0, 0, length(), -1)}),
       tool},
      {"leg", with(shoulder, {turn(length(), 0, 0), turn(length(), 0, 0), turn(0, 0, 0, 1)}), tool},
      {"1, 2, 3 and 3, 4, 5 meet",
       with(shoulder, {turn(0, 0, length(), -1), turn(0, 0, 0, 1), turn(length(), 0, 0, 1)}), tool},
      {"Stanford", with({turn(0, 0, length()), turn(0, 0, length(), -1), {'p', 0, 0.3, 0, 1, 0, 0}}, wrist_in_line),
       tool},
      {"gantry", with({{'p', 0, 0, 0, 0, 0, 0}, {'p', 0, 0, 0, 1, 0, 0}, {'p', 0, 0, 0, 0, 1, 0}}, wrist_in_line), tool,
       Kind::pose, -1, 2},
      {"shoulder, elbow, wrist; swivel", with(shoulder, elbow_and_wrist), tool, Kind::pose, -1, 8, true},
      {"shoulder, elbow, wrist; J3 given", with(shoulder, elbow_and_wrist), tool, Kind::pose, 2},
      {"J7 given",
       with(
           shoulder, {turn(0.08, 0, length(), 1), turn(-0.08, length(), 0, -1), turn(0, 0, 0, 1), turn(0.09, 0, 0, 1)}),
       tool, Kind::pose, 6},
      {"leg to a point",
       {{'r', length(), length(), 0, 0, 1, 0}, turn(length(), 0, length(), 1), turn(length(), 0, 0)},
       turn(length(), 0, 0),
       Kind::point,
       -1,
       4},
      {"SCARA",
       {turn(0, 0, length()), turn(length(), 0, 0), {'p', length(), 0, 0, 0, 0, 0}, turn(0, 0, 0)},
       tool,
       Kind::pose,
       -1,
       2},
      {"five joints", with(upright, {turn(length(), 0, 0), turn(0, 0, 0, 1)}), tool, Kind::pose, -1, 4},
      {"axis", with(arm, {turn(length(), length(), 0, 1), turn(0, 0, length(), -1)}), turn(0, length(), 0, 1),
       Kind::axis},
  };
}

Inverted inverted_chain(const Chain& chain, bool has_parameters = false) {
  KinematicTree tree = tree_of(chain, has_parameters);
  const model::FramePair frames = model::frame_pair(tree, "fr_base", "tool");
  return {std::move(tree), frames, {chain.kind, chain.given, chain.by_swivel, chain.tolerance}};
}

int poses() {
  return std::max(100, robot_count() / 2);
}

void for_each_chain(const std::function<void(const Chain&, const Inverted&)>& check) {
  for (const std::uint64_t seed : {std::uint64_t{1}, std::uint64_t{2}})
    for (const Chain& chain : chains(seed)) {
      SCOPED_TRACE(chain.name + ", seed " + std::to_string(seed));
      const Inverted inverted = inverted_chain(chain);
      ASSERT_EQ(inverted.size().branches, chain.branches);
      check(chain, inverted);
    }
}

// All branches that exist have the pose, and one of them has the positions.
TEST(InverseKinematics, BranchesHaveThePose) {
  for_each_chain([](const Chain&, const Inverted& inverted) {
    Dice dice(5);
    for (int i = 0; i < poses(); ++i) {
      const Values q = random_positions(inverted, dice, false);
      const Matrix<double> target = inverted.pose(q);
      double nearest = 10.0;
      for (const Inverted::Branch& branch : inverted.branches(target, q)) {
        ASSERT_TRUE(std::isfinite(branch.misfit) && std::isfinite(branch.determinant));
        if (branch.misfit > kExists) continue;
        EXPECT_LT(inverted.error(branch.q, target), kRandom);
        nearest = std::min(nearest, inverted.distance(branch.q, q));
        if (inverted.has_determinant()) {
          EXPECT_NEAR(std::abs(branch.determinant), std::abs(inverted.determinant(branch.q)), 1e-9);
        }
      }
      EXPECT_LT(nearest, 1e-7);
    }
  });
}

// Where chains are singular, also doubly, no wrong branch is said to exist, and some branch has the pose.
TEST(InverseKinematics, SingularPositionsHaveABranch) {
  for_each_chain([](const Chain& chain, const Inverted& inverted) {
    Dice dice(6);
    int unsolved = 0;
    for (int i = 0; i < poses(); ++i) {
      const Values q = random_positions(inverted, dice, true);
      const Matrix<double> target = inverted.pose(q);
      double best = 10.0;
      for (const Inverted::Branch& branch : inverted.branches(target, q)) {
        for (const double position : branch.q) ASSERT_TRUE(std::isfinite(position));
        const double error = inverted.error(branch.q, target);
        best = std::min(best, error);
        EXPECT_LT(error, branch.misfit + kRounding);
      }
      if (best > kExists) ++unsolved;
    }
    // A stretched elbow with an aligned wrist, and a given joint of a singular arm: rounding of the target decides.
    EXPECT_LE(unsolved, chain.given >= 0 || chain.name == "2, 3, 4 parallel" ? poses() / 10 : 0);
  });
}

// Targets in and out of reach: all numbers are finite, and the misfit of a branch bounds the error of its pose.
TEST(InverseKinematics, TargetsOutOfReach) {
  for_each_chain([](const Chain& chain, const Inverted& inverted) {
    Dice dice(7);
    int missed = 0;
    for (int i = 0; i < poses(); ++i) {
      Matrix<double> target = inverted.pose(random_positions(inverted, dice, false));
      for (int row = 0; row < 3; ++row) target(row, 3) += dice.between(-1.0, 1.0);
      const Values reference = random_positions(inverted, dice, false);
      for (const Inverted::Branch& branch : inverted.branches(target, reference)) {
        for (const double position : branch.q) ASSERT_TRUE(std::isfinite(position));
        const double error = inverted.error(branch.q, target);
        EXPECT_LT(error, branch.misfit + kRounding);
        EXPECT_LT(branch.misfit, 10 * error + kRounding);
        missed += error > 1e-6;
      }
    }
    if (inverted.has_determinant() && chain.given < 0 && !inverted.slides(0) && !inverted.slides(2)) {
      EXPECT_GT(missed, 0);
    }
  });
}

// The branch of the signs of q is q.
TEST(InverseKinematics, SignsNameTheBranch) {
  for_each_chain([](const Chain&, const Inverted& inverted) {
    Dice dice(8);
    for (int i = 0; i < poses() / 2; ++i) {
      const Values q = random_positions(inverted, dice, false), signs = inverted.signs(q);
      const Inverted::Branch branch = inverted.branch(inverted.pose(q), signs, q);
      for (const double sign : signs) EXPECT_EQ(std::abs(sign), 1.0);
      EXPECT_LT(inverted.distance(branch.q, q), 1e-6);
      EXPECT_LT(branch.misfit, kExists);
    }
  });
}

// Lengths that are parameters leave the classes as they are, wherever they are along an axis.
TEST(InverseKinematics, LengthsAreParameters) {
  std::vector<Chain> list = chains(4);
  list.push_back(list.back());
  list.back().tool.turn_x = 3;  // the axis is opposite to the length of the tool
  for (const Chain& chain : list) {
    if (chain.by_swivel) continue;
    SCOPED_TRACE(chain.name);
    const Inverted inverted = inverted_chain(chain, true);
    ASSERT_EQ(inverted.size().branches, chain.branches);
    ASSERT_EQ(inverted.size().joints, inverted.dof());
    Dice dice(10);
    for (int i = 0; i < 20; ++i) {
      const Values q = random_positions(inverted, dice, false);
      const Matrix<double> target = inverted.pose(q);
      double nearest = 10.0;
      for (const Inverted::Branch& branch : inverted.branches(target, q)) {
        EXPECT_LT(inverted.error(branch.q, target), branch.misfit + kRounding);
        if (branch.misfit > kExists) continue;
        nearest = std::min(nearest, inverted.distance(branch.q, q));
        if (inverted.has_determinant()) {
          EXPECT_NEAR(std::abs(branch.determinant), std::abs(inverted.determinant(branch.q)), 1e-9);
        }
      }
      EXPECT_LT(nearest, 1e-7);
      const Inverted::Branch branch = inverted.branch(target, inverted.signs(q), q);
      EXPECT_LT(inverted.distance(branch.q, q), 1e-6);
    }
  }
}

// ---- Chains that are slightly off.

// The chain with axes and tool off by up to this (rad, m).
Chain calibrated(Chain chain, double off, std::uint64_t seed) {
  Dice dice(seed);
  const auto change = [&](Placed& p) {
    for (double* x : {&p.x, &p.y, &p.z, &p.off_x, &p.off_y, &p.off_z}) *x += off * dice.between(-1.0, 1.0);
  };
  for (Placed& joint : chain.joints) change(joint);
  change(chain.tool);
  chain.tolerance = 10.0 * off;
  return chain;
}

std::vector<Chain> calibrated_chains() {
  const std::vector<Chain> known = chains(1);
  std::vector<Chain> list;
  // A wrist, parallel axes, the swivel, a given joint, a leg to a point, an axis.
  for (const std::size_t k : std::initializer_list<std::size_t>{0, 2, 7, 9, 10, 13})
    list.push_back(calibrated(known[k], 1e-4, k + 1));
  Chain offset = known[7];
  offset.name += ", the elbow has an offset";
  offset.joints[3].x = 0.08;
  offset.joints[4].x = -0.08;
  list.push_back(calibrated(offset, 1e-4, 3));
  return list;
}

// Newton steps behind the closed form of the nominal chain: the misfit of a branch is that of the chain itself, and few
// positions are missed.
TEST(InverseKinematics, CalibratedChainsHaveBranches) {
  for (const Chain& chain : calibrated_chains()) {
    SCOPED_TRACE(chain.name);
    const Inverted inverted = inverted_chain(chain);
    ASSERT_EQ(inverted.size().branches, chain.branches);
    ASSERT_GE(inverted.size().newton_steps, 2);
    Dice dice(12);
    constexpr int kPoses = 60;
    int found = 0, by_signs = 0;
    for (int i = 0; i < kPoses; ++i) {
      const Values q = random_positions(inverted, dice, false);
      Matrix<double> target = inverted.pose(q);
      bool is_found = false;
      for (const Inverted::Branch& branch : inverted.branches(target, q)) {
        EXPECT_LT(inverted.error(branch.q, target), branch.misfit + kRounding);
        is_found = is_found || (branch.misfit < kExists && inverted.distance(branch.q, q) < 1e-6);
      }
      found += is_found ? 1 : 0;
      const Inverted::Branch branch = inverted.branch(target, inverted.signs(q), q);
      by_signs += branch.misfit < kExists && inverted.distance(branch.q, q) < 1e-6 ? 1 : 0;
      for (int row = 0; row < 3; ++row) target(row, 3) += dice.between(-1.0, 1.0);
      for (const Inverted::Branch& moved : inverted.branches(target, q)) {
        for (const double position : moved.q) ASSERT_TRUE(std::isfinite(position));
        EXPECT_LT(inverted.error(moved.q, target), moved.misfit + kRounding);
      }
    }
    EXPECT_GE(found, kPoses * 9 / 10);
    EXPECT_GE(by_signs, kPoses * 9 / 10);
  }
}

// A tolerance does not change a chain that has a closed form.
TEST(InverseKinematics, ExactChainsNeedNoTolerance) {
  Chain chain = chains(1)[0];
  chain.tolerance = 1e-3;
  EXPECT_EQ(inverted_chain(chain).size().newton_steps, 0);
}

// ---- All solutions, by brute force: damped steps from random positions.

std::vector<Values> solutions(
    const Inverted& inverted,
    const Matrix<double>& target,
    const std::vector<bool>& moves,
    Dice& dice,
    const Values& given) {
  constexpr double kSame = 1e-5, kStep = 1e-6;
  std::vector<Values> found;
  const int n = inverted.dof();
  const auto residual = [&](const Values& q) {
    const Matrix<double> X = inverted.pose(q);
    Eigen::VectorXd r(12);
    for (int column = 0; column < 4; ++column)
      for (int row = 0; row < 3; ++row) r(3 * column + row) = X(row, column) - target(row, column);
    return r;
  };
  for (int seed = 0; seed < 150; ++seed) {
    Values q = random_positions(inverted, dice, false);
    for (int k = 0; k < n; ++k)
      if (!moves[static_cast<std::size_t>(k)]) q[static_cast<std::size_t>(k)] = given[static_cast<std::size_t>(k)];
    Eigen::VectorXd r = residual(q);
    for (int step = 0; step < 40 && r.norm() > 1e-10; ++step) {
      Eigen::MatrixXd J(12, n);
      for (int k = 0; k < n; ++k) {
        Values moved = q;
        moved[static_cast<std::size_t>(k)] += kStep;
        J.col(k) = moves[static_cast<std::size_t>(k)] ? Eigen::VectorXd((residual(moved) - r) / kStep)
                                                      : Eigen::VectorXd::Zero(12);
      }
      const Eigen::MatrixXd square =
          J.transpose() * J + (1e-9 + r.squaredNorm() / 20) * Eigen::MatrixXd::Identity(n, n);
      const Eigen::VectorXd change = test::solved(square, -J.transpose() * r);
      for (int k = 0; k < n; ++k) q[static_cast<std::size_t>(k)] += change(k);
      r = residual(q);
    }
    if (r.norm() > 1e-9) continue;
    if (std::none_of(
            found.begin(), found.end(), [&](const Values& other) { return inverted.distance(q, other) < kSame; }))
      found.push_back(q);
  }
  return found;
}

TEST(InverseKinematics, NoSolutionIsMissing) {
  const int count = std::max(1, robot_count() / 200);
  for (const Chain& chain : chains(3)) {
    if (chain.kind != InverseTask::Kind::pose || chain.by_swivel) continue;
    SCOPED_TRACE(chain.name);
    const Inverted inverted = inverted_chain(chain);
    Dice dice(9);
    std::vector<bool> moves(chain.joints.size(), true);
    if (chain.given >= 0) moves[static_cast<std::size_t>(chain.given)] = false;
    for (int i = 0; i < count; ++i) {
      const Values q = random_positions(inverted, dice, false);
      const Matrix<double> target = inverted.pose(q);
      const std::vector<Inverted::Branch> branches = inverted.branches(target, q);
      for (const Values& solution : solutions(inverted, target, moves, dice, q))
        EXPECT_TRUE(std::any_of(branches.begin(), branches.end(), [&](const Inverted::Branch& branch) {
          return inverted.distance(branch.q, solution) < 1e-4;
        }));
    }
  }
}

// ---- Chains without closed form.

algorithm::InverseKinematicsReport report_of(const Chain& chain, bool has_parameters = false) {
  const KinematicTree tree = tree_of(chain, has_parameters);
  return algorithm::report_inverse_kinematics(
      tree, model::frame_pair(tree, "fr_base", "tool"), {chain.kind, chain.given, chain.by_swivel, chain.tolerance});
}

TEST(InverseKinematics, SaysWhyThereIsNone) {
  const Chain general = {
      "general",
      {{'r', 0, 0, 0.3, 0, 0, 0},
       {'r', 0.1, 0.2, 0.1, 1, 0, 0},
       {'r', 0.3, 0.1, 0.2, 0, 1, 0},
       {'r', 0.2, 0.3, 0.1, 1, 0, 0},
       {'r', 0.1, 0.1, 0.4, 0, 1, 0},
       {'r', 0.2, 0.1, 0.1, 1, 0, 0}},
      {'r', 0, 0, 0.1, 0, 0, 0}};
  auto report = report_of(general);
  EXPECT_FALSE(report.has_closed_form);
  EXPECT_EQ(report.reason, "no equation finds one of J1, J2, J3, J4, J5, J6");
  EXPECT_EQ(report.hint, "damped steps serve any chain: <robcogen/generic/inverse_kinematics.h>");

  std::vector<Chain> known = chains(4);
  Chain offset = known[0];
  offset.joints[5].x = 0.07;
  report = report_of(offset);
  EXPECT_FALSE(report.has_closed_form);
  EXPECT_NE(report.hint.find("'given J1'"), std::string::npos) << report.hint;
  EXPECT_NE(report.hint.find("<robcogen/generic/all_solutions.h>"), std::string::npos) << report.hint;

  Chain wrist = known[0];
  wrist.joints[5].x = 67e-6;
  report = report_of(wrist);
  EXPECT_FALSE(report.has_closed_form);
  EXPECT_NE(report.reason.find("the axis of J6 misses that of J5 by 67 um"), std::string::npos) << report.reason;

  // The nominal chain of one that is slightly off.
  EXPECT_NE(report.hint.find("'tolerance = 0.001'"), std::string::npos) << report.hint;
  wrist.tolerance = 1e-3;
  report = report_of(wrist);
  EXPECT_TRUE(report.has_closed_form);
  EXPECT_EQ(report.reason.find("8 branches of a nominal chain, from which axes differ by up to "), 0U) << report.reason;
  wrist.tolerance = 1e-5;
  EXPECT_FALSE(report_of(wrist).has_closed_form);
  EXPECT_NE(report_of(calibrated_chains()[2]).reason.find("nominal chain"), std::string::npos);
  Chain swivel = calibrated_chains()[2];
  swivel.tolerance = 0.0;
  EXPECT_NE(report_of(swivel).hint.find("'tolerance = 0.001'"), std::string::npos) << report_of(swivel).hint;
  swivel.by_swivel = false;
  EXPECT_NE(report_of(swivel).hint.find("'swivel, tolerance = 0.001'"), std::string::npos) << report_of(swivel).hint;

  // A parameter that is zero by default.
  Chain shifted = known[0];
  shifted.joints[5].x = 1e-9;
  report = report_of(shifted, true);
  EXPECT_FALSE(report.has_closed_form);
  EXPECT_EQ(report.hint.find("axes must meet and be parallel whatever the values"), 0U) << report.hint;

  Chain redundant = known[9];
  redundant.given = -1;
  report = report_of(redundant);
  EXPECT_EQ(report.reason, "7 joints for 6 coordinates");
  EXPECT_EQ(report.hint, "closed forms exist with 'given J4' and 'given J7'");
  Chain off = calibrated(redundant, 1e-4, 3);
  off.tolerance = 0.0;
  EXPECT_EQ(
      report_of(off).hint, "closed forms exist with 'given J4, tolerance = 0.001' and 'given J7, tolerance = 0.001'");
  redundant.by_swivel = true;
  report = report_of(redundant);
  EXPECT_FALSE(report.has_closed_form);
  EXPECT_EQ(report.reason.find("a swivel angle needs seven joints"), 0U) << report.reason;
  redundant = known[7];
  redundant.by_swivel = false;
  EXPECT_NE(report_of(redundant).hint.find("'swivel'"), std::string::npos) << report_of(redundant).hint;
  EXPECT_TRUE(report_of(known[0]).has_closed_form);
}

}  // namespace
}  // namespace robcogen::numeric::inverse_kinematics_test
