// Random states of a function, and what the interpreter computes from them, for tests of functions over many states.
#pragma once

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <limits>
#include <random>
#include <string>
#include <vector>

#include "../../unit/command/run_tool.h"
#include "../calls.h"
#include "backend/common/cache.h"
#include "backend/gpu/gpu.h"
#include "backend/gpu/printers.h"
#include "model/elements.h"
#include "robcogen/gpu/batch.h"

namespace robcogen::test {

inline const std::filesystem::path kRobots = ROBCOGEN_ROBOTS_DIR;
inline const backend::Features kGpuFeatures = {
    .caches_parameters = true,
    .has_both = true,
    .column_loops = backend::ColumnLoops::if_faster};

// Writes the text of the library.
inline void write_gpu(
    const std::filesystem::path& folder,
    const backend::Library& library,
    const backend::gpu::Lengths& lengths = {}) {
  for (const OutputFile& file : backend::gpu::print(library, lengths)) {
    create_directories((folder / file.path).parent_path());
    write_text(folder / file.path, file.text);
  }
}

// Elements of the workspace of a function for so many states.
inline std::size_t workspace_of(const backend::gpu::StatesFunction& f, std::size_t count) {
  return f.stages ? (count + 31) / 32 * 32 * static_cast<std::size_t>(f.stages->workspace) : 0;
}

// Returns what the command prints; empty if it succeeds and prints nothing.
inline std::string run(const std::filesystem::path& folder, const std::string& command) {
  const std::filesystem::path log = folder / "log";
  const int status = std::system(("cd " + folder.string() + " && " + command + " > log 2>&1").c_str());
  const std::string text = read_text(log);
  return status == 0 || !text.empty() ? text : "failed: " + command;
}

// Parameters in tests are their defaults times this number, or this number.
constexpr double kOfDefault = 1.1;

// The cache of these parameters.
template <class Real>
std::vector<Real> cache_of(const backend::Library& library) {
  std::vector<Real> cache;
  for (const backend::Function& update : library.updates) {
    symbolic::Arrays<Real> inputs;
    for (const symbolic::InputArray& input : update.program.inputs)
      for (const std::string& element : input.elements)
        for (const model::Parameter& p : library.parameters())
          if (p.name == element)
            inputs[input.name].push_back(static_cast<Real>(kOfDefault * p.default_value.value_or(1)));
    const symbolic::Arrays<Real> outputs = symbolic::interpret<Real>(update.program, inputs);
    const std::vector<Real>& part = outputs.at(update.program.outputs.front().name);
    cache.insert(cache.end(), part.begin(), part.end());
  }
  return cache;
}

// The arrays of one function: its inputs and the expected results, state by state.
template <class Real>
struct States {
  std::vector<std::vector<std::vector<Real>>> arrays;  // by array, by state
};

template <class Real>
States<Real> random_states(
    const backend::Library& library,
    const symbolic::Program& program,
    int count,
    std::mt19937_64& engine) {
  States<Real> states;
  states.arrays.resize(program.inputs.size() + program.outputs.size());
  for (int i = 0; i < count; ++i) {
    const symbolic::Arrays<double> drawn = random_inputs(library, program, engine);
    symbolic::Arrays<Real> inputs;
    std::size_t k = 0;
    for (const symbolic::InputArray& input : program.inputs) {
      std::vector<Real>& values = inputs[input.name];
      for (const double value : drawn.at(input.name)) values.push_back(static_cast<Real>(value));
      if (input.role == symbolic::Role::parameters && !library.updates.empty()) values = cache_of<Real>(library);
      states.arrays[k++].push_back(values);
    }
    const symbolic::Arrays<Real> results = symbolic::interpret<Real>(program, inputs);
    for (const symbolic::OutputArray& output : program.outputs) states.arrays[k++].push_back(results.at(output.name));
  }
  return states;
}

// The text computes in the order of the program; only sines differ, and compilers fuse. So results may differ by a
// multiple of the rounding error that the generator states for the function. That is a root mean square over states, in
// units of half an epsilon, so the worst state of many differs by more: in the worst of a thousand states, the forward
// dynamics of iiwa14 in float differ from those in double by 5 times as many epsilons, and in the worst of ten thousand,
// the forward dynamics of a quadruped with two contacts by 6.7 times (in the worst of 35, mostly below 2). That is for
// inputs that the function is for: a negative compliance makes the system of the contacts singular somewhere.
constexpr double kTolerance = 8;

template <class Real>
Real tolerance(const backend::Function& function) {
  const double stated = function.error ? (sizeof(Real) == 4 ? function.error->in_float : function.error->in_double) : 0;
  return static_cast<Real>(kTolerance * std::max(4.0, stated)) * std::numeric_limits<Real>::epsilon();
}

// The scale of an array in state i: its largest element there, or a quarter of its root mean square over the states.
template <class Real>
Real scale(const std::vector<std::vector<Real>>& states, std::size_t i) {
  Real largest = 0, squares = 0;
  for (const Real value : states[i]) largest = std::max(largest, std::abs(value));
  for (const std::vector<Real>& state : states) {
    Real most = 0;
    for (const Real value : state) most = std::max(most, std::abs(value));
    squares += most * most;
  }
  return std::max(largest, std::sqrt(squares / static_cast<Real>(states.size())) / 4);
}

// States in memory, in some layout, between elements that nothing may touch.
template <class Real>
class Memory {
 public:
  Memory(robcogen_gpu_layout layout, std::size_t size, std::size_t count)
      : layout_(layout), size_(size), stride_(layout == robcogen_gpu_by_element ? count + 5 : size + 3) {
    const std::size_t states = (count + 31) / 32 * 32;
    numbers_.assign(2 * kGuard + std::max(states * (size + 3), size * stride_) + 1, kUntouched);
  }
  Real& at(std::size_t k, std::size_t i) {
    const std::size_t place = layout_ == robcogen_gpu_by_tile      ? i / 32 * 32 * size_ + k * 32 + i % 32
                              : layout_ == robcogen_gpu_by_element ? k * stride_ + i
                              : layout_ == robcogen_gpu_by_state   ? i * stride_ + k
                                                                   : k;
    return numbers_[kGuard + place];
  }
  robcogen_gpu_array array() const { return {numbers_.data() + kGuard, layout_, static_cast<std::ptrdiff_t>(stride_)}; }
  // The whole memory, of which the array begins behind kGuard numbers.
  std::vector<Real>& numbers() { return numbers_; }
  std::size_t touched() const {
    return numbers_.size() - std::size_t(std::count(numbers_.begin(), numbers_.end(), kUntouched));
  }

  static constexpr std::size_t kGuard = 64;

 private:
  static constexpr Real kUntouched = Real(-1.25e17);
  robcogen_gpu_layout layout_;
  std::size_t size_, stride_;
  std::vector<Real> numbers_;
};

// The memory of a function's arrays, with the inputs of the first states. `layouts`: of the arrays in turn.
template <class Real>
std::vector<Memory<Real>> memory_of(
    const backend::gpu::StatesFunction& f,
    const States<Real>& states,
    std::size_t count,
    const std::vector<robcogen_gpu_layout>& layouts) {
  std::vector<Memory<Real>> memory;
  for (std::size_t a = 0; a < f.arrays.size(); ++a) {
    memory.emplace_back(layouts[a % layouts.size()], f.arrays[a].size, count);
    for (std::size_t i = 0; i < count && !f.arrays[a].array.output; ++i)
      for (std::size_t k = 0; k < f.arrays[a].size; ++k) memory[a].at(k, i) = states.arrays[a][i][k];
  }
  return memory;
}

// How an array of the first states differs from what it should be; empty: not at all. NaN is right where it is wanted.
template <class Real>
std::string difference(
    Memory<Real>& got,
    const std::vector<std::vector<Real>>& wanted,
    std::size_t count,
    Real tolerance) {
  const std::size_t size = wanted.front().size();
  if (got.touched() != count * size) return ": something wrote beyond it, or not all of it";
  for (std::size_t i = 0; i < count; ++i) {
    const Real bound = tolerance * scale(wanted, i);
    for (std::size_t k = 0; k < size; ++k) {
      const Real x = got.at(k, i), y = wanted[i][k];
      if (std::abs(x - y) <= bound || (std::isnan(x) && std::isnan(y))) continue;
      return ": element " + std::to_string(k) + " of state " + std::to_string(i) + " is " + std::to_string(x) +
             ", not " + std::to_string(y) + ": " + std::to_string(std::abs(x - y) / bound) + " of the tolerance";
    }
  }
  return "";
}

}  // namespace robcogen::test
