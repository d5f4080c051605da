// What the command line may say, and what a user is told who wrote something else.
#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

namespace robcogen::command {

// A value of an option that is one of these words.
CLI::Validator one_of(std::vector<std::string> words);

// What is wrong with the command line and what to write instead, in lines.
std::string explain(const CLI::App& application, const CLI::ParseError& fault);

// `message`, and a line of its own for the hint when there is one.
std::string with_hint(const std::string& message, const std::string& hint);

}  // namespace robcogen::command
