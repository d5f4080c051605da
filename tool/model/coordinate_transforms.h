// The domain model of coordinate transforms (the paper's Fig. 1): products of primitive transforms between frames.
#pragma once

#include <optional>
#include <string>
#include <unordered_map>
#include <utility>
#include <vector>

#include "model/rigid_motions.h"

namespace robcogen::model {

// right: Rx(a) maps coordinates of the frame rotated by +a to the original frame (the usual rotation matrix), Tx(d)
// those of the frame moved by +d. left: the inverse.
enum class MovedFramePosition { left, right };

struct PrimitiveTransform {
  bool rotation = false;
  Axis axis = Axis::x;
  Quantity amount;
  std::vector<Quantity> quaternion = {};  // as ElementaryMotion has it
};

PrimitiveTransform inverse(PrimitiveTransform primitive);

// left_X_right = the product of the primitives, first one leftmost; empty is the identity.
struct CoordinateTransform {
  std::string left;
  std::string right;
  std::vector<PrimitiveTransform> primitives;
  std::string name;  // user name, may be empty
};

struct CoordinateTransforms {
  std::string name;
  MovedFramePosition position = MovedFramePosition::right;
  std::vector<Parameter> parameters;
  std::vector<std::string> variables;
  std::vector<CoordinateTransform> transforms;
};

// Frames, and the motions between them, for many questions about the same motions; these must outlive it.
class MotionGraph {
 public:
  explicit MotionGraph(const RigidMotions& motions);

  // The transform between any two frames that the motions connect: the shortest path is walked from `left` to `right`,
  // a motion walked backwards contributes its inverse. nullopt when the frames are unknown or not connected.
  std::optional<CoordinateTransform> transform_between(
      const std::string& left,
      const std::string& right,
      MovedFramePosition position = MovedFramePosition::right) const;

 private:
  // One motion on the path from one frame to another.
  struct Step {
    const Motion* motion = nullptr;
    bool backwards = false;
    int from = -1, to = -1;  // in the direction of the path
  };

  std::optional<std::vector<Step>> walk(int from, int to) const;

  MotionConvention convention_;
  std::unordered_map<std::string, int> frames_;
  std::vector<std::vector<Step>> leaving_;  // by frame, in the order of the motions
};

// The same for a single question.
std::optional<CoordinateTransform> transform_between(
    const RigidMotions& motions,
    const std::string& left,
    const std::string& right,
    MovedFramePosition position = MovedFramePosition::right);

// left, right of left_X_right.
using FrameNames = std::pair<std::string, std::string>;

// One transform for each motion, and its inverse.
std::vector<FrameNames> default_transforms(const RigidMotions& motions);

// The transforms between these frames, in their order. All must be connected.
CoordinateTransforms transforms_of(
    const RigidMotions& motions,
    const std::vector<FrameNames>& pairs,
    MovedFramePosition position = MovedFramePosition::right);

// The motions of transforms: their frames, and one motion per transform. Unlike those of a document, they may connect
// two frames by several paths.
RigidMotions motions_of(const CoordinateTransforms& transforms);

// The transforms between these frames, in their order: those in `transforms`, and products of them. All must be
// connected.
CoordinateTransforms chosen(const CoordinateTransforms& transforms, const std::vector<FrameNames>& pairs);

}  // namespace robcogen::model
