// Instances of parts, to which a list of desired transforms refers as `LF.foot` or in loops.
#pragma once

#include <set>
#include <string>
#include <utility>
#include <vector>

#include "language/desired/document.h"
#include "model/name_index.h"

namespace robcogen::import {

// The frames that a list may name: frames of a robot, or of a model of rigid motions.
struct KnownFrames {
  std::string kind;   // "robot", "model"
  std::string owner;  // its name
  model::NameIndex index;
  std::vector<std::string> links = {};
  std::vector<std::string> instances = {};  // instances of parts
};

// Finds instances and their frames, and reports each missing one once.
class InstanceResolver {
 public:
  InstanceResolver(std::shared_ptr<const Source> source, const KnownFrames& known, Diagnostics& diagnostics)
      : source_(std::move(source)), known_(known), diagnostics_(diagnostics) {}

  // Whether this is an instance of a part, or a prefix of frame names, which serves as an instance.
  bool exists(const std::string& instance, const Span& span);

  // Replaces `instance.frame` by the name of the frame. Returns false if there is no such frame.
  bool resolve(language::desired::Name& name);

 private:
  std::shared_ptr<const Source> source_;
  const KnownFrames& known_;
  Diagnostics& diagnostics_;
  std::set<std::string> existing_;                          // instances known to exist from earlier calls
  std::set<std::pair<std::string, std::string>> reported_;  // instances that do not exist, or lack a frame

  // The frames of an instance, by their names in the part.
  std::vector<std::string> frames_of(const std::string& instance) const;
  Place place(const Span& span) const { return {source_, span}; }
};

}  // namespace robcogen::import
