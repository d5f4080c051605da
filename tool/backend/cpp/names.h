// Identifiers of generated C++: free of its reserved words and of names that system headers keep to themselves.
#pragma once

#include <string>
#include <vector>

#include "backend/common/c_names.h"
#include "backend/common/names.h"

namespace robcogen::backend::cpp {

using c_family::is_reserved;

// Reserved names, and what stands beside a namespace at the outermost level: functions and structures of system headers
// (`sincos`, `index`, `stat`, …), which globals.inc lists, and namespaces that generated code names.
bool is_reserved_namespace(const std::string& name);

inline std::string identifier(const std::string& wanted) {
  return backend::identifier(wanted, is_reserved);
}

inline std::string shortened(const std::string& name, std::size_t limit) {
  return backend::shortened(name, limit, is_reserved);
}

class NameScope : public backend::NameScope {
 public:
  explicit NameScope(const std::vector<std::string>& taken = {}) : backend::NameScope(cpp::is_reserved, taken) {}
};

}  // namespace robcogen::backend::cpp
