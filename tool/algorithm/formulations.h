// The formulations of a robot's programs, found once.
#pragma once

#include <functional>
#include <optional>

#include "algorithm/dynamics.h"
#include "algorithm/frame_search.h"
#include "support/lazy.h"

namespace robcogen::algorithm {

// How the programs of a robot are traced: the frames that suit an algorithm are looked for when it is first asked for.
// Several threads may ask.
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
  Lazy<Formulation> newton_euler_, unactuated_base_, inertia_;
  Lazy<ForwardDynamicsChoice> forward_dynamics_;

  // With frames that suit these traces, looked for from those of `start` on.
  Formulation searched(const Formulation& start, const TraceOf& trace) const;
};

}  // namespace robcogen::algorithm
