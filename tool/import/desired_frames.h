// Resolves the frame names in a list of desired transforms.
#pragma once

#include <optional>
#include <set>
#include <string>
#include <vector>

#include "import/desired_instances.h"
#include "language/desired/document.h"

namespace robcogen::import {

// A pair of the list, as indices of its frames.
struct ResolvedPair {
  int left;
  int right;
  Place place;
};

// Looks up the frames of a document whose loops are unrolled. An unknown, repeated or unlisted frame is a warning; a
// wrong instance or loop variable is an error.
class FrameResolver {
 public:
  FrameResolver(const language::desired::Document& document, KnownFrames& known, Diagnostics& diagnostics)
      : document_(document),
        known_(known),
        diagnostics_(diagnostics),
        instances_(document.source, known, diagnostics) {}

  // Checks the owner of the frames, the loops, and the list of frames. Must be called before pairs are resolved.
  void check();

  // Returns the pairs whose frames exist, without duplicates. `what` is the meaning of a pair: `transform` or
  // `Jacobian`.
  std::vector<ResolvedPair> resolve(const std::vector<language::desired::Pair>& pairs, const std::string& what);

  // Replaces `instance.frame` by the name of the frame. Returns false after reporting that there is no such frame.
  bool resolve(language::desired::Name& name);

 private:
  const language::desired::Document& document_;
  KnownFrames& known_;  // not const: limits how many guesses it makes
  Diagnostics& diagnostics_;
  InstanceResolver instances_;
  std::set<std::string> accepted_;  // frames that are listed, or reported as unlisted

  void check_owner();
  void check_loops();
  void check_variable(const language::desired::Name& variable);
  void check_list();
  std::optional<int> frame(const language::desired::Name& name, const std::string& what);
  void warn_unknown(const language::desired::Name& name, const std::string& consequence);
  Place place(const Span& span) const { return {document_.source, span}; }
};

}  // namespace robcogen::import
