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

// Of robots whose elements of q are others than those of qd: `of spherical joints …; last those of …`.
std::string meaning_of_positions(const Library& library);

// Whether the elements are those of the joints, in the order of the model.
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

// The words of a language for columns, and the number of the first one.
struct ColumnWords {
  std::string all = "columns: ", one = "column ", end = "";
  std::size_t first = 1;
};

// What each column is of, where that is known: `columns: HAA, HFE`, `column 1: mass of the upper leg`.
std::vector<std::string> describe_columns(const Library& library, const Function& function, const ColumnWords& words);

// The elements of an input where a line holds their names, or what they are: `HAA, HFE`; else empty.
std::string describe_elements(const symbolic::InputArray& input);

// The same of the arrays of a function, inputs then outputs, under these names where all are plain arrays and matrices
// stand column by column: `q[2]: HAA, HFE`, `H[4]: result, 2 x 2, column by column`. `has_cache`: in place of the
// parameters it takes what was computed of them.
std::vector<std::string> describe_arrays(
    const symbolic::Program& program,
    const std::vector<std::string>& names,
    bool has_cache);

// What a function computes and how, its arguments and results as the language describes them, and remarks on these.
std::vector<std::string> describe_function(
    const Library& library,
    const Function& function,
    const std::vector<std::string>& arguments,
    const std::vector<std::string>& results,
    const ColumnWords& words = {});

}  // namespace robcogen::backend
