// MATLAB as a dialect: names and lines.
#pragma once

#include <string>
#include <vector>

#include "backend/common/lower.h"
#include "support/concat.h"

namespace robcogen::backend::matlab {

inline constexpr std::size_t kColumns = 100;

// Keywords of MATLAB and Octave, and their functions: packages and files of such names would shadow one.
bool is_reserved_file(const std::string& name);

// The same for variables, but for a few names of results.
bool is_reserved(const std::string& name);

const Dialect& dialect();

// The fields of the struct of parameters, by the names of all parameters. No function has the name of a field.
std::vector<std::string> fields(const std::vector<std::string>& parameters);

std::string upper_case(std::string text);

// The shortest text of a number: every one is a double.
std::string number(double value);

// A string literal.
std::string quoted(const std::string& text);

// Comment lines, wrapped at blanks; lines after the first are indented by `hanging` more. Quotation marks of the
// documentation go.
std::string comment(const std::string& text, std::size_t indent = 0, std::size_t hanging = 2);

// `head item, item tail` with this separator, continued where it is too long.
std::string wrapped(
    const std::string& head,
    const std::vector<std::string>& items,
    const std::string& tail,
    const std::string& separator = ",");

// `  target = [rows];`: one row in a line, unless it is a row or a column, and continued where it is too long.
std::string matrix(const std::string& target, const std::vector<std::vector<std::string>>& rows);

}  // namespace robcogen::backend::matlab
