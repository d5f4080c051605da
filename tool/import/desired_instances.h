// Instances of parts, which a list of desired transforms names as `LF.foot` or in loops.
#pragma once

#include <set>
#include <string>
#include <utility>
#include <vector>

#include "language/desired/document.h"
#include "model/name_index.h"

namespace robcogen::import {

// The frames that a list may name: those of a robot, or of a model of motions.
struct KnownFrames {
  std::string kind;   // "robot", "model"
  std::string owner;  // its name
  model::NameIndex index;
  std::vector<std::string> links = {};
  std::vector<std::string> instances = {};  // of parts
};

// Finds instances and their frames, and reports each that does not exist once.
class InstanceResolver {
 public:
  InstanceResolver(std::shared_ptr<const Source> source, const KnownFrames& known, Diagnostics& diagnostics)
      : source_(std::move(source)), known_(known), diagnostics_(diagnostics) {}

  // Whether it is an instance of a part, or a prefix of names that serves as one.
  bool exists(const std::string& instance, const Span& span);

  // Puts the name of the frame in place of `instance.frame`. False when there is none.
  bool resolve(language::desired::Name& name);

 private:
  std::shared_ptr<const Source> source_;
  const KnownFrames& known_;
  Diagnostics& diagnostics_;
  std::set<std::string> existing_;                          // of those that were asked for
  std::set<std::pair<std::string, std::string>> reported_;  // instances that do not exist, or lack a frame

  // As they are called in its part.
  std::vector<std::string> frames_of(const std::string& instance) const;
  Place place(const Span& span) const { return {source_, span}; }
};

}  // namespace robcogen::import
