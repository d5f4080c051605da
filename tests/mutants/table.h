// The list of mutants: small wrong changes of the generator, each of which some test must find.
//
// The table is text, in entries of
//     file pass/eliminate.cpp              the source that the next entries change, relative to tool/
//     killed by robcogen_pass_test Cse.*   who should notice: a test program, and which of its tests
//     - a - b                              an expression of that source, which stands there exactly once
//     + b - a                              the replacement in the mutant
// Where the expression alone stands there more often, the line quotes its surroundings and marks it: `- x = @a - b@;`.
// `-s` and `+s` change statements in the place of expressions. `killed by` holds until the next such lines.
#pragma once

#include <string>
#include <vector>

namespace robcogen::mutants {

struct Killer {
  std::string program, filter;
};

struct Mutant {
  int number = 0;  // from 1, in the order of the table
  std::string file;
  std::vector<Killer> killers;
  std::string context;  // stands in the file exactly once
  std::string original, mutated;
  std::size_t offset = 0;  // of the original in the context
  bool is_statement = false;
};

// Throws std::runtime_error with the line of a table that it cannot read.
std::vector<Mutant> read_table(const std::string& path);

std::string read_file(const std::string& path);

}  // namespace robcogen::mutants
