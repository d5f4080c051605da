#include "algorithm/kinematics/collision.h"

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

#include "algorithm/kinematics/frame_poses.h"
#include "algorithm/spatial/trace.h"
#include "model/collision.h"
#include "support/index.h"

namespace robcogen::algorithm {
namespace {

using model::Capsule;
using symbolic::Role;

// ---- Functions without branches.

Expression absolute(const Expression& x) {
  return x.is_zero() ? x : sqrt(x * x + x.graph()->constant(1e-36));
}

// x where it is positive, otherwise zero.
Expression positive_part(const Expression& x) {
  return 0.5 * (x + absolute(x));
}

// Exact where a is the smaller one.
Expression smaller(const Expression& a, const Expression& b) {
  return a - positive_part(a - b);
}

// In rounds, each of which compares neighbours: a path of log2(n) comparisons instead of n.
Expression smallest(std::vector<Expression> values) {
  while (values.size() > 1) {
    std::vector<Expression> next;
    for (std::size_t k = 0; k + 1 < values.size(); k += 2) next.push_back(smaller(values[k], values[k + 1]));
    if (values.size() % 2 == 1) next.push_back(values.back());
    values = std::move(next);
  }
  return values.front();
}

// x, between 0 and 1. The order makes both limits exact.
Expression in_unit_interval(const Expression& x) {
  if (x.is_zero()) return x;
  const Expression one = x.graph()->one();
  return one - positive_part(one - positive_part(x));
}

// ---- Capsules in the base.

struct PlacedCapsule {
  Vector3 from;
  Vector3 along;  // from one end to the other; zero for a sphere
  double squared_length = 0;
  double radius = 0;
};

class Scene {
 public:
  Scene(Trace& trace, const std::vector<Capsule>& capsules) : trace_(trace) {
    const std::vector<Expression> q = trace.joint_input("q", Role::joint_position);
    const std::vector<PathPose> links = link_poses(trace, q);
    for (const Capsule& capsule : capsules) {
      trace.section(capsule.name, "shape ", "");
      placed_.push_back(place(links[at(capsule.link)], capsule));
    }
  }

  const PlacedCapsule& operator[](std::size_t k) const { return placed_[k]; }

  Vector3 vector(const std::array<double, 3>& v) const {
    Graph& graph = trace_.graph;
    return {{graph.constant(v[0]), graph.constant(v[1]), graph.constant(v[2])}};
  }

 private:
  Trace& trace_;
  std::vector<PlacedCapsule> placed_;

  PlacedCapsule place(const PathPose& link, const Capsule& capsule) const {
    const auto& [a, b] = capsule.ends;
    const std::array<double, 3> d = {b[0] - a[0], b[1] - a[1], b[2] - a[2]};
    return {
        link.position + multiply(link.rotation, vector(a)), multiply(link.rotation, vector(d)),
        d[0] * d[0] + d[1] * d[1] + d[2] * d[2], capsule.radius};
  }
};

// The distance between the nearest points of two segments, which may be points.
Expression distance(Graph& graph, const PlacedCapsule& a, const PlacedCapsule& b) {
  Vector3 between = a.from - b.from;
  if (a.squared_length == 0 && b.squared_length > 0) return distance(graph, b, a);
  const auto number = [&](double x) { return graph.constant(x); };
  if (a.squared_length > 0 && b.squared_length == 0) {
    const Expression s = in_unit_interval(number(-1 / a.squared_length) * dot(a.along, between));
    between += s * a.along;
  } else if (a.squared_length > 0) {
    const double aa = a.squared_length, bb = b.squared_length;
    const Expression ab = dot(a.along, b.along), ac = dot(a.along, between), bc = dot(b.along, between);
    // From any point of segments that are parallel, the steps below lead to a nearest pair. This keeps the denominator
    // positive in float, and what rounding leaves of a derivative by `guess` small.
    constexpr double kParallel = 1e-6;
    const Expression denominator = number((1 + kParallel) * aa * bb) - ab * ab;
    const Expression guess = in_unit_interval((ab * bc - number(bb) * ac) / denominator);
    const Expression t = in_unit_interval(number(1 / bb) * (ab * guess + bc));
    const Expression s = in_unit_interval(number(1 / aa) * (ab * t - ac));
    between += s * a.along;
    between -= t * b.along;
  }
  return sqrt(dot(between, between) + number(1e-36));
}

std::vector<Capsule> capsules_of(const model::KinematicTree& tree, bool are_spheres) {
  std::vector<Capsule> chosen;
  for (const Capsule& capsule : model::capsules(tree))
    if (capsule.is_sphere() == are_spheres) chosen.push_back(capsule);
  return chosen;
}

void output_radii(Trace& trace, const std::vector<Capsule>& capsules) {
  std::vector<Expression> radii;
  for (const Capsule& capsule : capsules) radii.push_back(trace.graph.constant(capsule.radius));
  trace.output("radii", Role::value, radii);
}

}  // namespace

symbolic::Program collision_spheres(const model::KinematicTree& tree, const std::string& name) {
  Trace trace(tree);
  const std::vector<Capsule> spheres = capsules_of(tree, true);
  const Scene scene(trace, spheres);
  std::vector<Expression> centers;
  for (std::size_t k = 0; k < spheres.size(); ++k)
    centers.insert(centers.end(), scene[k].from.element.begin(), scene[k].from.element.end());
  trace.output("centers", Role::matrix, 3, static_cast<int>(spheres.size()), centers);
  output_radii(trace, spheres);
  return trace.program(name);
}

symbolic::Program collision_capsules(const model::KinematicTree& tree, const std::string& name) {
  Trace trace(tree);
  const std::vector<Capsule> capsules = capsules_of(tree, false);
  const Scene scene(trace, capsules);
  std::vector<Expression> ends;
  for (std::size_t k = 0; k < capsules.size(); ++k) {
    const Vector3 to = scene[k].from + scene[k].along;
    ends.insert(ends.end(), scene[k].from.element.begin(), scene[k].from.element.end());
    ends.insert(ends.end(), to.element.begin(), to.element.end());
  }
  trace.output("ends", Role::matrix, 6, static_cast<int>(capsules.size()), ends);
  output_radii(trace, capsules);
  return trace.program(name);
}

symbolic::Program self_distance(const model::KinematicTree& tree, const std::string& name) {
  Trace trace(tree);
  const std::vector<Capsule> capsules = model::capsules(tree);
  const Scene scene(trace, capsules);
  std::vector<Expression> distances;
  for (const auto& [i, k] : model::collision_pairs(tree, capsules)) {
    trace.section(capsules[i].name, {"pair ", capsules[i].name, " and ", capsules[k].name});
    const double radii = capsules[i].radius + capsules[k].radius;
    distances.push_back(distance(trace.graph, scene[i], scene[k]) - trace.graph.constant(radii));
  }
  trace.section("pairs", "nearest of all ", "");
  trace.output("distance", Role::distance, std::vector<Expression>{smallest(std::move(distances))});
  return trace.program(name);
}

}  // namespace robcogen::algorithm
