#include "model/collision_tree.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <utility>

#include "model/collision.h"
#include "support/index.h"

namespace robcogen::model {
namespace {

using Point3 = std::array<double, 3>;

// No hypot, whose last digit depends on the library.
double distance(const Point3& a, const Point3& b) {
  double sum = 0;
  for (std::size_t k = 0; k < 3; ++k) sum += (a[k] - b[k]) * (a[k] - b[k]);
  return std::sqrt(sum);
}

Point3 between(const Point3& a, const Point3& b, double t) {
  Point3 result;
  for (std::size_t k = 0; k < 3; ++k) result[k] = a[k] + t * (b[k] - a[k]);
  return result;
}

// Spheres at equal distances, which contain the capsule: neighbours meet on its surface or beyond.
std::vector<Ball> row_of(const Capsule& capsule) {
  if (capsule.is_sphere()) return {{capsule.ends[0], capsule.radius}};
  constexpr double kMost = 64;
  const double length = distance(capsule.ends[0], capsule.ends[1]);
  const double steps = std::min(std::ceil(length / capsule.radius), kMost - 1);
  const double half = length / steps / 2, radius = std::sqrt(capsule.radius * capsule.radius + half * half);
  std::vector<Ball> row;
  for (int k = 0; k <= static_cast<int>(steps); ++k)
    row.push_back({between(capsule.ends[0], capsule.ends[1], k / steps), radius});
  return row;
}

// A sphere of a shape, by its place in the list of shapes.
struct ShapeBall {
  std::size_t shape;
  Ball ball;
};

// Halves of the spheres, along the coordinate in which their centres are farthest apart, until these are few.
std::vector<std::vector<ShapeBall>> clusters(std::vector<ShapeBall> spheres) {
  constexpr std::size_t kMost = 4;
  if (spheres.size() <= kMost) return {spheres};
  std::size_t axis = 0;
  double most = -1;
  for (std::size_t k = 0; k < 3; ++k) {
    const auto less = [&](const ShapeBall& a, const ShapeBall& b) { return a.ball.center[k] < b.ball.center[k]; };
    const double low = std::min_element(spheres.begin(), spheres.end(), less)->ball.center[k];
    const double extent = std::max_element(spheres.begin(), spheres.end(), less)->ball.center[k] - low;
    if (extent > most) most = extent, axis = k;
  }
  std::stable_sort(spheres.begin(), spheres.end(), [&](const ShapeBall& a, const ShapeBall& b) {
    return a.ball.center[axis] < b.ball.center[axis];
  });
  const auto middle = spheres.begin() + static_cast<std::ptrdiff_t>(spheres.size() / 2);
  std::vector<std::vector<ShapeBall>> result = clusters({spheres.begin(), middle});
  for (std::vector<ShapeBall>& cluster : clusters({middle, spheres.end()})) result.push_back(std::move(cluster));
  return result;
}

Ball around(const std::vector<ShapeBall>& spheres) {
  std::vector<Ball> balls;
  for (const ShapeBall& sphere : spheres) balls.push_back(sphere.ball);
  return model::around(balls);
}

// The depth of each link in the tree.
std::vector<int> depths(const KinematicTree& tree) {
  std::vector<int> result(tree.links.size(), -1);
  const auto depth = [&](auto& self, int link) -> int {
    int& known = result[at(link)];
    if (known >= 0) return known;
    const int joint = tree.links[at(link)].parent_joint;
    return known = joint < 0 ? 0 : self(self, tree.joints[at(joint)].parent) + 1;
  };
  for (int link = 0; link < static_cast<int>(result.size()); ++link) depth(depth, link);
  return result;
}

}  // namespace

Ball around(const std::vector<Ball>& balls) {
  if (balls.size() == 1) return balls.front();
  // Badoiu and Clarkson (2003): step by step towards the point that is farthest away.
  constexpr int kSteps = 2000;
  Ball result;
  for (const Ball& ball : balls)
    for (std::size_t k = 0; k < 3; ++k) result.center[k] += ball.center[k] / static_cast<double>(balls.size());
  const auto farthest = [&] {
    return std::max_element(balls.begin(), balls.end(), [&](const Ball& a, const Ball& b) {
      return distance(result.center, a.center) + a.radius < distance(result.center, b.center) + b.radius;
    });
  };
  for (int step = 1; step <= kSteps; ++step) {
    const Ball& far = *farthest();
    const double from = distance(result.center, far.center);
    // The far side of the ball, seen from here.
    if (from > 0) result.center = between(result.center, far.center, (1 + far.radius / from) / (step + 1));
  }
  constexpr double kUnit = 1e6;
  for (double& x : result.center) x = std::round(x * kUnit) / kUnit;
  const Ball& far = *farthest();
  result.radius = std::ceil((distance(result.center, far.center) + far.radius) * kUnit) / kUnit;
  return result;
}

CollisionTree collision_tree(const KinematicTree& tree) {
  const std::vector<Capsule> shapes = capsules(tree);
  const std::vector<std::array<std::size_t, 2>> pairs = collision_pairs(tree, shapes);
  const std::vector<int> depth = depths(tree);

  // By link, parents first: the sets of its shapes that are checked against the same others.
  std::vector<std::set<std::size_t>> partners(shapes.size());
  for (const auto& [i, k] : pairs) {
    partners[i].insert(k);
    partners[k].insert(i);
  }
  std::map<std::pair<int, int>, std::vector<std::vector<std::size_t>>> sets;  // depth, link
  for (std::size_t i = 0; i < shapes.size(); ++i) {
    std::vector<std::vector<std::size_t>>& of_link = sets[{depth[at(shapes[i].link)], shapes[i].link}];
    const auto same = std::find_if(of_link.begin(), of_link.end(), [&](const std::vector<std::size_t>& set) {
      return partners[set.front()] == partners[i];
    });
    (same == of_link.end() ? of_link.emplace_back() : *same).push_back(i);
  }

  CollisionTree result;
  std::vector<std::size_t> shape_of_part;  // one of its shapes
  for (const auto& [key, of_link] : sets)
    for (const std::vector<std::size_t>& set : of_link) {
      CollisionTree::Part part = {key.second, {}, static_cast<int>(result.groups.size()), 0};
      std::vector<ShapeBall> spheres;
      for (const std::size_t i : set) {
        result.is_exact = result.is_exact && shapes[i].is_sphere();
        for (const Ball& ball : row_of(shapes[i])) spheres.push_back({i, ball});
      }
      part.ball = around(spheres);
      for (const std::vector<ShapeBall>& cluster : clusters(std::move(spheres))) {
        CollisionTree::Group group = {"", around(cluster), static_cast<int>(result.spheres.size()), 0};
        for (const auto& [i, ball] : cluster) {
          const bool is_new = group.count == 0 || shapes[i].body != shapes[cluster[at(group.count - 1)].shape].body;
          if (is_new) group.name += (group.name.empty() ? "" : ", ") + shapes[i].body;
          result.spheres.push_back({shapes[i].name, ball});
          ++group.count;
        }
        result.groups.push_back(std::move(group));
        ++part.count;
      }
      // The same, to the last digit.
      if (part.count == 1) part.ball = result.groups.back().ball;
      result.parts.push_back(part);
      shape_of_part.push_back(set.front());
    }

  for (std::size_t a = 0; a < shape_of_part.size(); ++a)
    for (std::size_t b = a + 1; b < shape_of_part.size(); ++b)
      if (partners[shape_of_part[a]].contains(shape_of_part[b]))
        result.pairs.push_back({static_cast<int>(a), static_cast<int>(b)});
  return result;
}

}  // namespace robcogen::model
