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
    const auto [low, high] = std::minmax_element(spheres.begin(), spheres.end(), less);
    const double extent = high->ball.center[k] - low->ball.center[k];
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
  std::vector<int> shape_of_group;  // one of its shapes
  std::vector<int> link_of_group;
  for (const auto& [key, of_link] : sets) {
    CollisionTree::Link& link = result.links.emplace_back();
    link = {key.second, {}, static_cast<int>(result.groups.size()), 0};
    std::vector<Ball> balls;
    for (const std::vector<std::size_t>& set : of_link) {
      std::vector<ShapeBall> spheres;
      for (const std::size_t i : set) {
        result.is_exact = result.is_exact && shapes[i].is_sphere();
        for (const Ball& ball : row_of(shapes[i])) spheres.push_back({i, ball}), balls.push_back(ball);
      }
      for (const std::vector<ShapeBall>& group : clusters(std::move(spheres))) {
        result.groups.push_back({"", {}, static_cast<int>(result.spheres.size()), static_cast<int>(group.size())});
        std::vector<Ball> inside;
        std::string& names = result.groups.back().name;
        for (const ShapeBall& sphere : group) {
          const Capsule& shape = shapes[sphere.shape];
          if (names.empty())
            names = shape.body;
          else if (names.rfind(shape.body) == std::string::npos)
            names += ", " + shape.body;
          result.spheres.push_back({shape.name, sphere.ball});
          inside.push_back(sphere.ball);
        }
        result.groups.back().ball = around(inside);
        shape_of_group.push_back(static_cast<int>(group.front().shape));
        link_of_group.push_back(static_cast<int>(result.links.size()) - 1);
        ++link.count;
      }
    }
    link.ball = link.count == 1 ? result.groups.back().ball : around(balls);
  }

  std::map<std::array<int, 2>, std::vector<std::array<int, 2>>> by_links;
  for (int a = 0; a < static_cast<int>(result.groups.size()); ++a)
    for (int b = a + 1; b < static_cast<int>(result.groups.size()); ++b)
      if (partners[at(shape_of_group[at(a)])].contains(at(shape_of_group[at(b)])))
        by_links[{link_of_group[at(a)], link_of_group[at(b)]}].push_back({a, b});
  for (const auto& [links, groups] : by_links) {
    result.link_pairs.push_back(
        {links[0], links[1], static_cast<int>(result.group_pairs.size()), static_cast<int>(groups.size())});
    result.group_pairs.insert(result.group_pairs.end(), groups.begin(), groups.end());
  }
  return result;
}

}  // namespace robcogen::model
