// The formulations of a robot's programs, each chosen once.
#pragma once

#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "algorithm/search/forward_dynamics_choice.h"
#include "algorithm/search/frame_search.h"
#include "model/coordinate_transforms.h"
#include "support/lazy.h"

namespace robcogen::algorithm {

// The function for which link frames are searched. A program that has no search of its own takes the frames in which it
// costs least.
enum class Search {
  none,  // the program has no formulation
  newton_euler,
  unactuated_base,
  inertia,
  inverse_dynamics_derivatives,
  forward_dynamics,
  cheaper,   // those of the model, or of Newton-Euler
  cheapest,  // the same, or of the inertia matrix
};

// Chooses how the programs of a robot are traced. The frames that suit an algorithm are searched for when they are
// first requested. Several threads may request them.
class FormulationChoices {
 public:
  using TraceOfProgram = std::function<symbolic::Program(const Formulation&)>;

  FormulationChoices(const model::KinematicTree& tree, const Formulation& common);

  // The choices of `original`, for programs whose congruent limbs fold in the same way (representative_limbs.h).
  static FormulationChoices for_congruent_limbs(FormulationChoices& original) { return FormulationChoices(original); }

  const Formulation& common() const { return common_; }
  // The robot for which programs with these formulations are traced: if mass properties may move to other links, those
  // of rotors do too (rotor_spin.h).
  const model::KinematicTree& tree() const { return spun_ ? *spun_ : model_; }
  // The robot as it is in the model.
  const model::KinematicTree& model() const { return model_; }
  const Formulation& newton_euler();
  const Formulation& unactuated_base();
  const Formulation& inertia();
  const Formulation& inverse_dynamics_derivatives();
  const ForwardDynamicsChoice& forward_dynamics();
  // The choice for a function. `trace` is called to compare formulations, once for all calls with the same name.
  ForwardDynamicsChoice choice(Search search, const std::string& function, const TraceOfProgram& trace);
  // The formulation for a function of several parts, each of which has one of these searches, in which all parts
  // together cost least; nullopt if they cost less with a choice of their own each. `trace(nullptr)` traces them so.
  // It is called once for all calls with the same name.
  using TraceOfParts = std::function<symbolic::Program(const Formulation*)>;
  std::optional<Formulation> common_choice(
      const std::vector<Search>& searches,
      const std::string& function,
      const TraceOfParts& trace);
  // The program joint_space_inertia_factor, whose sparsity other programs have.
  const symbolic::Program& inertia_factor();
  // The motions between frames.
  const model::MotionGraph& motions();
  // For programs of the model as it is; empty except in the choices for congruent limbs.
  const RepresentativeLinks& representative_of_model() const { return representative_of_model_; }

 private:
  explicit FormulationChoices(FormulationChoices& original);

  const model::KinematicTree& model_;
  std::shared_ptr<const model::KinematicTree> spun_;
  FormulationChoices* original_ = nullptr;
  Formulation common_;
  RepresentativeLinks representative_of_model_;
  Lazy<Formulation> newton_euler_, unactuated_base_, inertia_, inverse_dynamics_derivatives_;
  Lazy<ForwardDynamicsChoice> forward_dynamics_;
  Lazy<symbolic::Program> inertia_factor_;
  struct Motions {
    explicit Motions(const model::KinematicTree& tree) : of_tree(model::motions_of(tree)), graph(of_tree) {}
    const model::RigidMotions of_tree;
    const model::MotionGraph graph;
  };
  Lazy<std::unique_ptr<const Motions>> motions_;
  std::mutex mutex_;
  std::map<std::string, Lazy<Formulation>> cheapest_;              // by function
  std::map<std::string, Lazy<std::optional<Formulation>>> parts_;  // by function

  const Formulation& of(Search search);
  Formulation cheapest_for(const TraceOfProgram& trace, bool with_inertia);

  // `start` with frames that suit this trace; the search begins at the frames of `start`.
  Formulation searched(const Formulation& start, const TraceOf& trace) const;
  Formulation with_representatives(Formulation formulation) const;
};

}  // namespace robcogen::algorithm
