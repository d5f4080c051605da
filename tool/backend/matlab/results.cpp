// Assembles the results of a function from their values.
#include <algorithm>

#include "backend/common/meaning.h"
#include "backend/matlab/dialect.h"
#include "backend/matlab/printers.h"

namespace robcogen::backend::matlab {
namespace {

using symbolic::OutputArray;
using symbolic::Role;

using Row = std::vector<std::string>;
using Rows = std::vector<Row>;

bool is_zero(const std::string& element) {
  return element == "0";
}

std::string range(std::size_t first, std::size_t last) {
  const std::string begin = std::to_string(first + 1);
  return first == last ? begin : begin + ":" + std::to_string(last + 1);
}

std::string zeros(const std::string& target, std::size_t rows, std::size_t columns) {
  return "  " + target + " = zeros(" + std::to_string(rows) + ", " + std::to_string(columns) + ");\n";
}

Rows part(const Rows& rows, std::size_t row, std::size_t column, std::size_t height, std::size_t width) {
  Rows result;
  for (std::size_t r = row; r < row + height; ++r) {
    const auto begin = rows[r].begin() + static_cast<std::ptrdiff_t>(column);
    result.emplace_back(begin, begin + static_cast<std::ptrdiff_t>(width));
  }
  return result;
}

bool is_zero(const Rows& rows) {
  return std::all_of(rows.begin(), rows.end(), [](const Row& row) {
    return std::all_of(row.begin(), row.end(), [](const std::string& e) { return is_zero(e); });
  });
}

// A transform of spatial vectors, assembled from its 3 x 3 parts; the rotation appears twice.
std::string spatial_transform(const std::string& name, const Rows& rows) {
  std::string text = zeros(name, 6, 6);
  const Rows rotation = part(rows, 0, 0, 3, 3);
  text += matrix(name + "(1:3, 1:3)", rotation);
  for (const auto& [row, column] :
       {std::pair(std::size_t{3}, std::size_t{0}), std::pair(std::size_t{0}, std::size_t{3})}) {
    const Rows other = part(rows, row, column, 3, 3);
    if (!is_zero(other))
      text += matrix(name + "(" + range(row, row + 2) + ", " + range(column, column + 2) + ")", other);
  }
  return part(rows, 3, 3, 3, 3) == rotation ? text + "  " + name + "(4:6, 4:6) = " + name + "(1:3, 1:3);\n"
                                            : text + matrix(name + "(4:6, 4:6)", part(rows, 3, 3, 3, 3));
}

// Each row from its first to its last nonzero element, in pieces if there are gaps.
std::string row_by_row(const std::string& name, const Rows& rows) {
  constexpr std::size_t kGap = 3;  // zeros
  std::string text;
  for (std::size_t r = 0; r < rows.size(); ++r) {
    const Row& row = rows[r];
    std::size_t c = 0;
    while (c < row.size()) {
      if (is_zero(row[c])) {
        ++c;
        continue;
      }
      std::size_t last = c;
      for (std::size_t k = c; k < row.size() && k <= last + kGap; ++k)
        if (!is_zero(row[k])) last = k;
      const Row piece(
          row.begin() + static_cast<std::ptrdiff_t>(c), row.begin() + static_cast<std::ptrdiff_t>(last) + 1);
      text += matrix(name + "(" + std::to_string(r + 1) + ", " + range(c, last) + ")", {piece});
      c = last + 1;
    }
  }
  return text;
}

// Writes out the lower triangle only, and mirrors it.
std::string symmetric(const std::string& name, const Rows& rows) {
  Rows lower = rows;
  for (std::size_t r = 0; r < lower.size(); ++r) lower[r].resize(r + 1);
  return zeros(name, rows.size(), rows.size()) + row_by_row(name, lower) + "  " + name + " = " + name + " + tril(" +
         name + ", -1)';\n";
}

std::string column_by_column(const std::string& name, const Rows& rows, const std::vector<std::string>& columns) {
  std::string text = zeros(name, rows.size(), columns.size());
  for (std::size_t c = 0; c < columns.size(); ++c) {
    text += comment("column of " + columns[c], 2);
    const std::string place = ", " + std::to_string(c + 1) + ")";
    const Rows all = part(rows, 0, c, rows.size(), 1), angular = part(rows, 0, c, 3, 1),
               linear = part(rows, 3, c, 3, 1);
    const std::string line = matrix(name + "(:" + place, all);
    const bool is_one_line = std::count(line.begin(), line.end(), '\n') == 1;
    text += is_one_line ? line : matrix(name + "(1:3" + place, angular) + matrix(name + "(4:6" + place, linear);
  }
  return text;
}

bool rows_fit(const Rows& rows) {
  return std::all_of(rows.begin(), rows.end(), [](const Row& row) { return joined(row).size() + 10 <= kColumns; });
}

}  // namespace

std::string assemble(
    const OutputArray& output,
    const std::string& name,
    const std::vector<std::string>& elements,
    const std::vector<std::string>& columns) {
  const Rows rows = rows_of(output, elements);
  if (elements.empty())
    return zeros(name, static_cast<std::size_t>(output.rows), static_cast<std::size_t>(output.columns));
  if (output.role == Role::spatial_motion || output.role == Role::spatial_force) return spatial_transform(name, rows);
  if (rows_fit(rows)) return matrix(name, rows);
  if (output.role == Role::inertia_matrix) return symmetric(name, rows);
  if (symbolic::is_jacobian(output.role) && columns.size() == rows.front().size())
    return column_by_column(name, rows, columns);
  return zeros(name, rows.size(), rows.front().size()) + row_by_row(name, rows);
}

}  // namespace robcogen::backend::matlab
