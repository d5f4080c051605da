#include "server/parsed.h"

#include <system_error>
#include <utility>

#include "language/common/content.h"
#include "support/files.h"

namespace robcogen::server {

Parsed parsed(const OpenDocument& document) {
  Parsed result = {document.path, document.language, document.source, {}, {}, false};
  Diagnostics faults, ignored;
  const language::Content content = language::content_of(document.source->text());
  const bool is_ours = content == language::Content::unknown || content == language::Content::urdf;
  if (!is_ours || document.source->text().find('\0') != std::string_view::npos) {
    result.has_errors = true;
    return result;
  }
  if (content == language::Content::urdf) {
    result.language = driver::Language::urdf;
    result.document = urdf_names(document.source->text());
    return result;
  }
  switch (document.language) {
    case driver::Language::robot:
      result.document = language::kinematics::parse(document.source, faults);
      break;
    case driver::Language::desired:
      result.document = language::desired::parse(document.source, faults);
      break;
    case driver::Language::motions:
      result.document = language::motion::parse(document.source, faults);
      break;
    case driver::Language::transforms:
      result.document = language::transforms::parse(document.source, faults);
      break;
    default:
      return result;
  }
  result.tokens = language::tokenize(document.source, ignored);
  result.has_errors = faults.has_errors();
  return result;
}

const Parsed* ParsedDocuments::operator()(const std::filesystem::path& path) {
  const auto [known, is_new] = known_.insert({path, nullptr});
  if (!is_new) return known->second.get();
  if (const OpenDocument* open = documents_.find(path)) {
    std::shared_ptr<const Parsed>& last = texts_[path];
    if (!last || last->source != open->source) last = std::make_shared<const Parsed>(parsed(*open));
    known->second = last;
    return last.get();
  }
  const std::optional<driver::Language> language = driver::language_of_suffix(path);
  std::error_code ignored;
  if (!language || !std::filesystem::is_regular_file(path, ignored)) return nullptr;
  std::string fault;
  std::optional<std::string> text = read_file(path, fault);
  if (!text) return nullptr;
  const OpenDocument file = {"", path, *language, 0, std::make_shared<const Source>(path.string(), std::move(*text))};
  known->second = std::make_shared<const Parsed>(parsed(file));
  return known->second.get();
}

const Parsed* ParsedDocuments::imported(const Parsed& from, const language::kinematics::Import& import) {
  if (const Parsed* beside = (*this)((from.path.parent_path() / import.file).lexically_normal())) return beside;
  for (const std::filesystem::path& folder : documents_.import_folders)
    if (const Parsed* found = (*this)((folder / import.file).lexically_normal())) return found;
  return nullptr;
}

}  // namespace robcogen::server
