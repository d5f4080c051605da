// How the programs of a function become compiled kernels.
#pragma once

namespace robcogen::symbolic {

// What a kernel is compiled for, from the oldest processors to the newest.
enum class Level { baseline, avx2, avx512 };

// Decided from the programs before anything is printed (pass/kernel_form.h). The defaults are those of a function whose
// programs were not examined.
struct KernelForm {
  // The program in lanes computes its own sines. Otherwise the kernel calls a core in lanes.
  bool has_own_lanes = false;
  // The angles of all sines in lanes are small where robcogen::are_small is true for the joint positions.
  bool has_small_angles = false;
  // The core, or the core in lanes, is compiled into its caller.
  bool inlines_core = false;
  bool inlines_core_in_lanes = false;
  // The kernel calls functions for its sines, in place of containing them.
  bool calls_sines = false;
  // The highest level at which the kernel is expected to be faster than at the one below.
  Level level = Level::baseline;
  // Over many states, the function is computed one state at a time.
  bool takes_single_states = false;
};

}  // namespace robcogen::symbolic
