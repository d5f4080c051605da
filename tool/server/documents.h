// The documents that the editor has open: all that the server remembers.
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "driver/documents.h"
#include "support/source.h"

namespace robcogen::server {

struct OpenDocument {
  std::string uri;             // as the editor spells it
  std::filesystem::path path;  // without a file, its URI, with the suffix of its language
  driver::Language language = driver::Language::robot;
  std::int64_t version = 0;
  std::shared_ptr<const Source> source;
};

class Documents {
 public:
  // Searched for imported documents, after the folder of the document that imports.
  std::vector<std::filesystem::path> import_folders;

  // Documents in other languages are left alone: nullptr.
  const OpenDocument* open(const std::string& uri, const std::string& language, std::int64_t version, std::string text);
  // nullptr where it is not open.
  const OpenDocument* change(const std::string& uri, std::int64_t version, std::string text);
  bool close(const std::string& uri);

  const OpenDocument* find(const std::string& uri) const;
  const OpenDocument* find(const std::filesystem::path& path) const;
  const std::map<std::string, OpenDocument>& all() const { return documents_; }  // by URI
  // The editor's URI of an open document, else that of the file.
  std::string uri(const std::filesystem::path& path) const;

 private:
  std::map<std::string, OpenDocument> documents_;
  std::map<std::filesystem::path, std::string> uris_;
};

}  // namespace robcogen::server
