// Every program of a robot, by name: what the back ends print, `eval` runs and `ops` counts.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "algorithm/search/choices.h"
#include "model/kinematic_tree.h"
#include "symbolic/accuracy.h"
#include "symbolic/derivative.h"
#include "symbolic/program.h"
#include "symbolic/solved_columns.h"

namespace robcogen::algorithm {

// One function of the API. Overloads share `scope` and `name` and differ in inputs.
struct RobotFunction {
  std::string group;                 // one of groups()
  std::string scope;                 // "", inertia_factor, transforms::homogeneous, transforms::motion, jacobians, …
  std::string name;                  // `inverse_dynamics`, `fr_base_X_fr_foot`
  std::vector<std::string> summary;  // what, frames, units, source
  std::vector<int> columns;          // jacobians: the coordinate of each column
  model::FramePair frames;           // of functions between two frames
  symbolic::Program program;         // program.name is unique among the robot's functions
  std::string method = {};           // how it is computed, if there was a choice
  std::optional<symbolic::RoundingError> error = {};        // set once it is measured
  std::vector<symbolic::DerivativeBlock> derivatives = {};  // among its outputs, to be checked by differences
  std::vector<std::string> labels = {};                     // regressors: what each column multiplies
  // The same with a loop, if the program is too long for caches.
  std::optional<symbolic::SolvedColumns> solved = {};
};

// In canonical order.
const std::vector<std::string>& groups();

// The groups whose functions are each between two frames, one of the pairs of the desired transforms.
const std::vector<std::string>& groups_between_frames();

// The groups of contact functions: the robot has them if contact frames are desired.
const std::vector<std::string>& groups_of_contacts();

// The default groups of a robot: those that most programs need and that compile quickly.
const std::vector<std::string>& default_groups();

// Whether the robot's mass properties allow the functions of this group: functions that divide by the joint-space
// inertia matrix need a regular matrix, those of the centre of mass need mass, and all of the dynamics need inertia.
bool is_available(const model::KinematicTree& tree, const std::string& group);

// Why a group is not available; empty if it is. With `other_than_masses` it is also empty if the mass properties do not
// allow the group, which diagnostics of the model say.
enum class Reasons { all, other_than_masses };
std::string reason_of_absence(const model::KinematicTree& tree, const std::string& group, Reasons reasons);

// The functions of one group; none if it is not available. Gravity, if it enters, is folded to (0, 0, -9.81) in a
// fixed-base robot's first overload and an input in the others; external wrenches are inputs of the last.
std::vector<RobotFunction> functions(
    const model::KinematicTree& tree,
    const model::DesiredTransforms& desired,
    const std::string& group,
    FormulationChoices& choices);
std::vector<RobotFunction> functions(
    const model::KinematicTree& tree,
    const model::DesiredTransforms& desired,
    const std::string& group,
    const Formulation& formulation = {});

// The programs of these functions by the plain formulation, without names; empty for groups that do not depend on a
// formulation.
std::vector<symbolic::Program> plain_programs(
    const model::KinematicTree& tree,
    const model::DesiredTransforms& desired,
    const std::string& group);

// Whether constants of a program fold like a representative, so that it may differ from the program of the same
// function without representatives.
bool folds_like_others(const symbolic::Program& program);

// The programs of these functions with congruent limbs that fold in the same way, for lanes, by
// FormulationChoices::for_congruent_limbs; nullopt for a program that is the same; empty for groups that do not depend
// on a formulation.
std::vector<std::optional<symbolic::Program>> congruent_programs(
    const model::KinematicTree& tree,
    const model::DesiredTransforms& desired,
    const std::string& group,
    FormulationChoices& for_congruent_limbs);

}  // namespace robcogen::algorithm
