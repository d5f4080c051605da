// Libraries and random arguments of their functions, for the tests of the output languages.
#pragma once

#include <filesystem>
#include <random>
#include <string>
#include <vector>

#include "backend/library.h"
#include "driver/driver.h"
#include "symbolic/interpret.h"

namespace robcogen::test {

// Returns the library of a robot document, with its desired-transforms list if there is one next to it, or of a
// document of motions or transforms; with these derivatives.
backend::Library library_of(
    const std::filesystem::path& document,
    const std::string& name,
    driver::Primitives primitives = std::nullopt,
    const std::vector<driver::Derivative>& derivatives = {},
    const std::vector<std::string>& groups = algorithm::groups(),
    const backend::Features& features = {});

// Derivatives of a robot's dynamics: solved for in a loop over columns, and written out for the interpreter.
struct ColumnLoopLibraries {
  backend::Library in_loops, written_out;
};
ColumnLoopLibraries column_loop_libraries(const std::string& robot);

// Values lie between -2 and 2; parameters and compliances are above 0.5, and three in four contacts are closed.
// Positions of robots with loops lie within 0.1, because loops close only near the position in which they are
// assembled.
symbolic::Arrays<double> random_inputs(
    const backend::Library& library,
    const symbolic::Program& program,
    std::mt19937_64& engine);

// All results one after another, matrices row by row.
std::vector<double> flattened(const symbolic::Program& program, const symbolic::Arrays<double>& results);

}  // namespace robcogen::test
