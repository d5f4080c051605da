// The frames that options name, by patterns: functions of frames are made for these only.
#pragma once

#include <string>
#include <vector>

#include "model/kinematic_tree.h"
#include "support/diagnostics.h"

namespace robcogen::import {

// The name of a frame, or a name with wildcards (support/wildcards.h). The frame of a link or joint may be named
// without its `fr_`, unless another frame has that name.
struct FramePattern {
  std::string text;
  Place place;
};

// The transforms and Jacobians of the frames that these patterns name, in the order of the robot. Names without
// wildcards may be those of any frame; wildcards select among model::link_and_user_frames. A pattern that names no frame is
// an error.
model::DesiredTransforms desired_by_patterns(
    const std::vector<FramePattern>& patterns,
    const model::KinematicTree& tree,
    Diagnostics& diagnostics);

// The pairs of a list one of whose frames is named by these patterns, while the other one is too, or belongs to the
// base. Contacts stay as they are. A pattern that names no frame of the list is an error.
model::DesiredTransforms limited_by_patterns(
    const model::DesiredTransforms& list,
    const std::vector<FramePattern>& patterns,
    const model::KinematicTree& tree,
    Diagnostics& diagnostics);

}  // namespace robcogen::import
