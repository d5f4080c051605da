#include "algorithm/spatial/planar_loop.h"

#include <algorithm>

#include "algorithm/spatial/link_chain.h"

namespace robcogen::algorithm {
namespace {

Vector2 in_plane(Graph& graph, const model::Closure& closure, const Vector3& v) {
  std::array<Expression, 2> result;
  for (std::size_t k = 0; k < 2; ++k)
    for (std::size_t i = 0; i < 3; ++i) result[k] += graph.constant(closure.plane[k][i]) * v[i];
  return {result[0], result[1]};
}

std::vector<Pivot> pivots_of(Trace& trace, const model::Closure& closure, std::size_t e) {
  const model::LoopEnd& end = trace.tree.loops[at(closure.loop())].ends[e];
  const std::vector<int>& dependents = closure.dependents;
  const std::vector<Pose> poses = placements_at_zero(trace, end);
  std::vector<Pivot> pivots;
  Vector2 before;
  for (std::size_t k = 0; k < poses.size(); ++k) {
    const Vector2 origin = in_plane(trace.graph, closure, point_through(poses, k, {}));
    Pivot pivot;
    pivot.step = origin - before;
    if (k < end.joints.size()) {
      pivot.joint = end.joints[k];
      pivot.is_dependent = std::find(dependents.begin(), dependents.end(), pivot.joint) != dependents.end();
      pivot.sense = closure.senses[e][k];
      if (pivot.sense == 0)
        pivot.direction = in_plane(trace.graph, closure, direction_through(poses, k, unit_vector(trace.graph, 2)));
    }
    pivots.push_back(pivot);
    before = origin;
  }
  return pivots;
}

}  // namespace

PlanarLoop planar_loop(Trace& trace, const model::Closure& closure) {
  PlanarLoop loop;
  for (std::size_t e = 0; e < 2; ++e) loop[e] = pivots_of(trace, closure, e);
  return loop;
}

Vector2 PlanarChain::turn(std::size_t first, std::size_t last) const {
  Expression angle;
  for (std::size_t k = first; k < last; ++k) {
    const Pivot& pivot = pivots[k];
    if (pivot.sense != 0 && !pivot.is_dependent) angle += pivot.sense > 0 ? q[at(pivot.joint)] : -q[at(pivot.joint)];
  }
  if (angle.is_zero()) return {graph.one(), Expression()};
  return {cos(angle), sin(angle)};
}

Vector2 PlanarChain::reach(int first, std::size_t last) const {
  Vector2 v = pivots[last].step;
  for (int k = static_cast<int>(last) - 1; k > first; --k) {
    const Pivot& pivot = pivots[at(k)];
    if (pivot.sense == 0) {
      if (!pivot.is_dependent) v = v + q[at(pivot.joint)] * pivot.direction;
    } else {
      v = turned(turn(at(k), at(k) + 1), v);
    }
    v = v + pivot.step;
  }
  return v;
}

Posture posture(const PlanarChain& chain) {
  Posture result;
  Vector2 turn = {chain.graph.one(), Expression()};
  Vector2 origin = chain.pivots.front().step;
  std::size_t given = 0;  // the first joint behind the last one that follows
  Vector2 start = turn;
  for (std::size_t k = 0; k + 1 < chain.pivots.size(); ++k) {
    const Pivot& pivot = chain.pivots[k];
    const Expression& position = chain.q[at(pivot.joint)];
    result.origins.push_back(origin);
    result.directions.push_back(pivot.sense == 0 ? turned(turn, pivot.direction) : Vector2{});
    Vector2 step;
    if (pivot.sense == 0) {
      step = position * result.directions.back();
    } else if (pivot.is_dependent) {
      start = turned(turn, {cos(position), pivot.sense > 0 ? sin(position) : -sin(position)});
      turn = start;
      given = k + 1;
    } else {
      turn = turned(start, chain.turn(given, k + 1));
    }
    step = step + turned(turn, chain.pivots[k + 1].step);
    result.steps.push_back(step);
    origin = origin + step;
  }
  result.origins.push_back(origin);
  return result;
}

}  // namespace robcogen::algorithm
