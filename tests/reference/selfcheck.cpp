#include "robcogen/reference/selfcheck.h"

#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <optional>
#include <random>

#include "robcogen/reference/check_batch.h"
#include "robcogen/reference/check_contacts.h"
#include "robcogen/reference/check_control.h"
#include "robcogen/reference/check_derivatives.h"
#include "robcogen/reference/check_factor.h"
#include "robcogen/reference/check_frame_motion.h"
#include "robcogen/reference/check_identification.h"
#include "robcogen/reference/check_identities.h"
#include "robcogen/reference/check_inverse_kinematics.h"
#include "robcogen/reference/check_kinematics.h"
#include "robcogen/reference/check_partial_derivatives.h"
#include "robcogen/reference/check_parts.h"
#include "robcogen/reference/check_total_mass.h"
#include "robcogen/reference/check_trigonometry.h"
#include "robcogen/reference/command_line.h"
#include "robcogen/reference/loops.h"
#include "robcogen/reference/parameters.h"

namespace robcogen::reference {
namespace {

// The functions that a library may have in both precisions.
void check_dynamics(const AnySubject& subject, const Case& c, Checks& checks) {
  if (subject.inverse_dynamics) check_inverse_dynamics(subject, c, checks);
  if (subject.bias_forces) check_bias_forces(subject, c, checks);
  if (subject.forward_dynamics) check_forward_dynamics(subject, c, checks);
  if (subject.joint_space_inertia) check_inertia_matrix(subject, c, checks);
}

void check_identities(const AnySubject& subject, const Case& c, Checks& checks) {
  if (subject.bias_forces) check_gravity_gradient(subject, c, checks);
  if (subject.forward_dynamics && subject.inverse_dynamics) check_round_trips(subject, c, checks);
  if (!subject.joint_space_inertia) return;
  check_inertia_structure(subject, c, checks);
  check_energy(subject, c, checks);
  if (subject.inverse_dynamics) check_inertia_columns(subject, c, checks);
  if (subject.bias_forces) check_power(subject, c, checks);
}

void check_derivatives_of_dynamics(const AnySubject& subject, const Case& c, Checks& checks) {
  if (subject.inverse_dynamics_fully_actuated_derivatives) check_inverse_dynamics_derivatives(subject, c, checks);
  if (subject.gravity_forces_derivative) check_gravity_forces_derivative(subject, c, checks);
  if (subject.inverse_dynamics_derivatives) check_free_inverse_dynamics_derivatives(subject, c, checks);
  if (subject.inverse_dynamics_gradient) check_inverse_dynamics_gradient(subject, c, checks);
  if (subject.forward_dynamics_derivatives) check_forward_dynamics_derivatives(subject, c, checks);
}

void check_identification(const AnySubject& subject, const Case& c, Checks& checks) {
  if (subject.regressor) check_parameters_of_regressors(subject, c, checks);
  if (subject.regressor) check_regressor(subject, c, checks);
  if (subject.base_regressor) check_base_regressor(subject, c, checks);
  if (subject.energy_regressor) check_energy_regressor(subject, c, checks);
  if (subject.slotine_li_regressor) check_slotine_li_regressor(subject, c, checks);
}

void check_control(const AnySubject& subject, const Case& c, Checks& checks) {
  if (subject.passive_forces) check_passive_forces(subject, c, checks);
  if (subject.inertia_factor) check_inertia_factor(subject, c, checks);
  if (subject.inertia_factor && subject.bias_forces && subject.forward_dynamics)
    check_factor_dynamics(subject, c, checks);
  if (subject.coriolis_matrix) check_coriolis_matrix(subject, c, checks);
  if (subject.generalized_momentum) check_generalized_momentum(subject, c, checks);
  if (subject.path_dynamics) check_path_dynamics(subject, c, checks);
  if (subject.center_of_mass) check_center_of_mass(subject, c, checks);
  if (subject.center_of_mass) check_centroidal_momentum(subject, c, checks);
  if (subject.center_of_mass && subject.forward_dynamics) check_free_fall(subject, c, checks);
  if (subject.kinetic_energy) check_energies(subject, c, checks);
}

// `set` is the number of this set of parameter values.
void check(
    const Library& library,
    const Robot& tables,
    const std::vector<double>& values,
    std::mt19937_64& engine,
    int samples,
    int set,
    Checks& checks) {
  const AnySubject subject = library.subject(tables, values);
  const std::vector<double> cache = library.cache(values);
  for (int i = 0; i < samples; ++i) {
    Sample sample;
    const AtLoops closed = draw(engine, tables, sample);
    const Case c(closed.robot(), sample, i, &closed);
    check_dynamics(subject, c, checks);
    check_identities(subject, c, checks);
    check_control(subject, c, checks);
    check_derivatives_of_dynamics(subject, c, checks);
    check_identification(subject, c, checks);
    // The tables are empty where the library has no such functions.
    check_transforms(subject, c, checks);
    check_jacobians(subject, c, checks);
    check_frame_motions(subject, c, checks);
    check_contacts(c, cache, engine, checks);
    check_inverse_kinematics(c, cache, engine, checks);
  }
  if (subject.total_mass) check_total_mass(subject, tables, checks, set);
  check_trigonometry(tables, cache, engine, samples, checks);
  if (library.batch_functions != nullptr) check_batches(tables, *library.batch_functions, cache, engine, checks);
}

void check_single(const Library& library, std::mt19937_64& engine, int samples, Checks& checks) {
  const Robot& robot = *library.robot;
  const AnySubject subject = library.single(robot);
  checks.in_single(true);
  for (int i = 0; i < samples; ++i) {
    Sample sample;
    const AtLoops closed = draw(engine, robot, sample, true);
    check_dynamics(subject, Case(closed.robot(), sample, i), checks);
  }
  checks.in_single(false);
}

// Checks the derivatives and the fused functions that the robot was generated with. `values` are those of the
// parameters, if it has some.
void check_asked_functions(
    const Library& library,
    const std::vector<double>& values,
    std::mt19937_64& engine,
    int samples,
    Checks& checks) {
  const Robot& robot = *library.robot;
  const std::vector<double> cache = library.cache(values);
  std::optional<AtLoops> closed;  // for a robot with loops, at the inputs
  const auto inputs_of = [&](const reflection::Function& f) {
    std::vector<double> inputs = random_inputs(engine, robot, f, cache);
    if (f.positions < 0 || !follows_through_loops(robot)) return inputs;
    Sample sample;
    closed.emplace(draw(engine, robot, sample));
    const Vector<double>& q = sample.motion.q;
    std::copy(q.data(), q.data() + q.rows(), inputs.begin() + f.positions);
    return inputs;
  };
  const auto move = [&](const reflection::Function& f, const reflection::Derivative& d, int element, double step,
                        std::vector<double>& inputs) {
    if (d.input != f.positions || d.by_parameters) {
      inputs[static_cast<std::size_t>(d.input + element)] += step;
      return;
    }
    Vector<double> q(robot.position_count()), direction(robot.dof());
    const auto begin = inputs.begin() + f.positions;
    std::copy(begin, begin + q.rows(), q.data());
    direction(element) = step;
    Motion<double> there = at_rest(robot, moved(robot, q, direction));
    if (closed) closed->near(there);
    std::copy(there.q.data(), there.q.data() + q.rows(), begin);
  };
  check_partial_derivatives(
      robot.functions, robot.derivatives, inputs_of, move, values, library.cache, samples, checks);
  check_parts(robot.functions, robot.parts, inputs_of, samples, checks);
}

constexpr int kSetsOfValues = 4;

// Returns no checks if no parameter values were found.
Checks checks_of(const Library& library, std::uint64_t seed, int samples) {
  const Robot& robot = *library.robot;
  Checks checks;
  std::mt19937_64 engine(seed);
  if (robot.parameters.size == 0) {
    check(library, robot, {}, engine, samples, 0, checks);
    check_asked_functions(library, {}, engine, samples, checks);
    if (library.single != nullptr) check_single(library, engine, samples, checks);
    return checks;
  }
  std::optional<std::vector<double>> before = default_values(robot);
  for (int set = 0; set < kSetsOfValues; ++set) {
    const auto values = set == 0 && before ? before : random_values(engine, robot);
    if (!values) return Checks();
    const RobotOf tables(robot, *values);
    check(library, tables.robot(), *values, engine, samples, set, checks);
    check_asked_functions(library, *values, engine, samples, checks);
    library.check_updates(robot, *values, before ? *before : *values, checks, set);
    before = values;
  }
  return checks;
}

// The processor levels that the library has kernels for and this machine can run.
std::vector<Level> levels(const Library& library) {
  if (library.use_level == nullptr) return {Level::baseline};
  std::vector<Level> result;
  for (const Level level : {Level::baseline, Level::avx2, Level::avx512})
    if (level == available(level)) result.push_back(level);
  return result;
}

void use_level(const Library& library, Level level) {
  if (library.use_level == nullptr) return;
  constexpr const char* kNames[] = {"baseline", "avx2", "avx512"};
  std::printf("kernels of level %s:\n", kNames[static_cast<int>(level)]);
  library.use_level(level);
}

}  // namespace

int selfcheck(const Library& library, int argc, char** argv) {
  const std::optional<CommandLine> options = command_line(argc, argv);
  if (!options) return 2;
  std::printf(
      "%s: seed %llu, %d samples\n", library.robot->name, static_cast<unsigned long long>(options->seed),
      options->samples);
  int count = 0, failures = 0;
  for (const Level level : levels(library)) {
    use_level(library, level);
    const Checks checks = checks_of(library, options->seed, options->samples);
    std::printf("%s", checks.report().c_str());
    count += checks.size();
    failures += checks.failures();
  }
  if (count == 0 && library.robot->parameters.size > 0) {
    std::printf("no values found with which all links are bodies\n");
    return 77;
  }
  std::printf("%d checks, %d failed\n", count, failures);
  return failures == 0 ? 0 : 1;
}

}  // namespace robcogen::reference
