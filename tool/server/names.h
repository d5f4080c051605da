// Where the names of a document occur, and what each refers to, including across documents: frames in a list of desired
// transforms are frames of its robot, and `left_foot` is the frame `foot` of the part that is attached as `left`.
#pragma once

#include <compare>
#include <functional>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "server/parsed.h"
#include "server/robots.h"

namespace robcogen::server {

enum class NameKind { robot, part, instance, link, joint, loop, frame, parameter, constant, group, transform };

std::string describe(NameKind kind);

// What a name refers to.
struct Symbol {
  std::filesystem::path document;  // the document that declares it
  std::string scope;               // the part, or the group of a parameter; empty for the document itself
  NameKind kind = NameKind::link;
  std::string name;

  auto operator<=>(const Symbol&) const = default;
};

// An occurrence of a name: a word, or a piece of one.
struct Occurrence {
  Span span;
  Symbol symbol;
  bool is_declaration = false;
};

// A robot or a part.
struct Scope {
  const Parsed* document = nullptr;                  // with robots or parts, or a URDF
  const language::kinematics::Part* part = nullptr;  // nullptr: the robot

  // Must not be called for a URDF.
  const language::kinematics::Body& body() const {
    return part != nullptr ? static_cast<const language::kinematics::Body&>(*part) : *document->robot();
  }
  std::string name() const { return part != nullptr ? part->name.text : ""; }
};

class Names {
 public:
  Names(ParsedDocuments& documents, RobotFinder& robots) : documents_(documents), robots_(robots) {}

  // Returns the occurrences in the document, in the order of the text. A word with several pieces has an occurrence for
  // each.
  std::vector<Occurrence> occurrences(const Parsed& document);
  // The document of the robot or model that a list is about.
  const Parsed* model_of(const Parsed& list);

  // A piece of a name, as a span from the beginning of the name, and what it refers to.
  struct Piece {
    Span span;
    Symbol symbol;
  };
  // The pieces of the name of a link or joint, or of a frame, of a robot or part: its own, or those of instances in it.
  // Empty for a name that it does not have.
  std::vector<Piece> element(const Scope& scope, std::string_view name, std::size_t depth = 0);
  std::vector<Piece> frame(const Scope& scope, std::string_view name, std::size_t depth = 0);
  // Finds a part, or a robot used as a part, by the name under which a document knows it.
  std::optional<Scope> part(const Parsed& document, const std::string& name);
  // The part that is attached as this instance.
  std::optional<Scope> instance(const Scope& scope, const std::string& name);
  const std::map<std::string, Scope>& known_parts(const Parsed& document);

 private:
  struct Elements {
    std::set<std::string, std::less<>> links, frames;
    std::map<std::string, const language::kinematics::Joint*, std::less<>> joints;  // nullptr in a URDF
    std::vector<const language::kinematics::Instance*> instances;
  };

  ParsedDocuments& documents_;
  RobotFinder& robots_;
  std::map<const void*, Elements> elements_;  // by part, or by document
  std::map<const Parsed*, std::map<std::string, Scope>> parts_;

  const Elements& elements(const Scope& scope);
  std::vector<Piece> in_instances(const Scope& scope, std::string_view name, bool is_frame, std::size_t depth);
};

// Returns the occurrence that contains the offset or ends at it, because the cursor of an editor may be behind a name;
// nullptr if there is none.
const Occurrence* occurrence_at(const std::vector<Occurrence>& occurrences, std::size_t offset);

}  // namespace robcogen::server
