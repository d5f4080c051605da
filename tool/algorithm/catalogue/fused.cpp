#include "algorithm/catalogue/fused.h"

#include <algorithm>
#include <optional>
#include <stdexcept>
#include <utility>

#include "algorithm/catalogue/find.h"
#include "algorithm/catalogue/phrases.h"
#include "algorithm/catalogue/tracing.h"
#include "support/concat.h"
#include "symbolic/cost.h"
#include "symbolic/fuse.h"

namespace robcogen::algorithm {
namespace {

using symbolic::Program;
using symbolic::Role;

const Declaration& declaration_of_lists() {
  static const Declaration declaration = [] {
    Declaration d{.name = ""};
    d.group = kFusedGroup;
    return d;
  }();
  return declaration;
}

// The overload of a part in an overload of the whole: the one with the most loads among these.
const Declared& with_loads(const std::vector<Declared>& overloads, Loads loads) {
  const auto takes_more = [&](const Declared& f) { return f.subject.loads > loads; };
  const auto end = std::find_if(overloads.begin() + 1, overloads.end(), takes_more);
  return *(end - 1);
}

// The name of a part among the others: its own, or with the scope that distinguishes it.
std::string name_among(const std::vector<Declared>& parts, const Declared& part) {
  const bool is_alone =
      std::count_if(parts.begin(), parts.end(), [&](const Declared& other) { return other.name == part.name; }) == 1;
  return (is_alone ? "" : catalogue::prefix_of(part.is->scope)) + part.name;
}

// Names the results of the parts: `joint_space_inertia`; `bias_forces_tau` and `bias_forces_base_wrench`, of a part
// with several. A structure of several results has no place for what belongs to the only one of a function: columns of
// a Jacobian, and the object that has a factor.
void name_results(const std::vector<Declared>& parts, std::vector<Program>& programs) {
  for (std::size_t k = 0; k < parts.size(); ++k) {
    const std::string name = name_among(parts, parts[k]);
    for (symbolic::OutputArray& array : programs[k].outputs) {
      array.name = programs[k].outputs.size() == 1 ? name : name + "_" + array.name;
      if (symbolic::is_jacobian(array.role) || array.role == Role::inertia_factor) array.role = Role::matrix;
      if (array.role == Role::inverse_diagonal) array.role = Role::value;
    }
  }
}

// How the parts are traced.
struct Way {
  FormulationChoices& choices;
  // For all parts whose programs depend on a formulation; nullptr: each has its own.
  const Formulation* common;
  // The loads of the part bias_forces, from whose motions of links biases follow; nullopt: they have ways of their own.
  std::optional<Loads> from_bias_forces = {};
};

bool is_bias_forces(const Declared& function) {
  return function.is->scope == std::string() && function.is->name == std::string("bias_forces");
}

bool may_join_frames(const Declared& function) {
  const model::KinematicTree& tree = function.subject.tree;
  return function.is->joins_frames && tree.floating_base && !tree.has_rotors();
}

bool may_follow_from_bias_forces(const Declared& function) {
  const std::optional<FromBiasForces>& other = function.is->from_bias_forces;
  return other && (other->applies == nullptr || other->applies(function.subject));
}

// The other one if it costs less.
Program with_fewest_operations(Program program, std::optional<Program> other) {
  return other && symbolic::work(*other) < symbolic::work(program) ? std::move(*other) : std::move(program);
}

// The program of the parts in one, if there is such.
std::optional<Program> together(const Declared& function, FormulationChoices& choices) {
  if (function.is->together == nullptr) return std::nullopt;
  std::optional<Program> program = function.is->together(catalogue::tracing_of(function, choices));
  const Program outline = catalogue::fused_outline(function);
  for (std::size_t k = 0; program && k < outline.outputs.size(); ++k)
    program->outputs[k].name = outline.outputs[k].name;
  return program;
}

Program program_of(const Declared& function, const Way& way) {
  if (!function.parts.empty()) {
    std::vector<Program> programs;
    for (const Declared& part : function.parts) programs.push_back(program_of(part, way));
    name_results(function.parts, programs);
    return with_fewest_operations(symbolic::fused(function.kernel, programs), together(function, way.choices));
  }
  const auto& [choices, common, from_bias_forces] = way;
  const Loads own = function.subject.loads;
  if (from_bias_forces && may_follow_from_bias_forces(function))
    return function.is->from_bias_forces->trace(
        catalogue::joined_tracing(function, choices, common ? *common : choices.newton_euler(), *from_bias_forces));
  if (common && may_join_frames(function))
    return function.is->program.trace(catalogue::joined_tracing(function, choices, *common, own));
  return function.is->program.trace(
      common && is_formulated(function) ? catalogue::tracing_of(function, choices, *common)
                                        : catalogue::tracing_of(function, choices));
}

// The cheaper of two programs: biases have ways of their own, or follow from the motions of links in bias_forces.
Program cheaper_program_of(const Declared& function, FormulationChoices& choices, const Formulation* common) {
  Program program = program_of(function, {choices, common});
  const auto bias_forces = std::find_if(function.parts.begin(), function.parts.end(), is_bias_forces);
  if (bias_forces == function.parts.end()) return program;
  if (std::none_of(function.parts.begin(), function.parts.end(), may_follow_from_bias_forces)) return program;
  return with_fewest_operations(
      std::move(program), program_of(function, {choices, common, bias_forces->subject.loads}));
}

void add_searches(const Declared& function, std::vector<Search>& searches) {
  if (function.parts.empty() && is_formulated(function)) searches.push_back(function.is->program.search);
  for (const Declared& part : function.parts) add_searches(part, searches);
}

// What a part computes, in a line; its Jacobian does not say whose columns it has.
std::string line_of(const std::string& name, const symbolic::Function& part, const model::KinematicTree& tree) {
  std::string line = "`" + name + "`: " + (part.summary.empty() ? "" : part.summary.front());
  if (part.columns.empty()) return line;
  std::vector<std::string> joints;
  const std::vector<int> coordinates = tree.coordinates();
  for (const int column : part.columns) joints.push_back(tree.joints[at(coordinates[at(column)])].name);
  return line + " Columns: " + joined(joints) + ".";
}

}  // namespace

std::vector<std::vector<Declared>> fused_functions(
    const model::KinematicTree& tree,
    const model::DesiredTransforms& desired) {
  std::vector<std::vector<Declared>> list;
  for (const model::FusedFunction& function : desired.functions) {
    std::vector<std::vector<Declared>> parts;
    for (const model::FusedFunction::Part& part : function.parts) {
      parts.push_back(find_function(tree, desired, part.function));
      if (parts.back().empty()) throw std::logic_error("no function '" + part.function + "'");
    }
    const Subject subject{tree, desired.contacts};
    list.push_back(catalogue::fused_overloads(declaration_of_lists(), subject, function.name, parts));
  }
  return list;
}

namespace catalogue {

std::vector<Declared> fused_overloads(
    const Declaration& declaration,
    const Subject& subject,
    const std::string& name,
    const std::vector<std::vector<Declared>>& parts) {
  const auto most = std::max_element(parts.begin(), parts.end(), [](const auto& a, const auto& b) {
    return a.back().subject.loads < b.back().subject.loads;
  });
  std::vector<Declared> list;
  for (const Declared& overload : *most) {
    Declared& function = list.emplace_back(Declared{&declaration, subject, name, {}, {}});
    function.subject.loads = overload.subject.loads;
    function.kernel = name + suffix_of(function.subject);
    for (const std::vector<Declared>& overloads : parts)
      function.parts.push_back(with_loads(overloads, function.subject.loads));
  }
  return list;
}

Program fused_outline(const Declared& function) {
  std::vector<Program> outlines;
  for (const Declared& part : function.parts) outlines.push_back(outline(part));
  name_results(function.parts, outlines);
  return symbolic::fused_outline(function.kernel, outlines);
}

symbolic::Function fused_description(const Declared& function) {
  symbolic::Function result;
  result.group = function.is->group;
  result.name = function.name;
  result.kernel = function.kernel;
  for (const char* text : function.is->summary) result.summary.emplace_back(filled(text, function.subject));
  if (!result.summary.empty()) return result;
  result.summary.emplace_back("Several functions in one call, which computes once what they have in common.");
  for (const Declared& part : function.parts)
    result.summary.push_back(line_of(name_among(function.parts, part), described(part), function.subject.tree));
  const bool has_overloads = std::any_of(function.parts.begin(), function.parts.end(), [](const Declared& part) {
    return part.is->signature.overloads != Overloads::none;
  });
  if (has_overloads) result.summary.emplace_back(remark_on(function.subject.loads));
  return result;
}

symbolic::Function fused_trace(const Declared& function, FormulationChoices& choices) {
  std::vector<Search> searches;
  add_searches(function, searches);
  const auto traced = [&](const Formulation* common) { return cheaper_program_of(function, choices, common); };
  std::optional<Formulation> common;
  if (!searches.empty()) common = choices.common_choice(searches, function.kernel, traced);
  symbolic::Function result = fused_description(function);
  result.program = traced(common ? &*common : nullptr);
  if (common) result.method = description(choices.tree(), common->frames);
  result.derivatives = second_derivatives(result.program);
  int outputs = 0;
  for (const Declared& part : function.parts) {
    result.parts.push_back({part.kernel, outputs});
    outputs += static_cast<int>(outline(part).outputs.size());
  }
  return result;
}

}  // namespace catalogue
}  // namespace robcogen::algorithm
