// Positions that close planar loops, for all orders of joints that turn, slide and follow.
#include "algorithm/spatial/planar_positions.h"

#include <cctype>
#include <cmath>
#include <complex>
#include <numbers>
#include <string>

#include "values.h"

namespace robcogen::algorithm::planar_positions_test {
namespace {

using Point = std::complex<double>;

// A chain in numbers. Joints turn (r) or slide (p); capital letters mark joints that follow.
struct Link {
  char type = 'r';
  int sense = 0;
  Point step;  // from the joint before
  Point direction;
};

// The point after the last joint: the sum of the steps, each turned by all joints before it.
Point end_of(const std::vector<Link>& chain, const Point& last_step, const std::vector<double>& q) {
  Point point, turn = 1.0;
  for (std::size_t k = 0; k < chain.size(); ++k) {
    point += turn * chain[k].step;
    if (chain[k].sense == 0)
      point += turn * q[k] * chain[k].direction;
    else
      turn *= std::polar(1.0, chain[k].sense * q[k]);
  }
  return point + turn * last_step;
}

Point turn_of(const std::vector<Link>& chain, const std::vector<double>& q) {
  Point turn = 1.0;
  for (std::size_t k = 0; k < chain.size(); ++k) turn *= std::polar(1.0, chain[k].sense * q[k]);
  return turn;
}

class ClosedPositions : public testing::TestWithParam<std::array<const char*, 2>> {
 protected:
  test::Numbers numbers;

  Point point() { return {numbers.real(), numbers.real()}; }
  Vector2 vector(const Point& p) { return {numbers.expression(p.real()), numbers.expression(p.imag())}; }
  std::vector<Link> chain(const std::string& joints) {
    std::vector<Link> result;
    for (const char type : joints) {
      const bool slides = std::tolower(type) == 'p';
      result.push_back({type, slides ? 0 : 1 - 2 * numbers.pick(2), point(), std::polar(1.0, numbers.real())});
    }
    return result;
  }
  std::vector<Pivot> pivots(const std::vector<Link>& chain, const Point& last_step, int first_joint) {
    std::vector<Pivot> result;
    for (const Link& link : chain) {
      const bool is_dependent = std::isupper(link.type) != 0;
      result.push_back({first_joint++, link.sense, is_dependent, vector(link.step), vector(link.direction)});
    }
    result.push_back({-1, 0, false, vector(last_step)});
    return result;
  }
};

// One of the two branches gives the positions from which the loop was made; the other branch closes the loop, too.
TEST_P(ClosedPositions, CloseTheLoop) {
  for (int sample = 0; sample < 50; ++sample) {
    const std::array<std::vector<Link>, 2> chains = {chain(GetParam()[0]), chain(GetParam()[1])};
    std::array<std::vector<double>, 2> drawn;
    std::vector<Expression> q;
    for (std::size_t e = 0; e < 2; ++e)
      for (const Link& link : chains[e]) {
        drawn[e].push_back(numbers.real());
        q.push_back(std::isupper(link.type) ? Expression() : numbers.expression(drawn[e].back()));
      }
    std::array<Point, 2> last_steps = {point(), 0.0};
    const Point end = end_of(chains[0], last_steps[0], drawn[0]);
    last_steps[1] = (end - end_of(chains[1], 0.0, drawn[1])) / turn_of(chains[1], drawn[1]);
    const PlanarLoop loop = {
        pivots(chains[0], last_steps[0], 0), pivots(chains[1], last_steps[1], static_cast<int>(chains[0].size()))};

    int found = 0;
    for (const double branch : {1.0, -1.0}) {
      const std::vector<Expression> closed = closed_positions(numbers.graph, loop, branch, q);
      ASSERT_EQ(closed.size(), q.size());
      std::array<std::vector<double>, 2> positions;
      bool is_drawn = true;
      std::size_t joint = 0;
      for (std::size_t e = 0; e < 2; ++e)
        for (std::size_t k = 0; k < chains[e].size(); ++k, ++joint) {
          positions[e].push_back(numbers.value(closed[joint]));
          const double apart = positions[e][k] - drawn[e][k];
          // Square roots of small numbers lose half of the digits.
          is_drawn &= std::abs(chains[e][k].sense == 0 ? apart : std::remainder(apart, 2 * std::numbers::pi)) < 1e-6;
        }
      found += is_drawn ? 1 : 0;
      const Point first = end_of(chains[0], last_steps[0], positions[0]);
      const Point second = end_of(chains[1], last_steps[1], positions[1]);
      EXPECT_LT(std::abs(first - second), 1e-6) << "sample " << sample << ", branch " << branch;
    }
    EXPECT_EQ(found, 1) << "sample " << sample;
  }
}

INSTANTIATE_TEST_SUITE_P(
    AllOrders,
    ClosedPositions,
    testing::Values(
        std::array{"rR", "R"},
        std::array{"rRp", "prRr"},
        std::array{"RrR", "p"},
        std::array{"rRRr", "r"},
        std::array{"r", "pRrRp"},
        std::array{"RrP", "r"},
        std::array{"rRpPr", ""},
        std::array{"rPR", "r"},
        std::array{"PrRp", "r"},
        std::array{"rP", "Rr"},
        std::array{"R", "rpPr"}));

// Two sides of length 1 cannot span 3.
TEST(OpenLoop, HasNoPositions) {
  test::Numbers numbers;
  const auto along_x = [&](double x) { return Vector2{numbers.expression(x), Expression()}; };
  const PlanarLoop loop = {
      std::vector<Pivot>{{0, 1, true, {}}, {1, 1, true, along_x(1.0)}, {-1, 0, false, along_x(1.0)}},
      std::vector<Pivot>{{-1, 0, false, along_x(3.0)}}};
  for (const Expression& q : closed_positions(numbers.graph, loop, 1.0, std::vector<Expression>(2)))
    EXPECT_TRUE(std::isnan(numbers.value(q)));
}

}  // namespace
}  // namespace robcogen::algorithm::planar_positions_test
