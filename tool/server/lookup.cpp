#include "server/lookup.h"

#include <system_error>

#include "server/features.h"

namespace robcogen::server {

Lookup::Lookup(Workspace& workspace, const Json& parameters)
    : documents(workspace.documents(), workspace.parsed_texts()),
      names(documents, workspace.robots()),
      positions(workspace.encoding),
      workspace_(workspace) {
  open = workspace.documents().find(uri_in(parameters));
  document = open != nullptr ? documents(open->path) : nullptr;
  if (document == nullptr) return;
  occurrences = names.occurrences(*document);
  if (!parameters.contains("position")) return;
  offset = here().offset(parameters["position"]);
  at_place = occurrence_at(occurrences, offset);
}

Json Lookup::location(const Parsed& in, const Span& span) {
  return {{"uri", workspace_.documents().uri(in.path)}, {"range", positions(in.source).json(span)}};
}

std::vector<Lookup::Found> Lookup::everywhere(const Symbol& symbol) {
  std::set<std::filesystem::path> paths = {symbol.document};
  for (const auto& [uri, other] : workspace_.documents().all()) paths.insert(other.path);
  for (const std::filesystem::path& folder : workspace_.robots().folders())
    for (std::filesystem::path& path : documents_below(folder)) paths.insert(std::move(path));
  for (const std::filesystem::path& of : {symbol.document, open->path}) {
    std::error_code fault;
    for (const auto& entry : std::filesystem::directory_iterator(of.parent_path(), fault))
      if (driver::language_of_suffix(entry.path())) paths.insert(entry.path().lexically_normal());
  }
  std::vector<Found> found;
  for (const std::filesystem::path& path : paths) {
    const Parsed* other = documents(path);
    if (other == nullptr || other->source->text().find(symbol.name) == std::string_view::npos) continue;
    const std::vector<Occurrence> all = other == document ? occurrences : names.occurrences(*other);
    for (const Occurrence& o : all)
      if (o.symbol == symbol) found.push_back({other, o});
  }
  return found;
}

}  // namespace robcogen::server
