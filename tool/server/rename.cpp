// Renames an element everywhere, including in lists of desired transforms, in parts, and in names that refer to their
// instances.
#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "language/common/characters.h"
#include "server/features.h"
#include "server/lookup.h"
#include "server/session.h"
#include "server/vocabulary.h"

namespace robcogen::server {
namespace {

constexpr std::size_t kMaxName = 255;

[[noreturn]] void refuse(const std::string& why) {
  throw RequestError{ErrorCode::request_failed, why};
}

bool is_identifier(const std::string& name) {
  return !name.empty() && name.size() <= kMaxName && std::all_of(name.begin(), name.end(), language::is_word) &&
         !language::is_digit(name[0]);
}

// Returns the text with another word at these places, which are in order.
std::string with_word(std::string_view text, const std::vector<Span>& places, const std::string& word) {
  std::string result;
  std::size_t at = 0;
  for (const Span& place : places) {
    result += text.substr(at, place.begin - at);
    result += word;
    at = place.end;
  }
  return result + std::string(text.substr(at));
}

using Places = std::map<const Parsed*, std::vector<Span>>;

using Counts = std::map<std::string, int>;  // number of messages, by code

void add(const Analysis& analysis, Counts& counts) {
  for (const Diagnostic& d : analysis.diagnostics.all()) ++counts[d.code];
}

// Counts the messages of the documents that are to change, as they are.
Counts messages(Workspace& workspace, const Places& places) {
  Counts counts;
  for (const auto& [parsed, spans] : places) {
    if (const OpenDocument* open = workspace.documents().find(parsed->path)) {
      add(workspace.analysis(*open), counts);
      continue;
    }
    Documents with_file = workspace.documents();
    const OpenDocument* document =
        with_file.open(workspace.documents().uri(parsed->path), "", 0, std::string(parsed->source->text()));
    RobotFinder robots(with_file);
    robots.set_folders(workspace.robots().folders());
    if (document != nullptr) add(*analyse(*document, with_file, robots), counts);
  }
  return counts;
}

// Counts the messages of the same documents with the new name.
Counts messages(Workspace& workspace, const Places& places, const std::string& name) {
  Documents changed = workspace.documents();
  for (const auto& [parsed, spans] : places)
    changed.open(workspace.documents().uri(parsed->path), "", 0, with_word(parsed->source->text(), spans, name));
  RobotFinder robots(changed);
  robots.set_folders(workspace.robots().folders());
  Counts counts;
  for (const auto& [parsed, spans] : places)
    if (const OpenDocument* document = changed.find(parsed->path)) add(*analyse(*document, changed, robots), counts);
  return counts;
}

// Refuses a name that adds messages to a document: it may be taken.
void require_no_harm(Workspace& workspace, const Places& places, const std::string& name) {
  Counts counts = messages(workspace, places, name);
  for (const auto& [code, count] : messages(workspace, places)) counts[code] -= count;
  // A new name may resemble another name; that is the user's choice.
  counts.erase("similar-name");
  for (const auto& [code, count] : counts)
    if (count > 0)
      refuse(fmt::format("the name '{}' would cause errors or warnings ({}): is it already used?", name, code));
}

}  // namespace

Json prepare_rename(Workspace& workspace, const Json& parameters) {
  Lookup lookup(workspace, parameters);
  if (lookup.at_place == nullptr) return nullptr;
  return {{"range", lookup.here().json(lookup.at_place->span)}, {"placeholder", lookup.at_place->symbol.name}};
}

Json rename(Workspace& workspace, const Json& parameters) {
  Lookup lookup(workspace, parameters);
  const std::string name = parameters.at("newName").get<std::string>();
  if (lookup.at_place == nullptr) refuse("no name to rename here");
  const Symbol symbol = lookup.at_place->symbol;
  if (!is_identifier(name))
    refuse(fmt::format("'{}' is not a valid identifier: names consist of A-Z, a-z, 0-9 and '_'", name));
  Places places;
  for (const Lookup::Found& found : lookup.everywhere(symbol)) places[found.document].push_back(found.occurrence.span);
  if (places.empty() || symbol.name == name) return nullptr;
  for (const auto& [document, spans] : places) {
    if (document->has_errors)
      refuse(fmt::format("'{}' has syntax errors: some uses of the name may be missed", document->path.string()));
    const auto& reserved = keywords(document->language);
    if (std::find(reserved.begin(), reserved.end(), name) != reserved.end())
      refuse(fmt::format("'{}' is a keyword", name));
  }
  require_no_harm(workspace, places, name);
  Json changes = Json::object();
  for (const auto& [document, spans] : places) {
    Json& edits = changes[workspace.documents().uri(document->path)] = Json::array();
    for (const Span& span : spans)
      edits.push_back({{"range", lookup.positions(document->source).json(span)}, {"newText", name}});
  }
  return {{"changes", std::move(changes)}};
}

}  // namespace robcogen::server
