// The factors of the equations of motion with active contacts, with which their derivatives are solved:
//     H da = t + J^T df,   J da + compliance df = c at active contacts,   df = 0 at open ones,
// for right-hand sides (t, c) over the rows of H and of the contacts.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "algorithm/dynamics/contact_system.h"
#include "algorithm/dynamics/elimination.h"

namespace robcogen::algorithm {

// Which of their numbers may differ from zero, for a robot with these contacts.
struct ConstrainedStructure {
  ConstrainedStructure(const model::KinematicTree& tree, const ContactFrames& contacts);

  std::vector<std::string> rows;                 // names of (a, f)
  EliminationTree elimination;                   // of H
  OrderedInertia order;                          // of its rows; the matrix is not used
  std::vector<std::string> contact_rows;         // names
  std::vector<std::vector<int>> halves;          // by row of the contacts: the ordered rows of Y = L^-T J^T
  std::vector<std::pair<int, int>> of_contacts;  // elements of the factor of W + compliance, by row and column
};

struct ConstrainedFactors {
  LdlFactors of_inertia;                        // of H in the order of its elimination
  std::vector<std::vector<Expression>> halves;  // Y, by row of the contacts
  LdlFactors of_contacts;                       // of W + compliance at active contacts
  std::vector<Expression> active;               // by row of the contacts
};

ConstrainedFactors constrained_factors(const SwitchedContacts& contacts);

// The numbers of the factors in one list, their names, and the factors from such a list.
std::vector<Expression> numbers_of(const ConstrainedStructure& structure, const ConstrainedFactors& factors);
std::vector<std::string> labels_of(const ConstrainedStructure& structure);
ConstrainedFactors factors_from(const ConstrainedStructure& structure, const std::vector<Expression>& numbers);

// The solution (da, df) for b = (t, c). `column`: where the names of its elements end, for
// one of many solutions.
std::vector<Expression> solve(
    const ConstrainedStructure& structure,
    const ConstrainedFactors& factors,
    const std::vector<Expression>& b,
    const std::string& column = "");

}  // namespace robcogen::algorithm
