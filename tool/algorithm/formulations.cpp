#include "algorithm/formulations.h"

#include "algorithm/limb_inputs.h"
#include "algorithm/setup.h"
#include "symbolic/count.h"

namespace robcogen::algorithm {

using model::KinematicTree;

Formulation Formulations::searched(const Formulation& start, const TraceOf& trace) const {
  Formulation result = start;
  result.frames = cheap_frames(tree_, start, trace);
  return result;
}

const Formulation& Formulations::newton_euler() {
  return newton_euler_.get([&] {
    return searched(common_, [&](const KinematicTree& part, const Formulation& f) {
      return algorithm::newton_euler(part, "inverse_dynamics", default_loads(tree_), f);
    });
  });
}

const Formulation& Formulations::unactuated_base() {
  return unactuated_base_.get([&] {
    return searched(newton_euler(), [](const KinematicTree& part, const Formulation& f) {
      return unactuated_base_inverse_dynamics(part, "inverse_dynamics", Loads::gravity, f);
    });
  });
}

const Formulation& Formulations::inertia() {
  return inertia_.get([&] {
    return searched(common_, [](const KinematicTree& part, const Formulation& f) {
      return joint_space_inertia(part, "joint_space_inertia", f);
    });
  });
}

std::optional<Formulations> Formulations::with_typical_limbs() const {
  if (!tree_.parameters.empty() || limbs_in_lanes(tree_).empty()) return std::nullopt;
  Formulations result = *this;
  result.typical_of_model_ = typical_links(tree_);
  bool some_differ = !result.typical_of_model_.empty();
  const auto mark = [&](Formulation& formulation) {
    formulation.typical = typical_links(tree_, formulation);
    some_differ = some_differ || !formulation.typical.empty();
  };
  mark(result.common_);
  for (Lazy<Formulation>* found : {&result.newton_euler_, &result.unactuated_base_, &result.inertia_})
    if (found->made()) mark(*found->made());
  if (result.forward_dynamics_.made()) mark(result.forward_dynamics_.made()->formulation);
  return some_differ ? std::optional(std::move(result)) : std::nullopt;
}

Formulation Formulations::cheaper_for(const std::function<symbolic::Program(const Formulation&)>& trace) {
  const auto work = [&](Formulation formulation) {
    formulation.is_draft = true;
    formulation.typical.clear();
    return symbolic::work(trace(formulation));
  };
  return work(newton_euler()) < work(common_) ? newton_euler() : common_;
}

const ForwardDynamicsChoice& Formulations::forward_dynamics() {
  return forward_dynamics_.get([&] { return forward_dynamics_choice(tree_, common_); });
}

}  // namespace robcogen::algorithm
