// What keeps two models of one name out of a program. Their functions have the same names, so a linker would silently
// take those of one model for both. Every source that includes the header of a library refers to a name with this hash.
// The object file that defines it also defines a name without the hash, which a program can hold once only.
#pragma once

#include <string>
#include <vector>

#include "backend/library.h"

namespace robcogen::backend {

// A hash of all that decides what the functions of a library compute, and, for robots with parameters, the layout of
// these.
std::string identity(const Library& library);

// The names that the source file of a group defines: one with this hash, and one that a program can hold once only.
// None for all groups but one.
std::vector<std::string> identity_names(const Library& library, const std::string& group);
// The name with the hash.
std::string name_of_model(const Library& library);

// The macro with which headers contain the reference. The CMake functions define it for all who link a library.
inline constexpr const char* kRefersToModel = "ROBCOGEN_REFERS_TO_MODEL";

// The comment on the reference.
inline constexpr const char* kTwoModels =
    "A program with two models of this name does not link: give one of them another NAME or NAMESPACE.";

}  // namespace robcogen::backend
