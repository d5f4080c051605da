// The words that are valid at each place of a document: for completion, and for the grammars of editors.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "driver/documents.h"

namespace robcogen::server {

// The words that may begin an item of a block. The name of a block is the word that begins it; the document itself has
// an empty name.
struct BlockWords {
  std::string_view block;
  std::vector<std::string_view> words;
};

const std::vector<BlockWords>& block_words(driver::Language language);
// Returns the words of one block; empty for an unknown block.
const std::vector<std::string_view>& words_of_block(driver::Language language, std::string_view block);

// Returns the words that are keywords only in certain places, and are names elsewhere.
std::vector<std::string> contextual_words(driver::Language language);
const std::vector<std::string>& keywords(driver::Language language);

// The functions and the constant of expressions.
inline const std::vector<std::string_view> kFunctions = {"sin", "cos", "tan", "sqrt"};
inline constexpr std::string_view kPi = "PI";

}  // namespace robcogen::server
