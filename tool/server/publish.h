// Diagnostics as editors show them.
#pragma once

#include <filesystem>
#include <map>
#include <string>

#include "server/documents.h"
#include "server/json.h"
#include "server/positions.h"
#include "support/diagnostics.h"

namespace robcogen::server {

// The positions of the texts in one answer, each computed once.
class PositionCache {
 public:
  explicit PositionCache(PositionEncoding encoding) : encoding_(encoding) {}
  PositionEncoding encoding() const { return encoding_; }
  const Positions& operator()(const std::shared_ptr<const Source>& source);

 private:
  PositionEncoding encoding_;
  std::map<std::shared_ptr<const Source>, Positions> known_;
};

// Returns the users of the text at the place, such as an instance of a part, then the users of those, outwards.
std::vector<Note> users_of(Place place);

// Returns a `Diagnostic` value of the protocol. A diagnostic without a place is put at the beginning of the document.
Json published_diagnostic(
    const Diagnostic& d,
    const OpenDocument& document,
    const Documents& documents,
    PositionCache& positions);

// Returns `Diagnostic` values of the protocol by the path of the document that they are in, at most 1,000 per document;
// if there are more, the last one tells the total.
std::map<std::filesystem::path, Json> published(
    const Diagnostics& diagnostics,
    const OpenDocument& document,
    const Documents& documents,
    PositionCache& positions);

}  // namespace robcogen::server
