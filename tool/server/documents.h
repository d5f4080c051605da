// The documents that are open in the editor: the only state that the server keeps.
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
  std::filesystem::path path;  // for a document without a file: its URI with the suffix of its language
  driver::Language language = driver::Language::robot;
  std::int64_t version = 0;
  std::shared_ptr<const Source> source;
};

class Documents {
 public:
  // Folders that are searched for imported documents, after the folder of the importing document.
  std::vector<std::filesystem::path> import_folders;

  // Returns nullptr for documents in other languages, which are ignored.
  const OpenDocument* open(const std::string& uri, const std::string& language, std::int64_t version, std::string text);
  // Returns nullptr if the document is not open.
  const OpenDocument* change(const std::string& uri, std::int64_t version, std::string text);
  bool close(const std::string& uri);

  const OpenDocument* find(const std::string& uri) const;
  const OpenDocument* find(const std::filesystem::path& path) const;
  const std::map<std::string, OpenDocument>& all() const { return documents_; }  // by URI
  // Returns the editor's URI of an open document, or else the URI of the file.
  std::string uri(const std::filesystem::path& path) const;

 private:
  std::map<std::string, OpenDocument> documents_;
  std::map<std::filesystem::path, std::string> uris_;
};

}  // namespace robcogen::server
