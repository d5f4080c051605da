// The functions of a robot: which it has follows from the declarations and the model alone; each is traced when its
// program is needed.
#pragma once

#include <string>
#include <vector>

#include "algorithm/catalogue/declaration.h"
#include "algorithm/catalogue/groups.h"

namespace robcogen::algorithm {

// A function that a robot has.
struct Declared {
  const Declaration* is;
  Subject subject;
  std::string name;    // `fr_base_X_fr_foot`; overloads share it and differ in loads
  std::string kernel;  // `homogeneous_fr_base_X_fr_foot`, `inverse_dynamics_external`: unique among the functions
  std::vector<Declared> parts = {};  // of a fused function: the functions whose results it has, for the same loads
};

// The functions of one group, overloads one after another, fewest inputs first; none if the group is not available.
// Gravity, if it enters, is folded to (0, 0, -9.81) in a fixed-base robot's first overload and an input in the others;
// external wrenches are inputs of the last.
std::vector<Declared> declared(
    const model::KinematicTree& tree,
    const model::DesiredTransforms& desired,
    const std::string& group);

// The overloads of one function, whether the robot has it or not.
std::vector<Declared> overloads(const Declaration& declaration, const Subject& subject);

// What functions of these frames are declared for.
Subject subject_of(
    const model::KinematicTree& tree,
    const ContactFrames& contacts,
    const std::vector<model::InverseTarget>& inverses,
    const model::FramePair& frames);

// Whether the robot has the function between these frames, desired or not.
bool is_of(const Declaration& declaration, const Subject& subject);

// The groups of contact functions: the robot has them if contact frames are desired.
const std::vector<std::string>& groups_of_contacts();
// The groups with functions between frames, of the pairs of the desired transforms.
const std::vector<std::string>& groups_between_frames();

// The inputs and outputs of the program, by name, role and size.
symbolic::Program outline(const Declared& function);

// All but the program.
symbolic::Function described(const Declared& function);

// The function as these choices trace it.
symbolic::Function trace(const Declared& function, FormulationChoices& choices);

// All functions of a group.
std::vector<symbolic::Function> functions(
    const model::KinematicTree& tree,
    const model::DesiredTransforms& desired,
    const std::string& group,
    FormulationChoices& choices);
std::vector<symbolic::Function> functions(
    const model::KinematicTree& tree,
    const model::DesiredTransforms& desired,
    const std::string& group,
    const Formulation& formulation = {});

// Whether its program depends on the formulation.
bool is_formulated(const Declared& function);

// Whether constants of a program fold like a representative, so that it may differ from the program of the same
// function without representatives.
bool folds_like_others(const symbolic::Program& program);

// False if no constant of the function can do so with these choices.
bool may_fold_like_others(const Declared& function, FormulationChoices& choices);

// The group whose functions need collision shapes, which are not read otherwise; and whether a text mentions one of
// these functions.
inline constexpr const char* kCollisionGroup = "collision";
bool mentions_collisions(const std::string& text);

}  // namespace robcogen::algorithm
