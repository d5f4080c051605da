// Names for the statements of a finished program that become lines of their own: the name that the algorithm gave, or
// one that follows from the names of the operands, or from the quantity that the statement is a part of. The other
// statements are numbered within their section, without gaps.
#pragma once

#include <string>
#include <vector>

#include "symbolic/quantity_names.h"

namespace robcogen::symbolic {

// One name per statement, all distinct. Statements that do not get a line of their own are numbered after those that
// do.
//
//     hip_wx_wy, hip_wx2       products and squares
//     s2_KFE, sc_KFE           sin^2 and sin cos of an angle; s_2KFE, c_2KFE: sine and cosine of twice the angle
//     hip_Uxy                  elements of U = [wd]x + [w]x [w]x, the acceleration per position vector
//     hip_Sxx_plus_Syy         sums of two values of one link
//     hip_fx_by_HAA            a component after a rotation by the angle of a joint
//     hip_nx_moved             plus a multiple of another quantity of the link: the same about another point
//     hip_nz_to_az, hip_nz_of_az
//                              parts of hip_nz: the sum up to a term with hip_az, and that term
std::vector<std::string> line_names(const QuantityNames& known, const std::vector<bool>& is_line);

}  // namespace robcogen::symbolic
