// Names that generated code in C and C++ must not use as identifiers.
#pragma once

#include <string>

namespace robcogen::backend::c_family {

// Whether the name is a keyword of C++, or a macro of a compiler or of a standard or system header, which would replace
// the name (`I`, `major`, `linux`, `SIZE_MAX`, …). macros.inc lists the macros and the families of names of macros.
bool is_reserved(const std::string& name);

// Whether the name is a function, structure or enumerator of system headers outside of namespaces (`sincos`, `index`,
// `stat`, …), which globals.inc lists. Inside other scopes, these names are free.
bool is_global(const std::string& name);

}  // namespace robcogen::backend::c_family
