// The context of a place in a document, from its tokens: where somebody is writing, a document is rarely valid.
#pragma once

#include <map>
#include <set>
#include <string>
#include <vector>

#include "language/common/lexer.h"

namespace robcogen::server {

struct Context {
  // The enclosing blocks, outermost first: the word that begins each block, and the name after it.
  struct Block {
    std::string word;
    std::string name;
  };
  std::vector<Block> blocks;
  // The tokens of the statement before the place, without the word that is being written.
  std::vector<language::Token> before;
  int open_parentheses = 0;

  const std::string& block() const;
  bool follows(std::string_view text) const { return !before.empty() && before.back().text == text; }
  // Returns the word before the last token if that is `text`: `carrier` in `carrier =`.
  std::string_view word_before(std::string_view text) const;
};

// The names that a robot or part declares, from its tokens: the parser may have dropped incomplete elements.
struct DeclaredNames {
  std::vector<std::string> links, joints;                  // without the base
  std::set<std::string> carried, used;                     // links before `via`, and joints after it
  std::map<std::string, std::vector<std::string>> frames;  // user frames by link
};

// Returns the names of the part or robot around the place; of the part with this name.
DeclaredNames declared_around(const language::TokenList& tokens, const Context& context);
DeclaredNames declared_in_part(const language::TokenList& tokens, const std::string& part);

// Returns the names that stand where expressions have parameters, except `words`.
std::vector<std::string> parameter_names(const language::TokenList& tokens, const std::set<std::string>& words);

Context context_at(const language::TokenList& tokens, std::size_t offset);

}  // namespace robcogen::server
