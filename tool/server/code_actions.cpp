// Quick fixes for the diagnostics in a range.
#include <algorithm>

#include "server/features.h"
#include "server/quick_fixes.h"

namespace robcogen::server {

Json code_actions(Workspace& workspace, const Json& parameters) {
  const OpenDocument* document = workspace.documents().find(uri_in(parameters));
  Json actions = Json::array();
  if (document == nullptr) return actions;
  PositionCache positions(workspace.encoding);
  const Positions& here = positions(document->source);
  const Span range = here.span(parameters.at("range"));
  for (const Diagnostic& d : workspace.analysis(*document).diagnostics.all()) {
    const Place place = written_at(d.place);
    if (place.source != document->source) continue;
    if (place.span.begin > range.end || std::max(place.span.end, place.span.begin + 1) < range.begin) continue;
    for (const QuickFix& fix : quick_fixes(d)) {
      Json edits = Json::array();
      for (const TextChange& change : fix.changes)
        edits.push_back({{"range", here.json(change.span)}, {"newText", change.text}});
      actions.push_back(
          {{"title", fix.title},
           {"kind", "quickfix"},
           {"isPreferred", actions.empty()},
           {"diagnostics", Json::array({published_diagnostic(d, *document, workspace.documents(), positions)})},
           {"edit", {{"changes", {{document->uri, std::move(edits)}}}}}});
    }
  }
  return actions;
}

}  // namespace robcogen::server
