#include "import/linear_relations.h"

#include <algorithm>
#include <iterator>
#include <utility>

namespace robcogen::import {
namespace {

// Eliminates the joint from the relation by adding a multiple of the other relation, in which the joint has factor 1.
void eliminate(int joint, const LinearRelation& other, LinearRelation& relation) {
  const auto own = relation.find(joint);
  if (own == relation.end()) return;
  const Number share = -own->second;
  for (const auto& [added, factor] : other) {
    Number& sum = relation[added];
    sum = sum + share * factor;
  }
  std::erase_if(relation, [](const auto& entry) { return entry.second.is_zero(); });
}

}  // namespace

SolvedRelations solve(const std::vector<LinearRelation>& relations, const std::function<bool(int)>& may_follow) {
  SolvedRelations result;
  for (std::size_t i = 0; i < relations.size(); ++i) {
    LinearRelation relation = relations[i];
    for (const auto& [joint, follower] : result.followers) eliminate(joint, follower.sum, relation);
    const auto last =
        std::find_if(relation.rbegin(), relation.rend(), [&](const auto& entry) { return may_follow(entry.first); });
    if (last == relation.rend()) {
      result.unsolved.push_back({i, relation.empty()});
      continue;
    }
    const auto [joint, pivot] = *last;
    for (auto& [other, factor] : relation) factor = factor / pivot;
    for (auto& [followed, follower] : result.followers) eliminate(joint, relation, follower.sum);
    result.followers.emplace(joint, SolvedRelations::Follower{i, std::move(relation)});
  }
  return result;
}

}  // namespace robcogen::import
