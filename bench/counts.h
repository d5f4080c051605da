// The operation counts of all robots: a file under version control, and the differences of the generator's current
// counts from it.
#pragma once

#include <map>
#include <string>
#include <utility>
#include <vector>

namespace robcogen::bench {

// The kinds of operations, in the order of the numbers of a function.
extern const std::vector<std::string> kCounted;

// A function and its numbers.
using Counted = std::pair<std::string, std::vector<long>>;

// The functions of each robot, in the order in which the generator lists them.
using Counts = std::map<std::string, std::vector<Counted>>;

// Reads the output of `robcogen ops --json`. Throws nlohmann::json::exception if the text is something else.
std::vector<Counted> read_operations(const std::string& json);

// Write and read the text of a file of counts, which has a line for each function. Reading throws
// nlohmann::json::exception, or std::runtime_error for numbers of other things than kCounted.
std::string counts_text(const Counts& counts);
Counts read_counts(const std::string& text);

// One line for each change: `Leg, inverse_dynamics: mul 30 -> 33`.
struct Changes {
  std::vector<std::string> worse;  // numbers that rose, functions that are gone
  std::vector<std::string> other;  // numbers that fell, functions that are new
};

Changes changes(const std::string& robot, const std::vector<Counted>& before, const std::vector<Counted>& now);

}  // namespace robcogen::bench
