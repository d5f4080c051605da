// The words that each place of a document takes: for completion, and for the grammars of editors.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "driver/documents.h"

namespace robcogen::server {

// What may begin an item of a block. The name of a block is the word that begins it; the document itself has none.
struct BlockWords {
  std::string_view block;
  std::vector<std::string_view> words;
};

const std::vector<BlockWords>& block_words(driver::Language language);
// Of one block; empty for an unknown one.
const std::vector<std::string_view>& words_of_block(driver::Language language, std::string_view block);

// Words that mean something only in their place, and are names elsewhere.
std::vector<std::string> contextual_words(driver::Language language);
const std::vector<std::string>& keywords(driver::Language language);

// `sin`, …, of expressions, and the constant.
inline const std::vector<std::string_view> kFunctions = {"sin", "cos", "tan", "sqrt"};
inline constexpr std::string_view kPi = "PI";

}  // namespace robcogen::server
