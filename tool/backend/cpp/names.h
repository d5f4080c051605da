// Identifiers of generated C++, which avoid its reserved words and the names that system headers use as macros.
#pragma once

#include <string>
#include <vector>

#include "backend/common/c_names.h"
#include "backend/common/names.h"

namespace robcogen::backend::cpp {

using c_family::is_reserved;

// Whether a namespace at the outermost level must not have this name: reserved names, functions and structures of
// system headers (`sincos`, `index`, `stat`, …), which globals.inc lists, and namespaces that generated code names.
bool is_reserved_namespace(const std::string& name);

// `inverse_dynamics_derivatives` -> `InverseDynamicsDerivatives`: the structure of the results of a function.
std::string name_of_structure(const std::string& function);

// Whether a function of this name, or the structure of its results, would have a name that the namespace of a robot has
// for something else.
bool is_taken(const std::string& function);

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
