// The benchmarks of functions over many states, structure of arrays: `<function>/batch`, on the best of the processor's
// levels, and `<function>/batch/threads/<count>`, where each thread has a range of the states. Times are per state.
//
// Needs ROBCOGEN_BATCH_HEADER and the definitions of robot_bench.cpp.
#pragma once

#include ROBCOGEN_BATCH_HEADER

#include <algorithm>
#include <memory>
#include <thread>

#include "functions.h"

// The functions of the library by unqualified names, which are looked up where a call is instantiated: not every robot
// has every function. The namespace is separate because robcogen::bench has functions of the same names.
namespace robcogen_batch_calls {

using namespace ROBCOGEN_ROBOT_NAMESPACE::batch;

inline constexpr auto kInverseDynamics = [](const auto&... x) { inverse_dynamics(x...); };
inline constexpr auto kInverseDynamicsFullyActuated = [](const auto&... x) { inverse_dynamics_fully_actuated(x...); };
inline constexpr auto kForwardDynamics = [](const auto&... x) { forward_dynamics(x...); };
inline constexpr auto kJointSpaceInertia = [](const auto&... x) { joint_space_inertia(x...); };

}  // namespace robcogen_batch_calls

namespace robcogen::bench {

namespace generated = ROBCOGEN_ROBOT_NAMESPACE;
namespace calls = robcogen_batch_calls;

// An array of states, element by element: each column begins with a cache line. The stride, eight states more than a
// multiple of 16, is an odd number of lines, so that columns do not compete for the same cache sets.
class Columns {
 public:
  explicit Columns(int elements, std::size_t states = kStates)
      : elements_(static_cast<std::size_t>(elements)), stride_(states + 8), numbers_(elements_ * stride_ + kLine) {
    void* begin = numbers_.data();
    std::size_t room = numbers_.size() * sizeof(double);
    data_ = static_cast<double*>(std::align(kLine * sizeof(double), elements_ * stride_ * sizeof(double), begin, room));
  }
  Columns(const Columns&) = delete;
  Columns& operator=(const Columns&) = delete;

  template <class Values>
  void set(std::size_t state, const Values& values) {
    for (std::size_t k = 0; k < elements_; ++k) data_[k * stride_ + state] = values.data()[k];
  }

  template <class Value = batch::AnyVector>
  auto from(std::size_t begin) const {
    return batch::by_element<Value>(static_cast<const double*>(data_) + begin, stride());
  }
  template <class Value = batch::AnyVector>
  auto to(std::size_t begin) {
    return batch::by_element<Value>(data_ + begin, stride());
  }
  batch::Strided<const double> strided() const { return {data_, stride(), 1}; }
  batch::Strided<double> strided() { return {data_, stride(), 1}; }

 private:
  static constexpr std::size_t kLine = 8;  // of 64 bytes

  std::ptrdiff_t stride() const { return static_cast<std::ptrdiff_t>(stride_); }

  std::size_t elements_;
  std::size_t stride_;
  std::vector<double> numbers_;
  double* data_;
};

// The arguments of all functions, and memory for their results. Matrices are large, so there are only as many states of
// them as 256 KB hold; those of all states would exceed the near caches.
template <class R>
struct Arrays {
  static constexpr int kMatrixElements = R::InertiaMatrix::SizeAtCompileTime;
  static constexpr std::size_t kMatrices =
      std::clamp((std::size_t(1) << 15) / kMatrixElements / 16 * 16, std::size_t(16), kStates);

  explicit Arrays(const std::vector<State<R>>& states) : robot(states.front().robot) {
    for (std::size_t i = 0; i < kStates; ++i) {
      q.set(i, states[i].q);
      qd.set(i, states[i].qd);
      qdd.set(i, states[i].qdd);
      tau.set(i, states[i].tau);
      base_velocity.set(i, states[i].base_velocity);
      base_acceleration.set(i, states[i].base_acceleration);
    }
  }

  const R* robot;
  Columns q{R::kDof}, qd{R::kDof}, qdd{R::kDof}, tau{R::kDof}, base_velocity{6}, base_acceleration{6};
  Columns joint_result{R::kDof}, base_result{6}, matrix{kMatrixElements, kMatrices};
};

// Calls function(arguments…), with the robot's parameters first if it has some.
template <class R, class Function, class... Arguments>
void call(Function function, [[maybe_unused]] const R& robot, const Arguments&... arguments) {
  if constexpr (reference::kIsParametric<R>) {
    function(robot.parameters, arguments...);
  } else {
    function(arguments...);
  }
}

// Each function computes `count` states from `begin` on.
template <class R>
void inverse_dynamics_of(Arrays<R>& a, std::size_t begin, std::size_t count) {
  const auto n = static_cast<std::ptrdiff_t>(count);
  const auto q = a.q.from(begin), qd = a.qd.from(begin), qdd = a.qdd.from(begin);
  if constexpr (R::kFloatingBase) {
    call(
        calls::kInverseDynamicsFullyActuated, *a.robot, n, q, qd, qdd, a.base_velocity.template from<Twist>(begin),
        a.base_acceleration.template from<SpatialAcceleration>(begin), kStandardGravity, a.joint_result.to(begin),
        a.base_result.template to<Wrench>(begin));
  } else {
    call(calls::kInverseDynamics, *a.robot, n, q, qd, qdd, a.joint_result.to(begin));
  }
}

template <class R>
void forward_dynamics_of(Arrays<R>& a, std::size_t begin, std::size_t count) {
  const auto n = static_cast<std::ptrdiff_t>(count);
  const auto q = a.q.from(begin), qd = a.qd.from(begin), tau = a.tau.from(begin);
  if constexpr (R::kFloatingBase) {
    call(
        calls::kForwardDynamics, *a.robot, n, q, qd, tau, a.base_velocity.template from<Twist>(begin), kStandardGravity,
        a.joint_result.to(begin), a.base_result.template to<SpatialAcceleration>(begin));
  } else {
    call(calls::kForwardDynamics, *a.robot, n, q, qd, tau, a.joint_result.to(begin));
  }
}

template <class R>
void joint_space_inertia_of(Arrays<R>& a, std::size_t begin, std::size_t count) {
  constexpr std::size_t kRange = Arrays<R>::kMatrices;
  for (std::size_t i = 0; i < count; i += kRange) {
    const auto n = static_cast<std::ptrdiff_t>(std::min(kRange, count - i));
    call(calls::kJointSpaceInertia, *a.robot, n, a.q.from(begin + i), a.matrix.to(0));
  }
}

template <class R>
using Compute = void (*)(Arrays<R>& arrays, std::size_t begin, std::size_t count);

// Adds the benchmark of run(), which computes all states.
template <class Run>
void add_batch(const std::string& name, Run run) {
  benchmark::RegisterBenchmark((name + "/batch").c_str(), [run](benchmark::State& state) {
    for (auto _ : state) {
      run();
      benchmark::ClobberMemory();
    }
    state.SetItemsProcessed(static_cast<std::int64_t>(state.iterations() * kStates));
  });
}

template <class R>
void add_batch(const std::shared_ptr<Arrays<R>>& arrays, const std::string& name, Compute<R> compute) {
  add_batch(name, [arrays, compute] { compute(*arrays, 0, kStates); });
}

// Adds the benchmark of a function of positions only, from the library's table.
template <class R>
void add_batch_of_positions(
    const std::shared_ptr<const Arrays<R>>& arrays,
    const std::string& name,
    const std::string& kernel) {
  for (const reflection::BatchFunction& f : generated::reflection::batch_functions) {
    if (kernel != f.name) continue;
    add_batch(name, [arrays, results = std::make_shared<Columns>(f.outputs), call = f.call] {
      const double* parameters = reference::cache_of(*arrays->robot);
      call(parameters, kStates, arrays->q.strided(), results->strided(), batch::best_level());
    });
  }
}

// Each thread computes its range repeatedly, so that the time to start it does not count.
template <class R>
void add_threads(const std::shared_ptr<Arrays<R>>& arrays, const std::string& name, Compute<R> compute) {
  constexpr std::size_t kRepetitions = 1000;
  const std::size_t most = std::max(1u, std::thread::hardware_concurrency());
  for (std::size_t count = 1; count <= most; count *= 2) {
    const auto run = [arrays, compute, count](benchmark::State& state) {
      for (auto _ : state) {
        std::vector<std::thread> threads;
        for (std::size_t t = 0; t < count; ++t) {
          const std::size_t begin = kStates * t / count, end = kStates * (t + 1) / count;
          threads.emplace_back([&, begin, end] {
            for (std::size_t i = 0; i < kRepetitions; ++i) compute(*arrays, begin, end - begin);
          });
        }
        for (std::thread& thread : threads) thread.join();
      }
      state.SetItemsProcessed(static_cast<std::int64_t>(state.iterations() * kStates * kRepetitions));
    };
    const std::string threads = name + "/batch/threads/" + std::to_string(count);
    benchmark::RegisterBenchmark(threads.c_str(), run)->UseRealTime();
  }
}

template <class R>
void add_batches(const Robot& robot, const std::vector<State<R>>& states) {
  const auto arrays = std::make_shared<Arrays<R>>(states);
  if constexpr (reference::kHasInverseDynamics) {
    add_batch<R>(arrays, kInverseDynamics<R>, &inverse_dynamics_of<R>);
    add_threads<R>(arrays, kInverseDynamics<R>, &inverse_dynamics_of<R>);
  }
  if constexpr (reference::kHasForwardDynamics) {
    add_batch<R>(arrays, "forward_dynamics", &forward_dynamics_of<R>);
  }
  if constexpr (reference::kHasInertia) {
    add_batch<R>(arrays, "joint_space_inertia", &joint_space_inertia_of<R>);
  }
  for (const reflection::Transform* transform : measured_transforms(robot))
    add_batch_of_positions<R>(arrays, benchmark_name(*transform), kernel_name(*transform));
  for (const reflection::Jacobian* jacobian : measured_jacobians(robot))
    add_batch_of_positions<R>(arrays, benchmark_name(*jacobian), kernel_name(*jacobian));
}

}  // namespace robcogen::bench
