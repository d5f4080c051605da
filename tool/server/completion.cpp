#include "server/completion.h"

#include <algorithm>

#include "server/features.h"

namespace robcogen::server {
namespace {

bool is_in_comment(const Lookup& lookup) {
  const auto& comments = lookup.document->tokens.comments;
  return std::any_of(comments.begin(), comments.end(), [&](const language::Comment& c) {
    return c.span.begin < lookup.offset && lookup.offset <= c.span.end;
  });
}

}  // namespace

Json completion(Workspace& workspace, const Json& parameters) {
  Lookup lookup(workspace, parameters);
  CompletionItems items;
  if (lookup.document == nullptr || std::holds_alternative<std::monostate>(lookup.document->document) ||
      is_in_comment(lookup))
    return items.list();
  const Context context = context_at(lookup.document->tokens, lookup.offset);
  switch (lookup.document->language) {
    case driver::Language::robot:
      complete_robot(workspace, lookup, context, items);
      break;
    case driver::Language::desired:
      complete_list(workspace, lookup, context, items);
      break;
    case driver::Language::motions:
      complete_motions(lookup, context, items);
      break;
    case driver::Language::transforms:
      complete_transforms(lookup, context, items);
      break;
    default:
      break;
  }
  return items.list();
}

}  // namespace robcogen::server
