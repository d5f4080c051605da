#include "import/xml/findings.h"

#include <fmt/format.h>

#include <utility>

namespace robcogen::import::xml {

void Findings::add(const std::string& key, Finding finding) {
  const auto [at, is_new] = indices_.insert({key, findings_.size()});
  if (is_new) findings_.push_back({std::move(finding), 0});
  ++findings_[at->second].count;
}

void Findings::report(Diagnostics& diagnostics) const {
  for (const auto& [finding, count] : findings_) {
    const std::string times = count == 1 ? "" : fmt::format(" ({} times)", count);
    diagnostics.warning(finding.code, finding.place, finding.message + times).hint = finding.hint;
  }
}

}  // namespace robcogen::import::xml
