// Names for the values of a finished program: the text of the quantity that the algorithm gave or that follows from the
// operands, or what part of another quantity a value is. Values about which nothing is known are numbered within their
// section.
#pragma once

#include <string>
#include <vector>

#include "symbolic/program.h"

namespace robcogen::backend {

// One name per statement, all distinct. Of equal names, the first goes to a statement that has a line of its own
// whatever the widths of lines are, as `is_line` says; numbers start with these statements. Names do not depend on
// widths.
//
//     hip_nz_to_az, hip_nz_of_az    parts of hip_nz: the sum up to a term with hip_az, and that term
std::vector<std::string> value_names(const symbolic::Program& program, const std::vector<bool>& is_line);

}  // namespace robcogen::backend
