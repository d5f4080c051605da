// The state of the server: the open documents, and the results computed from them.
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

  // Returns the analysis of an open document with its present text.
  const Analysis& analysis(const OpenDocument& document);
  // Discards the results that depend on the document at this path, or all results, so that they are computed again at
  // their next use.
  void forget(const std::filesystem::path& changed);
  void forget_all();

  // Returns notifications of the diagnostics that changed, and always those of the document `shown`.
  std::vector<Json> publish(const std::string& shown);

 private:
  Documents documents_;
  RobotFinder robots_{documents_};
  ParsedTexts parsed_texts_;
  std::map<std::string, std::shared_ptr<const Analysis>> analyses_;           // by URI
  std::map<std::string, std::map<std::filesystem::path, Json>> diagnostics_;  // results for each open document
  std::map<std::filesystem::path, Json> published_;                           // last sent to the editor
};

}  // namespace robcogen::server
