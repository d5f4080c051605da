// Frames of other formats whose names the model gives to other frames.
#pragma once

#include "model/description.h"
#include "support/diagnostics.h"

namespace robcogen::import {

// The model has a frame `fr_<name>` for each link and joint. A frame of the document that has this name, such as that
// of a link `fr_hip` beside a link `hip`, becomes `fr_hip_frame`, with a note; otherwise nothing could refer to it.
void rename_hidden_frames(model::Description& description, Diagnostics& diagnostics);

}  // namespace robcogen::import
