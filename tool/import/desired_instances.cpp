#include "import/desired_instances.h"

#include <fmt/format.h>

#include <algorithm>

namespace robcogen::import {

namespace desired = language::desired;

namespace {

const std::string kFramePrefix = "fr_";

// The names that frame `foot` of instance LF may have: LF_foot, fr_LF_foot.
std::vector<std::string> names_in_instance(const std::string& instance, const std::string& frame) {
  if (frame.starts_with(kFramePrefix)) return {kFramePrefix + instance + "_" + frame.substr(kFramePrefix.size())};
  return {instance + "_" + frame, kFramePrefix + instance + "_" + frame};
}

}  // namespace

bool InstanceResolver::resolve(desired::Name& name) {
  if (!exists(name.instance, name.instance_span)) return false;
  for (const std::string& candidate : names_in_instance(name.instance, name.text)) {
    if (!known_.index.find(candidate)) continue;
    name.text = candidate;
    return true;
  }
  if (!reported_.insert({name.instance, name.text}).second) return false;
  Diagnostic& error = diagnostics_.error(
      "unknown-frame-of-instance", place(name.span),
      fmt::format("instance '{}' has no frame '{}'", name.instance, name.text));
  if (name.instance_span.begin < name.span.begin)
    error.notes.push_back({place(name.instance_span), fmt::format("'{}' is listed here", name.instance)});
  error.hint = did_you_mean(name.text, frames_of(name.instance));
  return false;
}

std::vector<std::string> InstanceResolver::frames_of(const std::string& instance) const {
  std::vector<std::string> names;
  for (int i = 0; i < known_.index.size(); ++i) {
    const std::string& name = known_.index.name_of(i);
    for (const std::string& prefix : {instance + "_", kFramePrefix + instance + "_"})
      if (name.starts_with(prefix)) names.push_back(name.substr(prefix.size()));
  }
  return names;
}

bool InstanceResolver::exists(const std::string& instance, const Span& span) {
  if (existing_.contains(instance)) return true;
  const std::vector<std::string>& known = known_.instances;
  if (std::find(known.begin(), known.end(), instance) != known.end() || !frames_of(instance).empty())
    return existing_.insert(instance).second;
  if (reported_.insert({instance, ""}).second)
    diagnostics_
        .error(
            "unknown-instance", place(span),
            fmt::format(
                "{} '{}' has neither an instance '{}' of a part nor frames whose names begin with '{}_'", known_.kind,
                known_.owner, instance, instance))
        .hint = did_you_mean(instance, known);
  return false;
}

}  // namespace robcogen::import
