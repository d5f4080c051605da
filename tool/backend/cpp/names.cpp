#include "backend/cpp/names.h"

#include <iterator>
#include <string_view>
#include <unordered_set>

namespace robcogen::backend::cpp {
namespace {

// Functions, structures and enumerators outside of namespaces. Inside other scopes, these names are free.
constexpr std::string_view kGlobalNames[] = {
#include "backend/common/globals.inc"
};

}  // namespace

bool is_reserved_namespace(const std::string& name) {
  static const std::unordered_set<std::string_view> globals(std::begin(kGlobalNames), std::end(kGlobalNames));
  return name == "std" || name == "Eigen" || name == "robcogen" || is_reserved(name) || globals.count(name) > 0;
}

}  // namespace robcogen::backend::cpp
