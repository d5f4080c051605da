// The self-check of one generated library: over random states, against the independent reference and against
// identities that hold for every robot. Compiled once a robot, with
//     ROBCOGEN_ROBOT_HEADER, ROBCOGEN_REFLECTION_HEADER   the generated headers, as <…>
//     ROBCOGEN_ROBOT_NAMESPACE                            the namespace of the generated code
//     ROBCOGEN_BATCH_HEADER                               where the library has functions over many states
//     ROBCOGEN_ROBOT_HAS_LEVELS                           where it has kernels for several processors: each is checked
//
//     hyl_selfcheck [--seed N] [--samples N]
//
// prints one line a check and exits with 1 when one failed, 2 when the command line is wrong, 77 when no values were
// found for the parameters of a robot. A robot with parameters is checked with several sets of values.
#include ROBCOGEN_ROBOT_HEADER
#include ROBCOGEN_REFLECTION_HEADER

#include "robcogen/level.h"
#include "robcogen/reference/available.h"
#include "robcogen/reference/check_batch.h"
#include "robcogen/reference/check_contacts.h"
#include "robcogen/reference/check_control.h"
#include "robcogen/reference/check_derivatives.h"
#include "robcogen/reference/check_factor.h"
#include "robcogen/reference/check_frame_motion.h"
#include "robcogen/reference/check_identification.h"
#include "robcogen/reference/check_identities.h"
#include "robcogen/reference/check_kinematics.h"
#include "robcogen/reference/check_parameters.h"
#include "robcogen/reference/check_partial_derivatives.h"
#include "robcogen/reference/check_trigonometry.h"
#include "robcogen/reference/command_line.h"
#include "robcogen/reference/compiled_robot.h"
#include "robcogen/reference/loops.h"

namespace robcogen::reference {
namespace {

template <class R>
void check(const Robot& robot, const CompiledRobot<R>& subject, std::mt19937_64& engine, int samples, Checks& checks) {
  for (int i = 0; i < samples; ++i) {
    Sample sample;
    const AtLoops closed = draw(engine, robot, sample);
    const Case c(closed.robot(), sample, i, &closed);
    if constexpr (kHasInverseDynamics) check_inverse_dynamics(subject, c, checks);
    if constexpr (kHasBiasForces) check_bias_forces(subject, c, checks);
    if constexpr (kHasBiasForces) check_gravity_gradient(subject, c, checks);
    if constexpr (kHasPassiveForces) check_passive_forces(subject, c, checks);
    if constexpr (kHasForwardDynamics) check_forward_dynamics(subject, c, checks);
    if constexpr (kHasForwardDynamics && kHasInverseDynamics) check_round_trips(subject, c, checks);
    if constexpr (kHasInertia) check_inertia_matrix(subject, c, checks);
    if constexpr (kHasInertia) check_inertia_structure(subject, c, checks);
    if constexpr (kHasInertia) check_energy(subject, c, checks);
    if constexpr (kHasInertia && kHasInverseDynamics) check_inertia_columns(subject, c, checks);
    if constexpr (kHasInertia && kHasBiasForces) check_power(subject, c, checks);
    if constexpr (kHasFactor) check_inertia_factor(subject, c, checks);
    if constexpr (kHasFactor && kHasBiasForces && kHasForwardDynamics) check_factor_dynamics(subject, c, checks);
    if constexpr (kHasCoriolisMatrix) check_coriolis_matrix(subject, c, checks);
    if constexpr (kHasInverseDynamicsDerivatives) check_inverse_dynamics_derivatives(subject, c, checks);
    if constexpr (kHasInverseDynamicsDerivatives) check_gravity_forces_derivative(subject, c, checks);
    if constexpr (R::kFloatingBase && kHasFreeInverseDynamicsDerivatives)
      check_free_inverse_dynamics_derivatives(subject, c, checks);
    if constexpr (kHasInverseDynamicsGradient) check_inverse_dynamics_gradient(subject, c, checks);
    if constexpr (kHasForwardDynamicsDerivatives) check_forward_dynamics_derivatives(subject, c, checks);
    if constexpr (kHasRegressor) check_parameters_of_regressors(subject, c, checks);
    if constexpr (kHasRegressor) check_regressor(subject, c, checks);
    if constexpr (kHasBaseRegressor) check_base_regressor(subject, c, checks);
    if constexpr (kHasEnergyRegressor) check_energy_regressor(subject, c, checks);
    if constexpr (kHasSlotineLiRegressor) check_slotine_li_regressor(subject, c, checks);
    if constexpr (kHasCentroidal) check_center_of_mass(subject, c, checks);
    if constexpr (kHasCentroidal) check_centroidal_momentum(subject, c, checks);
    if constexpr (kHasCentroidal && kHasForwardDynamics) check_free_fall(subject, c, checks);
    if constexpr (kHasEnergy) check_energies(subject, c, checks);
    // The tables are empty where the library has no such functions.
    check_transforms(subject, c, checks);
    check_jacobians(subject, c, checks);
    check_frame_motions(subject, c, checks);
    check_contacts(c, subject.cache(), engine, checks);
  }
  check_trigonometry(robot, subject.cache(), engine, samples, checks);
#ifdef ROBCOGEN_BATCH_HEADER
  check_batches(robot, ROBCOGEN_ROBOT_NAMESPACE::reflection::batch_functions, subject.cache(), engine, checks);
#endif
}

// The functions whose formulation is chosen, in single precision.
template <class R>
void check_single(
    const Robot& robot,
    const CompiledRobot<R>& subject,
    std::mt19937_64& engine,
    int samples,
    Checks& checks) {
  checks.in_single(true);
  for (int i = 0; i < samples; ++i) {
    Sample sample;
    const AtLoops closed = draw(engine, robot, sample, true);
    const Case c(closed.robot(), sample, i);
    if constexpr (kHasInverseDynamics) check_inverse_dynamics(subject, c, checks);
    if constexpr (kHasBiasForces) check_bias_forces(subject, c, checks);
    if constexpr (kHasForwardDynamics) check_forward_dynamics(subject, c, checks);
    if constexpr (kHasInertia) check_inertia_matrix(subject, c, checks);
  }
  checks.in_single(false);
}

// Derivatives that the robot was generated with. `values` are those of the parameters, where it has some.
template <class R>
void check_derivatives(
    const Robot& robot,
    const std::vector<double>& values,
    const std::vector<double>& cache,
    std::mt19937_64& engine,
    int samples,
    Checks& checks) {
  std::optional<AtLoops> closed;  // of a robot with loops, at the inputs
  const auto inputs_of = [&](const reflection::Function& f) {
    std::vector<double> inputs = random_inputs(engine, robot, f, cache);
    if (f.positions < 0 || !follows_through_loops(robot)) return inputs;
    Sample sample;
    closed.emplace(draw(engine, robot, sample));
    const Vector<double>& q = sample.motion.q;
    std::copy(q.data(), q.data() + q.rows(), inputs.begin() + f.positions);
    return inputs;
  };
  const auto cache_of = [](const std::vector<double>& moved) {
    if constexpr (kIsParametric<R>) {
      const auto parameters = parameters_of<R>(moved);
      return std::vector<double>(parameters.data(), parameters.data() + R::Parameters::size());
    } else {
      return moved;
    }
  };
  const auto move = [&](const reflection::Function& f, const reflection::Derivative& d, int element, double step,
                        std::vector<double>& inputs) {
    if (d.input != f.positions || d.by_parameters) {
      inputs[static_cast<std::size_t>(d.input + element)] += step;
      return;
    }
    Vector<double> q(robot.position_count()), way(robot.dof());
    const auto begin = inputs.begin() + f.positions;
    std::copy(begin, begin + q.rows(), q.data());
    way(element) = step;
    Motion<double> there = at_rest(robot, moved(robot, q, way));
    if (closed) closed->near(there);
    std::copy(there.q.data(), there.q.data() + q.rows(), begin);
  };
  check_partial_derivatives(robot.functions, robot.derivatives, inputs_of, move, values, cache_of, samples, checks);
}

constexpr int kSetsOfValues = 4;

// Empty where no values were found.
template <class R>
Checks selfcheck(const Robot& robot, std::uint64_t seed, int samples) {
  Checks checks;
  std::mt19937_64 engine(seed);
  if constexpr (kIsParametric<R>) {
    std::optional<std::vector<double>> before = default_values(robot);
    for (int set = 0; set < kSetsOfValues; ++set) {
      const auto values = set == 0 && before ? before : random_values(engine, robot);
      if (!values) return Checks();
      const RobotOf tables(robot, *values);
      const CompiledRobot<R> subject(tables.robot(), R{parameters_of<R>(*values)});
      check<R>(tables.robot(), subject, engine, samples, checks);
      check_derivatives<R>(robot, *values, subject.cache(), engine, samples, checks);
      if constexpr (kHasCentroidal) check_total_mass(subject, tables.robot(), checks, set);
      check_updates<R>(robot, *values, before ? *before : *values, checks, set);
      before = values;
    }
  } else {
    check<R>(robot, CompiledRobot<R>(robot), engine, samples, checks);
    check_derivatives<R>(robot, {}, {}, engine, samples, checks);
#ifndef ROBCOGEN_ROBOT_IS_DOUBLE_ONLY
    // Depends on R: nothing is made of it where the robot has parameters.
    using Single = std::conditional_t<kIsParametric<R>, void, ROBCOGEN_ROBOT_NAMESPACE::f32::Robot>;
    check_single<Single>(robot, CompiledRobot<Single>(robot), engine, samples, checks);
#endif
  }
  return checks;
}

// The processor levels that the library has kernels for, as far as this machine has them.
std::vector<robcogen::Level> levels() {
#ifdef ROBCOGEN_ROBOT_HAS_LEVELS
  std::vector<robcogen::Level> result;
  for (const auto level : {robcogen::Level::baseline, robcogen::Level::avx2, robcogen::Level::avx512})
    if (level == robcogen::available(level)) result.push_back(level);
  return result;
#else
  return {robcogen::Level::baseline};
#endif
}

void use_level([[maybe_unused]] robcogen::Level level) {
#ifdef ROBCOGEN_ROBOT_HAS_LEVELS
  constexpr const char* kNames[] = {"baseline", "avx2", "avx512"};
  std::printf("kernels of level %s:\n", kNames[static_cast<int>(level)]);
  ROBCOGEN_ROBOT_NAMESPACE::reflection::use_level(level);
#endif
}

}  // namespace
}  // namespace robcogen::reference

int main(int argc, char** argv) {
  namespace generated = ROBCOGEN_ROBOT_NAMESPACE;
  const std::optional<robcogen::reference::CommandLine> options = robcogen::reference::command_line(argc, argv);
  if (!options) return 2;
  const robcogen::reflection::Robot& robot = generated::reflection::robot;
  std::printf(
      "%s: seed %llu, %d samples\n", robot.name, static_cast<unsigned long long>(options->seed), options->samples);
  int count = 0, failures = 0;
  for (const robcogen::Level level : robcogen::reference::levels()) {
    robcogen::reference::use_level(level);
    const robcogen::reference::Checks checks =
        robcogen::reference::selfcheck<generated::Robot>(robot, options->seed, options->samples);
    std::printf("%s", checks.report().c_str());
    count += checks.size();
    failures += checks.failures();
  }
  if (count == 0 && robot.parameters.size > 0) {
    std::printf("no values found with which all links are bodies\n");
    return 77;
  }
  std::printf("%d checks, %d failed\n", count, failures);
  return failures == 0 ? 0 : 1;
}
