// Names for the statements of a finished program that become lines of their own: what the algorithm called them, or
// what follows from the names of what they are made of, or what they are a part of. What is left is numbered within its
// section, without gaps.
#pragma once

#include <string>
#include <vector>

#include "symbolic/quantity_names.h"

namespace robcogen::symbolic {

// By statement, each once. Names of statements that are no lines are numbers behind those of lines.
//
//     hip_wx_wy, hip_wx2       products and squares
//     s2_KFE, sc_KFE           sin^2 and sin cos of an angle; s_2KFE, c_2KFE: sine and cosine of twice the angle
//     hip_Uxy                  elements of U = [wd]x + [w]x [w]x: of acceleration per vector
//     hip_Sxx_plus_Syy         sums of two values of one link
//     hip_fx_by_HAA            a component after turning by the angle of a joint
//     hip_nx_moved             with a multiple of another quantity of the link: the same about another point
//     hip_nz_to_az, hip_nz_of_az
//                              of what hip_nz is made of: the sum up to a term of hip_az, or that term
std::vector<std::string> line_names(const QuantityNames& known, const std::vector<bool>& is_line);

}  // namespace robcogen::symbolic
