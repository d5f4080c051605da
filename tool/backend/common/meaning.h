// The meaning of the arrays of functions, for their documentation.
#pragma once

#include <string>
#include <vector>

#include "backend/library.h"
#include "symbolic/program.h"

namespace robcogen::backend {

// The quantity, its unit and its frame. Empty where the summary of the function says it, and for parameters and the
// wrenches on links, whose shape differs between languages.
std::string meaning(symbolic::Role role);

// Explains the elements of q if some of them are quaternions, or follow others; otherwise empty.
std::string remark_on_positions(const symbolic::Program& program);

// For robots whose elements of q differ from those of qd: `of spherical joints …; last those of …`.
std::string meaning_of_positions(const Library& library);

// Whether the elements correspond to the joints, in the order of the model.
bool is_of_joints(symbolic::Role role);

// Whether the output is a matrix. It may have a single row or column.
bool is_matrix(const symbolic::OutputArray& output);

// The number of rows of a square matrix that is stored in the array.
int side(const symbolic::InputArray& square);

// The elements of an output, which is stored column by column, as rows.
std::vector<std::vector<std::string>> rows_of(
    const symbolic::OutputArray& output,
    const std::vector<std::string>& elements);

// The names of the joints to which the columns of a Jacobian belong.
std::vector<std::string> column_joints(const Library& library, const Function& function);

// The words with which a language describes columns, and the number of the first column.
struct ColumnWords {
  std::string all = "columns: ", one = "column ", end = "";
  std::size_t first = 1;
};

// What each column refers to, where that is known: `columns: HAA, HFE`, `column 1: mass of the upper leg`.
std::vector<std::string> describe_columns(const Library& library, const Function& function, const ColumnWords& words);

// The names of an input's elements, `HAA, HFE`, or what the elements are. Empty if there are too many names for a line.
std::string describe_elements(const symbolic::InputArray& input);

// The same for the arrays of a function, inputs then outputs, under these names, in languages where all of them are
// plain arrays and matrices are stored column by column: `q[2]: HAA, HFE`, `H[4]: result, 2 x 2, column by column`.
// `has_cache`: in place of the parameters, the function takes values that were computed from them.
std::vector<std::string> describe_arrays(
    const symbolic::Program& program,
    const std::vector<std::string>& names,
    bool has_cache);

// Describes what a function computes and how, its arguments and results in the words of the language, with remarks on
// these.
std::vector<std::string> describe_function(
    const Library& library,
    const Function& function,
    const std::vector<std::string>& arguments,
    const std::vector<std::string>& results,
    const ColumnWords& words = {});

}  // namespace robcogen::backend
