// The words and the layout of JavaScript.
#pragma once

#include <string>
#include <vector>

#include "backend/common/lower.h"
#include "backend/library.h"
#include "support/concat.h"

namespace robcogen::backend::javascript {

inline constexpr std::size_t kColumns = 100;

const Dialect& dialect();

// The members of the object of parameters, by the names of all parameters.
std::vector<std::string> members(const std::vector<std::string>& parameters);

// The shortest text of a number, which may be NaN or infinite.
std::string number(double value);

// A string literal of one line.
std::string quoted(const std::string& text);

// `head item, item tail`, continued on lines that are indented by four more where it is too long.
std::string wrapped(const std::string& head, const std::vector<std::string>& items, const std::string& tail);

// Lines of a comment, wrapped if they are too long. They cannot end the comment.
std::string comment_lines(const std::vector<std::string>& lines, const std::string& margin);

// `export const model`, the constants of the robot.
std::string print_model(const Library& library);

}  // namespace robcogen::backend::javascript
