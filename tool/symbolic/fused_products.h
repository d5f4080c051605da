// The number of products that disappear in the sums that use them: a processor computes a * b + c as one operation.
#pragma once

#include <cstddef>
#include <vector>

namespace robcogen::symbolic {

// Products, sums and other users are indices of statements or nodes, from 0 to size - 1.
class FusedProducts {
 public:
  explicit FusedProducts(std::size_t size) : last_use_(size, kNone), next_(size, kNone) {}

  // A user that is not a sum, or cannot be fused with the product.
  static constexpr int kOther = -1;

  void add_use(int product, int user);
  // After all uses of the product, and after all products with a larger index.
  void add(int product);

  // A product disappears if all its uses are different sums, none of which has absorbed another product yet. Products
  // with the fewest uses are taken first, because they block the fewest others.
  int count() const;

 private:
  static constexpr int kNone = -1;

  struct Use {
    int user = kOther;
    int before = kNone;  // the use of the same product that was added before it
  };

  std::vector<Use> uses_;
  std::vector<int> last_use_;  // by product
  std::vector<int> first_;     // by the number of uses: the first product
  std::vector<int> next_;      // by product: the next one with as many uses

  template <class F>
  bool all_users(int product, F f) const;
};

}  // namespace robcogen::symbolic
