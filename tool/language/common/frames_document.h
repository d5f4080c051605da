// The common parts of documents about frames (motions and transforms): a header with the name of the model, its frames
// and its groups of parameters, and a body of statements about pairs of frames.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "language/common/cursor.h"
#include "language/common/expression.h"
#include "language/common/name.h"

namespace robcogen::language {

struct ParameterGroup {
  Name name;
  std::vector<Name> parameters;
  std::vector<std::string> comments;
};

struct FramesHeader {
  Name model;
  std::optional<std::vector<Name>> frames;  // the list, if there is one
  std::vector<ParameterGroup> groups;
  std::vector<std::string> comments;  // before `Model`
};

// A step along or about one axis: `trx(0.3)`, `Rz(q)`.
struct AxisStep {
  bool rotation = false;
  int axis = 0;  // 0 x, 1 y, 2 z
  ExpressionPtr amount;
  Span span;
};

// Parses `Model ID`, the list of frames, and groups of parameters. After an error, continues where the next part
// begins; `stops` are the keywords that begin the part after the header.
FramesHeader parse_frames_header(Cursor& cursor, std::initializer_list<std::string_view> stops);

// Parses steps. `words` are their names: translations along x, y, z, then rotations.
std::vector<AxisStep> parse_steps(Cursor& cursor, const std::vector<std::string>& words);

// Parses `[name]` if it is there.
std::optional<Name> parse_user_name(Cursor& cursor);

// Parses the statements of the body up to the end, calling read(cursor) at each. After an error, continues where
// at(cursor) tells that a statement begins, or at a line whose first token may begin a faulty one.
template <class At, class MayBegin, class Read>
auto parse_statements(Cursor& cursor, At at, MayBegin may_begin, Read read) {
  std::vector<decltype(read(cursor))> statements;
  while (!cursor.at_end()) {
    const std::size_t begin = cursor.peek().span.begin;
    try {
      statements.push_back(read(cursor));
    } catch (const SyntaxError&) {
      // The token that begins the faulty statement does not begin another one.
      if (!cursor.at_end() && cursor.peek().span.begin == begin) cursor.take();
      cursor.skip_until([&] { return at(cursor) || (may_begin(cursor) && cursor.begins_line()); });
    }
  }
  return statements;
}

// Reports a token that continues neither the steps nor the document. `what` is `a motion`, `next` is `the next motion`,
// for example.
[[noreturn]] void unexpected_after_steps(
    Cursor& cursor,
    const std::vector<std::string>& words,
    std::string_view what,
    std::string_view next);

// Return the canonical text of each part; names that are `keywords` are escaped.
std::string print_frames_header(const FramesHeader& header, const std::vector<std::string>& keywords);
std::string print_steps(const std::vector<AxisStep>& steps, const std::vector<std::string>& words);
std::string print_name(const Name& name, const std::vector<std::string>& keywords);
std::string print_comments(const std::vector<std::string>& comments, const std::string& indent = "");

// Whether the content is the same; places may differ.
bool equal(const FramesHeader& a, const FramesHeader& b);
bool equal(const std::vector<AxisStep>& a, const std::vector<AxisStep>& b);

}  // namespace robcogen::language
