// Parses blocks of items in braces in robot documents, with their order, repetitions, and missing items and braces.
#pragma once

#include <fmt/format.h>

#include <initializer_list>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "language/common/cursor.h"
#include "language/kinematics/document.h"

namespace robcogen::language::kinematics {

using WordList = std::initializer_list<std::string_view>;

// The words that begin the items of one block, in the order of the text.
using Words = std::vector<Token>;

// Returns `'a', 'b'`.
std::string quoted(WordList words);

// The words that begin the elements of a robot.
const WordList kElements = {"RobotBase", "link", "r_joint", "p_joint"};
// Words that the first RobCoGen does not know. They are names, except where an element begins.
const WordList kNewElements = {"h_joint", "c_joint", "u_joint", "planar_joint", "s_joint"};

// After an error in an item, the parser skips to the next item of the block or to its end. If the braces do not match,
// it skips to the next element, because the keyword of an element cannot stand anywhere else.
class BlockParser {
 public:
  explicit BlockParser(Cursor cursor) : cursor_(std::move(cursor)) {}

  Cursor& cursor() { return cursor_; }

  // Whether the cursor is at the keyword of an element, followed by a name: a keyword alone may be used as a name by
  // mistake.
  bool at_element() const;
  // Whether the cursor is at a word of kNewElements that begins an element.
  bool at_new_element() const;

  // Parses `{`, items, `}`. An item begins at a token that at_item accepts; otherwise item() reports it. `outer` are
  // the words that begin an item of the enclosing block. Returns whether there was no error.
  template <class AtItem, class Item>
  bool block(const std::string& owner, AtItem at_item, Item item, WordList outer = {}) {
    bool sound = true;
    const Token open = cursor_.peek();
    try {
      cursor_.expect("{", "after " + owner);
    } catch (const SyntaxError&) {
      if (!at_item()) throw;
      cursor_.assume_open_brace();
      sound = false;
    }
    const std::size_t inside = cursor_.open_blocks();
    if (cursor_.at("{") && !cursor_.after_line_end() && sound) report_second_brace();
    bool comma_is_reported = false;
    while (true) {
      if (cursor_.at("}")) {
        const Token brace = cursor_.take();
        if (!at_item()) return sound;
        report_extra_brace(owner, brace);
        cursor_.assume_open_brace();
        sound = false;
      }
      cursor_.begin_statement();
      try {
        if (cursor_.at_end()) cursor_.unexpected("'}'", "");
        if (at_element()) missing_brace(owner, open);
        if (cursor_.at_any(outer) && !at_item() && sound) {
          report_missing_brace(owner, open);
          cursor_.assume_closing_brace();
          return sound;
        }
        if (!cursor_.at(",")) {
          item();
          continue;
        }
        if (!std::exchange(comma_is_reported, true) && !cursor_.is_faulty_here())
          cursor_.error("unexpected-token", fmt::format("unexpected ',' in {}", owner)).hint =
              "items are separated by blanks only";
        sound = false;
        cursor_.take();
      } catch (const SyntaxError&) {
        sound = false;
        cursor_.skip_until([&] {
          const bool here = cursor_.open_blocks() == inside && (cursor_.at("}") || at_item());
          return here || cursor_.open_blocks() < inside || at_element();
        });
        if (cursor_.at_end() || cursor_.open_blocks() < inside || at_element()) throw;
      }
    }
  }

  template <class Item>
  bool block(const std::string& owner, WordList words, Item item, WordList outer = {}) {
    return block(
        owner, [&] { return cursor_.at_any(words); }, item, outer);
  }

  // Takes the word that begins an item. A block has at most one item with each word.
  Token word(Words& found);
  // Reports the words that were not found, at the owner. Returns whether all were found.
  bool check_complete(const std::string& owner, Span span, const Words& found, WordList words);
  [[noreturn]] void unknown_item(const std::string& owner, WordList words);
  [[noreturn]] void old_dialect(const std::string& sign);

  Name name(std::string_view what);
  void equals(const Token& key);
  // Parses an id, which must not be negative.
  int integer(const Token& key);
  ExpressionPtr scalar();
  // Parses the `(a, b)` of an item, with this number of components.
  std::vector<ExpressionPtr> components(const Token& key, std::size_t count);
  Vector vector(const Token& key);
  // Parses `{ translation = (…) rotation = (…) }`; nullopt if an error in it was reported.
  std::optional<Placement> placement(const std::string& owner, Span owner_span);

 protected:
  Cursor cursor_;

 private:
  void report_missing_brace(const std::string& owner, const Token& open);
  [[noreturn]] void missing_brace(const std::string& owner, const Token& open);
  void report_second_brace();
  void report_extra_brace(const std::string& owner, const Token& brace);
  void report_repetition(const Token& token, const Token& earlier);
};

}  // namespace robcogen::language::kinematics
