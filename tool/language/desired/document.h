// A desired-transforms document (.dtdsl) as written: which coordinate transforms, Jacobians and fused
// functions to generate.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "support/diagnostics.h"

namespace robcogen::language::desired {

// `foot`, or `leg.foot`: the frame that the part calls `foot`, in the instance `leg`, or in each instance in turn if
// `leg` is the variable of a loop.
struct Name {
  std::string text;
  Span span;
  std::string instance = {};  // the instance or loop variable, or empty
  Span instance_span = {};    // of the name of the instance
  int loop = kNoLoop;         // index of the enclosing loop

  static constexpr int kNoLoop = -1;
};

// `for variable in { instances } { … }`, which repeats its body for each instance of a part. Loops do not nest. The
// body consists of the adjacent elements of a list that have this loop.
struct Loop {
  Name variable;
  std::vector<Name> instances;
};

// `left_X_right` maps coordinates in `right` to coordinates in `left`. For a Jacobian, `left_J_right` gives the
// velocity of the origin of `right` with respect to `left`, in coordinates of `left`.
struct Pair {
  Name left;
  Name right;
  Span span;
};

// A frame in contact with the fixed environment, at a point or over a surface.
struct Contact {
  Name frame;
  bool is_surface = false;
};

// `control = bias_forces + jacobians.fr_base_J_fr_foot`: a function with the results of others.
struct Function {
  Name name;
  std::vector<Name> parts;  // with their scopes
};

// A pair whose transform is inverted: for joint positions at which it has a given value.
struct Inverse {
  enum class Task { pose, point, axis, given, swivel };
  Pair pair;
  Task task = Task::pose;
  Name given = {};                       // the joint whose position is an argument
  std::optional<double> tolerance = {};  // by which axes may differ from those of a nominal chain
};

struct Document {
  std::shared_ptr<const Source> source;
  Name robot;
  std::vector<Loop> loops;  // in the order of the text
  std::vector<Name> frames;
  std::vector<Pair> transforms;
  std::vector<Pair> jacobians;
  std::vector<Contact> contacts;
  std::vector<Function> functions;
  std::vector<Inverse> inverses;
  std::vector<std::string> comments;
};

// Parses as far as possible and reports every error. The document is valid only if no error was reported; it can be
// printed in any case. Does not check what the names refer to.
Document parse(std::shared_ptr<const Source> source, Diagnostics& diagnostics);

// Returns the canonical text, with all comments at the beginning. parse(print(d)) equals d, except for places.
std::string print(const Document& document);

// Returns the index of the loop that contains the element, or Name::kNoLoop.
int loop_of(const Name& name);
int loop_of(const Pair& pair);
int loop_of(const Contact& contact);
int loop_of(const Inverse& inverse);

// Whether the content is the same; places may differ.
bool equal(const Document& a, const Document& b);

}  // namespace robcogen::language::desired
