// Completion in lists of desired transforms.
#include "driver/find_function.h"
#include "import/kinematics.h"
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

// The parts of a fused function: names of functions, or what follows the scopes that are written.
void add_functions_of_robot(Workspace& workspace, Lookup& lookup, const Context& context, CompletionItems& items) {
  std::string scope;
  std::size_t end = context.before.size();
  const auto take_scope = [&] { scope = std::string(context.before[--end].text) + "." + scope; };
  // A point is a token only if a name follows it.
  const bool is_after_point = lookup.offset > 0 && lookup.document->source->text()[lookup.offset - 1] == '.';
  if (is_after_point && !context.follows(".") && end > 0) take_scope();
  while (end >= 2 && context.before[end - 1].text == ".") --end, take_scope();
  if (end == 0 || (context.before[end - 1].text != "=" && context.before[end - 1].text != "+")) return;
  const Parsed* model = lookup.names.model_of(*lookup.document);
  if (model == nullptr) return;
  const auto tree = tree_of(workspace, model->path);
  if (!tree) return;
  language::desired::Document list = *lookup.document->desired();
  for (const auto& fused : list.functions) items.leave_out(fused.name.text);
  list.functions.clear();  // one of them is being written
  Diagnostics ignored;     // they are published
  const model::DesiredTransforms desired = import::desired_transforms(list, *tree, ignored);
  for (const std::string& name : driver::function_names({*tree, desired}))
    if (name.starts_with(scope)) items.add(name.substr(scope.size()), function_item, "function of the robot");
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
  if (block == "Functions") return add_functions_of_robot(workspace, lookup, context, items);
  if (!context.follows("=")) items.add_words(driver::Language::desired, block);
  add_frames_of_model(workspace, lookup, items);
}

}  // namespace robcogen::server
