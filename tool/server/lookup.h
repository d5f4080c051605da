// A request about a place in a document: the document, its names, and the one at the place.
#pragma once

#include <optional>
#include <vector>

#include "server/names.h"
#include "server/workspace.h"

namespace robcogen::server {

class Lookup {
 public:
  // Of the document that the parameters name. Without one that is open, all is empty.
  Lookup(Workspace& workspace, const Json& parameters);
  Lookup(const Lookup&) = delete;
  Lookup& operator=(const Lookup&) = delete;

  const OpenDocument* open = nullptr;
  const Parsed* document = nullptr;
  ParsedDocuments documents;
  Names names;
  PositionCache positions;
  std::vector<Occurrence> occurrences;

  // At the `position` of the parameters.
  std::size_t offset = 0;
  const Occurrence* at_place = nullptr;

  const Positions& here() { return positions(document->source); }
  Json location(const Parsed& in, const Span& span);

  // A place of the symbol in any document: open ones, those of the workspace's folders, and those beside the document.
  struct Found {
    const Parsed* document;
    Occurrence occurrence;
  };
  std::vector<Found> everywhere(const Symbol& symbol);

 private:
  Workspace& workspace_;
};

}  // namespace robcogen::server
