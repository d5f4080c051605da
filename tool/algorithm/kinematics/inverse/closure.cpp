#include "algorithm/kinematics/inverse/closure.h"

#include <cmath>
#include <optional>

#include "algorithm/kinematics/inverse/laboratory.h"

namespace robcogen::algorithm::inversion {
namespace {

using Kind = Feature::Kind;
using Task = model::InverseTask::Kind;

// Two directions tell a rotation if they differ by more than 37 degrees.
constexpr double kLeastWeight = 0.2;

Expression square_of_difference(const TargetLoop& loop, const Closure::Item& item, const JointValues& values) {
  const Vector3 difference = loop.difference(item.feature, item.cut, values);
  return dot(difference, difference);
}

// The largest distance of the last frame from a point of a link, if no joint slides.
double reach(const SerialChain& chain, const Feature& point) {
  double sum = 0.0;
  Numbers3 x = point.point;
  for (int k = point.end; k < chain.joints; ++k) {
    const ChainAxis& axis = chain.axis(k);
    if (!axis.turns) continue;
    const Numbers3 foot = axis.point + dot(axis.direction, x - axis.point) * axis.direction;
    sum += norm(x - foot);
    x = foot;
  }
  return sum + norm(chain.position - x);
}

class ClosureSearch {
 public:
  ClosureSearch(
      Graph& graph,
      const TargetLoop& loop,
      const SerialChain& chain,
      const std::vector<JointValues>& branches)
      : graph_(graph), loop_(loop), chain_(chain), branches_(branches) {}

  Closure found() {
    if (chain_.task.kind == Task::orientation) return {};  // of a part of a chain, which is checked as a whole
    if (chain_.task.kind == Task::point) return {{of_target(Kind::point)}, {}};
    if (chain_.task.kind == Task::axis) return {{of_target(Kind::point)}, {of_target(Kind::direction)}};
    for (const Feature& f : features_of(chain_).all)
      if (f.kind != Kind::plane) (f.kind == Kind::point ? points_ : directions_).push_back(priced(f));
    std::optional<Closure> best;
    int least = 0;
    for (int link = 0; link <= chain_.joints; ++link)
      if (const auto [closure, cost] = of_link(link); closure && (!best || cost < least)) {
        best = closure;
        least = cost;
      }
    return *best;
  }

 private:
  struct Priced {
    Closure::Item item;
    int cost;
  };

  Graph& graph_;
  const TargetLoop& loop_;
  const SerialChain& chain_;
  const std::vector<JointValues>& branches_;
  std::vector<Priced> points_, directions_;

  Closure::Item of_target(Kind kind) {
    return priced({kind, chain_.joints, chain_.size(), chain_.position, chain_.rotation[2]}).item;
  }

  // Seen from where it costs least.
  Priced priced(const Feature& feature) {
    std::optional<Priced> best;
    for (int cut = 0; cut <= chain_.joints; ++cut) {
      if (cut > feature.begin && cut < feature.end) continue;
      const Closure::Item item = {feature, cut};
      const std::size_t mark = graph_.mark();
      for (const JointValues& values : branches_) square_of_difference(loop_, item, values);
      const int cost = weight(graph_, mark);
      graph_.rollback(mark);
      if (!best || cost < best->cost) best = {item, cost};
    }
    return *best;
  }

  struct OfLink {
    std::optional<Closure> closure;
    int cost = 0;
  };
  // A point of the link and two directions.
  OfLink of_link(int link) const {
    const auto is_of_link = [&](const Priced& p) { return p.item.feature.begin <= link && link <= p.item.feature.end; };
    const Priced* point = nullptr;
    for (const Priced& p : points_)
      if (is_of_link(p) && (!point || p.cost < point->cost)) point = &p;
    const Priced *first = nullptr, *second = nullptr;
    for (std::size_t i = 0; i < directions_.size(); ++i)
      for (std::size_t k = i + 1; k < directions_.size(); ++k) {
        const Priced &a = directions_[i], &b = directions_[k];
        if (!is_of_link(a) || !is_of_link(b) || angle_weight(a, b) < kLeastWeight) continue;
        if (first && first->cost + second->cost <= a.cost + b.cost) continue;
        first = &a;
        second = &b;
      }
    if (!point || !first) return {};
    const Feature& of_point = point->item.feature;
    Closure closure{
        {point->item}, {first->item, second->item}, reach(chain_, of_point), 1.0 / angle_weight(*first, *second)};
    for (int k = of_point.end; k < chain_.joints; ++k)
      if (!chain_.axis(k).turns) closure.slides.push_back(k);
    return {closure, point->cost + first->cost + second->cost};
  }

  // A rotation by a chord s moves them by at least s times the root of this, in the root of the sum of squares.
  static double angle_weight(const Priced& a, const Priced& b) {
    const double cosine = std::abs(dot(a.item.feature.direction, b.item.feature.direction));
    return cosine < kSameDirection ? 1.0 : 1.0 - cosine;
  }
};

}  // namespace

Closure cheapest_closure(
    Graph& graph,
    const TargetLoop& loop,
    const SerialChain& chain,
    const std::vector<JointValues>& branches) {
  return ClosureSearch(graph, loop, chain, branches).found();
}

Expression misfit(Graph& graph, const TargetLoop& loop, const Closure& closure, const JointValues& values) {
  Expression points, directions;
  for (const Closure::Item& item : closure.points) points += square_of_difference(loop, item, values);
  for (const Closure::Item& item : closure.directions) directions += square_of_difference(loop, item, values);
  const Expression square = points + graph.constant(closure.direction_weight) * directions;
  const double reach_square = closure.reach * closure.reach;
  if (closure.slides.empty()) return graph.constant(std::sqrt(1.0 + reach_square)) * sqrt(square);
  // By Cauchy, the square of a sum is at most the sum of squares times the number of terms.
  Expression squares = graph.constant(reach_square);
  for (const int k : closure.slides) squares += values[at(k)]->sine * values[at(k)]->sine;
  const double terms = static_cast<double>(closure.slides.size()) + (closure.reach == 0.0 ? 0.0 : 1.0);
  return sqrt((graph.one() + terms * squares) * square);
}

}  // namespace robcogen::algorithm::inversion
