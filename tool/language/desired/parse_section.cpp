#include "language/desired/parse_section.h"

#include <fmt/format.h>

#include <utility>

#include "language/desired/parse_function.h"
#include "language/desired/parse_loop.h"
#include "language/desired/parse_pair.h"

namespace robcogen::language::desired {
namespace {

// A section that is being parsed.
struct Section {
  Cursor& cursor;
  std::string_view word;
  Document& document;

  // Reports the missing closing brace of the section, or of a loop in it.
  [[noreturn]] void report_missing_brace(const Token& open) const {
    cursor
        .error(
            "missing-brace", fmt::format("expected '}}' at the end of '{}', found {}", word, describe(cursor.peek())))
        .notes.push_back({cursor.place(open.span), "opened here"});
    throw SyntaxError{};
  }

  // Parses a loop up to its body. Returns the opening brace of the body.
  Token add_loop(int outer, std::string_view element) const {
    LoopHead head = read_loop_head(cursor, outer, element);
    document.loops.push_back(std::move(head.loop));
    return head.open;
  }
  int last_loop() const { return static_cast<int>(document.loops.size()) - 1; }
};

// Parses elements up to the end of the section or loop, calling element(loop) at each.
template <class Element>
void read_list(const Section& section, const Token& open, int loop, const Element& element) {
  Cursor& cursor = section.cursor;
  while (!cursor.at("}")) {
    cursor.begin_statement();
    if (at_section(cursor)) section.report_missing_brace(open);
    if (cursor.accept(",") && cursor.at("}")) cursor.unexpected("the name of a frame", "after ','");
    if (at_loop(cursor) && cursor.at("{", 3)) {
      const Token inner = section.add_loop(loop, "the name of a frame");
      read_list(section, inner, section.last_loop(), element);
      continue;
    }
    element(loop);
    if (cursor.at("-") || cursor.at(".")) cursor.unexpected("',' or '}'", "after the name of a frame");
  }
  cursor.take();
}

// Parses `fr_foot`, `point fr_foot` or `surface fr_sole`.
Contact read_contact(Cursor& cursor, int loop) {
  const bool has_kind =
      cursor.at_any({"point", "surface"}) && (cursor.at_name(1) || cursor.at("left", 1) || cursor.at("right", 1));
  const bool is_surface = has_kind && cursor.take().text == "surface";
  return {read_frame(cursor, loop), is_surface};
}

bool at_task(const Cursor& cursor, std::size_t offset) {
  const auto at = [&](std::string_view word) { return cursor.at(word, offset); };
  const auto is_frame = [&](std::string_view next) { return cursor.at(next, offset + 1); };
  return (at("point") || at("axis") || at("given") || at("swivel")) && !is_frame("->") && !is_frame("<-") &&
         !is_frame(".");
}

bool at_tolerance(const Cursor& cursor, std::size_t offset) {
  return cursor.at("tolerance", offset) && cursor.at("=", offset + 1);
}

// Parses `point`, `axis`, `swivel` or `given J7`.
void read_task(Cursor& cursor, Inverse& inverse) {
  const std::string_view task = cursor.take().text;
  inverse.task = task == "point"    ? Inverse::Task::point
                 : task == "axis"   ? Inverse::Task::axis
                 : task == "swivel" ? Inverse::Task::swivel
                                    : Inverse::Task::given;
  if (inverse.task == Inverse::Task::given) inverse.given = read_name(cursor, "the name of a joint");
}

// Parses `tolerance = 1e-3`.
double read_tolerance(Cursor& cursor) {
  cursor.take();
  cursor.expect("=", "after 'tolerance'");
  const bool is_negative = cursor.accept("-");
  if (cursor.peek().kind != Token::Kind::number) cursor.unexpected("a number", "as the tolerance");
  const double value = number_of(cursor.take()).value();
  if (cursor.at_decimal_comma()) cursor.decimal_comma(cursor.previous().span);
  return is_negative ? -value : value;
}

// Parses what follows a pair: a task, a tolerance, both in this order, or nothing.
Inverse read_inverse(Cursor& cursor, Pair pair) {
  Inverse inverse{std::move(pair)};
  if (cursor.at(",") && (at_task(cursor, 1) || at_tolerance(cursor, 1))) cursor.take();
  if (at_task(cursor, 0)) read_task(cursor, inverse);
  if (cursor.at(",") && at_tolerance(cursor, 1)) cursor.take();
  if (at_tolerance(cursor, 0)) inverse.tolerance = read_tolerance(cursor);
  inverse.pair.span.end = cursor.previous().span.end;
  return inverse;
}

// Parses pairs, like read_list, calling add(pair) behind each.
template <class Add>
void read_pairs(const Section& section, const Token& open, int loop, const Add& add) {
  Cursor& cursor = section.cursor;
  const std::size_t inside = cursor.open_blocks();
  while (!cursor.at("}")) {
    cursor.begin_statement();
    PairParser pair(cursor, loop);
    try {
      if (cursor.at_end()) cursor.unexpected("'}'", "");
      if (at_section(cursor)) section.report_missing_brace(open);
      if (at_loop(cursor)) {
        const Token inner = section.add_loop(loop, "a pair of frames");
        read_pairs(section, inner, section.last_loop(), add);
      } else {
        add(pair.read());
      }
    } catch (const SyntaxError&) {
      pair.skip_to_next(inside);
      if (cursor.at_end() || at_section(cursor)) throw;
    }
  }
  cursor.take();
}

// Parses definitions of functions. After an error in one, continues at the next.
void read_functions(const Section& section, const Token& open, std::vector<Function>& functions) {
  Cursor& cursor = section.cursor;
  const std::size_t inside = cursor.open_blocks();
  while (!cursor.at("}")) {
    cursor.begin_statement();
    if (cursor.at_end()) cursor.unexpected("'}'", "");
    if (at_section(cursor)) section.report_missing_brace(open);
    try {
      functions.push_back(read_function(cursor));
    } catch (const SyntaxError&) {
      cursor.skip_until([&] {
        return (cursor.at("}") && cursor.open_blocks() <= inside) || (cursor.at_name() && cursor.at("=", 1)) ||
               at_section(cursor);
      });
      if (cursor.at_end() || at_section(cursor)) throw;
    }
  }
  cursor.take();
}

}  // namespace

void read_section(Cursor& cursor, const Token& word, Document& document) {
  const Section section = {cursor, word.text, document};
  const Token open = cursor.expect("{", fmt::format("after '{}'", word.text));
  if (word.text == "Frames")
    read_list(section, open, Name::kNoLoop, [&](int loop) { document.frames.push_back(read_frame(cursor, loop)); });
  else if (word.text == "Contacts")
    read_list(section, open, Name::kNoLoop, [&](int loop) { document.contacts.push_back(read_contact(cursor, loop)); });
  else if (word.text == "Functions")
    read_functions(section, open, document.functions);
  else if (word.text == "InverseKinematics")
    read_pairs(section, open, Name::kNoLoop, [&](Pair pair) {
      document.inverses.push_back(read_inverse(cursor, std::move(pair)));
    });
  else
    read_pairs(section, open, Name::kNoLoop, [&](Pair pair) {
      (word.text == "Transforms" ? document.transforms : document.jacobians).push_back(std::move(pair));
    });
}

}  // namespace robcogen::language::desired
