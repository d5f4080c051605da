// Turns and slides of link frames that make something vanish, and move no frame further than the robot is long.
//
// What is parallel, zero or along an axis but for rounding of the model's numbers counts as such here. The numbers that
// programs compute with stay what they are.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "algorithm/formulation/formulation.h"
#include "model/reach.h"

namespace robcogen::algorithm {

// By the same rule two limbs of one shape get corresponding frames.
struct Candidate {
  int rule = 0;
  model::Quantity value;
};

class FrameCandidates {
 public:
  FrameCandidates(const model::KinematicTree& tree, const Formulation& formulation);

  // Where all of the model is numbers.
  std::shared_ptr<const LinkNumbers> numbers() const;

  // Rule 0 keeps what there is; no two are equal. Of the child of the joint.
  std::vector<Candidate> turns(int joint, const LinkFrames& frames) const;
  std::vector<Candidate> slides(int joint, const model::Quantity& turn, const LinkFrames& frames) const;

 private:
  // The axis of a joint, seen from the model's frame of its parent link.
  struct Axis {
    bool is_known = false;     // direction, in numbers
    bool is_parallel = false;  // to the parent's z axis
    double sign = 1.0;         // of its z component
    double normal = 0.0;       // angle of the common normal, or of the offset from axis to axis
    double twist = 0.0;        // angle from there to the joint frame's x axis; of both for parallel axes
    bool has_offset = false;   // parallel axes: apart from each other
    model::Quantity foot;      // of the common normal along the parent's z axis
    model::Quantity along;     // the way from there along the joint's axis
  };

  const model::KinematicTree& tree_;
  std::vector<Axis> axes_;                          // by joint
  std::vector<std::optional<MassNumbers>> masses_;  // by link, in the model's frame; those that matter
  std::vector<model::Extent> extents_;              // by link

  static Axis axis_of(const model::Joint& joint);
};

}  // namespace robcogen::algorithm
