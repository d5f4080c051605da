#include "algorithm/search/choices.h"

#include <algorithm>
#include <optional>

#include "algorithm/dynamics/traced_robot.h"
#include "algorithm/formulation/rotor_spin.h"
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

namespace {

// Adds a formulation unless one with its frames is in the list.
void add_distinct(std::vector<const Formulation*>& list, const Formulation& f) {
  const bool is_new =
      std::none_of(list.begin(), list.end(), [&](const Formulation* other) { return other->frames == f.frames; });
  if (is_new) list.push_back(&f);
}

// As it is traced to be counted.
Formulation draft_of(Formulation formulation) {
  formulation.is_draft = true;
  formulation.representative.clear();
  return formulation;
}

}  // namespace

Formulation FormulationChoices::cheapest_for(const TraceOfProgram& trace, bool with_inertia) {
  std::vector<const Formulation*> tried = {&common_};
  add_distinct(tried, newton_euler());
  if (with_inertia) add_distinct(tried, inertia());
  if (tried.size() == 1) return common_;
  const Formulation* cheapest = tried.front();
  auto least = symbolic::work(trace(draft_of(*cheapest)));
  for (std::size_t k = 1; k < tried.size(); ++k) {
    const auto other = symbolic::work(trace(draft_of(*tried[k])));
    if (other < least) cheapest = tried[k], least = other;
  }
  return *cheapest;
}

std::optional<Formulation> FormulationChoices::common_choice(
    const std::vector<Search>& searches,
    const std::string& function,
    const TraceOfParts& trace) {
  Lazy<std::optional<Formulation>>* found = nullptr;
  {
    const std::scoped_lock lock(mutex_);
    found = &parts_[function];
  }
  return found->get([&] {
    std::vector<const Formulation*> tried = {&common_};
    for (const Search search : searches) add_distinct(tried, of(search));
    std::optional<Formulation> cheapest = *tried.back();
    if (tried.size() == 1) return cheapest;
    auto least = symbolic::work(trace(nullptr));
    cheapest.reset();
    for (const Formulation* f : tried) {
      const Formulation draft = draft_of(*f);
      const auto other = symbolic::work(trace(&draft));
      if (other <= least) cheapest = *f, least = other;
    }
    return cheapest;
  });
}

const Formulation& FormulationChoices::of(Search search) {
  switch (search) {
    case Search::newton_euler:
      return newton_euler();
    case Search::unactuated_base:
      return unactuated_base();
    case Search::inertia:
      return inertia();
    case Search::inverse_dynamics_derivatives:
      return inverse_dynamics_derivatives();
    case Search::forward_dynamics:
      return forward_dynamics().formulation;
    default:
      return common_;
  }
}

ForwardDynamicsChoice FormulationChoices::choice(
    Search search,
    const std::string& function,
    const TraceOfProgram& trace) {
  const auto with = [](const Formulation& f) { return ForwardDynamicsChoice{{}, f}; };
  switch (search) {
    case Search::none: {
      Formulation of_model = plain_formulation();
      of_model.representative = representative_of_model_;
      return with(of_model);
    }
    case Search::forward_dynamics:
      return forward_dynamics();
    case Search::cheaper:
    case Search::cheapest:
      break;
    default:
      return with(of(search));
  }
  Lazy<Formulation>* found = nullptr;
  {
    const std::scoped_lock lock(mutex_);
    found = &cheapest_[function];
  }
  return with(found->get([&] { return cheapest_for(trace, search == Search::cheapest); }));
}

const symbolic::Program& FormulationChoices::inertia_factor() {
  return inertia_factor_.get(
      [&] { return joint_space_inertia_factor(tree(), "joint_space_inertia_factor", inertia()); });
}

const model::MotionGraph& FormulationChoices::motions() {
  return motions_.get([&] { return std::make_unique<const Motions>(model_); })->graph;
}

}  // namespace robcogen::algorithm
