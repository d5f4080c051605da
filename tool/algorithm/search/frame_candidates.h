// Candidates for link frames: rotations about a joint's axis, and translations along it, that make numbers of the model
// zero in the new frames. No candidate moves a frame by more than the length of the robot.
//
// To find candidates, axes count as parallel, and numbers as zero or equal, if they are so up to the rounding of the
// numbers in the model. Programs compute with the numbers of the model.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "algorithm/formulation/formulation.h"
#include "model/reach.h"

namespace robcogen::algorithm {

// A value, and the rules that give it. In congruent limbs, one rule gives corresponding frames.
struct Candidate {
  int rule = 0;  // the first one
  model::Quantity value;
  std::vector<int> other_rules = {};
};

// The candidate of a rule; nullptr if there is none.
const Candidate* find_rule(const std::vector<Candidate>& candidates, int rule);

class FrameCandidates {
 public:
  FrameCandidates(const model::KinematicTree& tree, const Formulation& formulation);

  // The numbers of the model; nullptr if it has parameters.
  std::shared_ptr<const LinkNumbers> numbers() const;

  // The candidates for the child of the joint. Rule 0 keeps the present value; no two values are equal.
  std::vector<Candidate> turns(int joint, const LinkFrames& frames) const;
  std::vector<Candidate> slides(int joint, const model::Quantity& turn, const LinkFrames& frames) const;

 private:
  // The axis of a joint in the model's frame of its parent link.
  struct Axis {
    bool is_known = false;     // the direction is given by numbers
    bool is_parallel = false;  // to the parent's z axis
    double sign = 1.0;         // of its z component
    double normal = 0.0;       // angle of the common normal, or of the offset from axis to axis
    double twist = 0.0;        // angle from there to the joint frame's x axis; of both for parallel axes
    bool has_offset = false;   // parallel axes: apart from each other
    model::Quantity foot;      // of the common normal along the parent's z axis
    model::Quantity along;     // from the foot along the joint's axis
  };

  const model::KinematicTree& tree_;
  std::vector<Axis> axes_;                          // by joint
  std::vector<std::optional<MassNumbers>> masses_;  // by link, in the model's frame; base parameters if used
  std::vector<model::Extent> extents_;              // by link

  static Axis axis_of(const model::Joint& joint);
};

}  // namespace robcogen::algorithm
