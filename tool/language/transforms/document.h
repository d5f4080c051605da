// A Transforms-DSL document (.ctdsl) as written: coordinate transforms as products of primitive transforms.
#pragma once

#include <memory>

#include "language/common/frames_document.h"

namespace robcogen::language::transforms {

// `{left}_X_{right} = primitives` maps coordinates in `right` to coordinates in `left`. Without primitives, it is the
// identity.
struct Transform {
  Name left;
  Name right;
  std::vector<AxisStep> primitives;
  std::optional<Name> name;
  std::vector<std::string> comments;  // before the transform
  Span span;
};

// Which frame a primitive moves. right: Rx(a) maps coordinates in the frame rotated by +a to coordinates in the
// original frame; left: the inverse.
enum class MovedFramePosition { left, right };

struct Document {
  std::shared_ptr<const Source> source;
  FramesHeader header;
  MovedFramePosition position = MovedFramePosition::right;
  std::vector<std::string> position_comments;  // before `MovedFramePos`
  std::vector<Transform> transforms;
  std::vector<std::string> trailing_comments;
};

// Reserved words; and the names of the primitives among them: translations along x, y, z, then rotations.
const std::vector<std::string>& keywords();
const std::vector<std::string>& primitive_words();

// Parses as far as possible and reports every error. The document is valid only if no error was reported; it can be
// printed in any case. Does not check what the names refer to.
Document parse(std::shared_ptr<const Source> source, Diagnostics& diagnostics);

// Returns the canonical text. parse(print(d)) equals d, except for places; print(parse(print(d))) == print(d).
std::string print(const Document& document);

// Whether the content is the same; places may differ.
bool equal(const Document& a, const Document& b);

}  // namespace robcogen::language::transforms
