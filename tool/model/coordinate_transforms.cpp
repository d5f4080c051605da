#include "model/coordinate_transforms.h"

#include <algorithm>
#include <set>
#include <stdexcept>

#include "support/index.h"

namespace robcogen::model {

namespace {

// Returns from_X_to of one motion as primitives whose moved frame is on the right.
std::vector<PrimitiveTransform> primitives_of(const Motion& motion, MotionConvention convention) {
  std::vector<PrimitiveTransform> primitives;
  for (const ElementaryMotion& step : motion.steps)
    primitives.push_back({step.rotation, step.axis, step.amount, step.quaternion});
  if (convention == MotionConvention::fixed) {
    // Every step is about axes of the initial frame: translations add up, and the last rotation acts on all before it.
    const auto rotations = std::stable_partition(
        primitives.begin(), primitives.end(), [](const PrimitiveTransform& p) { return !p.rotation; });
    std::reverse(rotations, primitives.end());
  }
  return primitives;
}

}  // namespace

PrimitiveTransform inverse(PrimitiveTransform primitive) {
  primitive.amount = -primitive.amount;
  for (std::size_t i = 1; i < primitive.quaternion.size(); ++i) primitive.quaternion[i] = -primitive.quaternion[i];
  return primitive;
}

MotionGraph::MotionGraph(const RigidMotions& motions) : convention_(motions.convention) {
  const auto index_of = [&](const std::string& frame) {
    return frames_.emplace(frame, static_cast<int>(frames_.size())).first->second;
  };
  for (const std::string& frame : motions.frames) index_of(frame);
  for (const Motion& motion : motions.motions) {
    const int from = index_of(motion.from), to = index_of(motion.to);
    leaving_.resize(frames_.size());
    leaving_[at(from)].push_back({&motion, false, from, to});
    leaving_[at(to)].push_back({&motion, true, to, from});
  }
  leaving_.resize(frames_.size());
}

// Searches breadth first, so the path is the shortest.
std::optional<std::vector<MotionGraph::Step>> MotionGraph::walk(int from, int to) const {
  std::vector<const Step*> reached_by(leaving_.size(), nullptr);
  std::vector<int> queue = {from};
  for (std::size_t next = 0; next < queue.size() && from != to && !reached_by[at(to)]; ++next) {
    for (const Step& step : leaving_[at(queue[next])]) {
      if (step.to == from || reached_by[at(step.to)]) continue;
      reached_by[at(step.to)] = &step;
      queue.push_back(step.to);
    }
  }
  std::vector<Step> steps;
  for (int frame = to; frame != from; frame = steps.back().from) {
    if (!reached_by[at(frame)]) return std::nullopt;
    steps.push_back(*reached_by[at(frame)]);
  }
  std::reverse(steps.begin(), steps.end());
  return steps;
}

std::optional<CoordinateTransform> MotionGraph::transform_between(
    const std::string& left,
    const std::string& right,
    MovedFramePosition position) const {
  const auto from = frames_.find(left), to = frames_.find(right);
  if (from == frames_.end() || to == frames_.end()) return std::nullopt;
  const std::optional<std::vector<Step>> walk = this->walk(from->second, to->second);
  if (!walk) return std::nullopt;

  CoordinateTransform transform = {left, right, {}, ""};
  for (const Step& step : *walk) {
    std::vector<PrimitiveTransform> primitives = primitives_of(*step.motion, convention_);
    if (step.backwards) std::reverse(primitives.begin(), primitives.end());
    // An inverse and a moved frame on the left each negate.
    const bool negate = step.backwards != (position == MovedFramePosition::left);
    for (PrimitiveTransform& primitive : primitives) {
      transform.primitives.push_back(negate ? inverse(std::move(primitive)) : std::move(primitive));
    }
  }
  // The user's name belongs to the transform of the motion, not to its inverse.
  if (walk->size() == 1 && !walk->front().backwards) transform.name = walk->front().motion->name;
  return transform;
}

std::optional<CoordinateTransform> transform_between(
    const RigidMotions& motions,
    const std::string& left,
    const std::string& right,
    MovedFramePosition position) {
  return MotionGraph(motions).transform_between(left, right, position);
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
  const MotionGraph graph(motions);
  for (const auto& [left, right] : pairs) {
    std::optional<CoordinateTransform> transform = graph.transform_between(left, right, position);
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
    for (const PrimitiveTransform& p : transform.primitives) {
      const PrimitiveTransform step = transforms.position == MovedFramePosition::left ? inverse(p) : p;
      motion.steps.push_back({step.rotation, step.axis, step.amount, step.quaternion});
    }
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
