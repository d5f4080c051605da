#include "algorithm/spatial/planar_positions.h"

#include <utility>

#include "support/index.h"

namespace robcogen::algorithm {
namespace {

using symbolic::Expression;
using Chains = std::array<PlanarChain, 2>;

// A dependent joint.
struct Unknown {
  std::size_t end = 0;
  std::size_t place = 0;  // in its chain
  const Pivot* pivot = nullptr;

  bool slides() const { return pivot->sense == 0; }
  // The position of a joint that turns.
  Expression angle(const Vector2& turn) const { return atan2(pivot->sense > 0 ? turn.y : -turn.y, turn.x); }
};

std::vector<Unknown> unknowns(const PlanarLoop& loop) {
  std::vector<Unknown> result;
  for (std::size_t e = 0; e < 2; ++e)
    for (std::size_t k = 0; k < loop[e].size(); ++k)
      if (loop[e][k].is_dependent) result.push_back({e, k, &loop[e][k]});
  return result;
}

// The vector from the joint to `last`, or to the point that closes the loop.
Vector2 reach_behind(const Unknown& joint, const Chains& chains, std::size_t last) {
  return chains[joint.end].reach(static_cast<int>(joint.place), last);
}
Vector2 reach_behind(const Unknown& joint, const Chains& chains) {
  return reach_behind(joint, chains, chains[joint.end].pivots.size() - 1);
}

// The vectors from the origin of the plane to the point that closes the loop, and to the joint.
Vector2 reach_of(const PlanarChain& chain) {
  return chain.reach(-1, chain.pivots.size() - 1);
}
Vector2 reach_before(const Unknown& joint, const Chains& chains) {
  return chains[joint.end].reach(-1, joint.place);
}
Vector2 turn_before(const Unknown& joint, const Chains& chains) {
  return chains[joint.end].turn(0, joint.place);
}

// R(a) side + R(b) other = base.
std::array<Expression, 2> two_turns(const Chains& chains, const Unknown& first, const Unknown& second, double branch) {
  const bool is_one_end = first.end == second.end;
  const Vector2 from = reach_before(first, chains);
  const Vector2 side = is_one_end ? reach_behind(first, chains, second.place) : reach_behind(first, chains);
  const Vector2 other = reach_behind(second, chains);
  const Vector2 to = is_one_end ? reach_of(chains[1 - first.end]) : reach_before(second, chains);
  const auto [a, b] = triangle(side, is_one_end ? other : -other, to - from, branch);
  const Expression first_angle = first.angle(turned_back(turn_before(first, chains), a));
  const Vector2 behind =
      is_one_end ? turned(a, chains[first.end].turn(first.place + 1, second.place)) : turn_before(second, chains);
  return {first_angle, second.angle(turned_back(behind, b))};
}

std::array<Expression, 2> slide_and_turn(
    const Chains& chains,
    const Unknown& slide,
    const Unknown& turn,
    double branch) {
  const bool is_one_end = slide.end == turn.end;
  const Vector2 from = reach_before(turn, chains);
  const Vector2 side = reach_behind(turn, chains);
  const Vector2 base = reach_of(chains[1 - turn.end]) - from;
  OnLine found;
  Vector2 a;
  if (is_one_end && slide.place > turn.place) {
    // |side + s u| = |base|, and both turn together.
    const Vector2 u = turned(chains[turn.end].turn(turn.place + 1, slide.place), slide.pivot->direction);
    found = on_line(base, side, u, branch);
    a = turn_between(found.point, base);
  } else {
    // |base + s u| = |side|.
    const Vector2 u = turned(turn_before(slide, chains), slide.pivot->direction);
    found = on_line(side, base, is_one_end ? -u : u, is_one_end ? -branch : branch);
    a = turn_between(side, found.point);
  }
  return {found.beyond, turn.angle(turned_back(turn_before(turn, chains), a))};
}

}  // namespace

std::vector<Expression> closed_positions(
    symbolic::Graph& graph,
    const PlanarLoop& loop,
    double branch,
    std::vector<Expression> q) {
  const Chains chains = {PlanarChain{graph, loop[0], q}, PlanarChain{graph, loop[1], q}};
  std::vector<Unknown> u = unknowns(loop);
  if (u[1].slides() && !u[0].slides()) std::swap(u[0], u[1]);
  const std::array<Expression, 2> found =
      u[0].slides() ? slide_and_turn(chains, u[0], u[1], branch) : two_turns(chains, u[0], u[1], branch);
  for (std::size_t k = 0; k < 2; ++k) q[at(u[k].pivot->joint)] = found[k];
  return q;
}

}  // namespace robcogen::algorithm
