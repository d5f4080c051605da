#include "algorithm/search/choices.h"

#include "algorithm/dynamics/traced_robot.h"
#include "algorithm/formulation/rotor_spin.h"
#include "algorithm/search/corresponding_frames.h"
#include "symbolic/cost.h"

namespace robcogen::algorithm {

using model::KinematicTree;

FormulationChoices::FormulationChoices(const KinematicTree& tree, const Formulation& common)
    : model_(tree), common_(common) {
  if (common.base_parameters && tree.has_rotors())
    spun_ = std::make_shared<const KinematicTree>(with_spin_in_bodies(tree));
}

FormulationChoices::FormulationChoices(FormulationChoices& original)
    : model_(original.model_),
      spun_(original.spun_),
      original_(&original),
      common_(with_representatives(original.common_)),
      representative_of_model_(representative_links(original.model_)) {}

Formulation FormulationChoices::searched(const Formulation& start, const TraceOf& trace) const {
  Formulation result = start;
  result.frames = cheap_frames(tree(), start, trace);
  return result;
}

Formulation FormulationChoices::with_representatives(Formulation formulation) const {
  formulation.frames = corresponding_frames(tree(), formulation);
  formulation.representative = representative_links(tree(), formulation);
  return formulation;
}

const Formulation& FormulationChoices::newton_euler() {
  return newton_euler_.get([&] {
    if (original_) return with_representatives(original_->newton_euler());
    return searched(
        common_, [&](Trace& trace, const Formulation& f) { trace_newton_euler(trace, default_loads(tree()), f); });
  });
}

const Formulation& FormulationChoices::unactuated_base() {
  return unactuated_base_.get([&] {
    if (original_) return with_representatives(original_->unactuated_base());
    return searched(newton_euler(), [](Trace& trace, const Formulation& f) {
      trace_unactuated_base_inverse_dynamics(trace, Loads::gravity, f);
    });
  });
}

const Formulation& FormulationChoices::inertia() {
  return inertia_.get([&] {
    if (original_) return with_representatives(original_->inertia());
    return searched(common_, [](Trace& trace, const Formulation& f) { trace_joint_space_inertia(trace, f); });
  });
}

const Formulation& FormulationChoices::inverse_dynamics_derivatives() {
  return inverse_dynamics_derivatives_.get([&] {
    if (original_) return with_representatives(original_->inverse_dynamics_derivatives());
    return searched(newton_euler(), [&](Trace& trace, const Formulation& f) {
      trace_inverse_dynamics_derivatives(trace, default_loads(tree()), f);
    });
  });
}

const ForwardDynamicsChoice& FormulationChoices::forward_dynamics() {
  return forward_dynamics_.get([&] {
    if (!original_) return forward_dynamics_choice(tree(), common_);
    ForwardDynamicsChoice choice = original_->forward_dynamics();
    choice.formulation = with_representatives(choice.formulation);
    return choice;
  });
}

Formulation FormulationChoices::cheaper_for(const std::function<symbolic::Program(const Formulation&)>& trace) {
  const auto work = [&](Formulation formulation) {
    formulation.is_draft = true;
    formulation.representative.clear();
    return symbolic::work(trace(formulation));
  };
  return work(newton_euler()) < work(common_) ? newton_euler() : common_;
}

}  // namespace robcogen::algorithm
