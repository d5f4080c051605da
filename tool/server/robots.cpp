#include "server/robots.h"

#include <algorithm>
#include <array>
#include <system_error>
#include <utility>

#include "language/common/content.h"
#include "support/files.h"

namespace robcogen::server {
namespace {

namespace fs = std::filesystem;
using driver::Language;

constexpr std::size_t kMaxEntries = 20000;
constexpr std::array kSuffixes = {".kindsl", ".urdf", ".motdsl", ".ctdsl"};

// Returns the value of the first attribute `name` of the element `robot`.
std::string name_in_urdf(std::string_view text) {
  const std::size_t robot = text.find("<robot");
  if (robot == std::string_view::npos) return "";
  const std::string_view tag = text.substr(robot, text.find('>', robot) - robot);
  const std::size_t name = tag.find("name");
  const std::size_t open = name == std::string_view::npos ? name : tag.find_first_of("\"'", name);
  if (open == std::string_view::npos) return "";
  const std::size_t close = tag.find(tag[open], open + 1);
  return close == std::string_view::npos ? "" : std::string(tag.substr(open + 1, close - open - 1));
}

std::string name_after(const std::shared_ptr<const Source>& source, std::string_view keyword) {
  Diagnostics ignored;
  const language::TokenList list = language::tokenize(source, ignored);
  for (std::size_t i = 0; i + 1 < list.tokens.size(); ++i) {
    const bool is_name = list.tokens[i + 1].kind == language::Token::Kind::identifier;
    if (list.tokens[i].text == keyword && !list.tokens[i].escaped && is_name)
      return std::string(list.tokens[i + 1].text);
  }
  return "";
}

}  // namespace

std::string declared_name(Language language, const std::shared_ptr<const Source>& source) {
  const language::Content content = language::content_of(source->text());
  if (content == language::Content::urdf) return name_in_urdf(source->text());
  if (content != language::Content::unknown) return "";
  switch (language) {
    case Language::robot:
      return name_after(source, "Robot");
    case Language::motions:
    case Language::transforms:
      return name_after(source, "Model");
    default:
      return "";
  }
}

std::vector<fs::path> documents_below(const fs::path& folder) {
  std::vector<fs::path> result;
  std::error_code fault;
  fs::recursive_directory_iterator entry(folder, fs::directory_options::skip_permission_denied, fault), end;
  for (std::size_t seen = 0; !fault && entry != end && seen < kMaxEntries; entry.increment(fault), ++seen) {
    const std::string name = entry->path().filename().string();
    std::error_code ignored;
    if (entry->is_directory(ignored) && (name.starts_with('.') || name == "node_modules"))
      entry.disable_recursion_pending();
    else if (driver::language_of_suffix(entry->path()) && entry->is_regular_file(ignored))
      result.push_back(entry->path().lexically_normal());
  }
  std::sort(result.begin(), result.end());
  return result;
}

void RobotFinder::set_folders(std::vector<fs::path> folders) {
  folders_ = std::move(folders);
  forget_files();
}

bool RobotFinder::exists(const fs::path& path) const {
  std::error_code ignored;
  return documents_.find(path) != nullptr || fs::is_regular_file(path, ignored);
}

std::optional<fs::path> RobotFinder::find(const OpenDocument& list, const std::string& name) {
  for (const char* suffix : kSuffixes) {
    fs::path sibling = list.path;
    sibling.replace_extension(suffix);
    if (exists(sibling)) return sibling;
  }
  return find_by_name(list, name);
}

void RobotFinder::read_names() {
  if (names_) return;
  names_.emplace();
  for (const fs::path& folder : folders_) {
    for (const fs::path& file : documents_below(folder)) {
      const Language language = *driver::language_of_suffix(file);
      std::string fault;
      if (language == Language::desired) continue;
      if (std::optional<std::string> text = read_file(file, fault))
        (*names_)[declared_name(language, std::make_shared<const Source>(file.string(), std::move(*text)))].insert(
            file);
    }
  }
}

std::optional<fs::path> RobotFinder::find_by_name(const OpenDocument& list, const std::string& name) {
  if (name.empty()) return std::nullopt;
  read_names();
  std::set<fs::path> known = (*names_)[name], open;
  for (const auto& [uri, document] : documents_.all()) {
    known.erase(document.path);
    const bool is_model = document.language != Language::desired;
    if (is_model && declared_name(document.language, document.source) == name) open.insert(document.path);
  }
  known.insert(open.begin(), open.end());
  std::erase_if(known, [&](const fs::path& path) {
    std::error_code ignored;
    return documents_.find(path) == nullptr && !fs::exists(path, ignored);
  });
  for (const fs::path& path : known)
    if (path.parent_path() == list.path.parent_path()) return path;
  if (known.size() == 1) return *known.begin();
  // Of several documents, take the one that is open together with the list.
  const bool is_open = documents_.find(list.path) != nullptr;
  return is_open && open.size() == 1 ? std::optional(*open.begin()) : std::nullopt;
}

}  // namespace robcogen::server
