// A coordinate transform as a product of the user's own primitives: Rx(a) * Tz(b).
#pragma once

#include <string>
#include <vector>

#include "backend/common/lower.h"
#include "backend/library.h"

namespace robcogen::backend {

// The lines that compute the amounts, and the factors. An empty product is Tx(0).
struct Product {
  Kernel kernel;
  std::vector<std::string> factors;
};

Product product_of_primitives(const ProductData& data, const std::string& name, const Dialect& dialect);

// The convention of the primitives, for the documentation.
std::string convention_of_primitives(const Library& library);

}  // namespace robcogen::backend
