#include "backend/common/product.h"

namespace robcogen::backend {

Product product_of_primitives(const ProductData& data, const std::string& name, const Dialect& dialect) {
  Product product{lower(data.amounts, name, dialect), {}};
  for (std::size_t i = 0; i < data.primitives.size(); ++i) {
    const PrimitiveData& primitive = data.primitives[i];
    const std::string name_of_primitive = {primitive.rotation ? 'R' : 'T', "xyz"[primitive.axis]};
    product.factors.push_back(name_of_primitive + "(" + product.kernel.results.front()[i] + ")");
  }
  if (product.factors.empty()) product.factors = {"Tx(0)"};
  return product;
}

std::string convention_of_primitives(const Library& library) {
  const std::string frame = library.primitives == PrimitiveConvention::left
                                ? "from the original frame to the frame rotated by +a (moved frame on the left)"
                                : "from the frame rotated by +a to the original frame (moved frame on the right)";
  return "Product of your own Rx, Ry, Rz, Tx, Ty, Tz, which may return any kind of matrix: Rx(a) must map "
         "coordinates " +
         frame + ".";
}

}  // namespace robcogen::backend
