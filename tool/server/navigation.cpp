// Where names are declared and used.
#include "server/features.h"
#include "server/lookup.h"

namespace robcogen::server {
namespace {

// Returns the document that an import at the place names.
const Parsed* import_at(Lookup& lookup) {
  if (lookup.document == nullptr || lookup.document->robot() == nullptr) return nullptr;
  for (const auto& import : lookup.document->robot()->imports)
    if (import.span.begin <= lookup.offset && lookup.offset <= import.span.end)
      return lookup.documents.imported(*lookup.document, import);
  return nullptr;
}

// Finds the place of a frame that a list names in a robot that is not one of our documents, such as a URDF.
Json place_in_model(Workspace& workspace, Lookup& lookup) {
  if (lookup.document == nullptr || lookup.document->desired() == nullptr) return Json::array();
  const Parsed* robot = lookup.names.model_of(*lookup.document);
  if (robot == nullptr) return Json::array();
  const std::optional<model::KinematicTree> tree = tree_of(workspace, robot->path);
  if (!tree) return Json::array();
  for (const language::Token& token : lookup.document->tokens.tokens) {
    if (token.span.begin > lookup.offset || lookup.offset > token.span.end) continue;
    const std::optional<model::Frame> frame = tree->find_frame(std::string(token.text));
    if (!frame) continue;
    const auto index = static_cast<std::size_t>(frame->index);
    const Place place = written_at(
        frame->kind == model::Frame::Kind::link    ? tree->links[index].place
        : frame->kind == model::Frame::Kind::joint ? tree->joints[index].place
                                                   : tree->user_frames[index].place);
    if (!place.source) continue;
    return Json::array(
        {{{"uri", workspace.documents().uri(place.source->name())},
          {"range", lookup.positions(place.source).json(place.span)}}});
  }
  return Json::array();
}

}  // namespace

Json definition(Workspace& workspace, const Json& parameters) {
  Lookup lookup(workspace, parameters);
  if (const Parsed* imported = import_at(lookup)) return Json::array({lookup.location(*imported, {})});
  if (lookup.at_place == nullptr) return place_in_model(workspace, lookup);
  const Symbol symbol = lookup.at_place->symbol;
  Json result = Json::array();
  const Parsed* declares = lookup.documents(symbol.document);
  if (declares == nullptr) return result;
  const std::vector<Occurrence> occurrences = lookup.names.occurrences(*declares);
  for (const Occurrence& o : occurrences)
    if (o.symbol == symbol && o.is_declaration) result.push_back(lookup.location(*declares, o.span));
  // A parameter of a robot needs no declaration; its first use serves as one.
  for (const Occurrence& o : occurrences)
    if (o.symbol == symbol && result.empty()) result.push_back(lookup.location(*declares, o.span));
  return result;
}

Json references(Workspace& workspace, const Json& parameters) {
  Lookup lookup(workspace, parameters);
  Json result = Json::array();
  if (lookup.at_place == nullptr) return result;
  const bool with_declaration = member(member(parameters, "context"), "includeDeclaration") != false;
  for (const Lookup::Found& found : lookup.everywhere(lookup.at_place->symbol))
    if (with_declaration || !found.occurrence.is_declaration)
      result.push_back(lookup.location(*found.document, found.occurrence.span));
  return result;
}

Json highlights(Workspace& workspace, const Json& parameters) {
  Lookup lookup(workspace, parameters);
  Json result = Json::array();
  if (lookup.at_place == nullptr) return result;
  constexpr int kRead = 2, kWrite = 3;
  for (const Occurrence& o : lookup.occurrences)
    if (o.symbol == lookup.at_place->symbol)
      result.push_back({{"range", lookup.here().json(o.span)}, {"kind", o.is_declaration ? kWrite : kRead}});
  return result;
}

}  // namespace robcogen::server
