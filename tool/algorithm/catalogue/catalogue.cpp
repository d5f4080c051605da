#include "algorithm/catalogue/catalogue.h"

#include <algorithm>
#include <array>

#include "algorithm/catalogue/groups.h"
#include "algorithm/catalogue/sizes.h"
#include "support/index.h"

namespace robcogen::algorithm {
namespace {

using model::KinematicTree;

// What a robot must have for a group's functions: a set of these.
enum Needs : unsigned {
  kNothing = 0,
  kInertia = 1 << 0,
  kMass = 1 << 1,            // functions divide by the total mass
  kRegularInertia = 1 << 2,  // functions divide by the joint-space inertia matrix
  kFewPairs = 1 << 4,        // code without loops has a column for each position and velocity
  kFewOperations = 1 << 3,   // code without loops has many right-hand sides
  kFewElements = 1 << 5,     // a matrix has ten columns per link
};

constexpr unsigned kInertiaInverse = kInertia | kRegularInertia;

struct Group {
  const char* name;
  bool is_default;
  unsigned needs;  // of Needs
  // One of these is set.
  std::vector<RobotFunction> (*dynamics)(const KinematicTree&, FormulationChoices&);
  std::vector<RobotFunction> (*kinematics)(const KinematicTree&, const model::DesiredTransforms&);
  std::vector<RobotFunction> (*contacts)(const KinematicTree&, const ContactFrames&, FormulationChoices&) = nullptr;
  // The functions use the bodies, rotors and parameters of the model as they are. (The Coriolis matrix of a robot
  // depends on how its mass is assigned to links.)
  bool is_of_model = false;

  bool has_formulation() const { return kinematics == nullptr; }
  std::vector<RobotFunction> functions(
      const KinematicTree& tree,
      const model::DesiredTransforms& desired,
      FormulationChoices& choices) const {
    if (dynamics) return dynamics(is_of_model ? tree : choices.tree(), choices);
    if (kinematics) return kinematics(tree, desired);
    return desired.contacts.empty() ? std::vector<RobotFunction>()
                                    : contacts(choices.tree(), desired.contacts, choices);
  }
};

constexpr std::array kGroups = {
    Group{"inverse_dynamics", true, kInertia, inverse_dynamics_functions, nullptr},
    Group{"bias_forces", true, kInertia, bias_forces_functions, nullptr},
    Group{"passive_forces", false, kNothing, passive_forces_functions, nullptr, nullptr, true},
    Group{"forward_dynamics", true, kInertiaInverse, forward_dynamics_functions, nullptr},
    Group{"joint_space_inertia", true, kInertia, joint_space_inertia_functions, nullptr},
    Group{"joint_space_inertia_factor", true, kInertiaInverse, joint_space_inertia_factor_functions, nullptr},
    Group{"coriolis_matrix", false, kInertia, coriolis_matrix_functions, nullptr, nullptr, true},
    Group{"inverse_dynamics_derivatives", false, kInertia, inverse_dynamics_derivatives_functions, nullptr},
    Group{"inverse_dynamics_gradient", false, kInertia, inverse_dynamics_gradient_functions, nullptr},
    Group{
        "inverse_dynamics_second_derivatives", false, kInertia | kFewPairs,
        inverse_dynamics_second_derivatives_functions, nullptr},
    Group{
        "forward_dynamics_derivatives", false, kInertiaInverse | kFewOperations, forward_dynamics_derivatives_functions,
        nullptr},
    Group{"centroidal", true, kMass, centroidal_functions, nullptr, nullptr, true},
    Group{"energy", true, kInertia, energy_functions, nullptr},
    Group{"centroidal_bias", false, kMass, centroidal_bias_functions, nullptr, nullptr, true},
    Group{"contacts", false, kInertiaInverse, nullptr, nullptr, contacts_functions},
    Group{
        "constrained_forward_dynamics_derivatives", false, kInertiaInverse | kFewOperations, nullptr, nullptr,
        constrained_forward_dynamics_derivatives_functions},
    Group{"operational_space", false, kInertiaInverse, nullptr, nullptr, operational_space_functions},
    Group{"regressor", false, kFewElements, regressor_functions, nullptr, nullptr, true},
    Group{"base_regressor", false, kFewElements, base_regressor_functions, nullptr, nullptr, true},
    Group{"energy_regressor", false, kNothing, energy_regressor_functions, nullptr, nullptr, true},
    Group{"slotine_li_regressor", false, kFewElements, slotine_li_regressor_functions, nullptr, nullptr, true},
    Group{"transforms", true, kNothing, nullptr, transforms_functions},
    Group{"jacobians", true, kNothing, nullptr, jacobians_functions},
    Group{"jacobian_references", false, kNothing, nullptr, jacobian_references_functions},
    Group{"jacobians_with_base", false, kNothing, nullptr, jacobians_with_base_functions},
    Group{"jacobian_derivatives", false, kNothing, nullptr, jacobian_derivatives_functions},
    Group{"velocities", false, kNothing, nullptr, velocities_functions},
    Group{"accelerations", false, kNothing, nullptr, accelerations_functions},
    Group{"world", false, kNothing, nullptr, world_functions},
    Group{"world_centroidal", false, kMass, world_centroidal_functions, nullptr, nullptr, true}};

const Group* group_of(const std::string& name) {
  const auto found =
      std::find_if(kGroups.begin(), kGroups.end(), [&](const Group& group) { return group.name == name; });
  return found == kGroups.end() ? nullptr : &*found;
}

// The program without a loop, which `eval` runs, would take too long to build.
bool has_many_operations(const KinematicTree& tree) {
  constexpr long kMany = 600'000;
  return operations_of_solutions(tree) > kMany;
}

// Second derivatives take about a hundred operations for each such pair.
bool has_many_pairs(const KinematicTree& tree) {
  constexpr long kMany = 150;
  return pairs_of_coordinates(tree) > kMany;
}

// Generated functions return their results by value, and larger ones would not fit the stack: 128 KB, which is also
// Eigen's limit.
bool has_many_elements(const KinematicTree& tree) {
  constexpr int kMany = 16'000;
  const int base = tree.floating_base ? 6 : 0, links = tree.link_count() - (base > 0 ? 0 : 1);
  return (base + tree.dof()) * 10 * links > kMany;
}

struct Requirement {
  Needs need;
  bool (*is_met)(const KinematicTree&);
  const char* reason;
  bool is_of_masses = false;  // diagnostics of the mass properties give the reason, too
};

constexpr std::array kRequirements = {
    Requirement{
        kInertia, [](const KinematicTree& tree) { return !tree.inertia_defects.no_inertia; },
        "no link that moves has mass properties", true},
    Requirement{
        kMass, [](const KinematicTree& tree) { return !tree.inertia_defects.no_mass; },
        "the links that move have no mass", true},
    Requirement{
        kRegularInertia, [](const KinematicTree& tree) { return !tree.inertia_defects.is_singular(); },
        "its joint-space inertia matrix is singular", true},
    Requirement{
        kFewPairs, [](const KinematicTree& tree) { return !has_many_pairs(tree); },
        "with so many joints its code without loops would outgrow the caches of processors"},
    Requirement{
        kFewOperations, [](const KinematicTree& tree) { return !has_many_operations(tree); },
        "with so many joints its code would be too long"},
    Requirement{
        kFewElements, [](const KinematicTree& tree) { return !has_many_elements(tree); },
        "with ten columns for each of so many links its matrix would have more than 16,000 elements, too many for the "
        "stacks of threads"}};

bool lacks(const KinematicTree& tree, const Group& group, const Requirement& requirement) {
  return (group.needs & requirement.need) != 0 && !requirement.is_met(tree);
}

// Adds a remark to derivatives by positions, some of which are quaternions.
void add_turns_remark(std::vector<RobotFunction>& list) {
  for (RobotFunction& f : list) {
    const auto& outputs = f.program.outputs;
    if (std::any_of(outputs.begin(), outputs.end(), [](const auto& of) { return of.name == "d_q"; }))
      f.summary.emplace_back(
          "The position of a spherical joint has one column for a rotation (rad) about each axis of its child.");
  }
}

bool is_available(const Group& group, const KinematicTree& tree) {
  return std::none_of(
      kRequirements.begin(), kRequirements.end(), [&](const Requirement& r) { return lacks(tree, group, r); });
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

const std::vector<std::string>& groups_of_contacts() {
  static const std::vector<std::string> names =
      names_of_groups([](const Group& group) { return group.contacts != nullptr; });
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

std::string reason_of_absence(const KinematicTree& tree, const std::string& group, Reasons reasons) {
  const Group* found = group_of(group);
  if (!found) return "";
  const auto lacking = std::find_if(kRequirements.begin(), kRequirements.end(), [&](const Requirement& r) {
    return (reasons == Reasons::all || !r.is_of_masses) && lacks(tree, *found, r);
  });
  return lacking == kRequirements.end() ? "" : lacking->reason;
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
  std::vector<RobotFunction> list = found->functions(tree, desired, choices);
  if (!tree.spherical_joints().empty()) add_turns_remark(list);
  return list;
}

std::vector<symbolic::Program> plain_programs(
    const KinematicTree& tree,
    const model::DesiredTransforms& desired,
    const std::string& group) {
  const Group* found = group_of(group);
  if (!found || !found->has_formulation() || !is_available(*found, tree)) return {};
  Formulation plain = plain_formulation();
  plain.is_draft = true;
  FormulationChoices choices(tree, plain);
  std::vector<symbolic::Program> programs;
  for (RobotFunction& f : found->functions(tree, desired, choices)) programs.push_back(std::move(f.program));
  return programs;
}

bool folds_like_others(const symbolic::Program& program) {
  return std::any_of(program.constants.begin(), program.constants.end(), [](const symbolic::Constant& c) {
    return !c.folds_as_itself();
  });
}

std::vector<std::optional<symbolic::Program>> congruent_programs(
    const KinematicTree& tree,
    const model::DesiredTransforms& desired,
    const std::string& group,
    FormulationChoices& for_congruent_limbs) {
  const Group* found = group_of(group);
  if (!found || !found->has_formulation() || !is_available(*found, tree)) return {};
  std::vector<std::optional<symbolic::Program>> programs;
  for (RobotFunction& f : found->functions(tree, desired, for_congruent_limbs)) {
    const bool is_other = folds_like_others(f.program);
    programs.push_back(is_other ? std::optional(std::move(f.program)) : std::nullopt);
  }
  return programs;
}

}  // namespace robcogen::algorithm
