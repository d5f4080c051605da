#include "algorithm/catalogue/catalogue.h"

#include <algorithm>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "algorithm/catalogue/arrays.h"
#include "algorithm/catalogue/find.h"
#include "algorithm/catalogue/fused.h"
#include "algorithm/catalogue/phrases.h"
#include "algorithm/catalogue/sizes.h"
#include "algorithm/catalogue/tracing.h"
#include "algorithm/kinematics/kinematics.h"
#include "support/parallel.h"

namespace robcogen::algorithm {

using model::Frame;
using model::FramePair;
using model::KinematicTree;

namespace catalogue {

std::string prefix_of(const std::string& scope) {
  static const std::map<std::string, std::string> prefixes = {
      {"inertia_factor", "inertia_factor_"},
      {"transforms::homogeneous", "homogeneous_"},
      {"transforms::motion", "motion_"},
      {"transforms::force", "force_"},
      {"jacobians::in_target", "in_target_"},
      {"jacobians::spatial", "spatial_"},
      {"jacobians::with_base", "with_base_"},
      {"world", "in_world_"},
      {"world::in_target", "world_in_target_"},
      {"inverse_kinematics", "inverse_kinematics_"},
      {"inverse_kinematics::branch", "inverse_kinematics_branch_"},
      {"inverse_kinematics::configuration", "inverse_kinematics_configuration_"},
      {"inverse_kinematics::redundancy", "inverse_kinematics_redundancy_"}};
  const auto prefix = prefixes.find(scope);
  return prefix == prefixes.end() ? "" : prefix->second;
}

const char* suffix_of(const Subject& subject) {
  if (subject.loads == Loads::gravity_and_external) return "_external";
  return subject.loads == Loads::standard_gravity || subject.tree.floating_base ? "" : "_gravity";
}

const char* remark_on(Loads loads) {
  switch (loads) {
    case Loads::standard_gravity:
      return "Gravity is (0, 0, -9.81) m/s^2 in base coordinates.";
    case Loads::gravity:
      return "`gravity` (m/s^2) is in base coordinates.";
    case Loads::gravity_and_external:
      break;
  }
  return "`gravity` (m/s^2) is in base coordinates; `external` is the wrench on each link, in link coordinates about "
         "the link's origin.";
}

std::vector<symbolic::DerivativeBlock> second_derivatives(const symbolic::Program& program) {
  std::vector<symbolic::DerivativeBlock> blocks;
  const auto index = [&](std::size_t k) { return static_cast<int>(k); };
  for (std::size_t place = 0; place < program.outputs.size(); ++place)
    for (std::size_t of = 0; of < place; ++of)
      for (const symbolic::InputArray& input : program.inputs)
        if (program.outputs[place].name == program.outputs[of].name + "_" + input.name)
          blocks.push_back({index(of), input.name, index(place)});
  return blocks;
}

namespace {

Tracing tracing_with(const Declared& function, FormulationChoices& choices, Loads loads, ForwardDynamicsChoice choice) {
  const auto& [is, subject, name, kernel, parts] = function;
  const bool is_of_model = is->program.search == Search::none || is->is_of_model;
  const KinematicTree& tree = is_of_model ? choices.model() : choices.tree();
  return {
      {tree, subject.contacts, subject.frames, loads, {}, subject.task}, is->scope, kernel, std::move(choice), choices};
}

}  // namespace

Tracing tracing_of(const Declared& function, FormulationChoices& choices) {
  const Source& program = function.is->program;
  // Formulations are compared for the same loads, whatever those of the overload.
  const Loads compared = program.search == Search::cheapest ? default_loads(choices.tree()) : Loads::gravity;
  return tracing_with(
      function, choices, function.subject.loads,
      choices.choice(program.search, function.name, [&](const Formulation& formulation) {
        return program.trace(tracing_with(function, choices, compared, {{}, formulation}));
      }));
}

Tracing joined_tracing(const Declared& function, FormulationChoices& choices, const Formulation& given, Loads loads) {
  return {
      {choices.tree(), function.subject.contacts, function.subject.frames, loads, {}, function.subject.task},
      function.is->scope,
      function.kernel,
      {{}, given},
      choices};
}

Tracing tracing_of(const Declared& function, FormulationChoices& choices, const Formulation& given) {
  ForwardDynamicsChoice choice{{}, given};
  if (function.is->program.search == Search::forward_dynamics) choice.method = choices.forward_dynamics().method;
  return tracing_with(function, choices, function.subject.loads, std::move(choice));
}

}  // namespace catalogue

using catalogue::tracing_of;

namespace {

std::vector<Declaration> all_declarations() {
  std::vector<Declaration> all;
  for (const auto& rows :
       {catalogue::dynamics_declarations, catalogue::derivative_declarations, catalogue::contact_declarations,
        catalogue::identification_declarations, catalogue::kinematics_declarations, catalogue::world_declarations,
        catalogue::mechanism_declarations, catalogue::collision_declarations})
    for (GroupRows& of_group : rows())
      for (Declaration& row : of_group.rows) {
        row.group = of_group.group;
        all.push_back(std::move(row));
      }
  const auto place = [](const Declaration& row) {
    return std::find(groups().begin(), groups().end(), row.group) - groups().begin();
  };
  std::stable_sort(
      all.begin(), all.end(), [&](const Declaration& a, const Declaration& b) { return place(a) < place(b); });
  return all;
}

bool exists(Condition condition, const Subject& subject) {
  return condition == nullptr || condition(subject);
}

// Each frame of the pairs once, with the frame of the base on the left.
std::vector<FramePair> seen_from_base(
    const KinematicTree& tree,
    const std::vector<const std::vector<FramePair>*>& lists,
    const std::vector<model::ContactFrame>& contacts) {
  std::vector<FramePair> pairs;
  std::set<std::string> seen;
  const Frame base = tree.frames().front();
  const auto add = [&](const Frame& frame) {
    if (seen.insert(frame.name).second) pairs.push_back({base, frame});
  };
  for (const std::vector<FramePair>* list : lists)
    for (const FramePair& pair : *list) add(pair.left), add(pair.right);
  for (const model::ContactFrame& contact : contacts) add(contact.frame);
  return pairs;
}

// The desired frames of functions of this kind.
std::vector<FramePair> desired_frames(Of of, const KinematicTree& tree, const model::DesiredTransforms& desired) {
  switch (of) {
    case Of::robot:
      return {FramePair()};
    case Of::contacts:
      return desired.contacts.empty() ? std::vector<FramePair>() : std::vector<FramePair>{FramePair()};
    case Of::transform_pair:
      return desired.transforms;
    case Of::jacobian_pair:
    case Of::base_pair:
      return desired.jacobians;
    case Of::placed_frame:
      return seen_from_base(tree, {&desired.transforms, &desired.jacobians}, desired.contacts);
    case Of::inverse_pair: {
      std::vector<FramePair> pairs;
      for (const model::InverseTarget& target : desired.inverses) pairs.push_back(target.frames);
      return pairs;
    }
    case Of::moving_frame:
      break;
  }
  return seen_from_base(tree, {&desired.jacobians}, desired.contacts);
}

// A pair that is not desired has the default task.
model::InverseTask task_of(const FramePair& frames, const std::vector<model::InverseTarget>& inverses) {
  for (const model::InverseTarget& target : inverses)
    if (target.frames == frames) return target.task;
  return {};
}

std::vector<Loads> loads_of(const Declaration& declaration, const KinematicTree& tree) {
  if (declaration.signature.overloads == Overloads::none) return {default_loads(tree)};
  std::vector<Loads> list;
  if (!tree.floating_base) list.push_back(Loads::standard_gravity);
  list.push_back(Loads::gravity);
  if (declaration.signature.overloads == Overloads::gravity_and_external) list.push_back(Loads::gravity_and_external);
  return list;
}

std::vector<std::string> summary_of(const Declaration& declaration, const Subject& subject) {
  std::vector<std::string> lines;
  const auto add = [&](const char* text) {
    std::string line = catalogue::filled(text, subject);
    if (!line.empty()) lines.push_back(std::move(line));
  };
  for (const char* text : declaration.summary) add(text);
  if (declaration.signature.overloads != Overloads::none) add(catalogue::remark_on(subject.loads));
  for (const char* text : declaration.remarks) add(text);
  const bool is_by_positions = std::any_of(
      declaration.signature.outputs.begin(), declaration.signature.outputs.end(),
      [](const Array& a) { return a.name == std::string("d_q"); });
  if (is_by_positions && catalogue::has_spherical_joints(subject))
    add("The position of a spherical joint has one column for a rotation (rad) about each axis of its child.");
  return lines;
}

std::string method_of(const Declaration& declaration, const Tracing& t) {
  if (declaration.program.search == Search::none || declaration.method == Method::none) return "";
  const std::string frames = description(t.tree, t.choice.formulation.frames);
  if (declaration.method == Method::frames) return frames;
  const bool by_matrix = t.choice.method == ForwardDynamicsMethod::inertia_matrix;
  return std::string(
             by_matrix ? "Method: bias forces, and elimination in the joint-space inertia matrix."
                       : "Method: articulated-body algorithm.") +
         (frames.empty() ? "" : " " + frames);
}

std::vector<std::string> groups_with(bool (*is_kind)(Of)) {
  std::vector<std::string> names;
  for (const Declaration& row : declarations())
    if (is_kind(row.of) && (names.empty() || names.back() != row.group)) names.emplace_back(row.group);
  return names;
}

}  // namespace

const std::vector<Declaration>& declarations() {
  static const std::vector<Declaration> all = all_declarations();
  return all;
}

bool mentions_collisions(const std::string& text) {
  return std::any_of(declarations().begin(), declarations().end(), [&](const Declaration& row) {
    return row.group == std::string(kCollisionGroup) && text.find(row.name) != std::string::npos;
  });
}

const std::vector<std::string>& groups_of_contacts() {
  static const std::vector<std::string> names = groups_with([](Of of) { return of == Of::contacts; });
  return names;
}

const std::vector<std::string>& groups_between_frames() {
  static const std::vector<std::string> names =
      groups_with([](Of of) { return of != Of::robot && of != Of::contacts && of != Of::inverse_pair; });
  return names;
}

bool is_of(const Declaration& declaration, const Subject& subject) {
  const KinematicTree& tree = subject.tree;
  const Frame& right = subject.frames.right;
  switch (declaration.of) {
    case Of::contacts:
      if (subject.contacts.empty()) return false;
      break;
    case Of::base_pair:
      if (tree.link_of(subject.frames.left) != 0) return false;
      break;
    case Of::moving_frame:
      if (!tree.floating_base && tree.link_of(right) == 0) return false;
      [[fallthrough]];
    case Of::placed_frame:
      if (right.name == tree.frames().front().name) return false;
      break;
    default:
      break;
  }
  return exists(declaration.exists, subject);
}

Subject subject_of(
    const KinematicTree& tree,
    const ContactFrames& contacts,
    const std::vector<model::InverseTarget>& inverses,
    const FramePair& frames) {
  return {tree, contacts, frames, Loads::gravity, {}, task_of(frames, inverses)};
}

std::vector<Declared> overloads(const Declaration& declaration, const Subject& subject) {
  const std::string name = catalogue::filled(declaration.name, subject);
  if (declaration.parts) {
    std::vector<std::vector<Declared>> parts;
    for (const std::string& part : declaration.parts(subject))
      parts.push_back(find_function(subject.tree, subject.contacts, part));
    return catalogue::fused_overloads(declaration, subject, name, parts);
  }
  std::vector<Declared> list;
  for (const Loads loads : loads_of(declaration, subject.tree)) {
    Declared function{&declaration, subject, name, {}, {}};
    function.subject.loads = loads;
    const bool has_suffix = declaration.signature.overloads != Overloads::none;
    function.kernel =
        catalogue::prefix_of(declaration.scope) + name + (has_suffix ? catalogue::suffix_of(function.subject) : "");
    list.push_back(std::move(function));
  }
  return list;
}

std::vector<Declared> declared(
    const KinematicTree& tree,
    const model::DesiredTransforms& desired,
    const std::string& group) {
  std::vector<Declared> list;
  if (!is_available(tree, group)) return list;
  if (group == kFusedGroup)
    for (std::vector<Declared>& function : fused_functions(tree, desired))
      for (Declared& overload : function) list.push_back(std::move(overload));
  for (const Declaration& declaration : declarations()) {
    if (declaration.group != group) continue;
    for (const FramePair& frames : desired_frames(declaration.of, tree, desired)) {
      const Subject subject = subject_of(tree, desired.contacts, desired.inverses, frames);
      if (!is_of(declaration, subject)) continue;
      for (Declared& function : overloads(declaration, subject)) list.push_back(std::move(function));
    }
  }
  return list;
}

symbolic::Program outline(const Declared& function) {
  if (!function.parts.empty()) return catalogue::fused_outline(function);
  const Signature& signature = function.is->signature;
  const Subject& subject = function.subject;
  symbolic::Program program;
  program.name = function.kernel;
  std::vector<Array> inputs = signature.inputs;
  if (signature.overloads != Overloads::none) inputs.insert(inputs.end(), {catalogue::gravity, catalogue::external});
  // An inertia factor includes the parameters.
  if (!subject.tree.parameters.empty() && (inputs.empty() || inputs.front().role != symbolic::Role::inertia_factor))
    program.inputs.push_back(
        {"parameters", symbolic::Role::parameters, std::vector<std::string>(subject.tree.parameters.size())});
  const auto size = [&](Size of) { return of == nullptr ? 1 : of(subject); };
  for (const Array& array : inputs)
    if (exists(array.exists, subject))
      program.inputs.push_back(
          {array.name, array.role,
           std::vector<std::string>(static_cast<std::size_t>(size(array.rows) * size(array.columns)))});
  for (const Array& array : signature.outputs)
    if (exists(array.exists, subject))
      program.outputs.push_back({array.name, array.role, size(array.rows), size(array.columns), {}});
  return program;
}

symbolic::Function described(const Declared& function) {
  if (!function.parts.empty()) return catalogue::fused_description(function);
  const auto& [is, subject, name, kernel, parts] = function;
  symbolic::Function result;
  result.group = is->group;
  result.scope = is->scope;
  result.name = name;
  result.kernel = kernel;
  result.summary = summary_of(*is, subject);
  result.left = subject.frames.left.name;
  result.right = subject.frames.right.name;
  if (is->signature.outputs.front().name == std::string("sin_q"))
    result.row_joints = chain_coordinates(subject.tree, subject.frames);
  if (symbolic::is_jacobian(is->signature.outputs.front().role))
    result.columns = chain_coordinates(subject.tree, subject.frames);
  if (is->labels) result.labels = is->labels(subject);
  return result;
}

symbolic::Function trace(const Declared& function, FormulationChoices& choices) {
  if (!function.parts.empty()) return catalogue::fused_trace(function, choices);
  const Declaration& is = *function.is;
  const Tracing t = tracing_of(function, choices);
  Declared chosen = function;
  if (is.program.search == Search::forward_dynamics) chosen.subject.method = t.choice.method;
  symbolic::Function result = described(chosen);
  result.program = is.program.trace(t);
  result.method = method_of(is, t);
  result.derivatives = catalogue::second_derivatives(result.program);
  const long operations = is.in_columns ? is.in_columns->operations(function.subject) : 0;
  if (is.in_columns && is.in_columns->is_better(operations)) {
    result.solved = is.in_columns->trace(t);
    result.solved->is_long = are_long_solutions(operations);
  }
  return result;
}

bool is_formulated(const Declared& function) {
  if (!function.parts.empty()) return std::any_of(function.parts.begin(), function.parts.end(), is_formulated);
  return function.is->program.search != Search::none;
}

bool may_fold_like_others(const Declared& function, FormulationChoices& choices) {
  if (!function.parts.empty())
    return std::any_of(function.parts.begin(), function.parts.end(), [&](const Declared& part) {
      return may_fold_like_others(part, choices);
    });
  const Of of = function.is->of;
  return (of == Of::robot || of == Of::contacts) &&
         !tracing_of(function, choices).choice.formulation.representative.empty();
}

std::vector<symbolic::Function> functions(
    const KinematicTree& tree,
    const model::DesiredTransforms& desired,
    const std::string& group,
    FormulationChoices& choices) {
  const std::vector<Declared> list = declared(tree, desired, group);
  std::vector<symbolic::Function> result(list.size());
  for_each_index(list.size(), [&](std::size_t k) { result[k] = trace(list[k], choices); });
  return result;
}

std::vector<symbolic::Function> functions(
    const KinematicTree& tree,
    const model::DesiredTransforms& desired,
    const std::string& group,
    const Formulation& formulation) {
  FormulationChoices choices(tree, formulation);
  return functions(tree, desired, group, choices);
}

bool folds_like_others(const symbolic::Program& program) {
  return std::any_of(program.constants.begin(), program.constants.end(), [](const symbolic::Constant& c) {
    return !c.folds_as_itself();
  });
}

}  // namespace robcogen::algorithm
