#include "pass/lanes/lane_signs.h"

#include <algorithm>
#include <iterator>
#include <utility>

namespace robcogen::pass {

Sign Signs::variable(bool costs) {
  variables_.push_back({costs, {}});
  return {0, {static_cast<int>(variables_.size()) - 1}};
}

Sign Signs::product(const Sign& a, const Sign& b) const {
  Sign result = fixed(a.lanes ^ b.lanes);
  std::set_symmetric_difference(
      a.variables.begin(), a.variables.end(), b.variables.begin(), b.variables.end(),
      std::back_inserter(result.variables));
  return result;
}

Sign Signs::resolved(const Sign& sign) {
  Sign result = fixed(sign.lanes);
  for (const int v : sign.variables) {
    std::optional<Sign>& value = variables_[static_cast<std::size_t>(v)].value;
    if (value) value = resolved(*value);
    result = product(result, value ? *value : Sign{0, {v}});
  }
  return result;
}

void Signs::make_plain(const Sign& sign) {
  Sign rest = resolved(sign);
  // The latest variable that costs nothing, otherwise the latest of all.
  auto choice = std::find_if(rest.variables.rbegin(), rest.variables.rend(), [&](int v) {
    return !variables_[static_cast<std::size_t>(v)].costs;
  });
  if (choice == rest.variables.rend()) choice = rest.variables.rbegin();
  if (choice == rest.variables.rend()) return;
  const int variable = *choice;
  rest.variables.erase(std::next(choice).base());
  variables_[static_cast<std::size_t>(variable)].value = std::move(rest);
}

unsigned Signs::value(const Sign& sign) {
  return resolved(sign).lanes;
}

}  // namespace robcogen::pass
