// The measurements of one benchmark program.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

namespace robcogen::bench {

// For one call, ns, over the repetitions.
struct Time {
  double median = 0;
  double least = 0;
  double most = 0;
};

// A function of the generated library.
struct Function {
  std::string name;    // of its benchmark
  std::string kernel;  // that it calls
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
  int states = 0;  // that each function is called with in turn
  std::vector<Function> functions;
  std::vector<PeerTime> peer_times;
  std::vector<std::string> peers;  // in the order in which they are listed everywhere
  std::vector<Absence> absent;
  std::map<std::string, std::string> compared;  // quantity -> the function that is set against peers
  double gigahertz = 0;                         // while this was measured, from additions that wait; 0: unknown
  std::optional<double> compile_seconds;        // of the library
  std::map<std::string, long> bytes;            // of the compiled kernels, by name; may lack some
  int processors = 0;
  int megahertz = 0;
  bool frequency_scaling = false;
};

// Cycles below which no call gets on a processor with two units for products and sums, when none overlaps with the
// next: its critical path, or half its instructions. nullopt where nothing was counted.
std::optional<double> least_cycles(const Function& function);

// The cycles of a call with sines and cosines given, as `least_cycles` has them; nullopt where that was not measured.
std::optional<double> cycles(const Results& results, const Function& function);

// The operation counts that are shown, and the quantities that are compared, in the order in which they are shown.
extern const std::vector<std::string> kCounts;
extern const std::vector<std::string> kQuantities;

// From Google Benchmark's JSON, each repetition separately. Throws nlohmann::json::exception when the text is something
// else.
Results read_results(const std::string& json);

// Bytes of each kernel compiled for double, by its name, what it calls once sines and cosines are known and the parts
// of long ones included. `listing` is the output of `nm -S -C`: address, size, type and demangled name, such as `void
// hyl::kernel::inverse_dynamics<double>(double const*, …)`.
std::map<std::string, long> kernel_sizes(const std::string& listing);

}  // namespace robcogen::bench
