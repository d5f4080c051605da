#include "algorithm/kinematics/inverse/arrangements.h"

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <utility>

#include "algorithm/kinematics/inverse/features.h"

namespace robcogen::algorithm::inversion {
namespace {

// How many arrangements are looked at, and how many are returned.
constexpr std::size_t kLookedAt = 256, kReturned = 3;

// Moves a slide at `from` behind, or before, as many turning joints about its direction as follow, one after another.
// Other slides do not matter, and are passed.
std::vector<SerialChain> places_of_slide(const SerialChain& chain, int from) {
  std::vector<SerialChain> places = {chain};
  for (const int step : {-1, 1}) {
    SerialChain moved = chain;
    for (int k = from; k + step >= 0 && k + step < chain.joints; k += step) {
      const ChainAxis& other = moved.axis(k + step);
      if (other.turns && !are_parallel(other.direction, chain.axis(from).direction)) break;
      std::swap(moved.axes[at(k)], moved.axes[at(k + step)]);
      if (moved.given == k + step) moved.given = k;
      if (moved.axis(k).turns) places.push_back(moved);
    }
  }
  return places;
}

// By how many joints the features have in common.
int promise(const SerialChain& chain) {
  int sum = 0;
  for (const Feature& f : features_of(chain).maximal) {
    int turning = 0;
    for (int k = f.begin; k < f.end; ++k) turning += chain.axis(k).turns ? 1 : 0;
    sum += std::max(turning - 1, 0);
  }
  return sum;
}

}  // namespace

std::vector<SerialChain> arrangements(const SerialChain& chain) {
  std::vector<SerialChain> all = {chain};
  const std::vector<ChainAxis> axes = chain.axes;
  for (const ChainAxis& slide : axes) {
    if (slide.amount < 0 || slide.turns) continue;
    std::vector<SerialChain> next;
    for (const SerialChain& arranged : all) {
      const auto here = std::find_if(
          arranged.axes.begin(), arranged.axes.end(), [&](const ChainAxis& a) { return a.amount == slide.amount; });
      std::vector<SerialChain> places = places_of_slide(arranged, static_cast<int>(here - arranged.axes.begin()));
      if (next.size() + places.size() > kLookedAt) places.resize(1);
      std::move(places.begin(), places.end(), std::back_inserter(next));
    }
    all = std::move(next);
  }
  if (all.size() == 1) return all;
  std::vector<std::pair<int, std::size_t>> order;
  for (std::size_t i = 0; i < all.size(); ++i) order.emplace_back(-promise(all[i]), i);
  std::stable_sort(order.begin(), order.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
  std::vector<SerialChain> best;
  for (std::size_t i = 0; i < std::min(kReturned, order.size()); ++i) best.push_back(all[order[i].second]);
  return best;
}

}  // namespace robcogen::algorithm::inversion
