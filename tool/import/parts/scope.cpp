#include "import/parts/scope.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <utility>

#include "import/parts/rewrite.h"

namespace robcogen::import::parts {

using kinematics::Name;

Scopes::Scopes(const DocumentPtr& document, const Resolver& resolve, Diagnostics& diagnostics)
    : resolve_(resolve), diagnostics_(diagnostics) {
  read(document);
}

const Entry* Scopes::find(const DocumentPtr& document, const std::string& name) const {
  const Scope& scope = scopes_.at(document);
  const auto found = scope.find(name);
  return found == scope.end() ? nullptr : &found->second;
}

std::vector<std::string> Scopes::names(const DocumentPtr& document) const {
  std::vector<std::string> names;
  for (const auto& [name, entry] : scopes_.at(document)) names.push_back(name);
  return names;
}

void Scopes::read(const DocumentPtr& document) {
  if (scopes_.contains(document)) return;
  open_.push_back(document);
  Scope scope;
  for (const kinematics::Part& part : document->parts) {
    declare(scope, part.name.text, {document, &part, part.name}, {document->source, part.name.span});
    check(document, part);
  }
  for (const kinematics::Import& import : document->imports) this->import(document, import, scope);
  open_.pop_back();
  scopes_.insert({document, std::move(scope)});
}

void Scopes::import(const DocumentPtr& document, const kinematics::Import& import, Scope& scope) {
  const Place place = {document->source, import.span};
  const DocumentPtr imported = resolve_(*document, import);
  if (!imported) return;
  if (std::find(open_.begin(), open_.end(), imported) != open_.end()) {
    diagnostics_
        .error(
            "import-circle", place,
            fmt::format("'{}' imports itself, directly or through other documents", import.file))
        .hint = "move the parts that both documents need to another document";
    return;
  }
  read(imported);
  for (const auto& [name, entry] : scopes_.at(imported)) declare(scope, name, entry, place);
  if (!imported->has_robot()) {
    if (import.name)
      diagnostics_.error(
          "no-robot", {document->source, import.name->span},
          fmt::format("'{}' has no robot to name '{}'", import.file, import.name->text));
    return;
  }
  const Name& name = import.name ? *import.name : imported->robot;
  declare(scope, name.text, {imported, nullptr, imported->robot}, place);
}

void Scopes::declare(Scope& scope, const std::string& name, const Entry& entry, const Place& place) {
  const auto [known, is_new] = scope.insert({name, entry});
  if (is_new || known->second.is(entry)) return;
  Diagnostic& error = diagnostics_.error("duplicate-part", place, fmt::format("part '{}' is declared twice", name));
  error.notes.push_back({{known->second.document->source, known->second.name.span}, "first declared here"});
  if (entry.part == nullptr) error.hint = fmt::format("give the robot another name: 'import \"…\" as other_{}'", name);
}

void Scopes::check(const DocumentPtr& document, const kinematics::Part& part) {
  const auto place = [&](const Span& span) { return Place{document->source, span}; };
  std::map<std::string, Span> known;
  const std::set<std::string> used = parameters_of(part);
  for (const kinematics::PartParameter& parameter : part.parameters) {
    const auto [earlier, is_new] = known.insert({parameter.name.text, parameter.name.span});
    if (is_new) {
      // A name that is similar to it is reported itself.
      const bool is_misspelt = !did_you_mean(parameter.name.text, {used.begin(), used.end()}).empty();
      if (!used.contains(parameter.name.text) && !is_misspelt)
        diagnostics_.warning(
            "unused-parameter", place(parameter.name.span),
            fmt::format("part '{}' does not use its parameter '{}'", part.name.text, parameter.name.text));
      continue;
    }
    diagnostics_
        .error(
            "duplicate-parameter", place(parameter.name.span),
            fmt::format("part '{}' declares parameter '{}' twice", part.name.text, parameter.name.text))
        .notes.push_back({place(earlier->second), "first declared here"});
  }
  std::vector<std::string> links;
  for (const kinematics::Link& link : part.links) links.push_back(link.name.text);
  for (const kinematics::Child& root : part.roots) {
    const Name& name = root.link;
    if (std::find(links.begin(), links.end(), name.text) == links.end()) {
      diagnostics_
          .error(
              "unknown-root", place(name.span),
              fmt::format("part '{}' has no link '{}' for its root", part.name.text, name.text))
          .hint = did_you_mean(name.text, links);
    }
    for (const kinematics::Link& link : part.links)
      for (const kinematics::Child& child : link.children)
        if (child.link.text == name.text)
          diagnostics_
              .error(
                  "root-with-parent", place(name.span),
                  fmt::format("the root '{}' of part '{}' has a parent in the part", name.text, part.name.text))
              .notes.push_back({place(child.link.span), fmt::format("link '{}' carries it here", link.name.text)});
  }
}

}  // namespace robcogen::import::parts
