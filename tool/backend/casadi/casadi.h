// Functions that CasADi loads as external ones from a shared library (its naming protocol: F, F_n_in, F_n_out,
// F_name_in, F_name_out, F_sparsity_in, F_sparsity_out, F_work). They wrap the functions in C.
#pragma once

#include <string>

#include "backend/library.h"

namespace robcogen::backend::casadi {

// The path of the file, next to the files of the library in C with this prefix.
std::string output(const std::string& prefix);

// Prints <prefix>_c/casadi.c: one CasADi function, <prefix>_casadi_<kernel>, for each function of the library in C.
OutputFile print(const Library& library);

}  // namespace robcogen::backend::casadi
