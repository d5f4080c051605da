#include "import/parts/arguments.h"

#include <fmt/format.h>

#include <map>
#include <set>
#include <string>
#include <utility>

#include "import/parts/assembly.h"
#include "import/parts/terms.h"

namespace robcogen::import::parts {

using kinematics::Instance;
using kinematics::Joint;

namespace {

void read(
    const kinematics::Argument& argument,
    const Instance& instance,
    const std::set<std::string>& known,
    std::map<std::string, Span>& given,
    const std::shared_ptr<const Source>& source,
    Diagnostics& diagnostics,
    Meanings& result) {
  const std::string& name = argument.name.text;
  const auto [earlier, is_new] = given.insert({name, argument.name.span});
  if (!is_new) {
    diagnostics
        .error("duplicate-argument", {source, argument.name.span}, fmt::format("argument '{}' is given twice", name))
        .notes.push_back({{source, earlier->second}, "first given here"});
  } else if (!known.contains(name)) {
    diagnostics
        .error(
            "unknown-argument", {source, argument.name.span},
            fmt::format("part '{}' has no parameter '{}'", instance.part.text, name))
        .hint = did_you_mean(name, {known.begin(), known.end()});
  } else {
    result.values.insert_or_assign(name, argument.value);
  }
}

}  // namespace

Meanings meanings_of(
    const Entry& entry,
    const Instance& instance,
    std::size_t offset,
    const std::shared_ptr<const Source>& source,
    Diagnostics& diagnostics) {
  Meanings result;
  for (const Joint& joint : entry.body().joints)
    for (std::string& name : coordinate_names(joint)) result.joints.insert(std::move(name));
  std::set<std::string> known;
  if (entry.part != nullptr) {
    result.part = entry.part->name.text;
    for (const kinematics::PartParameter& parameter : entry.part->parameters) {
      known.insert(parameter.name.text);
      if (parameter.default_value) result.values.insert({parameter.name.text, parameter.default_value});
    }
  } else {
    known = parameters_of(entry.body());
  }
  std::map<std::string, Span> given;
  for (const kinematics::Argument& argument : instance.arguments)
    read(argument, instance, known, given, source, diagnostics, result);
  if (entry.part == nullptr) return result;
  for (const kinematics::PartParameter& parameter : entry.part->parameters) {
    if (result.values.contains(parameter.name.text)) continue;
    const Span span = {parameter.name.span.begin + offset, parameter.name.span.end + offset};
    diagnostics
        .error(
            "missing-argument", {source, instance.name.span},
            fmt::format("'{}' has no argument for parameter '{}'", instance.name.text, parameter.name.text))
        .notes.push_back({{source, span}, fmt::format("part '{}' declares it here", instance.part.text)});
    result.values.insert({parameter.name.text, term(Number::rational(1), instance.name.span)});
  }
  return result;
}

}  // namespace robcogen::import::parts
