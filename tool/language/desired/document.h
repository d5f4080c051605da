// A desired-transforms document (.dtdsl) as written: which coordinate transforms and Jacobians to generate.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "support/diagnostics.h"

namespace robcogen::language::desired {

struct Name {
  std::string text;
  Span span;
};

// `left_X_right`: maps coordinates in `right` to coordinates in `left`. For a Jacobian `left_J_right`: velocity of the
// origin of `right` with respect to `left`, in coordinates of `left`.
struct Pair {
  Name left;
  Name right;
  Span span;
};

// A frame that touches what does not move: by a point, or by a surface.
struct Contact {
  Name frame;
  bool is_surface = false;
};

struct Document {
  std::shared_ptr<const Source> source;
  Name robot;
  std::vector<Name> frames;
  std::vector<Pair> transforms;
  std::vector<Pair> jacobians;
  std::vector<Contact> contacts;
  std::vector<std::string> comments;
};

// Reads as far as possible and reports every error. The document is valid only when no error was reported; it can be
// printed in any case. Does not check what the names refer to.
Document parse(std::shared_ptr<const Source> source, Diagnostics& diagnostics);

// The canonical text, its comments at the beginning. parse(print(d)) equals d, except for places.
std::string print(const Document& document);

// Same content; places may differ.
bool equal(const Document& a, const Document& b);

}  // namespace robcogen::language::desired
