// The number of products that disappear in the sums that use them: a processor computes a * b + c as one operation.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace robcogen::symbolic {

// `products` has the uses of each product that only sums use, as indices of statements or nodes from 0 to size - 1. A
// product disappears if its uses are different sums, none of which has absorbed another product yet. Products with the
// fewest uses are taken first, because they block the fewest others.
int fused_products(const std::vector<std::span<const int>>& products, std::size_t size);

}  // namespace robcogen::symbolic
