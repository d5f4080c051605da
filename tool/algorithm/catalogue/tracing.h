// How the functions of the catalogue are traced.
#pragma once

#include "algorithm/catalogue/catalogue.h"

namespace robcogen::algorithm::catalogue {

// The function with these choices: as they are made for it, or with a given choice, where its program depends on one.
Tracing tracing_of(const Declared& function, FormulationChoices& choices);
Tracing tracing_of(const Declared& function, FormulationChoices& choices, const Formulation& given);
// The same for a program that joins those of other functions with these loads (Declaration::joins_frames).
Tracing joined_tracing(const Declared& function, FormulationChoices& choices, const Formulation& given, Loads loads);

// Each output `d_x_y` is the derivative of the output `d_x` by the input y.
std::vector<symbolic::DerivativeBlock> second_derivatives(const symbolic::Program& program);

// `jacobians` -> ``, `world` -> `in_world_`: several scopes may have functions of the same name.
std::string prefix_of(const std::string& scope);
// The end of the names of programs of overloads.
const char* suffix_of(const Subject& subject);
const char* remark_on(Loads loads);

}  // namespace robcogen::algorithm::catalogue
