// Names that generated code in Python must not use as identifiers.
#pragma once

#include <string>

namespace robcogen::backend {

bool is_python_keyword(const std::string& name);

}  // namespace robcogen::backend
