// Calls of functions with random arguments, and their results, which Octave must reproduce.
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace robcogen::octave {

struct Argument {
  std::string name;
  int rows = 0;
  int columns = 1;
  // `array`; `scalars`: Octave gets the elements one by one; `struct:a,b`: a field each.
  std::string kind = "array";
  std::vector<int> quaternions = {};  // the elements that begin unit quaternions
  std::vector<double> around = {};    // values are drawn within a fifth of these; else of all signs
  double limit = 4.0;                 // of those: more than half a turn
};

struct Result {
  std::string name;
  int rows = 0;
  int columns = 1;
};

// Arrays are stored column by column.
using Evaluate = std::function<void(const double* const* arguments, double* const* results)>;

struct Call {
  std::string function;  // `hyl.transforms.homogeneous.fr_base_X_fr_foot`
  std::vector<Argument> arguments;
  std::vector<Result> results;
  Evaluate evaluate;
  bool omits_gravity = false;  // the last argument: Octave is called without it, and it is (0, 0, -9.81) m/s^2
};

// Writes folder/calls.txt, a line each call (`function name rows columns kind… > name rows columns…`), and
// folder/values.bin: for each call and state the arguments and then the results, as doubles. Deterministic. Throws
// std::runtime_error when a value is not finite or a file cannot be written.
void write_values(const std::vector<Call>& calls, int states, const std::filesystem::path& folder);

// The command line of the programs: arguments[first] is the number of states, the next one the folder. Returns the exit
// status.
int write_values(const std::vector<Call>& calls, const std::vector<std::string>& arguments, std::size_t first);

}  // namespace robcogen::octave
