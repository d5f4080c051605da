#include "server/publish.h"

#include <fmt/format.h>

#include <utility>

#include "server/uri.h"

namespace robcogen::server {
namespace {

constexpr std::size_t kMaxShown = 1000;

int severity_number(Severity severity) {
  switch (severity) {
    case Severity::error:
      return 1;
    case Severity::warning:
      return 2;
    case Severity::note:
      return 3;
  }
  return 1;
}

std::string full_message(const Diagnostic& d) {
  std::string text = d.message;
  for (const std::string& detail : d.details) text += "\n" + detail;
  if (!d.hint.empty()) text += "\nhint: " + d.hint;
  return text;
}

Json related(const Diagnostic& d, const Documents& documents, PositionCache& positions) {
  Json list = Json::array();
  std::vector<Note> notes = d.notes;
  for (Note& user : users_of(d.place)) notes.push_back(std::move(user));
  for (const Note& note : notes) {
    const Place place = written_at(note.place);
    if (!place.source) continue;
    list.push_back(
        {{"location",
          {{"uri", documents.uri(place.source->name())}, {"range", positions(place.source).underlined(place.span)}}},
         {"message", note.message}});
  }
  return list;
}

}  // namespace

const Positions& PositionCache::operator()(const std::shared_ptr<const Source>& source) {
  const auto known = known_.find(source);
  if (known != known_.end()) return known->second;
  return known_.emplace(source, Positions(source, encoding_)).first->second;
}

std::vector<Note> users_of(Place place) {
  std::vector<Note> notes;
  while (place.source) {
    const Source::Use* use = place.source->use_at(place.span.begin);
    if (use == nullptr || use->note.empty()) break;
    place.span = use->user;
    notes.push_back({place, use->note});
  }
  return notes;
}

Json published_diagnostic(
    const Diagnostic& d,
    const OpenDocument& document,
    const Documents& documents,
    PositionCache& positions) {
  Place place = written_at(d.place);
  if (!place.source) place = {document.source, {}};
  Json shown = {
      {"range", positions(place.source).underlined(place.span)},
      {"severity", severity_number(d.severity)},
      {"source", "robcogen"},
      {"code", d.code},
      {"message", full_message(d)}};
  if (Json places = related(d, documents, positions); !places.empty()) shown["relatedInformation"] = std::move(places);
  return shown;
}

std::map<std::filesystem::path, Json> published(
    const Diagnostics& diagnostics,
    const OpenDocument& document,
    const Documents& documents,
    PositionCache& positions) {
  std::map<std::filesystem::path, Json> result;
  result[document.path] = Json::array();
  for (const Diagnostic& d : diagnostics.all()) {
    Place place = written_at(d.place);
    if (!place.source) place = {document.source, {}};
    Json& list = result.try_emplace(place.source->name(), Json::array()).first->second;
    if (list.size() == kMaxShown) continue;
    Json shown = published_diagnostic(d, document, documents, positions);
    if (list.size() + 1 == kMaxShown) {
      shown.erase("code");
      shown.erase("relatedInformation");
      shown["message"] = fmt::format("{} diagnostics; no more of them are shown", diagnostics.all().size());
    }
    list.push_back(std::move(shown));
  }
  return result;
}

}  // namespace robcogen::server
