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

// The positions of the texts of one answer, each counted once.
class PositionCache {
 public:
  explicit PositionCache(PositionEncoding encoding) : encoding_(encoding) {}
  PositionEncoding encoding() const { return encoding_; }
  const Positions& operator()(const std::shared_ptr<const Source>& source);

 private:
  PositionEncoding encoding_;
  std::map<std::shared_ptr<const Source>, Positions> known_;
};

// Who uses the text that holds the place, such as an instance of a part, and who uses that, outwards.
std::vector<Note> users_of(Place place);

// A value `Diagnostic` of the protocol. A diagnostic without a place is at the beginning of the document.
Json published_diagnostic(
    const Diagnostic& d,
    const OpenDocument& document,
    const Documents& documents,
    PositionCache& positions);

// Values `Diagnostic` of the protocol by the path of the document that they are in. No more than 1,000 of a document;
// the last one then counts the rest.
std::map<std::filesystem::path, Json> published(
    const Diagnostics& diagnostics,
    const OpenDocument& document,
    const Documents& documents,
    PositionCache& positions);

}  // namespace robcogen::server
