#include "symbolic/fused_products.h"

#include <algorithm>

#include "support/index.h"

namespace robcogen::symbolic {

int fused_products(std::vector<std::span<const int>> products, std::size_t size) {
  std::stable_sort(products.begin(), products.end(), [](const auto& a, const auto& b) { return a.size() < b.size(); });
  std::vector<char> taken(size, false);
  int fused = 0;
  for (const std::span<const int> sums : products) {
    if (std::adjacent_find(sums.begin(), sums.end()) != sums.end()) continue;  // m + m
    if (std::any_of(sums.begin(), sums.end(), [&](int sum) { return taken[at(sum)]; })) continue;
    for (const int sum : sums) taken[at(sum)] = true;
    ++fused;
  }
  return fused;
}

}  // namespace robcogen::symbolic
