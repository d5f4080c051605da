// MATLAB as a dialect: names and lines.
#pragma once

#include <string>
#include <vector>

#include "backend/common/lower.h"
#include "support/concat.h"

namespace robcogen::backend::matlab {

inline constexpr std::size_t kColumns = 100;

// Whether the name is a keyword or a function of MATLAB or Octave. A package or file of such a name would shadow it.
bool is_reserved_file(const std::string& name);

// The same for variables, except a few names of results.
bool is_reserved(const std::string& name);

const Dialect& dialect();

// The fields of the struct of parameters, from the names of all parameters. No function has the name of a field.
std::vector<std::string> fields(const std::vector<std::string>& parameters);

std::string upper_case(std::string text);

// The shortest text of a number, which is always a double.
std::string number(double value);

// A string literal.
std::string quoted(const std::string& text);

// Comment lines, wrapped at blanks; lines after the first are indented by `hanging` more. Quotation marks of the
// documentation are removed.
std::string comment(const std::string& text, std::size_t indent = 0, std::size_t hanging = 2);

// `head item, item tail` with this separator, continued on further lines where it is too long.
std::string wrapped(
    const std::string& head,
    const std::vector<std::string>& items,
    const std::string& tail,
    const std::string& separator = ",");

// `  target = [rows];` with one line per row, except for a single row or column, continued where it is too long.
std::string matrix(const std::string& target, const std::vector<std::vector<std::string>>& rows);

}  // namespace robcogen::backend::matlab
