// Grammars of the language guide: reads them, derives random documents, and matches them with documents.
//
// `'word'` is a literal, `"word"` a literal that is not reserved, NAME in capitals a token, Name a rule. ? * + | ( )
// have their usual meaning; & means any order and binds tighter than |.
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
  std::vector<std::shared_ptr<const Node>> of;  // parts; of a repetition, the one that repeats
  int least = 0, most = 0;                      // of a repetition
  bool is_reserved = true;                      // true for a literal `'word'`
};

class Grammar {
 public:
  // Reads the rules `Name ::= …` in the text of code blocks; a later rule replaces an earlier one of the same name.
  // Throws std::runtime_error if they cannot be read.
  explicit Grammar(const std::string& text);

  const std::string& first_rule() const { return first_; }

  // Reserved literals that are words, in all rules that can be reached from the first one without passing through
  // `without`.
  std::set<std::string> words(const std::string& without) const;
  // Names that are used but not defined by a rule, except tokens.
  std::vector<std::string> undefined() const;

  // Derives a random document with its tokens separated by blanks. Below `deepest` levels of nested rules, it takes the
  // first alternative of each choice and the fewest repetitions.
  std::string derive(std::mt19937& random, int deepest) const;
  // True if the tokens, of which the last one is the end, form a document. Words of `keywords` are not names.
  bool matches(const std::vector<language::Token>& tokens, const std::set<std::string>& keywords) const;

 private:
  using NodePtr = std::shared_ptr<const Node>;

  std::map<std::string, NodePtr> rules_;
  std::string first_;
};

}  // namespace robcogen::test
