// Completion in motions and in coordinate transforms.
#include <algorithm>

#include "server/completion.h"

namespace robcogen::server {
namespace {

void add_frames(const Lookup& lookup, CompletionItems& items) {
  for (const Occurrence& o : lookup.occurrences)
    if (o.symbol.kind == NameKind::frame) items.add(o.symbol.name, field_item, "frame");
}

}  // namespace

void complete_motions(const Lookup& lookup, const Context& context, CompletionItems& items) {
  if (context.word_before("=") == "Convention") return items.add_words(driver::Language::motions, "Convention");
  if (context.open_parentheses > 0) return items.add_expression(lookup);
  const bool is_arrow = context.follows("->");
  const auto& before = context.before;
  const auto has = [&](std::string_view text) {
    return std::any_of(before.begin(), before.end(), [&](const auto& token) { return token.text == text; });
  };
  if (!context.block().empty()) return add_frames(lookup, items);
  if (!is_arrow && has(":")) items.add_words(driver::Language::motions, ":");
  if (!has("Convention")) items.add_words(driver::Language::motions, "");
  if (has("Convention") || is_arrow) add_frames(lookup, items);
}

void complete_transforms(const Lookup& lookup, const Context& context, CompletionItems& items) {
  const std::string_view convention = context.word_before("=");
  if (convention == "MovedFramePos" || convention == "TransformedFramePos")
    return items.add_words(driver::Language::transforms, convention);
  if (context.open_parentheses > 0) return items.add_expression(lookup);
  if (!context.block().empty() || context.follows("{")) return add_frames(lookup, items);
  const auto& before = context.before;
  const bool is_product =
      std::any_of(before.begin(), before.end(), [](const auto& token) { return token.text == "="; });
  items.add_words(driver::Language::transforms, is_product ? "=" : "");
}

}  // namespace robcogen::server
