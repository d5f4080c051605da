// Documents as their parsers read them, valid or not. Requests about names use these.
#pragma once

#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <variant>
#include <vector>

#include "language/common/lexer.h"
#include "language/desired/document.h"
#include "language/kinematics/document.h"
#include "language/motion/document.h"
#include "language/transforms/document.h"
#include "server/documents.h"
#include "server/urdf_names.h"

namespace robcogen::server {

struct Parsed {
  std::filesystem::path path;
  driver::Language language = driver::Language::robot;
  std::shared_ptr<const Source> source;
  // monostate: MJCF, or not a text.
  std::variant<
      std::monostate,
      UrdfNames,
      language::kinematics::Document,
      language::desired::Document,
      language::motion::Document,
      language::transforms::Document>
      document;
  language::TokenList tokens;
  bool has_errors = false;  // syntax errors: the document may be incomplete

  const language::kinematics::Document* robot() const { return std::get_if<language::kinematics::Document>(&document); }
  const UrdfNames* urdf() const { return std::get_if<UrdfNames>(&document); }
  const language::desired::Document* desired() const { return std::get_if<language::desired::Document>(&document); }
  const language::motion::Document* motions() const { return std::get_if<language::motion::Document>(&document); }
  const language::transforms::Document* transforms() const {
    return std::get_if<language::transforms::Document>(&document);
  }
};

Parsed parsed(const OpenDocument& document);

// The last parse of each open document: an editor sends many requests about one text.
using ParsedTexts = std::map<std::filesystem::path, std::shared_ptr<const Parsed>>;

// Parses each document once, whether it is open or in a file.
class ParsedDocuments {
 public:
  ParsedDocuments(const Documents& documents, ParsedTexts& texts) : documents_(documents), texts_(texts) {}
  // Returns nullptr if there is no such file, or if it is not in one of our languages.
  const Parsed* operator()(const std::filesystem::path& path);
  // The document that an import names.
  const Parsed* imported(const Parsed& from, const language::kinematics::Import& import);
  const Documents& open() const { return documents_; }

 private:
  const Documents& documents_;
  ParsedTexts& texts_;
  std::map<std::filesystem::path, std::shared_ptr<const Parsed>> known_;
};

}  // namespace robcogen::server
