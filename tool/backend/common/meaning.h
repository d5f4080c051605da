// What the arrays of functions are, for their documentation.
#pragma once

#include <string>
#include <vector>

#include "backend/library.h"
#include "symbolic/program.h"

namespace robcogen::backend {

// The quantity, its unit and its frame; empty where the summary of the function says it, and for parameters and the
// wrenches on links, whose shape differs between languages.
std::string meaning(symbolic::Role role);

// What the elements of q are where some of them are quaternions, or follow others; else empty.
std::string remark_on_positions(const symbolic::Program& program);

// Whether the elements are those of the joints, in the order of the model.
// Of robots whose elements of q are others than those of qd: `of spherical joints …; last those of …`.
std::string meaning_of_positions(const Library& library);

bool is_of_joints(symbolic::Role role);

// Whether it has rows and columns, though one of them may be the only one.
bool is_matrix(const symbolic::OutputArray& output);

// Rows of a square matrix that stands in the array.
int side(const symbolic::InputArray& square);

// The elements of an output, which stand column by column, in rows.
std::vector<std::vector<std::string>> rows_of(
    const symbolic::OutputArray& output,
    const std::vector<std::string>& elements);

// The names of the joints to which the columns of a Jacobian belong.
std::vector<std::string> column_joints(const Library& library, const Function& function);

}  // namespace robcogen::backend
