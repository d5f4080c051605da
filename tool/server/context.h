// What surrounds a place in a document, by its tokens: a document is rarely sound where somebody writes.
#pragma once

#include <map>
#include <set>
#include <string>
#include <vector>

#include "language/common/lexer.h"

namespace robcogen::server {

struct Context {
  // The blocks around the place, outermost first: the word that begins each, and the name behind it.
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
  // The word before the last token: `carrier` in `carrier =`.
  std::string_view word_before(std::string_view text) const;
};

// The names of a robot or part, by its tokens: the parser may have lost elements that are not complete.
struct DeclaredNames {
  std::vector<std::string> links, joints;                  // without the base
  std::set<std::string> carried, used;                     // links and joints behind `via` and before it
  std::map<std::string, std::vector<std::string>> frames;  // user frames by link
};

// Of the part or robot around the place; by the name of the part.
DeclaredNames declared_around(const language::TokenList& tokens, const Context& context);
DeclaredNames declared_in_part(const language::TokenList& tokens, const std::string& part);

// Names that stand where expressions have parameters, but for `words`.
std::vector<std::string> parameter_names(const language::TokenList& tokens, const std::set<std::string>& words);

Context context_at(const language::TokenList& tokens, std::size_t offset);

}  // namespace robcogen::server
