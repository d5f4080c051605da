// The measurements of one benchmark program.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

namespace robcogen::bench {

// Times of one call (ns) over the repetitions.
struct Time {
  double median = 0;
  double least = 0;
  double most = 0;
};

// A function of the generated library.
struct Function {
  std::string name;    // of its benchmark
  std::string kernel;  // called by it
  Time time;
  std::map<std::string, long> counts;   // of operations; zeros are left out
  std::optional<Time> given_trig = {};  // of a call that takes sines and cosines
  std::optional<Time> batch = {};       // of one state, in calls for many at once
};

// The same quantity by another library.
struct PeerTime {
  std::string peer;
  std::string quantity;  // of kQuantities
  Time time;
};

struct Absence {
  std::string library;
  std::string reason;
};

struct Results {
  std::string robot;
  int joints = 0;
  bool floating_base = false;
  int states = 0;  // over which each function is called in turn
  std::vector<Function> functions;
  std::vector<PeerTime> peer_times;
  std::vector<std::string> peers;  // in the order in which they are listed everywhere
  std::vector<Absence> absent;
  std::map<std::string, std::string> compared;  // quantity -> the function that is compared with peers
  double gigahertz = 0;                         // during the measurement, from a chain of additions; 0: unknown
  std::optional<double> compile_seconds;        // of the library
  std::map<std::string, long> bytes;            // of the compiled kernels, by name; may lack some
  int processors = 0;
  int megahertz = 0;
  bool frequency_scaling = false;
};

// Lower bound (cycles) of a call on a processor with two units for products and sums, if calls do not overlap: its
// critical path, or half its instructions. nullopt if nothing was counted.
std::optional<double> least_cycles(const Function& function);

// The measured cycles of a call with given sines and cosines, comparable with `least_cycles`; nullopt if not measured.
std::optional<double> cycles(const Results& results, const Function& function);

// The operation counts and the compared quantities, in the order in which they are shown.
extern const std::vector<std::string> kCounts;
extern const std::vector<std::string> kQuantities;

// Reads Google Benchmark's JSON, with each repetition separately. Throws nlohmann::json::exception if the text is
// something else.
Results read_results(const std::string& json);

// Bytes of each kernel compiled for double, by its name, including its core after sines and cosines and the parts of
// long kernels. `listing` is the output of `nm -S -C`: address, size, type and demangled name, such as
// `void hyl::kernel::inverse_dynamics<double>(double const*, …)`.
std::map<std::string, long> kernel_sizes(const std::string& listing);

}  // namespace robcogen::bench
