// Closures of loops in a plane.
#include "algorithm/spatial/closures.h"
#include "algorithm/spatial/planar_positions.h"
#include "algorithm/spatial/trace.h"

namespace robcogen::algorithm {
namespace {

class PlanarClosure : public TracedClosure {
 public:
  PlanarClosure(Trace& trace, const model::Closure& closure, const PlanarLoop& loop, const std::vector<Expression>& q)
      : TracedClosure(trace, closure), loop_(loop) {
    for (std::size_t e = 0; e < 2; ++e) postures_[e] = posture({trace.graph, loop_[e], q});
  }

 private:
  PlanarLoop loop_;
  std::array<Posture, 2> postures_;

  std::vector<Column> columns() override {
    std::vector<Column> result;
    for (std::size_t e = 0; e < 2; ++e) {
      const Vector2& point = postures_[e].origins.back();
      for (std::size_t k = 0; k < postures_[e].steps.size(); ++k) {
        const Pivot& pivot = loop_[e][k];
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
      for (std::size_t k = 0; k < postures_[e].steps.size(); ++k) {
        const Pivot& pivot = loop_[e][k];
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
  const PlanarLoop loop = planar_loop(trace, closure);
  if (positions == Positions::solved) q = closed_positions(trace.graph, loop, closure.branch, std::move(q));
  return std::make_unique<PlanarClosure>(trace, closure, loop, q);
}

}  // namespace robcogen::algorithm
