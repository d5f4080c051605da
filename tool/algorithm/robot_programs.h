// Every program of a robot, by name: what the back ends print, `eval` runs and `ops` counts.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "algorithm/dynamics.h"
#include "algorithm/frame_search.h"
#include "model/kinematic_tree.h"
#include "symbolic/program.h"

namespace robcogen::algorithm {

// One function of the API. Overloads share `scope` and `name` and differ in inputs.
struct RobotFunction {
  std::string group;                 // one of groups()
  std::string scope;                 // "", inertia_factor, transforms::homogeneous, transforms::motion, jacobians, …
  std::string name;                  // `inverse_dynamics`, `fr_base_X_fr_foot`
  std::vector<std::string> summary;  // what, frames, units, source
  std::vector<int> columns;          // jacobians: the joint of each column
  model::FramePair frames;           // of what is about two frames
  symbolic::Program program;         // program.name is unique among the robot's functions
  std::string method = {};           // how it is computed, where there was a choice; a line of the summary too
};

// In canonical order.
const std::vector<std::string>& groups();

// The groups of a robot that nobody chose groups for: those that most programs need, and that cost little to compile.
const std::vector<std::string>& default_groups();

// How the programs of a robot are traced: the frames that suit an algorithm are looked for when it is first asked for.
class Formulations {
 public:
  Formulations(const model::KinematicTree& tree, const Formulation& common) : tree_(tree), common_(common) {}

  const Formulation& common() const { return common_; }
  const Formulation& newton_euler();
  const Formulation& unactuated_base();
  const Formulation& inertia();
  const ForwardDynamicsChoice& forward_dynamics();
  // For programs of the model as it is.
  const TypicalLinks& typical_of_model() const { return typical_of_model_; }
  // The same for programs whose equal limbs are to fold alike (typical_limbs.h); nullopt where they do so anyway, and
  // of robots with parameters.
  std::optional<Formulations> with_typical_limbs() const;
  // For a program that no frames were looked for: those of Newton-Euler, or the model's.
  Formulation cheaper_for(const std::function<symbolic::Program(const Formulation&)>& trace);

 private:
  const model::KinematicTree& tree_;
  Formulation common_;
  TypicalLinks typical_of_model_;
  std::optional<Formulation> newton_euler_, unactuated_base_, inertia_;

  // Looks for frames, from those of `start` on, unless that was done.
  const Formulation& searched(std::optional<Formulation>& place, const Formulation& start, const TraceOf& trace);
  std::optional<ForwardDynamicsChoice> forward_dynamics_;
};

// The functions of one group. Gravity, where it enters, is folded to (0, 0, -9.81) in a fixed-base robot's first
// overload and an input in the others; external wrenches are inputs of the last.
std::vector<RobotFunction> functions(
    const model::KinematicTree& tree,
    const model::DesiredTransforms& desired,
    const std::string& group,
    Formulations& formulations);
std::vector<RobotFunction> functions(
    const model::KinematicTree& tree,
    const model::DesiredTransforms& desired,
    const std::string& group,
    const Formulation& formulation = {});

// The programs of these functions with equal limbs that fold alike, for lanes; nullopt where these are the same.
std::vector<std::optional<symbolic::Program>> alike_programs(
    const model::KinematicTree& tree,
    const model::DesiredTransforms& desired,
    const std::string& group,
    const Formulations& formulations);

}  // namespace robcogen::algorithm
