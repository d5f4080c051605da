// Functions as CasADi loads external ones from a shared library (its naming protocol: F, F_n_in, F_n_out, F_name_in,
// F_name_out, F_sparsity_in, F_sparsity_out, F_work), over those in C.
#pragma once

#include <string>

#include "backend/library.h"

namespace robcogen::backend::casadi {

// Beside the files of the library in C with this prefix.
std::string output(const std::string& prefix);

// <prefix>_c/casadi.c: for each function of the library in C one of CasADi, <prefix>_casadi_<kernel>.
OutputFile print(const Library& library);

}  // namespace robcogen::backend::casadi
