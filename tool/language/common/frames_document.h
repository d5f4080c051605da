// What documents about frames (motions and transforms) have in common: a header of the model's name, its frames and its
// groups of parameters, and a body of statements about pairs of frames.
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
  std::optional<std::vector<Name>> frames;  // the list, where there is one
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

// `Model ID`, the list of frames, groups of parameters. Goes on after an error where the next part begins; `stops` are
// the keywords that begin what follows the header.
FramesHeader parse_frames_header(Cursor& cursor, std::initializer_list<std::string_view> stops);

// Steps named `words`, those of translations along x, y, z first, then rotations.
std::vector<AxisStep> parse_steps(Cursor& cursor, const std::vector<std::string>& words);

// `[name]`, where it stands.
std::optional<Name> parse_user_name(Cursor& cursor);

// The canonical text of the parts; `keywords` are escaped.
std::string print_frames_header(const FramesHeader& header, const std::vector<std::string>& keywords);
std::string print_steps(const std::vector<AxisStep>& steps, const std::vector<std::string>& words);
std::string print_name(const Name& name, const std::vector<std::string>& keywords);
std::string print_comments(const std::vector<std::string>& comments, const std::string& indent = "");

// Same content, places apart.
bool equal(const FramesHeader& a, const FramesHeader& b);
bool equal(const std::vector<AxisStep>& a, const std::vector<AxisStep>& b);

}  // namespace robcogen::language
