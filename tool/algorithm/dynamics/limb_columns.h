// Right-hand sides that belong to limbs, solved with one column of each limb at a time.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "algorithm/dynamics/elimination.h"
#include "algorithm/dynamics/ldl.h"
#include "algorithm/spatial/trace.h"
#include "symbolic/solved_columns.h"

namespace robcogen::algorithm {

// The elements of L that the elimination leaves, by row and column of the ordered matrix.
std::vector<std::pair<int, int>> elements_of_factor(const EliminationTree& elimination);

// Names of these elements, then of the reciprocals of D. `names`: of the ordered rows.
std::vector<std::string> labels_of_factor(const EliminationTree& elimination, const std::vector<std::string>& names);
// The factor from numbers in this order, of which it takes the first.
LdlFactors factor_of(const EliminationTree& elimination, const std::vector<Expression>& numbers);
// Its numbers.
std::vector<Expression> numbers_of(const EliminationTree& elimination, const LdlFactors& factors);

// Declares the input `factor` for these numbers.
LdlFactors given_factors(
    ProgramTrace& trace,
    const EliminationTree& elimination,
    const std::vector<std::string>& names);

// Sets `limbs` if a floating base has two, four, eight or sixteen limbs with the same number of coordinates and the
// same structure, and if some blocks of right-hand sides are zero in the rows of other limbs: elimination then starts
// in the limb of the column only. `name`: of the program.
void find_limbs(const model::KinematicTree& tree, const std::string& name, symbolic::SolvedColumns& solved);

}  // namespace robcogen::algorithm
