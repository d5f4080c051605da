#include "server/documents.h"

#include <array>
#include <utility>

#include "server/uri.h"

namespace robcogen::server {
namespace {

using driver::Language;

// The names of languages in editors, which are also the suffixes of files.
constexpr std::array kLanguages = {
    std::pair("kindsl", Language::robot), std::pair("dtdsl", Language::desired), std::pair("motdsl", Language::motions),
    std::pair("ctdsl", Language::transforms), std::pair("urdf", Language::urdf)};

std::shared_ptr<const Source> source(const OpenDocument& document, std::string text) {
  return std::make_shared<const Source>(document.path.string(), std::move(text));
}

}  // namespace

const OpenDocument* Documents::open(
    const std::string& uri,
    const std::string& language,
    std::int64_t version,
    std::string text) {
  close(uri);
  OpenDocument document = {uri, path_of(uri), Language::robot, version, nullptr};
  std::optional<Language> known = driver::language_of_suffix(document.path);
  for (const auto& [name, value] : kLanguages) {
    if (known || name != language) continue;
    known = value;
    if (!document.path.is_absolute()) document.path += std::string(".") + name;
  }
  if (!known) return nullptr;
  document.language = *known;
  document.source = source(document, std::move(text));
  uris_[document.path] = uri;
  return &(documents_[uri] = std::move(document));
}

const OpenDocument* Documents::change(const std::string& uri, std::int64_t version, std::string text) {
  const auto found = documents_.find(uri);
  if (found == documents_.end()) return nullptr;
  found->second.version = version;
  found->second.source = source(found->second, std::move(text));
  return &found->second;
}

bool Documents::close(const std::string& uri) {
  const auto found = documents_.find(uri);
  if (found == documents_.end()) return false;
  uris_.erase(found->second.path);
  documents_.erase(found);
  return true;
}

const OpenDocument* Documents::find(const std::string& uri) const {
  const auto found = documents_.find(uri);
  return found == documents_.end() ? nullptr : &found->second;
}

const OpenDocument* Documents::find(const std::filesystem::path& path) const {
  const auto found = uris_.find(path);
  return found == uris_.end() ? nullptr : find(found->second);
}

std::string Documents::uri(const std::filesystem::path& path) const {
  const OpenDocument* open = find(path);
  return open != nullptr ? open->uri : uri_of(path);
}

}  // namespace robcogen::server
