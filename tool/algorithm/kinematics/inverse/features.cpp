#include "algorithm/kinematics/inverse/features.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace robcogen::algorithm::inversion {
namespace {

using Kind = Feature::Kind;

constexpr std::array<Numbers3, 3> kUnit = {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};

// Solves a x = b by elimination with column pivots; the smallest pivot tells whether there is a solution.
struct Solved {
  Numbers3 x;
  double smallest_pivot;
};
Solved solved(std::array<Numbers3, 3> a, Numbers3 b) {
  double smallest = 1.0;
  for (std::size_t k = 0; k < 3; ++k) {
    std::size_t pivot = k;
    for (std::size_t i = k; i < 3; ++i)
      if (std::abs(a[i][k]) > std::abs(a[pivot][k])) pivot = i;
    std::swap(a[k], a[pivot]);
    std::swap(b[k], b[pivot]);
    smallest = std::min(smallest, std::abs(a[k][k]));
    if (smallest == 0.0) return {{}, 0.0};
    for (std::size_t i = k + 1; i < 3; ++i) {
      const double factor = a[i][k] / a[k][k];
      for (std::size_t c = k; c < 3; ++c) a[i][c] -= factor * a[k][c];
      b[i] -= factor * b[k];
    }
  }
  Numbers3 x{};
  for (std::size_t k = 3; k-- > 0;) {
    double sum = b[k];
    for (std::size_t c = k + 1; c < 3; ++c) sum -= a[k][c] * x[c];
    x[k] = sum / a[k][k];
  }
  return {x, smallest};
}

double distance_to(const ChainAxis& axis, const Numbers3& x) {
  return norm(cross(x - axis.point, axis.direction));
}

class FeatureFinder {
 public:
  explicit FeatureFinder(const SerialChain& chain) : chain_(chain) {}

  Features found() {
    add_meeting_points();
    add_points_of_axes();
    add_directions_and_planes();
    add_planes_of_slides();
    add_fixed();
    Features features{found_, found_};
    for (const Feature& f : found_)
      for (int begin = f.begin; begin < f.end; ++begin)
        for (int end = begin + 1; end <= f.end; ++end)
          // The freedoms of the task are never solved: a part has all of them or none.
          if ((f.end <= chain_.joints || end == f.end) && (f.kind == Kind::point || has_turn(begin, end)))
            add(features.all, {f.kind, begin, end, f.point, f.direction});
    return features;
  }

 private:
  const SerialChain& chain_;
  std::vector<Feature> found_;

  Numbers3 clean(const Numbers3& x) const { return without_rounding(chain_, x); }

  bool is_near(const Numbers3& a, const Numbers3& b) const { return norm(a - b) < 10.0 * chain_.same_point; }

  bool has_turn(int begin, int end) const {
    return std::any_of(
        chain_.axes.begin() + begin, chain_.axes.begin() + end, [](const ChainAxis& a) { return a.turns; });
  }

  // Planes with the same joints are parallel to each other.
  void add(std::vector<Feature>& list, const Feature& f) const {
    const bool is_known = std::any_of(list.begin(), list.end(), [&](const Feature& g) {
      return f.kind == g.kind && f.begin == g.begin && f.end == g.end &&
             (f.kind == Kind::point ? is_near(f.point, g.point) : norm(f.direction - g.direction) < kSameDirection);
    });
    if (!is_known) list.push_back(f);
  }

  bool is_in_meeting_point(int k, const Numbers3& x) const {
    return std::any_of(found_.begin(), found_.end(), [&](const Feature& f) {
      return f.kind == Kind::point && f.end - f.begin > 1 && f.begin <= k && k < f.end && is_near(f.point, x);
    });
  }

  void add_meeting_points() {
    for (int begin = 0; begin < chain_.size(); ++begin)
      for (int end = chain_.size(); end > begin + 1; --end)
        if (const auto x = common_point(chain_, begin, end)) {
          const bool is_part = std::any_of(found_.begin(), found_.end(), [&](const Feature& f) {
            return f.begin <= begin && end <= f.end && is_near(f.point, *x);
          });
          if (!is_part) add(found_, {Kind::point, begin, end, clean(*x), {}});
          break;
        }
  }

  void add_points_of_axes() {
    const std::vector<Feature> meeting = found_;
    for (int k = 0; k < chain_.size(); ++k) {
      const ChainAxis& axis = chain_.axis(k);
      if (!axis.turns) continue;
      std::vector<Numbers3> points = {axis.point};
      for (const int neighbour : {k - 1, k + 1})
        if (neighbour >= 0 && neighbour < chain_.size() && chain_.axis(neighbour).turns)
          points.push_back(foot(axis, chain_.axis(neighbour)));
      for (const Feature& f : meeting)
        points.push_back(axis.point + dot(axis.direction, f.point - axis.point) * axis.direction);
      for (const Numbers3& point : points)
        if (!is_in_meeting_point(k, point)) add(found_, {Kind::point, k, k + 1, clean(point), {}});
    }
  }

  // The joints around k that leave a direction, or a plane with this normal, in place.
  Feature run(Kind kind, int k, const Numbers3& direction) const {
    const auto keeps = [&](int i) {
      const ChainAxis& axis = chain_.axis(i);
      if (axis.turns) return are_parallel(axis.direction, direction);
      return kind == Kind::direction || std::abs(dot(axis.direction, direction)) < kSameDirection;
    };
    Feature f{kind, k, k + 1, {}, direction};
    while (f.begin > 0 && keeps(f.begin - 1)) --f.begin;
    while (f.end < chain_.size() && keeps(f.end)) ++f.end;
    return f;
  }

  void add_directions_and_planes() {
    for (int k = 0; k < chain_.size(); ++k) {
      if (!chain_.axis(k).turns) continue;
      for (const Kind kind : {Kind::direction, Kind::plane}) {
        Feature f = run(kind, k, chain_.axis(k).direction);
        int first = f.begin;
        while (!chain_.axis(first).turns) ++first;
        f.direction = chain_.axis(first).direction;
        if (kind == Kind::plane) f.point = chain_.axis(first).point;
        add(found_, f);
      }
    }
  }

  void add_planes_of_slides() {
    for (int k = 0; k < chain_.size(); ++k)
      for (const Numbers3& normal : kUnit)
        if (!chain_.axis(k).turns && std::abs(dot(chain_.axis(k).direction, normal)) < kSameDirection)
          add(found_, run(Kind::plane, k, normal));
  }

  void add_fixed() {
    const int end = chain_.size();
    if (chain_.task.kind == model::InverseTask::Kind::orientation)
      for (const Numbers3& e : kUnit) {
        add(found_, {Kind::direction, chain_.joints, end, {}, e});
        add(found_, {Kind::direction, 0, 0, {}, e});
      }
    if (chain_.task.kind != model::InverseTask::Kind::pose) return;
    add(found_, {Kind::point, end, end, clean(chain_.position), {}});
    for (const Numbers3& e : kUnit) {
      add(found_, {Kind::direction, end, end, {}, e});
      add(found_, {Kind::direction, 0, 0, {}, e});
    }
  }
};

}  // namespace

std::optional<Numbers3> common_point(const SerialChain& chain, int begin, int end) {
  // The least sum of squared distances.
  constexpr double kParallel = 1e-6;
  std::array<Numbers3, 3> a{};
  Numbers3 b{};
  for (int k = begin; k < end; ++k) {
    const ChainAxis& axis = chain.axis(k);
    if (!axis.turns) return std::nullopt;
    for (std::size_t i = 0; i < 3; ++i) {
      const Numbers3 row = kUnit[i] - axis.direction[i] * axis.direction;
      a[i] = a[i] + row;
      b[i] += dot(row, axis.point);
    }
  }
  const Solved point = solved(a, b);
  if (point.smallest_pivot < kParallel) return std::nullopt;
  for (int k = begin; k < end; ++k)
    if (distance_to(chain.axis(k), point.x) > chain.same_point) return std::nullopt;
  return point.x;
}

double gap(const ChainAxis& a, const ChainAxis& b) {
  const Numbers3 w = cross(a.direction, b.direction), between = b.point - a.point;
  return are_parallel(a.direction, b.direction) ? norm(cross(between, a.direction))
                                                : std::abs(dot(between, w)) / norm(w);
}

Numbers3 foot(const ChainAxis& a, const ChainAxis& b) {
  constexpr double kParallel = 1e-6;
  const Numbers3 w = cross(a.direction, b.direction), between = b.point - a.point;
  const double along =
      norm(w) < kParallel ? dot(a.direction, between) : dot(cross(between, b.direction), w) / dot(w, w);
  return a.point + along * a.direction;
}

Features features_of(const SerialChain& chain) {
  return FeatureFinder(chain).found();
}

}  // namespace robcogen::algorithm::inversion
