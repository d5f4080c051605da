// What keeps two models of one name out of a program. Their functions have the same names, so a linker would silently
// take those of one model for both. Every source that includes the header of a library refers to a name with this hash.
// The object file that defines it also defines a name without the hash, which a program can hold once only.
#pragma once

#include <string>

#include "backend/library.h"

namespace robcogen::backend {

// A hash of all that decides what the functions of a library compute, and, for robots with parameters, the layout of
// these.
std::string identity(const Library& library);

// The group in whose source file the names are defined.
std::string group_of_identity(const Library& library);

// The macro with which headers contain the reference. The CMake functions define it for all who link a library.
inline constexpr const char* kRefersToModel = "ROBCOGEN_REFERS_TO_MODEL";

// The name that exists once, after that of the library.
inline constexpr const char* kOnlyOne = "two_models_have_the_same_NAME_and_NAMESPACE";

}  // namespace robcogen::backend
