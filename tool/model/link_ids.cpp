#include <fmt/format.h>

#include <map>

#include "model/plausibility.h"

namespace robcogen::model {

namespace {

// `4, 7 to 9, ...`: the numbers missing between the first and the last key.
std::string gaps_between(const std::map<int, Place>& ids) {
  constexpr int kShown = 5;
  std::string text;
  int shown = 0;
  for (auto it = ids.begin(); it != ids.end(); ++it) {
    const auto next = std::next(it);
    // Without overflow at the ends of the range: the keys ascend.
    if (next == ids.end() || it->first + 1 == next->first) continue;
    if (!text.empty()) text += ", ";
    if (shown++ == kShown) return text + "...";
    const int first = it->first + 1, last = next->first - 1;
    text += first == last ? fmt::format("{}", first) : fmt::format("{} to {}", first, last);
  }
  return text;
}

}  // namespace

void check_link_ids(const Description& description, Diagnostics& diagnostics) {
  // Links are numbered from 0 or 1, or from 2 where the base counts as 1.
  constexpr int kLargestFirstId = 2;
  std::map<int, Place> ids;
  for (const DescribedLink& link : description.links) {
    if (!link.id) continue;
    const auto [earlier, is_new] = ids.insert({*link.id, link.id_place});
    if (is_new) continue;
    diagnostics.warning("duplicate-id", link.id_place, fmt::format("id {} of link '{}' is taken", *link.id, link.name))
        .notes.push_back({earlier->second, "first used here"});
  }
  if (ids.empty()) return;
  const auto& [first, first_place] = *ids.begin();
  const std::string gaps = gaps_between(ids);
  if (!gaps.empty()) {
    diagnostics.warning("gapped-ids", first_place, fmt::format("ids of links are not consecutive: no {}", gaps));
  } else if (first < 0 || first > kLargestFirstId) {
    diagnostics.warning("gapped-ids", first_place, fmt::format("ids of links start with {}, not with 1", first));
  }
}

}  // namespace robcogen::model
