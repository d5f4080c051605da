#include "algorithm/catalogue/catalogue.h"

#include <algorithm>
#include <array>

#include "algorithm/catalogue/groups.h"
#include "support/index.h"

namespace robcogen::algorithm {
namespace {

using model::KinematicTree;

// What a group's functions take from the mass properties.
enum class Needs {
  nothing,
  inertia,          // some
  mass,             // they divide by the total mass
  inertia_inverse,  // they divide by the joint-space inertia matrix
  free_joints,      // some, and the recursion knows neither rotors nor couplings
  many_solutions,   // both, for many right-hand sides in code without loops
};

struct Group {
  const char* name;
  bool is_default;
  Needs needs;
  // One of these.
  std::vector<RobotFunction> (*dynamics)(const KinematicTree&, FormulationChoices&);
  std::vector<RobotFunction> (*kinematics)(const KinematicTree&, const model::DesiredTransforms&);
};

constexpr std::array kGroups = {
    Group{"inverse_dynamics", true, Needs::inertia, inverse_dynamics_functions, nullptr},
    Group{"bias_forces", true, Needs::inertia, bias_forces_functions, nullptr},
    Group{"passive_forces", false, Needs::nothing, passive_forces_functions, nullptr},
    Group{"forward_dynamics", true, Needs::inertia_inverse, forward_dynamics_functions, nullptr},
    Group{"joint_space_inertia", true, Needs::inertia, joint_space_inertia_functions, nullptr},
    Group{"joint_space_inertia_factor", true, Needs::inertia_inverse, joint_space_inertia_factor_functions, nullptr},
    Group{"coriolis_matrix", false, Needs::inertia, coriolis_matrix_functions, nullptr},
    Group{"inverse_dynamics_derivatives", false, Needs::free_joints, inverse_dynamics_derivatives_functions, nullptr},
    Group{"inverse_dynamics_gradient", false, Needs::inertia, inverse_dynamics_gradient_functions, nullptr},
    Group{
        "forward_dynamics_derivatives", false, Needs::many_solutions, forward_dynamics_derivatives_functions, nullptr},
    Group{"centroidal", true, Needs::mass, centroidal_functions, nullptr},
    Group{"energy", true, Needs::inertia, energy_functions, nullptr},
    Group{"transforms", true, Needs::nothing, nullptr, transforms_functions},
    Group{"jacobians", true, Needs::nothing, nullptr, jacobians_functions},
    Group{"jacobian_references", false, Needs::nothing, nullptr, jacobian_references_functions},
    Group{"jacobian_derivatives", false, Needs::nothing, nullptr, jacobian_derivatives_functions},
    Group{"velocities", false, Needs::nothing, nullptr, velocities_functions},
    Group{"accelerations", false, Needs::nothing, nullptr, accelerations_functions}};

const Group* group_of(const std::string& name) {
  const auto found =
      std::find_if(kGroups.begin(), kGroups.end(), [&](const Group& group) { return group.name == name; });
  return found == kGroups.end() ? nullptr : &*found;
}

// A product and a sum, there and back, for each pair of a coordinate and one that carries it, and each right-hand side.
// More would outgrow the caches for instructions.
bool has_many_operations(const KinematicTree& tree) {
  constexpr long kMany = 32'000;
  std::vector<long> carrying(tree.joints.size());
  long pairs = tree.floating_base ? 15 : 0;
  for (const int j : tree.topological()) {
    const int parent = tree.parent_joint_of(j);
    carrying[at(j)] = parent < 0 ? (tree.floating_base ? 6 : 0) : carrying[at(parent)] + 1;
    pairs += carrying[at(j)];
  }
  return 4 * pairs * (3 * tree.dof() + (tree.floating_base ? 3 : 0)) > kMany;
}

bool has_rotors(const KinematicTree& tree) {
  return std::any_of(
      tree.joints.begin(), tree.joints.end(), [](const model::Joint& joint) { return joint.drive.rotor.has_value(); });
}

bool is_available(const Group& group, const KinematicTree& tree) {
  const model::InertiaDefects& defects = tree.inertia_defects;
  switch (group.needs) {
    case Needs::nothing:
      return true;
    case Needs::inertia:
      return !defects.no_inertia;
    case Needs::mass:
      return !defects.no_mass;
    case Needs::inertia_inverse:
      return !defects.no_inertia && !defects.is_singular();
    case Needs::free_joints:
      return !defects.no_inertia && !has_rotors(tree) && tree.couplings.empty();
    case Needs::many_solutions:
      return !defects.no_inertia && !defects.is_singular() && !has_rotors(tree) && tree.couplings.empty() &&
             !has_many_operations(tree);
  }
  return true;
}

template <class Condition>
std::vector<std::string> names_of_groups(Condition condition) {
  std::vector<std::string> names;
  for (const Group& group : kGroups)
    if (condition(group)) names.emplace_back(group.name);
  return names;
}

}  // namespace

const std::vector<std::string>& groups() {
  static const std::vector<std::string> names = names_of_groups([](const Group&) { return true; });
  return names;
}

const std::vector<std::string>& default_groups() {
  static const std::vector<std::string> names = names_of_groups([](const Group& group) { return group.is_default; });
  return names;
}

const std::vector<std::string>& groups_between_frames() {
  static const std::vector<std::string> names =
      names_of_groups([](const Group& group) { return group.kinematics != nullptr; });
  return names;
}

bool is_available(const KinematicTree& tree, const std::string& group) {
  const Group* found = group_of(group);
  return found && is_available(*found, tree);
}

std::string reason_of_absence(const KinematicTree& tree, const std::string& group) {
  const Group* found = group_of(group);
  if (!found || (found->needs != Needs::free_joints && found->needs != Needs::many_solutions)) return "";
  if (has_rotors(tree)) return "derivatives of robots with rotors are not generated";
  if (!tree.couplings.empty()) return "derivatives of robots with coupled joints are not generated";
  if (found->needs == Needs::many_solutions && has_many_operations(tree))
    return "with so many joints its code without loops would outgrow the caches of processors";
  return "";
}

std::vector<RobotFunction> functions(
    const KinematicTree& tree,
    const model::DesiredTransforms& desired,
    const std::string& group,
    const Formulation& formulation) {
  FormulationChoices choices(tree, formulation);
  return functions(tree, desired, group, choices);
}

std::vector<RobotFunction> functions(
    const KinematicTree& tree,
    const model::DesiredTransforms& desired,
    const std::string& group,
    FormulationChoices& choices) {
  const Group* found = group_of(group);
  if (!found || !is_available(*found, tree)) return {};
  return found->dynamics ? found->dynamics(tree, choices) : found->kinematics(tree, desired);
}

std::vector<symbolic::Program> plain_programs(const KinematicTree& tree, const std::string& group) {
  const Group* found = group_of(group);
  if (!found || !found->dynamics || !is_available(*found, tree)) return {};
  Formulation plain = plain_formulation();
  plain.is_draft = true;
  FormulationChoices choices(tree, plain);
  std::vector<symbolic::Program> programs;
  for (RobotFunction& f : found->dynamics(tree, choices)) programs.push_back(std::move(f.program));
  return programs;
}

std::vector<std::optional<symbolic::Program>> congruent_programs(
    const KinematicTree& tree,
    const std::string& group,
    FormulationChoices& for_congruent_limbs) {
  const Group* found = group_of(group);
  if (!found || !found->dynamics || !is_available(*found, tree)) return {};
  std::vector<std::optional<symbolic::Program>> programs;
  for (RobotFunction& f : found->dynamics(tree, for_congruent_limbs)) {
    const bool is_other = std::any_of(f.program.constants.begin(), f.program.constants.end(), [](const Number& n) {
      return n.typical() != n.value();
    });
    programs.push_back(is_other ? std::optional(std::move(f.program)) : std::nullopt);
  }
  return programs;
}

}  // namespace robcogen::algorithm
