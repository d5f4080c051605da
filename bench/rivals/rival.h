// Code that other generators made for one robot, behind an interface of plain numbers. It is compiled with its own
// flags into its own library, so that it does not share inline functions with the benchmark.
#pragma once

#include <cstddef>

namespace robcogen::rivals {

// Arrays of `count` states, one state after the other, in the conventions of peers/peer.h; base vectors have 6
// elements, gravity 3, which are the same for all states.
struct States {
  std::size_t count;
  const double *q, *qd, *qdd, *tau, *base_velocity, *base_acceleration;
  const double* gravity;
};

// In the order of peers::Quantity.
enum class Function { inverse_dynamics, forward_dynamics, inertia_matrix };
constexpr int kFunctions = 3;

struct Rival {
  const char* name;  // "first RobCoGen"
  double agreement;  // tolerance against this project's code, given by the precision of its model's numbers
  int joints;
  bool floating_base;
  void (*prepare)(const States&);
  void (*run)(Function, std::size_t state);
  void (*result)(Function, double* values);  // of the last run: base first; matrices by columns
};

}  // namespace robcogen::rivals

// The functions that the libraries of one robot export.
extern "C" {
[[gnu::visibility("default")]] const robcogen::rivals::Rival* robcogen_rival_first_robcogen();
[[gnu::visibility("default")]] const robcogen::rivals::Rival* robcogen_rival_cppadcodegen();
}
