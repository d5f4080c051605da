// A coordinate transform as a product of primitives that the user has: Rx(a) * Tz(b).
#pragma once

#include <string>

#include "backend/common/lower.h"
#include "backend/library.h"

namespace robcogen::backend {

// The lines that compute the amounts, and the product with this sign between its factors. An empty product is Tx(0).
struct Product {
  Kernel kernel;
  std::string text;
};

Product product_of_primitives(
    const ProductData& data,
    const std::string& name,
    const std::string& sign,
    const Dialect& dialect);

// The convention of the primitives, for the documentation.
std::string convention_of_primitives(const Library& library);

}  // namespace robcogen::backend
