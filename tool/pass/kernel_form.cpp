#include "pass/kernel_form.h"

#include <cstddef>

#include "pass/small_angles.h"
#include "symbolic/cost.h"

namespace robcogen::pass {
namespace {

using symbolic::Cost;
using symbolic::Function;
using symbolic::KernelForm;
using symbolic::Level;
using symbolic::Program;
using symbolic::Role;

// The largest number of instructions of a core that is also compiled into its caller, because the cost of the call is
// measurable there. All other cores are compiled once.
constexpr int kSmallCore = 64;

// The number of lanes of a vector. A robot has dozens of kernels of the kinematics. One that reads more sines than fit
// in a vector calls functions for its sines and for its core, however short the core is: compiling it then takes half
// the time, and the calls take little of the time of the sines.
constexpr std::size_t kInVector = 4;

// The largest number of instructions of a kernel in lanes that computes its own sines. Passing them to a core, from an
// array into lanes, would take about fifty more. All other kernels call a core in lanes, which is written and compiled
// once.
constexpr int kSmallInLanes = 512;

// The number of products that must be fused into sums for a gain by a processor level, if there are neither sines nor
// lanes.
constexpr int kFewestFused = 24;

// The most results of a function that is computed for as many states at once as a vector has lanes. For eight states in
// double precision, these take 256 KB; more would outgrow the stacks of threads.
constexpr int kMaxElements = 4'000;

// The fewest instructions of a kernel that is compiled for AVX-512. Its 32 registers save loads and stores: kernels of
// 10 arms, quadrupeds and humanoids with more instructions take 0.88 of the time on average, shorter ones 0.97.
constexpr int kFewestForAvx512 = 300;

// AVX2 computes the sines of four angles at once, holds four limbs in a register, and fuses products into sums.
bool gains_by_avx2(const Function& f) {
  if (f.solved || f.in_lanes) return true;
  const Cost count = symbolic::cost(f.program);
  return count.sincos > 1 || count.mul + count.add - count.instructions >= kFewestFused;
}

// Loops over columns fill registers of AVX2, and take up to 1.15 of the time with AVX-512.
bool gains_by_avx512(const Function& f) {
  return !f.solved && symbolic::cost(f.in_lanes ? *f.in_lanes : f.program).instructions >= kFewestForAvx512;
}

Level level_of(const Function& f) {
  if (!gains_by_avx2(f)) return Level::baseline;
  return gains_by_avx512(f) ? Level::avx512 : Level::avx2;
}

// Symmetric matrices are written in place.
bool takes_single_states(const Program& program) {
  int elements = 0;
  for (const symbolic::OutputArray& output : program.outputs) elements += output.rows * output.columns;
  const bool is_symmetric = program.outputs.size() == 1 && program.outputs.front().role == Role::inertia_matrix;
  return elements > kMaxElements && !is_symmetric;
}

}  // namespace

KernelForm kernel_form(const Function& f, const GroupTraits& group) {
  const auto is_small = [](const Program& program, int limit) { return symbolic::cost(program).instructions <= limit; };
  KernelForm form;
  form.calls_sines = group.is_kinematics && f.core && f.core->read.size() > kInVector;
  if (f.core && !form.calls_sines) {
    form.inlines_core = is_small(f.core->program, kSmallCore);
    form.inlines_core_in_lanes = f.core->in_lanes && is_small(*f.core->in_lanes, kSmallCore);
  }
  form.has_own_lanes = f.in_lanes && (!f.core || is_small(*f.in_lanes, kSmallInLanes));
  form.has_small_angles = form.has_own_lanes && has_small_angles(*f.in_lanes);
  if (group.is_default || !group.is_kinematics) form.level = level_of(f);
  form.takes_single_states = takes_single_states(f.program);
  return form;
}

}  // namespace robcogen::pass
