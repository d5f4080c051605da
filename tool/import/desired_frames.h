// Frames that a list of desired transforms names.
#pragma once

#include <optional>
#include <set>
#include <string>
#include <vector>

#include "import/desired_instances.h"
#include "language/desired/document.h"

namespace robcogen::import {

// A pair of the list, by index of its frames.
struct ResolvedPair {
  int left;
  int right;
  Place place;
};

// Looks up the frames of a document in which loops are unrolled. A frame that does not exist, is repeated or not listed
// is a warning; wrong instances and variables of loops are errors.
class FrameResolver {
 public:
  FrameResolver(const language::desired::Document& document, KnownFrames& known, Diagnostics& diagnostics)
      : document_(document),
        known_(known),
        diagnostics_(diagnostics),
        instances_(document.source, known, diagnostics) {}

  // The owner of the frames, loops, and the list of frames: before pairs are resolved.
  void check();

  // Pairs whose frames exist, each once. `what` is the meaning of a pair: `transform`, `Jacobian`.
  std::vector<ResolvedPair> resolve(const std::vector<language::desired::Pair>& pairs, const std::string& what);

  // Puts the name of the frame in place of `instance.frame`. False after reporting that there is none.
  bool resolve(language::desired::Name& name);

 private:
  const language::desired::Document& document_;
  KnownFrames& known_;  // its guesses of what is meant are limited
  Diagnostics& diagnostics_;
  InstanceResolver instances_;
  std::set<std::string> accepted_;  // listed, or reported as not listed

  void check_owner();
  void check_loops();
  void check_variable(const language::desired::Name& variable);
  void check_list();
  std::optional<int> frame(const language::desired::Name& name, const std::string& what);
  void warn_unknown(const language::desired::Name& name, const std::string& consequence);
  Place place(const Span& span) const { return {document_.source, span}; }
};

}  // namespace robcogen::import
