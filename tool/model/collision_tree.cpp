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

// Parents before their children.
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
  const std::vector<int> depth = depths(tree);
  std::vector<std::size_t> order(shapes.size());
  for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    const auto key = [&](std::size_t i) { return std::pair(depth[at(shapes[i].link)], shapes[i].link); };
    return key(a) < key(b);
  });

  CollisionTree result;
  std::vector<int> body_of(shapes.size()), link_of_body;
  for (const std::size_t i : order) {
    const Capsule& shape = shapes[i];
    const bool is_new_link = result.links.empty() || result.links.back().link != shape.link;
    if (is_new_link) result.links.push_back({shape.link, {}, static_cast<int>(result.bodies.size()), 0});
    if (is_new_link || result.bodies.back().name != shape.body) {
      result.bodies.push_back({shape.body, {}, static_cast<int>(result.spheres.size()), 0});
      link_of_body.push_back(static_cast<int>(result.links.size()) - 1);
      ++result.links.back().count;
    }
    body_of[i] = static_cast<int>(result.bodies.size()) - 1;
    for (const Ball& ball : row_of(shape)) {
      result.spheres.push_back({shape.name, ball});
      ++result.bodies.back().count;
    }
    result.is_exact = result.is_exact && shape.is_sphere();
  }

  const auto balls_of = [](const auto& list, const auto& group) {
    std::vector<Ball> balls;
    for (int k = 0; k < group.count; ++k) balls.push_back(list[at(group.first + k)].ball);
    return balls;
  };
  for (CollisionTree::Body& body : result.bodies) body.ball = around(balls_of(result.spheres, body));
  // Of the spheres themselves, because that is smaller.
  for (CollisionTree::Link& link : result.links) {
    std::vector<Ball> balls;
    for (int k = 0; k < link.count; ++k)
      for (const Ball& ball : balls_of(result.spheres, result.bodies[at(link.first + k)])) balls.push_back(ball);
    link.ball = link.count == 1 ? result.bodies[at(link.first)].ball : around(balls);
  }

  std::map<std::array<int, 2>, std::set<std::array<int, 2>>> pairs;  // of links: of bodies
  for (const auto& [i, k] : collision_pairs(tree, shapes)) {
    std::array<int, 2> bodies = {body_of[i], body_of[k]};
    if (bodies[0] > bodies[1]) std::swap(bodies[0], bodies[1]);
    pairs[{link_of_body[at(bodies[0])], link_of_body[at(bodies[1])]}].insert(bodies);
  }
  for (const auto& [links, bodies] : pairs) {
    result.link_pairs.push_back(
        {links[0], links[1], static_cast<int>(result.body_pairs.size()), static_cast<int>(bodies.size())});
    result.body_pairs.insert(result.body_pairs.end(), bodies.begin(), bodies.end());
  }
  return result;
}

}  // namespace robcogen::model
