// Code that generate_cppadcodegen.cpp made for one robot, with Pinocchio and CppADCodeGen. Compiled once per robot with
//     ROBCOGEN_RIVAL_CODE   the file, in quotes
#include <array>
#include <vector>

#include "rivals/rival.h"

#include ROBCOGEN_RIVAL_CODE

namespace robcogen::rivals {
namespace {

class Robot {
 public:
  void prepare(const States& s) {
    count_ = s.count;
    const auto joints = static_cast<std::size_t>(rival_joints);
    for (std::vector<double>& list : arguments_) list.clear();
    const auto append = [](std::vector<double>& list, const double* all, std::size_t state, std::size_t size) {
      list.insert(list.end(), all + state * size, all + (state + 1) * size);
    };
    for (std::size_t i = 0; i < s.count; ++i) {
      for (const bool is_inverse : {true, false}) {
        std::vector<double>& list = arguments_[is_inverse ? 0 : 1];
        append(list, s.q, i, joints);
        append(list, s.qd, i, joints);
        append(list, is_inverse ? s.qdd : s.tau, i, joints);
        if (rival_floating_base == 0) continue;
        append(list, s.base_velocity, i, 6);
        if (is_inverse) append(list, s.base_acceleration, i, 6);
        append(list, s.gravity, 0, 3);
      }
      append(arguments_[2], s.q, i, joints);
    }
    const std::size_t size = joints + (rival_floating_base != 0 ? 6 : 0);
    results_ = {std::vector<double>(size), std::vector<double>(size), std::vector<double>(size * size)};
  }

  void run(Function function, std::size_t state) {
    const auto f = static_cast<std::size_t>(function);
    const double* in = arguments_[f].data() + state * (arguments_[f].size() / count_);
    double* out = results_[f].data();
    switch (function) {
      case Function::inverse_dynamics:
        return rival_inverse_dynamics::call(&in, &out, {});
      case Function::forward_dynamics:
        return rival_forward_dynamics::call(&in, &out, {});
      case Function::inertia_matrix:
        return rival_inertia_matrix::call(&in, &out, {});
    }
  }

  void result(Function function, double* values) const {
    for (const double value : results_[static_cast<std::size_t>(function)]) *values++ = value;
  }

 private:
  std::size_t count_ = 0;
  std::array<std::vector<double>, kFunctions> arguments_;  // of all states
  std::array<std::vector<double>, kFunctions> results_;    // of the last run
};

Robot& robot() {
  static Robot only;
  return only;
}

}  // namespace
}  // namespace robcogen::rivals

extern "C" const robcogen::rivals::Rival* robcogen_rival_cppadcodegen() {
  using namespace robcogen::rivals;
  static const Rival rival = {
      "Pinocchio with CppADCodeGen",
      1e-9,
      rival_joints,
      rival_floating_base != 0,
      [](const States& states) { robot().prepare(states); },
      [](Function function, std::size_t state) { robot().run(function, state); },
      [](Function function, double* values) { robot().result(function, values); }};
  return &rival;
}
