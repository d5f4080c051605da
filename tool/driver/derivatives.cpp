#include "driver/derivatives.h"

#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <optional>
#include <utility>

#include "algorithm/kinematics/loop_functions.h"
#include "driver/failure.h"
#include "driver/find_function.h"
#include "symbolic/derivative.h"

namespace robcogen::driver {
namespace {

using algorithm::Declared;
using symbolic::DerivativeMode;
using symbolic::Program;
using symbolic::Role;

std::string text_of(const Derivative& derivative) {
  return fmt::format("{}:{}", derivative.function, fmt::join(derivative.inputs, ","));
}

[[noreturn]] void refuse(const Derivative& derivative, const std::string& message, const std::string& hint = "") {
  throw Failure{
      wrong_usage, with_hint(fmt::format("robcogen: error: --derivatives {}: {}", text_of(derivative), message), hint)};
}

bool takes(const Program& program, const std::string& input) {
  if (input == symbolic::kBaseRotation) return symbolic::orientation_of_base(program) != nullptr;
  return std::any_of(
      program.inputs.begin(), program.inputs.end(), [&](const auto& array) { return array.name == input; });
}

bool takes_all(const Program& program, const Derivative& derivative) {
  return std::all_of(derivative.inputs.begin(), derivative.inputs.end(), [&](const std::string& input) {
    return takes(program, input);
  });
}

// Functions are not differentiated with respect to which contacts are active: that input is 0 or 1.
void require_smooth_inputs(const Derivative& derivative, const Program& program) {
  std::vector<std::string> others;
  for (const symbolic::InputArray& array : program.inputs)
    if (array.role != Role::contact_activity) others.push_back(array.name);
  for (const symbolic::InputArray& array : program.inputs)
    if (array.role == Role::contact_activity &&
        std::count(derivative.inputs.begin(), derivative.inputs.end(), array.name) > 0)
      refuse(
          derivative, fmt::format(
                          "the elements of '{}' are switches, 0 or 1; {} also takes {} "
                          "[derivative-by-switches]",
                          array.name, derivative.function, fmt::join(others, ", ")));
}

// `all` have the inputs and outputs of the overloads.
void require_inputs(const Derivative& derivative, const std::vector<Program>& all) {
  std::vector<std::string> known, results;
  for (const Program& program : all) {
    for (const symbolic::InputArray& array : program.inputs)
      if (std::count(known.begin(), known.end(), array.name) == 0) known.push_back(array.name);
    for (const symbolic::OutputArray& array : program.outputs) results.push_back(array.name);
  }
  const std::string arguments = known.empty() ? "none" : fmt::format("{}", fmt::join(known, ", "));
  const bool turns = std::any_of(
      all.begin(), all.end(), [](const Program& program) { return takes(program, symbolic::kBaseRotation); });
  if (turns) known.emplace_back(symbolic::kBaseRotation);
  for (const std::string& input : derivative.inputs) {
    if (std::count(known.begin(), known.end(), input) > 0) continue;
    if (input == symbolic::kBaseRotation)
      refuse(
          derivative, fmt::format(
                          "{} takes {}, neither gravity nor the pose of the base, and does not depend on how the base "
                          "is oriented [no-orientation]",
                          derivative.function, arguments));
    const bool is_result = std::count(results.begin(), results.end(), input) > 0;
    refuse(
        derivative,
        fmt::format(
            "'{}' is {} an argument of {}, which takes {} [unknown-argument]", input,
            is_result ? "a result, not" : "not", derivative.function, arguments),
        is_result ? "" : did_you_mean(input, known));
  }
  for (const Program& program : all) require_smooth_inputs(derivative, program);
  const bool together =
      std::any_of(all.begin(), all.end(), [&](const Program& program) { return takes_all(program, derivative); });
  if (!together) refuse(derivative, fmt::format("no form of {} takes these together", derivative.function));
}

// The suffix of the function's name.
std::string suffix_of(const Derivative& derivative) {
  return fmt::format("_d_{}", fmt::join(derivative.inputs, "_"));
}

// `hint`: for a refusal.
Program differentiated(
    const Program& program,
    const Derivative& derivative,
    DerivativeMode mode,
    const symbolic::FollowerRates& rates,
    const std::string& hint) {
  std::optional<Program> result = symbolic::with_derivatives(program, derivative.inputs, mode, kMaxExpressions, rates);
  if (!result)
    refuse(
        derivative,
        fmt::format(
            "code without loops would have more than {} operations, too many to compile [too-many-operations]",
            kMaxExpressions),
        hint);
  result->name = program.name + suffix_of(derivative);
  // The interface makes an object of these results for the original function only.
  for (symbolic::OutputArray& array : result->outputs) {
    if (array.role == Role::inertia_factor) array.role = Role::matrix;
    if (array.role == Role::inverse_diagonal) array.role = Role::value;
  }
  return std::move(*result);
}

std::string summary_of(const Derivative& derivative) {
  return fmt::format(
      "With partial derivatives by {}: one row per element of the result, in the order of its columns, and one column "
      "per element of the argument.",
      fmt::join(derivative.inputs, ", "));
}

symbolic::Function differentiated(
    symbolic::Function function,
    const Derivative& derivative,
    DerivativeMode mode,
    const symbolic::FollowerRates& rates = {},
    const std::string& hint = "") {
  std::vector<symbolic::DerivativeBlock> blocks;
  const auto values = static_cast<int>(function.program.outputs.size());
  int place = values;
  bool is_by_turns = false, has_followers = false, is_by_rotation = false;
  for (const std::string& input : derivative.inputs) {
    is_by_rotation = is_by_rotation || input == symbolic::kBaseRotation;
    for (int k = 0; k < values; ++k, ++place) {
      for (const symbolic::InputArray& array : function.program.inputs) {
        if (array.name != input) continue;
        is_by_turns = is_by_turns || !array.quaternions.empty();
        has_followers = has_followers || array.followers > 0;
      }
      blocks.push_back({k, input, place});
    }
  }
  function.derivatives = std::move(blocks);
  function.program = differentiated(function.program, derivative, mode, rates, hint);
  function.name += suffix_of(derivative);
  function.kernel = function.program.name;
  function.summary.push_back(summary_of(derivative));
  if (is_by_turns)
    function.summary.emplace_back(
        "A quaternion has three columns in place of four: rotations (rad) about the axes of the child.");
  if (is_by_rotation)
    function.summary.emplace_back(
        "`base_rotation` has three columns: rotations (rad) of the base about its own axes; gravity is fixed in the "
        "world "
        "and changes in base coordinates.");
  if (has_followers)
    function.summary.emplace_back("The last elements of q have no columns: they follow the others through the loops.");
  return function;
}

// Names the function with derivatives of this one in code with loops, if there is one.
std::string hint_of_group(const model::KinematicTree& tree, const std::string& function) {
  struct WithLoops {
    const char *function, *group, *with_derivatives, *inputs;
  };
  const std::string base = tree.floating_base ? ", base_velocity, base_rotation" : "";
  constexpr const char *kForward = "forward_dynamics_derivatives",
                       *kConstrained = "constrained_forward_dynamics_derivatives";
  for (const auto& [of, group, with_derivatives, inputs] :
       {WithLoops{"forward_dynamics", kForward, kForward, "q, qd, tau"},
        WithLoops{"constrained_forward_dynamics", kConstrained, kConstrained, "q, qd, tau, contact_acceleration"},
        WithLoops{"impact", kConstrained, "impact_derivatives", "q, qd, restitution"}})
    if (of == function && algorithm::is_available(tree, group))
      return fmt::format(
          "{}, of the group {}, has derivatives by {}{}, in shorter code", with_derivatives, group, inputs,
          function == "impact" && tree.floating_base ? ", base_velocity" : base);
  return "";
}

bool is_identifier(const std::string& text) {
  return !text.empty() && !(text[0] >= '0' && text[0] <= '9');
}

// Each derivative once.
std::vector<const Derivative*> distinct(const std::vector<Derivative>& list) {
  std::vector<const Derivative*> result;
  for (const Derivative& d : list) {
    const bool is_known = std::any_of(result.begin(), result.end(), [&](const Derivative* other) {
      return other->function == d.function && other->inputs == d.inputs;
    });
    if (!is_known) result.push_back(&d);
  }
  return result;
}

}  // namespace

Derivative parse_derivative(const std::string& text) {
  const auto refuse_text = [&](const std::string& message) {
    throw Failure{
        wrong_usage, fmt::format(
                         "robcogen: error: --derivatives '{}': {} [wrong-derivative]\nhint: write function:input or "
                         "function:input,input, such as inverse_dynamics:q,qd",
                         text, message)};
  };
  // `jacobians::A_J_B:q`, as in C++, means the same as `jacobians.A_J_B:q`.
  const std::size_t colon = text.rfind(':');
  if (colon == std::string::npos) refuse_text("no input to differentiate with respect to");
  Derivative result{dotted("", text.substr(0, colon)), {}};
  if (result.function.empty() || result.function.back() == ':') refuse_text("no function to differentiate");
  for (std::size_t begin = colon + 1; begin <= text.size();) {
    const std::size_t end = std::min(text.find(',', begin), text.size());
    const std::string input = text.substr(begin, end - begin);
    if (input.empty()) refuse_text("an input without a name");
    if (!is_identifier(input)) refuse_text(fmt::format("'{}' is not the name of an input", input));
    if (std::count(result.inputs.begin(), result.inputs.end(), input) > 0)
      refuse_text(fmt::format("'{}' is given twice", input));
    result.inputs.push_back(input);
    begin = end + 1;
  }
  return result;
}

Function function_of(Declared declared, const Derivative* derivative) {
  Function function;
  const std::string suffix = derivative ? suffix_of(*derivative) : "";
  function.group = derivative ? kDerivativesGroup : declared.is->group;
  function.scope = declared.is->scope;
  function.name = declared.name + suffix;
  function.kernel = declared.kernel + suffix;
  function.declared = std::make_shared<const Declared>(std::move(declared));
  function.derivative = derivative;
  return function;
}

std::vector<Function> derivative_functions(const Robot& robot, const std::filesystem::path& model) {
  std::vector<Function> list;
  for (const Derivative* derivative : distinct(robot.derivatives)) {
    const std::vector<Declared> overloads = find_functions(robot, derivative->function);
    if (overloads.empty())
      refuse_function(fmt::format("robot '{}'", robot.tree.name), model, derivative->function, function_names(robot));
    if (overloads.front().is->scope == std::string("inertia_factor"))
      refuse(
          *derivative, "functions of an inertia factor take an object, not numbers",
          "joint_space_inertia and forward_dynamics have derivatives");
    std::vector<Program> outlines;
    for (const Declared& overload : overloads) outlines.push_back(algorithm::outline(overload));
    require_inputs(*derivative, outlines);
    for (std::size_t k = 0; k < overloads.size(); ++k)
      if (takes_all(outlines[k], *derivative)) list.push_back(function_of(overloads[k], derivative));
  }
  return list;
}

std::vector<symbolic::Function> derivative_functions(
    const Transforms& transforms,
    const std::vector<Function>& functions,
    const std::filesystem::path& model) {
  std::vector<std::string> names;
  for (const Function& f : functions) names.push_back(dotted(f.scope, f.name));
  std::vector<symbolic::Function> list;
  for (const Derivative* derivative : distinct(transforms.derivatives)) {
    const auto place = std::find(names.begin(), names.end(), derivative->function);
    if (place == names.end())
      refuse_function(fmt::format("model '{}'", transforms.document.name), model, derivative->function, names);
    symbolic::Function f = functions[static_cast<std::size_t>(place - names.begin())];
    require_inputs(*derivative, {f.program});
    f.group = kDerivativesGroup;
    list.push_back(differentiated(std::move(f), *derivative, DerivativeMode::cheaper));
  }
  return list;
}

symbolic::Function differentiated(
    symbolic::Function function,
    const Derivative& derivative,
    const Declared& declared,
    const algorithm::FormulationChoices& choices) {
  const model::KinematicTree& tree = declared.subject.tree;
  function.group = kDerivativesGroup;
  const std::string hint = hint_of_group(tree, function.name);
  return differentiated(
      std::move(function), derivative, algorithm::derivative_mode(choices.common()), algorithm::follower_rates(tree),
      hint);
}

}  // namespace robcogen::driver
