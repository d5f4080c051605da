// Turns and slides of link frames that make numbers vanish and move no frame further than the robot is long.
//
// Here, axes that are parallel but for rounding in the model's numbers count as parallel, and likewise zeros and
// directions. Programs still compute with the numbers of the model.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "algorithm/formulation/formulation.h"
#include "model/reach.h"

namespace robcogen::algorithm {

// The same rule gives two congruent limbs corresponding frames.
struct Candidate {
  int rule = 0;
  model::Quantity value;
};

// nullptr: none has the rule.
const Candidate* find_rule(const std::vector<Candidate>& candidates, int rule);

class FrameCandidates {
 public:
  FrameCandidates(const model::KinematicTree& tree, const Formulation& formulation);

  // nullptr where the model has parameters.
  std::shared_ptr<const LinkNumbers> numbers() const;

  // For the child of the joint. Rule 0 keeps the present value; no two values are equal.
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
    model::Quantity along;     // from there along the joint's axis
  };

  const model::KinematicTree& tree_;
  std::vector<Axis> axes_;                          // by joint
  std::vector<std::optional<MassNumbers>> masses_;  // by link, in the model's frame; those that matter
  std::vector<model::Extent> extents_;              // by link

  static Axis axis_of(const model::Joint& joint);
};

}  // namespace robcogen::algorithm
