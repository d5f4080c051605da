// The parts that a document may name: its own, and those of the documents that it imports.
#pragma once

#include <map>
#include <memory>
#include <set>
#include <string>
#include <vector>

#include "import/parts.h"

namespace robcogen::import::parts {

namespace kinematics = language::kinematics;
using DocumentPtr = std::shared_ptr<const kinematics::Document>;

// A part, or the robot of a document.
struct Entry {
  DocumentPtr document;
  const kinematics::Part* part = nullptr;  // nullptr: the robot
  kinematics::Name name;                   // where it is declared

  const kinematics::Body& body() const { return part ? static_cast<const kinematics::Body&>(*part) : *document; }
  bool is(const Entry& other) const { return document == other.document && part == other.part; }
};

// The parts of every document that is reachable from the first one, by name.
class Scopes {
 public:
  // Reports files that cannot be imported, import cycles, part names that clash, and parts that cannot be attached.
  Scopes(const DocumentPtr& document, const Resolver& resolve, Diagnostics& diagnostics);

  // Returns nullptr for a name that the document does not know.
  const Entry* find(const DocumentPtr& document, const std::string& name) const;
  std::vector<std::string> names(const DocumentPtr& document) const;

 private:
  using Scope = std::map<std::string, Entry>;

  const Resolver& resolve_;
  Diagnostics& diagnostics_;
  std::map<DocumentPtr, Scope> scopes_;
  std::vector<DocumentPtr> open_;  // documents being read, each imported by the one before

  void read(const DocumentPtr& document);
  void import(const DocumentPtr& document, const kinematics::Import& import, Scope& scope);
  void declare(Scope& scope, const std::string& name, const Entry& entry, const Place& place);
  void check(const DocumentPtr& document, const kinematics::Part& part);
};

}  // namespace robcogen::import::parts
