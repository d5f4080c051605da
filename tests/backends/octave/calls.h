// Calls of functions with random arguments, and the results that Octave must reproduce.
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
  // `array`; `scalars`: Octave gets the elements one by one; `struct:a,b`: Octave gets a structure with a field for
  // each.
  std::string kind = "array";
  std::vector<int> quaternions = {};  // indices of the first elements of unit quaternions
  std::vector<double> around = {};    // values are drawn within a fifth of these; if empty, up to `limit`
  double limit = 4.0;                 // largest magnitude if `around` is empty: more than half a turn
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
  bool omits_gravity = false;  // Octave is called without the last argument, which is (0, 0, -9.81) m/s^2
};

// Writes folder/calls.txt, one line for each call (`function name rows columns kind… > name rows columns…`), and
// folder/values.bin: for each call and state the arguments and then the results, as doubles. The output is
// deterministic. Throws std::runtime_error if a value is not finite or a file cannot be written.
void write_values(const std::vector<Call>& calls, int states, const std::filesystem::path& folder);

// Writes the values as the command line of a program asks: arguments[first] is the number of states, the next one the
// folder. Returns the exit status.
int write_values(const std::vector<Call>& calls, const std::vector<std::string>& arguments, std::size_t first);

}  // namespace robcogen::octave
