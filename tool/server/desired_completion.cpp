// Completion in lists of desired transforms.
#include "server/completion.h"
#include "server/features.h"

namespace robcogen::server {
namespace {

void add_frames_of_model(Workspace& workspace, Lookup& lookup, CompletionItems& items) {
  const Parsed* model = lookup.names.model_of(*lookup.document);
  for (const auto& name : lookup.document->desired()->frames) items.add(name.text, field_item, "frame of the list");
  if (model == nullptr) return;
  if (const auto tree = tree_of(workspace, model->path)) {
    for (const model::Frame& frame : tree->frames()) items.add(frame.name, field_item, "frame");
    return;
  }
  for (const Occurrence& o : lookup.names.occurrences(*model))
    if (o.symbol.kind == NameKind::frame) items.add(o.symbol.name, field_item, "frame");
}

}  // namespace

void complete_list(Workspace& workspace, Lookup& lookup, const Context& context, CompletionItems& items) {
  const std::string& block = context.block();
  if (block.empty()) {
    if (context.follows("Robot") || context.follows("Model")) return;
    return items.add_words(driver::Language::desired, "");
  }
  if (block == "Frames") {
    // Frames that are already listed are not offered again.
    for (const auto& name : lookup.document->desired()->frames) items.leave_out(name.text);
    items.add_words(driver::Language::desired, block);
    add_frames_of_model(workspace, lookup, items);
    return;
  }
  if (block == "Functions") return;
  if (!context.follows("=")) items.add_words(driver::Language::desired, block);
  add_frames_of_model(workspace, lookup, items);
}

}  // namespace robcogen::server
