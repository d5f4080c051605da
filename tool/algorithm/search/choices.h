// The formulations of a robot's programs, each chosen once.
#pragma once

#include <functional>
#include <memory>

#include "algorithm/search/forward_dynamics_choice.h"
#include "algorithm/search/frame_search.h"
#include "support/lazy.h"

namespace robcogen::algorithm {

// Chooses how the programs of a robot are traced. The frames that suit an algorithm are searched for when they are
// first requested. Several threads may request them.
class FormulationChoices {
 public:
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
  // The formulation for a program that has no frame search of its own: with the frames of Newton-Euler or of the model,
  // whichever is cheaper.
  Formulation cheaper_for(const std::function<symbolic::Program(const Formulation&)>& trace);
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

  // `start` with frames that suit this trace; the search begins at the frames of `start`.
  Formulation searched(const Formulation& start, const TraceOf& trace) const;
  Formulation with_representatives(Formulation formulation) const;
};

}  // namespace robcogen::algorithm
