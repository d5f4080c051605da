// A Motion-DSL document (.motdsl) as written: poses of frames relative to one another.
#pragma once

#include <memory>

#include "language/common/frames_document.h"

namespace robcogen::language::motion {

// `from -> to : steps`: the steps move frame `from` onto frame `to`.
struct Motion {
  Name from;
  Name to;
  std::vector<AxisStep> steps;  // may be empty: the frames coincide
  std::optional<Name> name;
  std::vector<std::string> comments;  // before the motion
  Span span;
};

// local: each step refers to the axes of the frame reached so far. fixed: the axes stay parallel to those of the
// initial frame.
enum class Convention { local, fixed };

struct Document {
  std::shared_ptr<const Source> source;
  FramesHeader header;
  Convention convention = Convention::local;
  std::vector<std::string> convention_comments;  // before `Convention`
  std::vector<Motion> motions;
  std::vector<std::string> trailing_comments;
};

// Reserved words; and the names of the steps among them: translations along x, y, z, then rotations.
const std::vector<std::string>& keywords();
const std::vector<std::string>& step_words();

// Parses as far as possible and reports every error. The document is valid only if no error was reported; it can be
// printed in any case. Does not check what the names refer to.
Document parse(std::shared_ptr<const Source> source, Diagnostics& diagnostics);

// Returns the canonical text. parse(print(d)) equals d, except for places; print(parse(print(d))) == print(d).
std::string print(const Document& document);

// Whether the content is the same; places may differ.
bool equal(const Document& a, const Document& b);

}  // namespace robcogen::language::motion
