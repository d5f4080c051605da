// The items of a completion: words of the language, and names.
#pragma once

#include <set>
#include <string>
#include <string_view>

#include "server/json.h"
#include "server/lookup.h"

namespace robcogen::server {

// Item kinds of the protocol.
enum ItemKind {
  function_item = 3,
  field_item = 5,
  variable_item = 6,
  class_item = 7,
  module_item = 9,
  keyword_item = 14
};

// Each label is listed once, with the kind with which it was added first.
class CompletionItems {
 public:
  void add(std::string_view label, ItemKind kind, const std::string& detail);
  void add_word(std::string_view word) { add(word, keyword_item, ""); }
  // Adds the words that may begin an item of the block.
  void add_words(driver::Language language, std::string_view block);
  // Adds what an expression at the place may name: parameters, functions, the constant.
  void add_expression(const Lookup& lookup);

  // Excludes a label from later additions.
  void leave_out(const std::string& label) { known_.insert(label); }

  // The list in the form of the protocol.
  const Json& list() const { return items_; }

 private:
  Json items_ = Json::array();
  std::set<std::string> known_;
};

}  // namespace robcogen::server
