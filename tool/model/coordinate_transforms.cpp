#include "model/coordinate_transforms.h"

#include <algorithm>
#include <map>
#include <set>
#include <stdexcept>
#include <string_view>

namespace robcogen::model {

namespace {

// One motion on the way from one frame to another.
struct Step {
  const Motion* motion = nullptr;
  bool backwards = false;
};

bool is_known(const RigidMotions& motions, const std::string& frame) {
  if (std::find(motions.frames.begin(), motions.frames.end(), frame) != motions.frames.end()) return true;
  return std::any_of(motions.motions.begin(), motions.motions.end(), [&](const Motion& m) {
    return m.from == frame || m.to == frame;
  });
}

// The motions between two frames, in the order of the walk (breadth first, so that it is the shortest).
std::optional<std::vector<Step>> path(const RigidMotions& motions, const std::string& from, const std::string& to) {
  std::multimap<std::string_view, Step> leaving;
  for (const Motion& motion : motions.motions) {
    leaving.insert({motion.from, {&motion, false}});
    leaving.insert({motion.to, {&motion, true}});
  }
  std::map<std::string_view, Step> reached_by = {{from, Step{}}};
  std::vector<std::string_view> queue = {from};
  for (std::size_t next = 0; next < queue.size() && !reached_by.contains(to); ++next) {
    const auto [begin, end] = leaving.equal_range(queue[next]);
    for (auto it = begin; it != end; ++it) {
      const Step& step = it->second;
      const std::string_view frame = step.backwards ? step.motion->from : step.motion->to;
      if (reached_by.insert({frame, step}).second) queue.push_back(frame);
    }
  }
  if (!reached_by.contains(to)) return std::nullopt;

  std::vector<Step> steps;
  for (std::string_view frame = to; frame != from;) {
    const Step& step = reached_by.at(frame);
    steps.push_back(step);
    frame = step.backwards ? step.motion->to : step.motion->from;
  }
  std::reverse(steps.begin(), steps.end());
  return steps;
}

// from_X_to of one motion, as primitives whose moved frame is on the right.
std::vector<PrimitiveTransform> primitives_of(const Motion& motion, MotionConvention convention) {
  std::vector<PrimitiveTransform> primitives;
  for (const ElementaryMotion& step : motion.steps) primitives.push_back({step.rotation, step.axis, step.amount});
  if (convention == MotionConvention::fixed) {
    // Every step is about axes of the initial frame: translations add up, and the last rotation acts on all before it.
    const auto rotations = std::stable_partition(
        primitives.begin(), primitives.end(), [](const PrimitiveTransform& p) { return !p.rotation; });
    std::reverse(rotations, primitives.end());
  }
  return primitives;
}

}  // namespace

std::optional<CoordinateTransform> transform_between(
    const RigidMotions& motions,
    const std::string& left,
    const std::string& right,
    MovedFramePosition position) {
  if (!is_known(motions, left) || !is_known(motions, right)) return std::nullopt;
  const auto walk = path(motions, left, right);
  if (!walk) return std::nullopt;

  CoordinateTransform transform = {left, right, {}, ""};
  for (const Step& step : *walk) {
    std::vector<PrimitiveTransform> primitives = primitives_of(*step.motion, motions.convention);
    if (step.backwards) std::reverse(primitives.begin(), primitives.end());
    // An inverse negates, and so does spelling the same map with the moved frame on the left.
    const bool negate = step.backwards != (position == MovedFramePosition::left);
    for (PrimitiveTransform& primitive : primitives) {
      if (negate) primitive.amount = -primitive.amount;
      transform.primitives.push_back(std::move(primitive));
    }
  }
  // A user's name belongs to the transform that the motion itself stands for, not to its inverse.
  if (walk->size() == 1 && !walk->front().backwards) transform.name = walk->front().motion->name;
  return transform;
}

std::vector<FrameNames> default_transforms(const RigidMotions& motions) {
  std::vector<FrameNames> pairs;
  for (const Motion& motion : motions.motions) {
    pairs.emplace_back(motion.from, motion.to);
    pairs.emplace_back(motion.to, motion.from);
  }
  return pairs;
}

CoordinateTransforms transforms_of(
    const RigidMotions& motions,
    const std::vector<FrameNames>& pairs,
    MovedFramePosition position) {
  CoordinateTransforms result = {motions.name, position, motions.parameters, motions.variables, {}};
  for (const auto& [left, right] : pairs) {
    std::optional<CoordinateTransform> transform = transform_between(motions, left, right, position);
    if (!transform) throw std::logic_error("transform between frames that no motions connect");
    result.transforms.push_back(std::move(*transform));
  }
  return result;
}

RigidMotions motions_of(const CoordinateTransforms& transforms) {
  RigidMotions motions = {
      transforms.name, MotionConvention::local, transforms.parameters, transforms.variables, {}, {}};
  std::set<std::string> known;
  for (const CoordinateTransform& transform : transforms.transforms) {
    for (const std::string& frame : {transform.left, transform.right})
      if (known.insert(frame).second) motions.frames.push_back(frame);
    Motion motion = {transform.left, transform.right, {}, transform.name};
    for (const PrimitiveTransform& p : transform.primitives)
      motion.steps.push_back(
          {p.rotation, p.axis, transforms.position == MovedFramePosition::left ? -p.amount : p.amount});
    motions.motions.push_back(std::move(motion));
  }
  return motions;
}

CoordinateTransforms chosen(const CoordinateTransforms& transforms, const std::vector<FrameNames>& pairs) {
  const RigidMotions motions = motions_of(transforms);
  CoordinateTransforms result = transforms_of(motions, pairs, transforms.position);
  for (CoordinateTransform& transform : result.transforms) {
    const auto given = std::find_if(
        transforms.transforms.begin(), transforms.transforms.end(),
        [&](const CoordinateTransform& t) { return t.left == transform.left && t.right == transform.right; });
    if (given != transforms.transforms.end()) transform = *given;
  }
  return result;
}

}  // namespace robcogen::model
