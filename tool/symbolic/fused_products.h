// How many products disappear in the sums that use them: a processor computes a * b + c as one operation.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace robcogen::symbolic {

// Of products with the sums that use them, by statements or nodes from 0 to size - 1, for those used by nothing but
// sums. A product disappears where every use is a sum of its own that has not absorbed another product yet. Those with
// fewest uses go first: they block fewest others.
int fused_products(std::vector<std::span<const int>> products, std::size_t size);

}  // namespace robcogen::symbolic
