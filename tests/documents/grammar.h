// Grammars of the guide to the languages: read, derived from at random, and matched with documents.
//
// `'word'` literal, `"word"` one that is not reserved, NAME in capitals a token, Name a rule; ? * + | ( ) as usual, &
// any order, tighter than |.
#pragma once

#include <map>
#include <memory>
#include <random>
#include <set>
#include <string>
#include <vector>

#include "language/common/lexer.h"

namespace robcogen::test {

struct Node {
  enum class Kind { literal, name, sequence, choice, any_order, repeat };
  Kind kind = Kind::sequence;
  std::string text;                             // of a literal, or a name
  std::vector<std::shared_ptr<const Node>> of;  // parts; one of a repetition
  int least = 0, most = 0;                      // of a repetition
  bool is_reserved = true;                      // a literal: `'word'`
};

class Grammar {
 public:
  // Rules `Name ::= …` of the text of code blocks; later ones of the same name replace earlier ones. Throws
  // std::runtime_error where they cannot be read.
  explicit Grammar(const std::string& text);

  const std::string& first_rule() const { return first_; }

  // Reserved literals that are words, of all rules that can be reached from the first one but not through `without`.
  std::set<std::string> words(const std::string& without) const;
  // Names of rules that are used and not defined, but for tokens.
  std::vector<std::string> undefined() const;

  // A random document, its tokens separated by blanks. Where rules nest deeper than so many levels, it takes the first
  // of all choices and the least of all repetitions.
  std::string derive(std::mt19937& random, int deepest) const;
  // Whether the tokens, the last one the end, are a document. Words of `keywords` are not names.
  bool matches(const std::vector<language::Token>& tokens, const std::set<std::string>& keywords) const;

 private:
  using NodePtr = std::shared_ptr<const Node>;

  std::map<std::string, NodePtr> rules_;
  std::string first_;
};

}  // namespace robcogen::test
