// The domain model of coordinate transforms (the paper's Fig. 1): products of primitive transforms between frames.
#pragma once

#include <optional>
#include <string>
#include <unordered_map>
#include <utility>
#include <vector>

#include "model/rigid_motions.h"

namespace robcogen::model {

// right: Rx(a) maps coordinates in the frame rotated by +a to coordinates in the original frame (the usual rotation
// matrix), and Tx(d) maps coordinates in the frame moved by +d. left: the inverse.
enum class MovedFramePosition { left, right };

struct PrimitiveTransform {
  bool rotation = false;
  Axis axis = Axis::x;
  Quantity amount;
  std::vector<Quantity> quaternion = {};  // as in ElementaryMotion
};

PrimitiveTransform inverse(PrimitiveTransform primitive);

// left_X_right is the product of the primitives, in order from left to right. An empty product is the identity.
struct CoordinateTransform {
  std::string left;
  std::string right;
  std::vector<PrimitiveTransform> primitives;
  std::string name;  // given by the user, or empty
};

struct CoordinateTransforms {
  std::string name;
  MovedFramePosition position = MovedFramePosition::right;
  std::vector<Parameter> parameters;
  std::vector<std::string> variables;
  std::vector<CoordinateTransform> transforms;
};

// The graph of frames and the motions between them, built once for many queries. It refers to the motions, which must
// outlive it.
class MotionGraph {
 public:
  explicit MotionGraph(const RigidMotions& motions);

  // Returns the transform between any two frames that the motions connect. It follows the shortest path from `left` to
  // `right`; a motion traversed backwards contributes its inverse. nullopt if a frame is unknown or the two are not
  // connected.
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

// The same for a single query.
std::optional<CoordinateTransform> transform_between(
    const RigidMotions& motions,
    const std::string& left,
    const std::string& right,
    MovedFramePosition position = MovedFramePosition::right);

// The names of left and right in left_X_right.
using FrameNames = std::pair<std::string, std::string>;

// For each motion, its transform and the inverse.
std::vector<FrameNames> default_transforms(const RigidMotions& motions);

// Returns the transforms between these pairs of frames, in the same order. All pairs must be connected.
CoordinateTransforms transforms_of(
    const RigidMotions& motions,
    const std::vector<FrameNames>& pairs,
    MovedFramePosition position = MovedFramePosition::right);

// Converts transforms to motions: one motion per transform. Unlike the motions of a document, these may connect two
// frames by several paths.
RigidMotions motions_of(const CoordinateTransforms& transforms);

// Returns the transforms between these pairs of frames, in the same order: those in `transforms`, or products of them.
// All pairs must be connected.
CoordinateTransforms chosen(const CoordinateTransforms& transforms, const std::vector<FrameNames>& pairs);

}  // namespace robcogen::model
