// Completion by language: what may stand at a place of a document. Each function adds to a list of items.
#pragma once

#include "server/completion_items.h"
#include "server/context.h"
#include "server/lookup.h"
#include "server/workspace.h"

namespace robcogen::server {

void complete_robot(Workspace& workspace, Lookup& lookup, const Context& context, CompletionItems& items);
// A list of desired transforms.
void complete_list(Workspace& workspace, Lookup& lookup, const Context& context, CompletionItems& items);
void complete_motions(const Lookup& lookup, const Context& context, CompletionItems& items);
void complete_transforms(const Lookup& lookup, const Context& context, CompletionItems& items);

}  // namespace robcogen::server
