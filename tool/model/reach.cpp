#include "model/reach.h"

#include <algorithm>
#include <cmath>

#include "support/index.h"

namespace robcogen::model {
namespace {

double magnitude(const Quantity& q, double of_unknown) {
  return q.is_constant() ? std::abs(q.number().value()) : of_unknown;
}

// An upper bound on the length.
double length_of(const std::array<Quantity, 3>& offset) {
  double sum = 0.0;
  for (const Quantity& q : offset) sum += magnitude(q, 1.0);
  return sum;
}

// The extent of the link without its subtree.
Extent extent_of(const Link& link) {
  Extent result;
  if (!link.inertia) return result;
  const Inertia& body = *link.inertia;
  result.length = length_of(body.com);
  if (body.reference) result.length += length_of(body.reference->translation);
  result.mass = magnitude(body.mass, 0.0);
  for (const Quantity* q : {&body.ixx, &body.iyy, &body.izz, &body.ixy, &body.ixz, &body.iyz})
    result.inertia += magnitude(*q, 0.0);
  return result;
}

}  // namespace

std::vector<Extent> extents(const KinematicTree& tree) {
  std::vector<Extent> result;
  for (const Link& link : tree.links) result.push_back(extent_of(link));
  std::vector<int> from_leaves = tree.topological();
  std::reverse(from_leaves.begin(), from_leaves.end());
  for (const int j : from_leaves) {
    const Joint& joint = tree.joints[at(j)];
    const Extent& child = result[at(joint.child)];
    Extent& parent = result[at(joint.parent)];
    parent.length = std::max(parent.length, length_of(joint.placement.translation) + child.length);
    parent.mass += child.mass;
    parent.inertia += child.inertia;
  }
  for (Extent& extent : result) extent.inertia += extent.mass * extent.length * extent.length;
  return result;
}

}  // namespace robcogen::model
