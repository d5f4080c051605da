// Names that neither C nor C++ leaves to identifiers of generated code.
#pragma once

#include <string>

namespace robcogen::backend::c_family {

// Keywords of C++, and macros of compilers and of standard and system headers that would eat the name (`I`, `major`,
// `linux`, `SIZE_MAX`, …). macros.inc lists them.
bool is_reserved(const std::string& name);

}  // namespace robcogen::backend::c_family
