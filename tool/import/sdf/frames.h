// Frames of a document: their names, and the poses between them.
#pragma once

#include "import/sdf/document.h"

namespace robcogen::import::from_sdf {

// Finds the frames that poses, frames and joints name, and the links that they are attached to. Reports unknown frames,
// and frames that are placed or attached in a circle.
void resolve_frames(Document& document, Diagnostics& diagnostics);

// The pose of a frame in another one, along the references between the two: a pose that the file gives is exact.
Pose relative_pose(const Document& document, int frame, int reference);

// The index of the joint of this name in a scope; nullopt after reporting that there is none.
std::optional<int> find_joint(const Document& document, int scope, const Name& name, Diagnostics& diagnostics);

}  // namespace robcogen::import::from_sdf
