#include "server/completion_items.h"

#include "server/context.h"
#include "server/vocabulary.h"

namespace robcogen::server {

void CompletionItems::add(std::string_view label, ItemKind kind, const std::string& detail) {
  if (label.empty() || !known_.insert(std::string(label)).second) return;
  items_.push_back({{"label", label}, {"kind", static_cast<int>(kind)}, {"detail", detail}});
}

void CompletionItems::add_words(driver::Language language, std::string_view block) {
  for (const std::string_view word : words_of_block(language, block)) add_word(word);
}

void CompletionItems::add_expression(const Lookup& lookup) {
  for (const Occurrence& o : lookup.occurrences)
    if (o.symbol.kind == NameKind::parameter && o.symbol.document == lookup.document->path)
      add(o.symbol.name, variable_item, "parameter");
  std::set<std::string> words(kFunctions.begin(), kFunctions.end());
  words.insert({std::string(kPi), "pi"});
  for (const std::string& keyword : keywords(lookup.document->language)) words.insert(keyword);
  for (const language::Token& token : lookup.document->tokens.tokens)
    if (token.span.begin < lookup.offset && lookup.offset <= token.span.end) words.insert(std::string(token.text));
  for (const std::string& name : parameter_names(lookup.document->tokens, words)) add(name, variable_item, "parameter");
  add(kPi, variable_item, "the constant");
  for (const std::string_view function : kFunctions) add(function, function_item, "");
}

}  // namespace robcogen::server
