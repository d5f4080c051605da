#include "symbolic/fused_products.h"

#include "support/index.h"

namespace robcogen::symbolic {

void FusedProducts::add_use(int product, int user) {
  const Use use = {user, last_use_[at(product)]};
  last_use_[at(product)] = static_cast<int>(uses_.size());
  uses_.push_back(use);
}

// Whether f holds for all users of a product.
template <class F>
bool FusedProducts::all_users(int product, F f) const {
  for (int use = last_use_[at(product)]; use != kNone; use = uses_[at(use)].before)
    if (!f(uses_[at(use)].user)) return false;
  return true;
}

void FusedProducts::add(int product) {
  std::size_t count = 0;
  int last = kOther;
  const bool can_disappear = all_users(product, [&](int user) {
    const bool is_new_sum = user != kOther && user != last;  // not the second m of m + m
    last = user;
    ++count;
    return is_new_sum;
  });
  if (!can_disappear || count == 0) return;
  if (first_.size() <= count) first_.resize(count + 1, kNone);
  next_[at(product)] = first_[count];
  first_[count] = product;
}

int FusedProducts::count() const {
  std::vector<char> taken(next_.size(), false);
  int fused = 0;
  for (const int first : first_)
    for (int product = first; product != kNone; product = next_[at(product)]) {
      if (!all_users(product, [&](int sum) { return !taken[at(sum)]; })) continue;
      all_users(product, [&](int sum) { return taken[at(sum)] = true; });
      ++fused;
    }
  return fused;
}

}  // namespace robcogen::symbolic
