// Turns the loops of a description into loops of a tree.
#pragma once

#include "model/description.h"
#include "model/loop_context.h"

namespace robcogen::model {

// Adds the described loops to the tree, and the joints that are to be independent to the context. Reports names that
// are taken or unknown, loops whose frames are on one link, and parameters without the default value that determines
// how a loop is assembled.
void declare_loops(const Description& description, LoopContext& context);

}  // namespace robcogen::model
