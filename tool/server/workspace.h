// What the server knows while it runs: the open documents, and what follows from them.
#pragma once

#include <map>
#include <memory>
#include <set>
#include <string>
#include <vector>

#include "server/analysis.h"
#include "server/documents.h"
#include "server/parsed.h"
#include "server/positions.h"
#include "server/publish.h"
#include "server/robots.h"

namespace robcogen::server {

class Workspace {
 public:
  PositionEncoding encoding = PositionEncoding::utf16;

  Documents& documents() { return documents_; }
  const Documents& documents() const { return documents_; }
  RobotFinder& robots() { return robots_; }
  ParsedTexts& parsed_texts() { return parsed_texts_; }

  // Of an open document, at its present text.
  const Analysis& analysis(const OpenDocument& document);
  // What follows from the document of this path is computed again at its next use; without a path, everything is.
  void forget(const std::filesystem::path& changed);
  void forget_all();

  // Notifications of the diagnostics that changed, and in any case of those of the document `shown`.
  std::vector<Json> publish(const std::string& shown);

 private:
  Documents documents_;
  RobotFinder robots_{documents_};
  ParsedTexts parsed_texts_;
  std::map<std::string, std::shared_ptr<const Analysis>> analyses_;           // by URI
  std::map<std::string, std::map<std::filesystem::path, Json>> diagnostics_;  // that each open document yields
  std::map<std::filesystem::path, Json> published_;                           // what the editor has
};

}  // namespace robcogen::server
