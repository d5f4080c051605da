// Code that other generators made for one robot, behind an interface of plain numbers: it is compiled with flags of its
// own, into a library of its own, so that nothing of its inline functions is shared with the benchmark.
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
  double agreement;  // with which it agrees with this project's code: that of the numbers of its model
  int joints;
  bool floating_base;
  void (*prepare)(const States&);
  void (*run)(Function, std::size_t state);
  void (*result)(Function, double* values);  // of the last run: base first; matrices by columns
};

}  // namespace robcogen::rivals

// What the libraries of one robot export.
extern "C" {
[[gnu::visibility("default")]] const robcogen::rivals::Rival* robcogen_rival_first_robcogen();
[[gnu::visibility("default")]] const robcogen::rivals::Rival* robcogen_rival_cppadcodegen();
}
