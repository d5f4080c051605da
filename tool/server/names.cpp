#include "server/names.h"

#include <algorithm>
#include <utility>

#include "server/collect_names.h"

namespace robcogen::server {
namespace {

namespace kinematics = language::kinematics;

constexpr std::size_t kMaxNesting = 64;  // of parts
constexpr std::string_view kFrame = "fr_";

Symbol symbol_in(const Scope& scope, NameKind kind, std::string_view name) {
  return {scope.document->path, scope.name(), kind, std::string(name)};
}

// Moves the pieces behind the first `count` characters.
std::vector<Names::Piece> moved(std::vector<Names::Piece> pieces, std::size_t count) {
  for (Names::Piece& piece : pieces) piece.span = {piece.span.begin + count, piece.span.end + count};
  return pieces;
}

}  // namespace

std::string describe(NameKind kind) {
  switch (kind) {
    case NameKind::robot:
      return "robot";
    case NameKind::part:
      return "part";
    case NameKind::instance:
      return "instance";
    case NameKind::link:
      return "link";
    case NameKind::joint:
      return "joint";
    case NameKind::loop:
      return "loop";
    case NameKind::frame:
      return "frame";
    case NameKind::parameter:
      return "parameter";
    case NameKind::constant:
      return "constant";
    case NameKind::group:
      return "group of parameters";
    case NameKind::transform:
      return "transform";
  }
  return "name";
}

const Names::Elements& Names::elements(const Scope& scope) {
  const void* of = scope.part != nullptr ? static_cast<const void*>(scope.part) : scope.document;
  const auto [known, is_new] = elements_.try_emplace(of);
  if (!is_new) return known->second;
  if (const UrdfNames* urdf = scope.document->urdf()) {
    for (const UrdfLink& link : urdf->links) known->second.links.insert(link.name.text);
    for (const UrdfJoint& joint : urdf->joints) known->second.joints.insert({joint.name.text, nullptr});
    return known->second;
  }
  const kinematics::Body& body = scope.body();
  for (const kinematics::Link& link : body.links) {
    known->second.links.insert(link.name.text);
    for (const kinematics::Frame& frame : link.frames) known->second.frames.insert(frame.name.text);
    for (const kinematics::Instance& instance : link.instances) known->second.instances.push_back(&instance);
  }
  for (const kinematics::Joint& joint : body.joints) known->second.joints.insert({joint.name.text, &joint});
  return known->second;
}

const std::map<std::string, Scope>& Names::known_parts(const Parsed& document) {
  const auto [known, is_new] = parts_.try_emplace(&document);
  if (!is_new || document.robot() == nullptr) return known->second;
  std::map<std::string, Scope> scopes;
  for (const kinematics::Part& part : document.robot()->parts) scopes.insert({part.name.text, {&document, &part}});
  for (const kinematics::Import& import : document.robot()->imports) {
    const Parsed* imported = documents_.imported(document, import);
    if (imported != nullptr && imported->urdf() != nullptr)
      scopes.insert({import.name ? import.name->text : imported->urdf()->robot.text, {imported, nullptr}});
    if (imported == nullptr || imported->robot() == nullptr) continue;
    for (const auto& [name, scope] : known_parts(*imported)) scopes.insert({name, scope});
    if (imported->robot()->has_robot())
      scopes.insert({import.name ? import.name->text : imported->robot()->robot.text, {imported, nullptr}});
  }
  return parts_[&document] = std::move(scopes);
}

std::optional<Scope> Names::part(const Parsed& document, const std::string& name) {
  const auto& known = known_parts(document);
  const auto found = known.find(name);
  return found == known.end() ? std::nullopt : std::optional(found->second);
}

std::optional<Scope> Names::instance(const Scope& scope, const std::string& name) {
  for (const kinematics::Instance* instance : elements(scope).instances)
    if (instance->name.text == name) return part(*scope.document, instance->part.text);
  return std::nullopt;
}

std::vector<Names::Piece> Names::in_instances(
    const Scope& scope,
    std::string_view name,
    bool is_frame,
    std::size_t depth) {
  if (depth > kMaxNesting) return {};
  for (const kinematics::Instance* instance : elements(scope).instances) {
    const std::string& prefix = instance->name.text;
    if (name.size() <= prefix.size() + 1 || !name.starts_with(prefix) || name[prefix.size()] != '_') continue;
    const std::optional<Scope> attached = part(*scope.document, instance->part.text);
    if (!attached) continue;
    const std::string_view rest = name.substr(prefix.size() + 1);
    std::vector<Piece> pieces = is_frame ? frame(*attached, rest, depth + 1) : element(*attached, rest, depth + 1);
    if (pieces.empty()) continue;
    pieces = moved(std::move(pieces), prefix.size() + 1);
    pieces.insert(pieces.begin(), {{0, prefix.size()}, symbol_in(scope, NameKind::instance, prefix)});
    return pieces;
  }
  return {};
}

std::vector<Names::Piece> Names::element(const Scope& scope, std::string_view name, std::size_t depth) {
  const Elements& known = elements(scope);
  if (known.links.contains(name)) return {{{0, name.size()}, symbol_in(scope, NameKind::link, name)}};
  if (known.joints.contains(name)) return {{{0, name.size()}, symbol_in(scope, NameKind::joint, name)}};
  // A coordinate of a joint with several coordinates, or the massless link after it; the motor of an elastic joint.
  for (const auto& [joint, declared] : known.joints) {
    if (declared == nullptr) break;  // URDFs have joints with one coordinate only
    if (name.size() <= joint.size() + 1 || !name.starts_with(joint) || name[joint.size()] != '_') continue;
    std::string_view rest = name.substr(joint.size() + 1);
    if (rest.ends_with("_link")) rest.remove_suffix(5);
    const bool is_motor = rest == "motor" && declared->elasticity;
    if (rest.ends_with("_motor")) rest.remove_suffix(6);
    const auto words = kinematics::coordinate_words(declared->type);
    if (is_motor || std::find(words.begin(), words.end(), rest) != words.end())
      return {{{0, joint.size()}, symbol_in(scope, NameKind::joint, joint)}};
  }
  return in_instances(scope, name, false, depth);
}

std::vector<Names::Piece> Names::frame(const Scope& scope, std::string_view name, std::size_t depth) {
  if (elements(scope).frames.contains(name)) return {{{0, name.size()}, symbol_in(scope, NameKind::frame, name)}};
  // In a URDF, a link on a fixed joint is a frame of its own name.
  if (scope.document->urdf() != nullptr && elements(scope).links.contains(name)) return element(scope, name, depth);
  if (name.starts_with(kFrame)) {
    const std::string_view rest = name.substr(kFrame.size());
    if (std::vector<Piece> pieces = element(scope, rest, depth); !pieces.empty())
      return moved(std::move(pieces), kFrame.size());
    // `fr_left_foot` may be the user frame `fr_foot` of the part.
    if (depth <= kMaxNesting) {
      for (const kinematics::Instance* instance : elements(scope).instances) {
        const std::string& prefix = instance->name.text;
        if (!rest.starts_with(prefix + "_")) continue;
        const std::optional<Scope> attached = part(*scope.document, instance->part.text);
        const std::string inner = std::string(kFrame) + std::string(rest.substr(prefix.size() + 1));
        if (!attached || !elements(*attached).frames.contains(inner)) continue;
        return {{{kFrame.size(), kFrame.size() + prefix.size()}, symbol_in(scope, NameKind::instance, prefix)}};
      }
    }
  }
  return in_instances(scope, name, true, depth);
}

const Parsed* Names::model_of(const Parsed& list) {
  if (list.desired() == nullptr) return nullptr;
  const OpenDocument document = {"", list.path, list.language, 0, list.source};
  const auto path = robots_.find(document, list.desired()->robot.text);
  return path ? documents_(*path) : nullptr;
}

std::vector<Occurrence> Names::occurrences(const Parsed& document) {
  std::vector<Occurrence> result = collect_names(document, *this);
  std::sort(result.begin(), result.end(), [](const Occurrence& a, const Occurrence& b) {
    return a.span.begin != b.span.begin ? a.span.begin < b.span.begin : a.span.end < b.span.end;
  });
  return result;
}

const Occurrence* occurrence_at(const std::vector<Occurrence>& occurrences, std::size_t offset) {
  const Occurrence* found = nullptr;
  for (const Occurrence& o : occurrences)
    if (o.span.begin <= offset && offset <= o.span.end && (found == nullptr || o.span.begin >= found->span.begin))
      found = &o;
  return found;
}

}  // namespace robcogen::server
