// The benchmark of one generated library: each function over 1,024 random states in turn, or over as many of a smooth
// motion if ROBCOGEN_BENCH_STATES is `trajectory` in the environment. Compiled once per robot, with
//     ROBCOGEN_ROBOT_HEADER, ROBCOGEN_REFLECTION_HEADER   the generated headers, as <…>
//     ROBCOGEN_ROBOT_NAMESPACE                            the namespace of the generated code
//     ROBCOGEN_BATCH_HEADER                               functions over many states, if the library has them
//     ROBCOGEN_BENCH_FLAGS                                the flags of its kernels, as text
//     ROBCOGEN_BENCH_URDF                                 the robot as a URDF, if other libraries are measured too
//     ROBCOGEN_BENCH_FIRST_ROBCOGEN, ROBCOGEN_BENCH_CPPADCODEGEN   defined if code of these generators for the robot is
//     linked
//
// Exit status 1: another library disagrees with the generated code; nothing was timed.
#include ROBCOGEN_ROBOT_HEADER
#include ROBCOGEN_REFLECTION_HEADER

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <string>

#include "clock.h"
#include "functions.h"

#ifdef ROBCOGEN_BATCH_HEADER
#include "batches.h"
#endif

#ifdef ROBCOGEN_BENCH_URDF
#include "compared.h"
#include "peer_benchmarks.h"
#include "rivals/rival.h"
#include "rivals/rivals.h"
#endif

namespace robcogen::bench {
namespace {

template <class R>
void add_functions(const Robot& robot, const std::vector<State<R>>& states) {
  if constexpr (reference::kHasInverseDynamics) add_inverse_dynamics<R>(robot, states);
  if constexpr (reference::kHasForwardDynamics) add_forward_dynamics<R>(robot, states);
  if constexpr (reference::kHasInertia) add_inertia_matrix<R>(robot, states);
  if constexpr (reference::kHasFactor) add_inertia_factor<R>(robot, states);
  if constexpr (reference::kHasBiasForces) add_bias_forces<R>(robot, states);
  add_kinematics<R>(robot, states);
}

#ifdef ROBCOGEN_BENCH_URDF
constexpr std::size_t kCheckedStates = 64;

std::vector<const rivals::Rival*> linked_rivals() {
  return {
#ifdef ROBCOGEN_BENCH_FIRST_ROBCOGEN
      robcogen_rival_first_robcogen(),
#endif
#ifdef ROBCOGEN_BENCH_CPPADCODEGEN
      robcogen_rival_cppadcodegen(),
#endif
  };
}

// Loads the other libraries' models of the robot and adds their benchmarks. Returns false, with a message, if one of
// them disagrees with the generated code. The peers must outlive the benchmarks.
template <class R>
bool add_peers(const Robot& robot, const std::vector<State<R>>& states, std::vector<peers::Candidate>& candidates) {
  const peers::Subject robot_of_peers = subject(robot, ROBCOGEN_BENCH_URDF);
  const std::vector<Computed> ours = computed<R>(robot, states);
  bool agree = true;
  const auto check = [&](const peers::Candidate& candidate, double agreement) {
    if (candidate.peer == nullptr) return;
    candidate.peer->prepare(converted_states<R>(states));
    for (const std::string& message : disagreements(*candidate.peer, ours, kCheckedStates, agreement)) {
      std::fprintf(stderr, "%s: %s\n", robot.name, message.c_str());
      agree = false;
    }
  };
  candidates = peers::load(robot_of_peers);
  for (const peers::Candidate& candidate : candidates) check(candidate, kAgreement);
  for (const rivals::Rival* rival : linked_rivals()) {
    candidates.push_back(rivals::candidate(*rival, robot_of_peers));
    check(candidates.back(), rival->agreement);
  }
  add_peer_benchmarks(candidates, ours, kStates);
  return agree;
}
#endif

// An instance with the declared defaults of its parameters, or random values, because the time does not depend on them.
template <class R>
R instance([[maybe_unused]] const Robot& robot) {
  if constexpr (reference::kIsParametric<R>) {
    typename R::ParameterArray values;
    std::mt19937_64 engine(kSeed);
    for (std::size_t i = 0; i < values.size(); ++i) {
      const reflection::Parameter& p = robot.parameters[static_cast<int>(i)];
      values[i] = std::isnan(p.default_value) ? reference::uniform(engine, 1) : p.default_value;
    }
    return R{typename R::Parameters(values)};
  } else {
    return R();
  }
}

}  // namespace
}  // namespace robcogen::bench

int main(int argc, char** argv) {
  namespace generated = ROBCOGEN_ROBOT_NAMESPACE;
  namespace bench = robcogen::bench;
  using R = generated::Robot;
  const bench::Robot& robot = generated::reflection::robot;
  benchmark::AddCustomContext("robot", robot.name);
  benchmark::AddCustomContext("flags", ROBCOGEN_BENCH_FLAGS);
  benchmark::AddCustomContext("states", std::to_string(bench::kStates));
  benchmark::AddCustomContext("joints", std::to_string(robot.dof()));
  benchmark::AddCustomContext("floating_base", robot.floating_base ? "yes" : "no");
  const R instance = bench::instance<R>(robot);
  const char* const asked = std::getenv("ROBCOGEN_BENCH_STATES");
  const std::string kind = asked ? asked : "random";
  if (kind != "random" && kind != "trajectory") {
    std::fprintf(stderr, "ROBCOGEN_BENCH_STATES is '%s', not 'random' or 'trajectory'\n", asked);
    return 2;
  }
  benchmark::AddCustomContext("kind of states", kind);
  const std::vector<bench::State<R>> states =
      kind == "trajectory" ? bench::states_of_trajectory<R>(robot, instance) : bench::random_states<R>(robot, instance);
  bench::add_functions<R>(robot, states);
#ifdef ROBCOGEN_BATCH_HEADER
  bench::add_batches<R>(robot, states);
#endif
  bench::add_clock();
#ifdef ROBCOGEN_BENCH_URDF
  std::vector<robcogen::peers::Candidate> candidates;
  if (!bench::add_peers<R>(robot, states, candidates)) return 1;
#endif
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 2;
  benchmark::RunSpecifiedBenchmarks();
  benchmark::Shutdown();
  return 0;
}
