// The factor L of H = L^T L: values by hand, structural zeros, and cost.
#include <cmath>

#include "algorithm/dynamics/dynamics.h"
#include "hand_robots.h"
#include "symbolic/cost.h"

namespace robcogen::algorithm::inertia_factor_test {
namespace {

using namespace test;
using symbolic::Program;

// A tree without symmetries; link l<i> is the child of joint j<i>, and `parents[i]` is the link that carries it (-1:
// the base).
model::KinematicTree tree_of(const std::vector<int>& parents, bool floating) {
  model::Description d;
  d.name = "tree";
  d.floating_base = floating;
  d.base = model::test::link("base");
  d.base.inertia = model::test::ball(3, 0.5);
  const auto name = [](const char* letter, std::size_t i) { return letter + std::to_string(i); };
  for (std::size_t i = 0; i < parents.size(); ++i) {
    d.links.push_back(model::test::link(name("l", i)));
    model::Inertia inertia = model::test::ball(1.0 + 0.1 * static_cast<double>(i), 0.3);
    for (std::size_t k = 0; k < 3; ++k) inertia.com[k] = model::Quantity(0.1 * static_cast<double>(k + 1));
    inertia.ixy = model::Quantity(0.01);
    d.links.back().inertia = inertia;
    model::Placement crooked;
    for (std::size_t k = 0; k < 3; ++k) {
      crooked.translation[k] = model::Quantity(0.2 + 0.1 * static_cast<double>(k));
      crooked.rotation[k] = model::Quantity(0.3 - 0.2 * static_cast<double>(i + k));
    }
    d.joints.push_back(model::test::joint(name("j", i), model::JointType::revolute, crooked));
  }
  for (std::size_t i = 0; i < parents.size(); ++i) {
    auto& children = parents[i] < 0 ? d.base.children : d.links[static_cast<std::size_t>(parents[i])].children;
    children.push_back({name("l", i), name("j", i), {}, {}});
  }
  return built(d);
}

// True if coordinate b is a or carries a.
bool carries(const std::vector<int>& parents, bool floating, int b, int a) {
  const int base = floating ? 6 : 0;
  if (b < base) return b <= a;
  for (int i = a - base; i >= 0; i = parents[static_cast<std::size_t>(i)])
    if (i == b - base) return true;
  return false;
}

// Marks outputs that are not literal zeros with `x`, row by row.
std::vector<std::string> pattern(const Program& p) {
  const symbolic::OutputArray& output = p.outputs[0];
  std::vector<std::string> rows(static_cast<std::size_t>(output.rows));
  for (std::size_t k = 0; k < output.values.size(); ++k) {
    const symbolic::Operand& value = output.values[k];
    const bool zero = value.kind == symbolic::Operand::Kind::constant &&
                      p.constants[static_cast<std::size_t>(value.index)].value() == 0;
    rows[k % rows.size()] += zero ? '.' : 'x';
  }
  return rows;
}

template <class Condition>
std::vector<std::string> pattern(int size, const Condition& holds) {
  std::vector<std::string> rows(static_cast<std::size_t>(size));
  for (int a = 0; a < size; ++a)
    for (int b = 0; b < size; ++b) rows[static_cast<std::size_t>(a)] += holds(a, b) ? 'x' : '.';
  return rows;
}

struct Programs {
  explicit Programs(const model::KinematicTree& tree)
      : factor(joint_space_inertia_factor(tree, "factor")),
        solve(inertia_factor_solve(tree, factor, "solve")),
        inverse_L(inertia_factor_inverse_L(tree, factor, "inverse_L")),
        inverse(inertia_factor_inverse(tree, factor, "inverse")) {}

  Program factor, solve, inverse_L, inverse;
};

// L^T L by hand: the last pivot is the moment of the lower rod.
TEST(JointSpaceInertiaFactor, OfTwoRods) {
  constexpr double q2 = -1.1;
  const double own = kM2 * kL2 * kL2, coupled = own + kM2 * kL1 * kL2 * std::cos(q2);
  const double whole = kM1 * kL1 * kL1 + kM2 * (kL1 * kL1 + kL2 * kL2 + 2 * kL1 * kL2 * std::cos(q2));
  const double last = std::sqrt(own), below = coupled / last, first = std::sqrt(whole - below * below);
  const model::KinematicTree tree = two_rods();
  const Programs p(tree);
  const symbolic::Arrays<double> found = symbolic::interpret<double>(p.factor, {{"q", {0.4, q2}}});
  expect_near(found.at("L"), {first, below, 0, last});
  expect_near(found.at("inverse_diagonal"), {1 / first, 1 / last});

  expect_near(run(p.inverse_L, found), {1 / first, -below / (first * last), 0, 1 / last});
  const double determinant = whole * own - coupled * coupled;
  expect_near(
      run(p.inverse, found), {own / determinant, -coupled / determinant, -coupled / determinant, whole / determinant});
  symbolic::Arrays<double> with_x = found;
  with_x["x"] = {whole - coupled, coupled - own};  // H (1, -1)
  expect_near(run(p.solve, with_x), {1, -1});
}

class OfATree : public testing::TestWithParam<bool> {
 protected:
  const std::vector<int> parents_ = {-1, 0, 1, 0, 3, 3, -1, 6};
  const int size_ = static_cast<int>(parents_.size()) + (GetParam() ? 6 : 0);
};

TEST_P(OfATree, IsZeroButForAncestors) {
  const Programs p(tree_of(parents_, GetParam()));
  const auto ancestor = [&](int a, int b) { return carries(parents_, GetParam(), b, a); };
  EXPECT_EQ(pattern(p.factor), pattern(size_, ancestor));
  EXPECT_EQ(pattern(p.inverse_L), pattern(size_, ancestor));
  EXPECT_EQ(pattern(p.inverse), pattern(size_, [&](int a, int b) {
              for (int k = 0; k < size_; ++k)
                if (ancestor(a, k) && ancestor(b, k)) return true;
              return false;
            }));
}

// The factor takes a square root and a division for each coordinate except the leaves, whose inertia is constant; later
// functions take none. Solving takes two products for each element of L.
TEST_P(OfATree, CostsWhatItsElementsCost) {
  const Programs p(tree_of(parents_, GetParam()));
  int below_diagonal = 0, in_inverse = 0;
  for (int a = 0; a < size_; ++a) {
    for (int b = 0; b < a; ++b) {
      if (!carries(parents_, GetParam(), b, a)) continue;
      ++below_diagonal;
      ++in_inverse;  // the row's factor
      for (int k = b; k < a; ++k)
        in_inverse += carries(parents_, GetParam(), b, k) && carries(parents_, GetParam(), k, a) ? 1 : 0;
    }
  }
  const symbolic::Cost factor = symbolic::cost(p.factor), solve = symbolic::cost(p.solve);
  const symbolic::Cost inverse_L = symbolic::cost(p.inverse_L), inverse = symbolic::cost(p.inverse);
  constexpr int kLeaves = 4;
  EXPECT_EQ(factor.sqrt, size_ - kLeaves);
  EXPECT_EQ(factor.div, size_ - kLeaves);
  EXPECT_EQ(solve.mul, 2 * (below_diagonal + size_));
  EXPECT_EQ(solve.add, 2 * below_diagonal);
  EXPECT_EQ(inverse_L.mul, in_inverse);
  for (const symbolic::Cost& count : {solve, inverse_L, inverse}) EXPECT_EQ(count.div + count.sqrt, 0);
}

INSTANTIATE_TEST_SUITE_P(Bases, OfATree, testing::Values(false, true), [](const auto& each) {
  return std::string(each.param ? "Floating" : "Fixed");
});

// In the document's order, children come before parents: L is not triangular, but it is as sparse and still a factor.
TEST(JointSpaceInertiaFactor, KeepsTheOrderOfTheDocument) {
  const std::vector<int> parents = {1, 2, -1, 1};
  const model::KinematicTree tree = tree_of(parents, false);
  const Programs p(tree);
  EXPECT_EQ(pattern(p.factor), (std::vector<std::string>{"xxx.", ".xx.", "..x.", ".xxx"}));
  const symbolic::Arrays<double> q = {{"q", {0.3, -0.8, 1.2, 0.5}}};
  const std::vector<double> L = run(p.factor, q), H = run(joint_space_inertia(tree, "H"), q);
  std::vector<double> product(16);
  for (std::size_t r = 0; r < 4; ++r)
    for (std::size_t c = 0; c < 4; ++c)
      for (std::size_t k = 0; k < 4; ++k) product[r + 4 * c] += L[k + 4 * r] * L[k + 4 * c];
  expect_near(product, H);
}

// Two independent slides: H is constant, so L is too.
TEST(JointSpaceInertiaFactor, OfAConstantMatrixIsConstant) {
  model::Description d = model::test::two_links();
  for (model::DescribedJoint& joint : d.joints) joint.type = model::JointType::prismatic;
  const Program p = joint_space_inertia_factor(built(d), "factor");
  EXPECT_TRUE(p.statements.empty());
}

}  // namespace
}  // namespace robcogen::algorithm::inertia_factor_test
