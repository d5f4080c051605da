#include <fmt/format.h>

#include <iterator>
#include <map>
#include <string>

#include "model/plausibility.h"

namespace robcogen::model {

namespace {

// Returns the numbers missing between the first and the last key, as in `4, 7 to 9, ...`
std::string gaps_between(const std::map<int, Place>& ids) {
  constexpr int kShown = 5;
  std::string text;
  int shown = 0;
  for (auto it = ids.begin(); it != ids.end(); ++it) {
    const auto next = std::next(it);
    // This does not overflow at the ends of the range, because the keys ascend.
    if (next == ids.end() || it->first + 1 == next->first) continue;
    if (!text.empty()) text += ", ";
    if (shown++ == kShown) return text + "...";
    const int first = it->first + 1, last = next->first - 1;
    text += first == last ? fmt::format("{}", first) : fmt::format("{} to {}", first, last);
  }
  return text;
}

// The first RobCoGen traverses the links by id and assumes that parents come first.
void check_parents_first(const Description& description, Diagnostics& diagnostics) {
  std::map<std::string, const DescribedLink*> links;
  for (const DescribedLink& link : description.links) links.insert({link.name, &link});
  for (const DescribedLink& parent : description.links) {
    for (const DescribedChild& child : parent.children) {
      const auto found = links.find(child.link);
      if (!parent.id || found == links.end() || !found->second->id || *found->second->id >= *parent.id) continue;
      Diagnostic& warning = diagnostics.warning(
          "child-before-parent", found->second->id_place,
          fmt::format(
              "id {} of link '{}' is smaller than id {} of its parent '{}': the first RobCoGen computes wrong "
              "dynamics from such ids, without a message",
              *found->second->id, child.link, *parent.id, parent.name));
      warning.notes.push_back({parent.id_place, fmt::format("the id of '{}' is here", parent.name)});
      warning.hint = "number parents before their children; in this generator ids have no effect";
    }
  }
}

}  // namespace

void check_link_ids(const Description& description, Diagnostics& diagnostics) {
  // Links are numbered from 0 or 1, or from 2 if the base counts as 1.
  constexpr int kMaxFirstId = 2;
  std::map<int, Place> ids;
  for (const DescribedLink& link : description.links) {
    if (!link.id) continue;
    const auto [earlier, is_new] = ids.insert({*link.id, link.id_place});
    if (is_new) continue;
    diagnostics
        .warning(
            "duplicate-id", link.id_place,
            fmt::format("id {} of link '{}' is the id of another link", *link.id, link.name))
        .notes.push_back({earlier->second, "first used here"});
  }
  if (!diagnostics.has_errors())
    check_parents_first(description, diagnostics);  // otherwise such an order may not exist
  if (ids.empty()) return;
  const auto& [first, first_place] = *ids.begin();
  const std::string gaps = gaps_between(ids);
  if (!gaps.empty()) {
    diagnostics.warning("gapped-ids", first_place, fmt::format("ids of links are not consecutive: {} missing", gaps));
  } else if (first < 0 || first > kMaxFirstId) {
    diagnostics.warning("gapped-ids", first_place, fmt::format("ids of links start with {}, not with 1", first));
  }
}

}  // namespace robcogen::model
