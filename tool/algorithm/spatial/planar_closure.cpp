// Closures of loops in a plane.
#include <algorithm>
#include <array>

#include "algorithm/spatial/closures.h"
#include "algorithm/spatial/link_chain.h"
#include "algorithm/spatial/triangle.h"

namespace robcogen::algorithm {
namespace {

// A joint, or the end of the loop behind the last one, as the plane has it at q = 0.
struct Pivot {
  int joint = -1;
  int sense = 0;      // 1, -1; 0 of a joint that slides
  Vector2 step;       // from the pivot before
  Vector2 direction;  // of a joint that slides
};

// What is known of one end in the loop's posture.
struct Posture {
  std::vector<Vector2> origins;     // of the pivots
  std::vector<Vector2> directions;  // of joints that slide
  std::vector<Vector2> steps;       // from each pivot to the next one
};

class PlanarClosure : public TracedClosure {
 public:
  PlanarClosure(Trace& trace, const model::Closure& closure, std::vector<Expression>& q, Positions positions)
      : TracedClosure(trace, closure), q_(q) {
    for (std::size_t e = 0; e < 2; ++e) ends_[e] = pivots(e);
    if (positions == Positions::solved) solve();
    q = q_;
    for (std::size_t e = 0; e < 2; ++e) postures_[e] = posture(e);
  }

 private:
  std::vector<Expression> q_;
  std::array<std::vector<Pivot>, 2> ends_;  // the point that closes the loop last
  std::array<Posture, 2> postures_;

  // ---- The model.

  Vector2 in_plane(const Vector3& v) const {
    std::array<Expression, 2> result;
    for (std::size_t k = 0; k < 2; ++k)
      for (std::size_t i = 0; i < 3; ++i) result[k] += trace_.graph.constant(closure_.plane[k][i]) * v[i];
    return {result[0], result[1]};
  }

  std::vector<Pivot> pivots(std::size_t e) const {
    const model::LoopEnd& end = trace_.tree.loops[at(closure_.loop())].ends[e];
    const std::vector<Pose> poses = placements_at_zero(trace_, end);
    std::vector<Pivot> result;
    Vector2 before;
    for (std::size_t k = 0; k < poses.size(); ++k) {
      const Vector2 origin = in_plane(point_through(poses, k, {}));
      Pivot pivot;
      pivot.step = origin - before;
      if (k < end.joints.size()) {
        pivot.joint = end.joints[k];
        pivot.sense = closure_.senses[e][k];
        if (pivot.sense == 0) pivot.direction = in_plane(direction_through(poses, k, unit_vector(trace_.graph, 2)));
      }
      result.push_back(pivot);
      before = origin;
    }
    return result;
  }

  // ---- Given joints.

  // Of joints from `first` up to `last`, without this one, that are given.
  Vector2 turn_of(std::size_t e, std::size_t first, std::size_t last) const {
    Expression angle;
    for (std::size_t k = first; k < last; ++k) {
      const Pivot& pivot = ends_[e][k];
      if (pivot.sense != 0 && !is_dependent(pivot.joint))
        angle += pivot.sense > 0 ? q_[at(pivot.joint)] : -q_[at(pivot.joint)];
    }
    if (angle.is_zero()) return {trace_.graph.one(), Expression()};
    return {cos(angle), sin(angle)};
  }

  // From a pivot to another one behind it, as seen from behind the first; both may be dependent, what is between is
  // given. `first` is -1 for the origin of the plane.
  Vector2 reach(std::size_t e, int first, std::size_t last) const {
    Vector2 v = ends_[e][last].step;
    for (int k = static_cast<int>(last) - 1; k > first; --k) {
      const Pivot& pivot = ends_[e][at(k)];
      if (pivot.sense == 0) {
        if (!is_dependent(pivot.joint)) v = v + q_[at(pivot.joint)] * pivot.direction;
      } else {
        v = turned(turn_of(e, at(k), at(k) + 1), v);
      }
      v = v + pivot.step;
    }
    return v;
  }

  // ---- Dependent joints.

  struct Unknown {
    std::size_t end = 0, place = 0;
    int joint = -1, sense = 0;
  };

  std::vector<Unknown> unknowns() const {
    std::vector<Unknown> result;
    for (std::size_t e = 0; e < 2; ++e)
      for (std::size_t k = 0; k + 1 < ends_[e].size(); ++k)
        if (is_dependent(ends_[e][k].joint)) result.push_back({e, k, ends_[e][k].joint, ends_[e][k].sense});
    return result;
  }

  std::size_t last(std::size_t e) const { return ends_[e].size() - 1; }

  void set_turn(const Unknown& u, const Vector2& turn) {
    q_[at(u.joint)] = atan2(u.sense > 0 ? turn.y : -turn.y, turn.x);
  }

  void solve() {
    const std::vector<Unknown> u = unknowns();
    if (u[0].sense == 0)
      solve_slide(u[0], u[1]);
    else if (u[1].sense == 0)
      solve_slide(u[1], u[0]);
    else
      solve_turns(u[0], u[1]);
  }

  // R(a) side + R(b) other = base.
  void solve_turns(const Unknown& first, const Unknown& second) {
    const bool is_one_end = first.end == second.end;
    const std::size_t e = first.end, o = second.end;
    const int before = static_cast<int>(first.place);
    const Vector2 from = reach(e, -1, first.place);
    const Vector2 side = reach(e, before, is_one_end ? second.place : last(e));
    const Vector2 other = reach(o, static_cast<int>(second.place), last(o));
    const Vector2 to = is_one_end ? reach(1 - e, -1, last(1 - e)) : reach(o, -1, second.place);
    const auto [a, b] = triangle(side, is_one_end ? other : -other, to - from, closure_.branch);
    set_turn(first, turned_back(turn_of(e, 0, first.place), a));
    const Vector2 behind =
        is_one_end ? turned(a, turn_of(e, first.place + 1, second.place)) : turn_of(o, 0, second.place);
    set_turn(second, turned_back(behind, b));
  }

  void solve_slide(const Unknown& slide, const Unknown& turn) {
    const std::size_t e = turn.end, o = 1 - e;
    const bool is_one_end = slide.end == e;
    const Vector2 from = reach(e, -1, turn.place);
    const Vector2 side = reach(e, static_cast<int>(turn.place), last(e));
    const Vector2 base = reach(o, -1, last(o)) - from;
    const Vector2& direction = ends_[slide.end][slide.place].direction;
    Vector2 a;
    if (is_one_end && slide.place > turn.place) {
      // |side + s u| = |base|, and both turn together.
      const Vector2 u = turned(turn_of(e, turn.place + 1, slide.place), direction);
      const OnLine found = on_line(base, side, u, closure_.branch);
      q_[at(slide.joint)] = found.way;
      a = turn_between(found.point, base);
    } else {
      // |base + s u| = |side|.
      const Vector2 u = turned(turn_of(slide.end, 0, slide.place), direction);
      const OnLine found = on_line(side, base, is_one_end ? -u : u, is_one_end ? -closure_.branch : closure_.branch);
      q_[at(slide.joint)] = found.way;
      a = turn_between(side, found.point);
    }
    set_turn(turn, turned_back(turn_of(e, 0, turn.place), a));
  }

  // ---- Rates: ends move apart by the columns of K.

  Posture posture(std::size_t e) const {
    Posture result;
    Vector2 turn = {trace_.graph.one(), Expression()};
    Vector2 origin = ends_[e].front().step;
    std::size_t given = 0;  // joints since the last dependent one
    Vector2 start = turn;
    for (std::size_t k = 0; k < last(e); ++k) {
      const Pivot& pivot = ends_[e][k];
      result.origins.push_back(origin);
      result.directions.push_back(pivot.sense == 0 ? turned(turn, pivot.direction) : Vector2{});
      Vector2 step;
      if (pivot.sense == 0) {
        step = q_[at(pivot.joint)] * result.directions.back();
      } else if (is_dependent(pivot.joint)) {
        const Expression& angle = q_[at(pivot.joint)];
        start = turned(turn, {cos(angle), pivot.sense > 0 ? sin(angle) : -sin(angle)});
        turn = start;
        given = k + 1;
      } else {
        turn = turned(start, turn_of(e, given, k + 1));
      }
      step = step + turned(turn, ends_[e][k + 1].step);
      result.steps.push_back(step);
      origin = origin + step;
    }
    result.origins.push_back(origin);
    return result;
  }

  std::vector<Column> columns() override {
    std::vector<Column> result;
    for (std::size_t e = 0; e < 2; ++e) {
      const Vector2& point = postures_[e].origins.back();
      for (std::size_t k = 0; k < last(e); ++k) {
        const Pivot& pivot = ends_[e][k];
        const Vector2 moved =
            pivot.sense == 0 ? postures_[e].directions[k] : perpendicular(point - postures_[e].origins[k]);
        const bool is_negative = (e == 1) != (pivot.sense < 0);
        result.push_back({pivot.joint, {is_negative ? -moved.x : moved.x, is_negative ? -moved.y : moved.y}});
      }
    }
    return result;
  }

  std::vector<Expression> error() override {
    const Vector2 apart = postures_[0].origins.back() - postures_[1].origins.back();
    return {apart.x, apart.y};
  }

  std::vector<Expression> bias(const std::vector<Expression>& qd) override {
    Vector2 total;
    for (std::size_t e = 0; e < 2; ++e) {
      Expression w;
      for (std::size_t k = 0; k < last(e); ++k) {
        const Pivot& pivot = ends_[e][k];
        const Expression& rate = qd[at(pivot.joint)];
        Vector2 acceleration;
        if (pivot.sense == 0)
          acceleration = (w + w) * (rate * perpendicular(postures_[e].directions[k]));
        else
          w += pivot.sense > 0 ? rate : -rate;
        acceleration = acceleration - (w * w) * postures_[e].steps[k];
        total = e == 0 ? total + acceleration : total - acceleration;
      }
    }
    return {total.x, total.y};
  }

  std::vector<std::vector<Expression>> force_of(const std::vector<Expression>& lambda) override {
    std::vector<Expression> force(3);
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t k = 0; k < 2; ++k) force[i] += trace_.graph.constant(closure_.plane[k][i]) * lambda[k];
    return {force};
  }
};

}  // namespace

std::unique_ptr<TracedClosure> traced_in_plane(
    Trace& trace,
    const model::Closure& closure,
    std::vector<Expression>& q,
    Positions positions) {
  return std::make_unique<PlanarClosure>(trace, closure, q, positions);
}

}  // namespace robcogen::algorithm
