// A desired-transforms document (.dtdsl) as written: which coordinate transforms and Jacobians to generate.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "support/diagnostics.h"

namespace robcogen::language::desired {

// `foot`, or `leg.foot`: the frame that is called foot in the part, of the instance leg or of each in turn, where leg
// is the variable of a loop.
struct Name {
  std::string text;
  Span span;
  std::string instance = {};  // or empty
  Span instance_span = {};    // of its name
  int loop = kNoLoop;         // the one that it stands in

  static constexpr int kNoLoop = -1;
};

// `for variable in { instances } { … }`, once for each instance of a part. Loops do not nest. Those elements of a list
// that stand one after another with the same loop are its body.
struct Loop {
  Name variable;
  std::vector<Name> instances;
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
  std::vector<Loop> loops;  // in order of the text
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

// The loop that a pair or contact stands in, or Name::kNoLoop.
int loop_of(const Name& name);
int loop_of(const Pair& pair);
int loop_of(const Contact& contact);

// Same content; places may differ.
bool equal(const Document& a, const Document& b);

}  // namespace robcogen::language::desired
