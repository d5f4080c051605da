// A request about a place in a document: the document, its names, and the name at the place.
#pragma once

#include <optional>
#include <vector>

#include "server/names.h"
#include "server/workspace.h"

namespace robcogen::server {

class Lookup {
 public:
  // Looks up the document that the parameters name. If it is not open, all fields are empty.
  Lookup(Workspace& workspace, const Json& parameters);
  Lookup(const Lookup&) = delete;
  Lookup& operator=(const Lookup&) = delete;

  const OpenDocument* open = nullptr;
  const Parsed* document = nullptr;
  ParsedDocuments documents;
  Names names;
  PositionCache positions;
  std::vector<Occurrence> occurrences;

  // The place at the `position` of the parameters.
  std::size_t offset = 0;
  const Occurrence* at_place = nullptr;

  const Positions& here() { return positions(document->source); }
  Json location(const Parsed& in, const Span& span);

  // An occurrence of the symbol in any document: open ones, those in the workspace folders, and those in the same
  // folder as the document.
  struct Found {
    const Parsed* document;
    Occurrence occurrence;
  };
  std::vector<Found> everywhere(const Symbol& symbol);

 private:
  Workspace& workspace_;
};

}  // namespace robcogen::server
