// The rows of the catalogue: what a function of the API is, before any program is traced.
#pragma once

#include <optional>
#include <string>
#include <type_traits>
#include <vector>

#include "algorithm/dynamics/contact_rows.h"
#include "algorithm/dynamics/dynamics.h"
#include "algorithm/dynamics/world_frames.h"
#include "algorithm/kinematics/inverse_kinematics.h"
#include "algorithm/kinematics/kinematics.h"
#include "algorithm/search/choices.h"
#include "model/kinematic_tree.h"
#include "symbolic/function.h"

namespace robcogen::algorithm {

// What one function is declared for: a robot with its contact frames, the frames of the function, and its loads.
struct Subject {
  const model::KinematicTree& tree;
  const ContactFrames& contacts;
  model::FramePair frames = {};  // of a function of one frame: the base and this frame
  Loads loads = Loads::gravity;
  std::optional<ForwardDynamicsMethod> method = {};  // of forward dynamics, once it is chosen
  model::InverseTask task = {};                      // of inverse kinematics
};

using Condition = bool (*)(const Subject&);
using Size = int (*)(const Subject&);

// An input or an output. Arrays of the base, and loads that are not inputs, do not exist for each subject.
struct Array {
  const char* name;
  symbolic::Role role;
  Size rows;
  Size columns = nullptr;  // nullptr: one
  Condition exists = nullptr;
};

// How a function is traced: the subject, with the robot whose rotors may have moved into its bodies, and the choices.
struct Tracing : Subject {
  std::string scope;
  std::string name;  // of the program
  ForwardDynamicsChoice choice;
  FormulationChoices& choices;
};

// Which pairs of frames, single frames, or whole robots have the function.
enum class Of {
  robot,
  contacts,        // the robot, if contact frames are desired
  transform_pair,  // each desired transform
  jacobian_pair,   // each desired Jacobian
  base_pair,       // each desired Jacobian whose left frame is on the base: from others, the base is seen to move
  inverse_pair,    // each pair of frames of inverse kinematics
  placed_frame,    // each frame of desired transforms, Jacobians and contacts, except that of the base itself
  moving_frame,    // each frame of desired Jacobians and contacts that moves in the world
};

// The overloads of a function. With a floating base gravity is always an input, because it tells the orientation of the
// base; with a fixed base there is also one without it.
enum class Overloads { none, gravity, gravity_and_external };

// What a function says about how it is computed, where there is a choice.
enum class Method { none, frames, algorithm_and_frames };

// A form of the function with a loop over right-hand sides, for robots for which it is better.
struct ColumnForm {
  long (*operations)(const Subject&);
  bool (*is_better)(long operations);
  symbolic::SolvedColumns (*trace)(const Tracing&);
};

// Another way to compute a bias, for functions that are fused with bias_forces: from the motions of the links, which it
// has in common with these. It takes gravity as they do.
struct FromBiasForces {
  Condition applies;
  symbolic::Program (*trace)(const Tracing&);
};

// Inputs follow the parameters of the model, and precede the gravity and the external wrenches of overloads.
struct Signature {
  std::vector<Array> inputs, outputs;
  Overloads overloads = Overloads::none;
};

// How the program is traced, and for which search of link frames.
struct Source {
  symbolic::Program (*trace)(const Tracing&) = nullptr;
  Search search = Search::none;
};

// Text may have the placeholders of phrases.h.
struct Declaration {
  const char* scope = "";
  const char* name;  // a pattern: `{A}_X_{B}`, `J_{B}`, or plain
  Of of = Of::robot;
  Condition exists = nullptr;
  std::vector<const char*> summary = {};
  Signature signature = {};
  Source program = {};
  std::vector<const char*> remarks = {};  // the end of the summary
  // Uses the bodies, rotors and parameters of the model as they are. (The Coriolis matrix of a robot depends on how its
  // mass is assigned to links.)
  bool is_of_model = false;
  std::vector<std::string> (*labels)(const Subject&) = nullptr;  // of columns
  Method method = Method::frames;                                // if there is a search
  std::optional<ColumnForm> in_columns = {};
  // The program may be traced in the link frames of functions that it is fused with, if the base floats: it is then of
  // the same composite bodies.
  bool joins_frames = false;
  std::optional<FromBiasForces> from_bias_forces = {};
  // In place of a signature: the names of the functions (find.h) whose results are its results, part by part. A program
  // is not needed, but may cost less than those of the parts together; nullopt for a subject that has none.
  std::vector<std::string> (*parts)(const Subject&) = nullptr;
  std::optional<symbolic::Program> (*together)(const Tracing&) = nullptr;
  const char* group = "";  // set by declarations()
};

// All functions, by group in canonical order.
const std::vector<Declaration>& declarations();

// The rows of each source of this folder.
struct GroupRows {
  const char* group;
  std::vector<Declaration> rows;
};
using Declarations = std::vector<GroupRows>;
namespace catalogue {
Declarations dynamics_declarations();
Declarations derivative_declarations();
Declarations contact_declarations();
Declarations identification_declarations();
Declarations kinematics_declarations();
Declarations world_declarations();
Declarations mechanism_declarations();
Declarations collision_declarations();
}  // namespace catalogue

// ---- From algorithms to Source::trace.

// The axes, or the form of transforms, that a scope stands for.
template <class T>
T of_scope(const std::string& scope);
template <>
TransformForm of_scope(const std::string& scope);
template <>
JacobianReference of_scope(const std::string& scope);
template <>
Axes of_scope(const std::string& scope);
template <>
CentroidalAxes of_scope(const std::string& scope);

// The part of a tracing that an algorithm takes as a parameter of this type.
template <class T>
decltype(auto) part(const Tracing& t) {
  if constexpr (std::is_same_v<T, model::KinematicTree>)
    return (t.tree);
  else if constexpr (std::is_same_v<T, ContactFrames>)
    return (t.contacts);
  else if constexpr (std::is_same_v<T, model::FramePair>)
    return (t.frames);
  else if constexpr (std::is_same_v<T, model::Frame>)
    return (t.frames.right);
  else if constexpr (std::is_same_v<T, std::string>)
    return (t.name);
  else if constexpr (std::is_same_v<T, model::InverseTask>)
    return (t.task);
  else if constexpr (std::is_same_v<T, Loads>)
    return (t.loads);
  else if constexpr (std::is_same_v<T, ForwardDynamicsChoice>)
    return (t.choice);
  else if constexpr (std::is_same_v<T, Formulation>)
    return (t.choice.formulation);
  else if constexpr (std::is_same_v<T, RepresentativeLinks>)
    return (t.choice.formulation.representative);
  else if constexpr (std::is_same_v<T, symbolic::Program>)
    return t.choices.inertia_factor();
  else
    return of_scope<T>(t.scope);
}

template <auto algorithm>
struct Called;
template <class Result, class... Parts, Result (*algorithm)(Parts...)>
struct Called<algorithm> {
  static Result with(const Tracing& t) { return algorithm(part<std::remove_cvref_t<Parts>>(t)...); }
};

template <auto algorithm>
inline constexpr auto by = Called<algorithm>::with;

}  // namespace robcogen::algorithm
