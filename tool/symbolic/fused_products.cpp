#include "symbolic/fused_products.h"

#include <algorithm>
#include <numeric>

#include "support/index.h"

namespace robcogen::symbolic {

int fused_products(const std::vector<std::span<const int>>& products, std::size_t size) {
  // The products in the order of the number of their uses, of which there are few different ones.
  std::vector<std::size_t> first;  // by the number of uses: the place of the first product
  for (const std::span<const int> sums : products) {
    if (first.size() < sums.size() + 2) first.resize(sums.size() + 2);
    ++first[sums.size() + 1];
  }
  std::partial_sum(first.begin(), first.end(), first.begin());
  std::vector<const std::span<const int>*> ordered(products.size());
  for (const std::span<const int>& sums : products) ordered[first[sums.size()]++] = &sums;
  std::vector<char> taken(size, false);
  int fused = 0;
  for (const std::span<const int>* const product : ordered) {
    const std::span<const int> sums = *product;
    if (std::adjacent_find(sums.begin(), sums.end()) != sums.end()) continue;  // m + m
    if (std::any_of(sums.begin(), sums.end(), [&](int sum) { return taken[at(sum)]; })) continue;
    for (const int sum : sums) taken[at(sum)] = true;
    ++fused;
  }
  return fused;
}

}  // namespace robcogen::symbolic
