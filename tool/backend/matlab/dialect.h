// MATLAB as a dialect: names and lines.
#pragma once

#include <string>
#include <vector>

#include "backend/common/lower.h"

namespace robcogen::backend::matlab {

inline constexpr std::size_t kColumns = 100;

// Keywords of MATLAB and Octave, and what generated text, or a reader of it, takes for a function or a constant.
bool is_reserved(const std::string& name);

const Dialect& dialect();

// A string literal.
std::string quoted(const std::string& text);

// Comment lines, wrapped at blanks.
std::string comment(const std::string& text, std::size_t indent = 0);

// `target = [rows];`, continued where it is too long. Elements hold no blanks but around operators.
std::string assignment(
    const std::string& target,
    const std::vector<std::vector<std::string>>& rows,
    std::size_t indent = 0);

}  // namespace robcogen::backend::matlab
