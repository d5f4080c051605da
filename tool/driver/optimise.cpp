#include "driver/optimise.h"

#include <algorithm>
#include <utility>

#include "algorithm/catalogue/model_numbers.h"
#include "driver/candidates.h"
#include "driver/limbs_in_lanes.h"
#include "pass/passes.h"
#include "pass/split_angles.h"
#include "pass/split_parameters.h"
#include "support/parallel.h"

namespace robcogen::driver {
namespace {

// An internal function of the library.
symbolic::Function function_of(const char* group, symbolic::Program program, std::vector<std::string> summary) {
  symbolic::Function function;
  function.group = group;
  function.name = function.kernel = program.name;
  function.summary = std::move(summary);
  function.program = std::move(program);
  return function;
}

Functions run_passes(Functions functions, const Passes& passes) {
  for_each_index(functions.list.size(), [&](std::size_t i) {
    symbolic::Program& program = functions.list[i].program;
    program = pass::run(std::move(program), passes);
  });
  return functions;
}

// Leaves only the loops over right-hand sides that a language wants.
Functions choose_column_loops(Functions functions, backend::ColumnLoops loops) {
  for (Function& function : functions.list) {
    std::optional<symbolic::SolvedColumns>& solved = function.solved;
    if (!solved || loops == backend::ColumnLoops::if_faster) continue;
    if (loops == backend::ColumnLoops::if_long && solved->is_long)
      solved->limbs.reset();  // columns of limbs are solved in lanes
    else
      solved.reset();
  }
  return functions;
}

// Makes a stage of the right-hand sides of each function that loops over solutions. The stage and the solution of one
// column are printed as programs; the function itself keeps only its inputs and outputs.
Functions separate_right_sides(Functions functions, const Passes& passes, const Passes& passes_of_solution) {
  const std::size_t count = functions.list.size();
  for (std::size_t i = 0; i < count; ++i) {
    Function& outer = functions.list[i];
    if (!outer.solved) continue;
    Function stage;
    stage.is_stage = true;
    stage.group = outer.group;
    stage.name = stage.kernel = outer.solved->right_sides.name;
    stage.summary = {"Right-hand sides of " + outer.program.name + ", and the factor with which they are solved."};
    stage.program = pass::run(std::move(outer.solved->right_sides), passes);
    outer.solved->right_sides = {};
    outer.solved->right_sides.name = stage.name;
    outer.solved->right_sides.outputs = {stage.program.outputs.back()};
    outer.solved->solution = pass::run(std::move(outer.solved->solution), passes_of_solution);
    if (auto& limbs = outer.solved->limbs) limbs->solution = pass::run(std::move(limbs->solution), passes_of_solution);
    for (symbolic::OutputArray& array : outer.program.outputs)
      array.values.assign(array.values.size(), symbolic::Operand{});
    outer.program.constants = {symbolic::Constant()};
    outer.program.statements.clear();
    outer.is_first_choice = false;
    outer.results.reset();
    functions.list.push_back(std::move(stage));
  }
  return functions;
}

// Moves the values that depend on the parameters alone into updates, which compute a cache that the functions then
// read. This comes before the passes, which put parameters and variables together in one sum.
Functions split_parameters(const Robot& robot, Functions functions, const Passes& passes) {
  std::vector<symbolic::Program> programs;
  for (Function& function : functions.list) programs.push_back(std::move(function.program));
  std::vector<pass::Interfaces> interfaces;
  for (const model::Parameter& p : robot.tree.parameters)
    interfaces.push_back({model::is_kinematics(p), model::is_dynamics(p)});
  pass::SplitPrograms split = pass::split_parameters(std::move(programs), interfaces);
  for (std::size_t i = 0; i < functions.list.size(); ++i) {
    functions.list[i].program = std::move(split.programs[i]);
    functions.list[i].results.reset();  // these belong to other inputs
  }
  functions = run_passes(std::move(functions), passes);
  const auto add_update = [&](symbolic::Program& program, const std::string& what) {
    functions.updates.push_back(function_of(
        "parameters", pass::run(std::move(program), passes), {"The part of the cache that depends on " + what + "."}));
  };
  add_update(split.kinematics, "kinematics parameters alone");
  add_update(split.dynamics, "dynamics parameters alone");
  add_update(split.both, "kinematics and dynamics parameters together");
  functions.numbers.push_back(function_of(
      "parameters", algorithm::model_numbers(robot.tree),
      {"The numbers of the model, a column for each link, joint and frame."}));
  if (!robot.tree.couplings.empty())
    functions.numbers.push_back(function_of(
        "parameters", algorithm::coupling_numbers(robot.tree),
        {"The numbers of couplings, a column for each coupled joint: its factors, then its offset."}));
  if (!robot.tree.tendons.empty())
    functions.numbers.push_back(function_of(
        "parameters", algorithm::tendon_numbers(robot.tree),
        {"The numbers of tendons, a column for each: the factors of all joints, stiffness, damping, rest length."}));
  return functions;
}

Functions split_angles(const Robot& robot, Functions functions) {
  std::vector<pass::WithLanes> programs;
  for (const Function& function : functions.list)
    programs.push_back({function.program, function.in_lanes ? &*function.in_lanes : nullptr});
  std::vector<pass::Position> positions;
  for (const int j : robot.tree.coordinates()) {
    const model::Joint& joint = robot.tree.joints[at(j)];
    positions.push_back({joint.name, model::turns(joint.type)});
  }
  pass::SplitAngles split = pass::split_angles(programs, positions);
  for (std::size_t i = 0; i < programs.size(); ++i) functions.list[i].core = std::move(split.cores[i]);
  functions.trigonometry = {
      split.angle_count, std::move(split.angles),
      function_of(
          "trigonometry", std::move(split.addition),
          {"Sines and cosines of all angles from those of the joints; the addition theorems give those of sums."})};
  return functions;
}

}  // namespace

Functions optimise(const Model& model, Functions functions, const Steps& steps, const backend::Features& features) {
  const Passes passes = steps.passes();
  const Robot* robot = model.robot();
  if (!robot) return run_passes(std::move(functions), passes);
  const bool splits = features.caches_parameters && !robot->tree.parameters.empty();
  const bool has_lanes = (features.has_lanes || features.has_both) && steps.has_lanes();
  const std::vector<algorithm::LimbsInLanes> limbs =
      has_lanes ? algorithm::limbs_in_lanes(robot->tree) : std::vector<algorithm::LimbsInLanes>();
  FormulationsByEffort formulations(*robot, steps.formulation());
  const auto pack = [&](Function& function) {
    pack_lanes(*robot, limbs, function, formulations.with(function.effort), passes);
  };
  const CostOfPrinted cost = [&](Function& function) {
    if (has_lanes && !features.has_both && !function.solved) pack(function);
    return starts(function.in_lanes ? *function.in_lanes : function.program);
  };
  functions = choose_candidates(
      *robot, std::move(functions), formulations, splits ? Passes() : passes, splits ? CostOfPrinted() : cost);
  functions = choose_column_loops(std::move(functions), features.column_loops);
  functions = separate_right_sides(std::move(functions), splits ? Passes() : passes, passes);
  if (splits) functions = split_parameters(*robot, std::move(functions), passes);
  if (has_lanes) for_each_index(functions.list.size(), [&](std::size_t i) { pack(functions.list[i]); });
  // Quaternions have no sines, and joints that follow others are not coordinates.
  if (features.takes_sines && robot->tree.position_count() == robot->tree.dof())
    functions = split_angles(*robot, std::move(functions));
  return functions;
}

}  // namespace robcogen::driver
