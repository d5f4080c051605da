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
using symbolic::DerivativeForm;
using symbolic::DerivativeMode;
using symbolic::Program;
using symbolic::Role;

// The words for each form: the option, and what stands in the names of functions.
struct Words {
  const char *option, *infix;
};

Words words_of(DerivativeForm form) {
  switch (form) {
    case DerivativeForm::gradient:
      return {"--gradients", "gradient"};
    case DerivativeForm::tangent:
      return {"--tangents", "tangent"};
    case DerivativeForm::matrix:
      break;
  }
  return {"--derivatives", "d"};
}

std::string text_of(const Derivative& derivative) {
  return fmt::format("{}:{}", derivative.function, fmt::join(derivative.inputs, ","));
}

[[noreturn]] void refuse(const Derivative& derivative, const std::string& message, const std::string& hint = "") {
  throw Failure{
      wrong_usage,
      with_hint(
          fmt::format("robcogen: error: {} {}: {}", words_of(derivative.form).option, text_of(derivative), message),
          hint)};
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
  return fmt::format("_{}_{}", words_of(derivative.form).infix, fmt::join(derivative.inputs, "_"));
}

std::string suffix_of(const std::vector<Derivative>& derivatives_in_turn) {
  std::string suffix;
  for (const Derivative& derivative : derivatives_in_turn) suffix += suffix_of(derivative);
  return suffix;
}

// The inputs and outputs of the function with its derivatives, by their names alone.
Program outline_with(Program outline, const Derivative& derivative) {
  const std::vector<symbolic::OutputArray> results = outline.outputs;
  const auto add_input = [&](const std::string& name) { outline.inputs.push_back({name, Role::value, {}}); };
  const auto add_output = [&](const std::string& name) { outline.outputs.push_back({name, Role::value, 0, 1, {}}); };
  if (derivative.form == DerivativeForm::gradient)
    for (const symbolic::WeightedOutputs& weights : symbolic::weights_of_outputs(outline)) add_input(weights.name);
  if (derivative.form == DerivativeForm::tangent)
    for (const symbolic::OutputArray& of : results) add_output(symbolic::name_of_tangent(of.name));
  for (const std::string& input : derivative.inputs) {
    if (derivative.form == DerivativeForm::tangent) add_input(symbolic::name_of_tangent(input));
    if (derivative.form == DerivativeForm::gradient) add_output(symbolic::name_of_gradient(input));
    if (derivative.form == DerivativeForm::matrix)
      for (const symbolic::OutputArray& of : results)
        add_output(symbolic::name_of_block(results.size(), of.name, input));
  }
  return outline;
}

// For derivatives of derivatives, which may have such arguments and results already.
void require_new_names(const Derivative& derivative, const Program& outline) {
  std::vector<std::string> names;
  const auto require = [&](const std::string& name) {
    if (std::count(names.begin(), names.end(), name) > 0)
      refuse(
          derivative,
          fmt::format("{} has '{}' already, an argument or a result [repeated-derivative]", derivative.function, name));
    names.push_back(name);
  };
  const Program with = outline_with(outline, derivative);
  for (const symbolic::InputArray& array : with.inputs) require(array.name);
  names.clear();
  for (const symbolic::OutputArray& array : with.outputs) require(array.name);
}

// In the form that is asked for; nullopt if it takes more than kMaxExpressions.
std::optional<Program> program_with(
    const Program& program,
    const Derivative& derivative,
    DerivativeMode mode,
    const symbolic::FollowerRates& rates) {
  const std::size_t place = symbolic::place_of_loads(program);
  std::optional<Program> result;
  switch (derivative.form) {
    case DerivativeForm::matrix:
      return symbolic::with_derivatives(program, derivative.inputs, mode, kMaxExpressions, rates);
    case DerivativeForm::gradient:
      result = symbolic::with_gradient(program, symbolic::weights_of_outputs(program), derivative.inputs, place, rates);
      break;
    case DerivativeForm::tangent:
      result = symbolic::with_tangents(program, derivative.inputs, place, rates);
      break;
  }
  return result->statements.size() > kMaxExpressions ? std::nullopt : std::move(result);
}

// `hint`: for a refusal.
Program differentiated(
    const Program& program,
    const Derivative& derivative,
    DerivativeMode mode,
    const symbolic::FollowerRates& rates,
    const std::string& hint) {
  std::optional<Program> result = program_with(program, derivative, mode, rates);
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

std::string summary_of(const Derivative& derivative, const Program& program) {
  const std::string inputs = fmt::format("{}", fmt::join(derivative.inputs, ", "));
  if (derivative.form == DerivativeForm::gradient) {
    std::vector<std::string> sums;
    for (const symbolic::WeightedOutputs& weights : symbolic::weights_of_outputs(program))
      sums.push_back(fmt::format("{} times {}", weights.name, weights.outputs.front()));
    return fmt::format(
        "With the gradient of {} by {}, element by element (of a matrix, column by column): the transpose of the "
        "partial derivatives times the weights, by reverse mode at a small multiple of the cost of the function.",
        fmt::join(sums, " plus "), inputs);
  }
  if (derivative.form == DerivativeForm::tangent) {
    std::vector<std::string> rates;
    for (const std::string& input : derivative.inputs) rates.push_back(symbolic::name_of_tangent(input));
    return fmt::format(
        "With the rates of the results when {} change at the rates {}: the partial derivatives times these rates, by "
        "forward mode at a small multiple of the cost of the function.",
        inputs, fmt::join(rates, ", "));
  }
  return fmt::format(
      "With partial derivatives by {}: one row per element of the result, in the order of its columns, and one column "
      "per element of the argument.",
      inputs);
}

// Where the derivatives are among the results, to be checked by differences.
std::vector<symbolic::DerivativeBlock> blocks_of(const Program& program, const Derivative& derivative) {
  std::vector<symbolic::DerivativeBlock> blocks;
  const auto results = static_cast<int>(program.outputs.size());
  int place = results;
  for (const std::string& input : derivative.inputs) {
    switch (derivative.form) {
      case DerivativeForm::matrix:
        for (int k = 0; k < results; ++k) blocks.push_back({k, input, place++});
        break;
      case DerivativeForm::gradient:
        blocks.push_back(
            {0, input, place++, derivative.form, symbolic::weights_of_outputs(program).front().name, results});
        break;
      case DerivativeForm::tangent:
        blocks.push_back({0, input, place, derivative.form, symbolic::name_of_tangent(input), results});
        break;
    }
  }
  return blocks;
}

symbolic::Function differentiated(
    symbolic::Function function,
    const Derivative& derivative,
    DerivativeMode mode,
    const symbolic::FollowerRates& rates = {},
    const std::string& hint = "") {
  bool is_by_turns = false, has_followers = false, is_by_rotation = false;
  for (const std::string& input : derivative.inputs) {
    is_by_rotation = is_by_rotation || input == symbolic::kBaseRotation;
    for (const symbolic::InputArray& array : function.program.inputs) {
      if (array.name != input) continue;
      is_by_turns = is_by_turns || !array.quaternions.empty();
      has_followers = has_followers || array.followers > 0;
    }
  }
  function.derivatives = blocks_of(function.program, derivative);
  function.summary.push_back(summary_of(derivative, function.program));
  function.program = differentiated(function.program, derivative, mode, rates, hint);
  function.name += suffix_of(derivative);
  function.kernel = function.program.name;
  const char* elements = derivative.form == DerivativeForm::matrix ? "columns" : "elements";
  if (is_by_turns)
    function.summary.push_back(fmt::format(
        "A quaternion has three {} in place of four: rotations (rad) about the axes of the child.", elements));
  if (is_by_rotation)
    function.summary.push_back(fmt::format(
        "`base_rotation` has three {}: rotations (rad) of the base about its own axes; gravity is fixed in the world "
        "and changes in base coordinates.",
        elements));
  if (has_followers)
    function.summary.push_back(
        fmt::format("The last elements of q have no {}: they follow the others through the loops.", elements));
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

// The inputs by which `all` differentiates a function; none if it leaves the function out.
std::vector<std::string> smooth_inputs(const Program& outline) {
  // Such as `d_q` of inverse_dynamics_derivatives.
  for (const symbolic::OutputArray& output : outline.outputs)
    for (const symbolic::InputArray& input : outline.inputs)
      if (output.name == symbolic::name_of_gradient(input.name)) return {};
  std::vector<std::string> inputs;
  for (const symbolic::InputArray& input : outline.inputs)
    if (input.role != Role::parameters && input.role != Role::contact_activity && !input.elements.empty())
      inputs.push_back(input.name);
  return inputs;
}

// Each derivative once, and in the place of `all` those that it stands for.
std::vector<Derivative> expanded(const std::vector<Derivative>& list, const std::vector<Function>& functions) {
  std::vector<Derivative> result;
  const auto is_known = [&](const auto& is_same) { return std::any_of(result.begin(), result.end(), is_same); };
  for (const Derivative& d : list)
    if (!d.is_all() && !is_known([&](const Derivative& other) {
          return other.function == d.function && other.inputs == d.inputs && other.form == d.form;
        }))
      result.push_back(d);
  const std::vector<Derivative> named = result;
  for (const Derivative& d : list) {
    if (!d.is_all()) continue;
    for (const Function& f : functions) {
      const std::string name = dotted(f.scope, f.name);
      const auto is_of_it = [&](const Derivative& other) { return other.function == name; };
      const auto is_same = [&](const Derivative& other) { return is_of_it(other) && other.form == d.form; };
      if (f.scope == "inertia_factor" || f.group == "inverse_kinematics") continue;
      if (std::any_of(named.begin(), named.end(), is_of_it) || is_known(is_same)) continue;
      std::vector<std::string> inputs = smooth_inputs(f.declared ? algorithm::outline(*f.declared) : f.program);
      if (!inputs.empty()) result.push_back({name, std::move(inputs), d.form});
    }
  }
  return result;
}

}  // namespace

Derivative parse_derivative(const std::string& text, DerivativeForm form) {
  const auto refuse_text = [&](const std::string& message) {
    throw Failure{
        wrong_usage, fmt::format(
                         "robcogen: error: {} '{}': {} [wrong-derivative]\nhint: write function:input or "
                         "function:input,input, such as inverse_dynamics:q,qd, or all",
                         words_of(form).option, text, message)};
  };
  if (text == "all") return {text, {}, form};
  // `jacobians::A_J_B:q`, as in C++, means the same as `jacobians.A_J_B:q`.
  const std::size_t colon = text.rfind(':');
  if (colon == std::string::npos) refuse_text("no input to differentiate with respect to");
  Derivative result{dotted("", text.substr(0, colon)), {}, form};
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

Function function_of(Declared declared, std::vector<Derivative> derivatives_in_turn) {
  Function function;
  const std::string suffix = suffix_of(derivatives_in_turn);
  function.group = suffix.empty() ? declared.is->group : kDerivativesGroup;
  function.scope = declared.is->scope;
  function.name = declared.name + suffix;
  function.kernel = declared.kernel + suffix;
  function.declared = std::make_shared<const Declared>(std::move(declared));
  function.derivatives_in_turn = std::move(derivatives_in_turn);
  return function;
}

namespace {

// This derivative, after those of which it is the derivative.
std::vector<Derivative> in_turn(const Derivative& derivative, const std::vector<Derivative>& all) {
  for (const Derivative& inner : all) {
    if (inner.function + suffix_of(inner) != derivative.function) continue;
    std::vector<Derivative> result = in_turn(inner, all);
    result.push_back(derivative);
    return result;
  }
  return {derivative};
}

// The overloads that have these derivatives. Throws a Failure if there is none.
std::vector<Declared> overloads_with(
    const std::vector<Derivative>& derivatives_in_turn,
    std::vector<Declared> overloads) {
  std::vector<Program> outlines;
  for (const Declared& overload : overloads) outlines.push_back(algorithm::outline(overload));
  for (const Derivative& derivative : derivatives_in_turn) {
    require_inputs(derivative, outlines);
    std::vector<Declared> remaining;
    std::vector<Program> with_derivative;
    for (std::size_t k = 0; k < overloads.size(); ++k) {
      if (!takes_all(outlines[k], derivative)) continue;
      require_new_names(derivative, outlines[k]);
      remaining.push_back(std::move(overloads[k]));
      with_derivative.push_back(outline_with(std::move(outlines[k]), derivative));
    }
    overloads = std::move(remaining);
    outlines = std::move(with_derivative);
  }
  return overloads;
}

}  // namespace

std::vector<Function> derivative_functions(
    const Robot& robot,
    const std::vector<Function>& functions,
    const std::filesystem::path& model) {
  std::vector<Function> list;
  const std::vector<Derivative> derivatives = expanded(robot.derivatives, functions);
  for (const Derivative& derivative : derivatives) {
    const std::vector<Derivative> derivatives_in_turn = in_turn(derivative, derivatives);
    const std::string& name = derivatives_in_turn.front().function;
    std::vector<Declared> overloads = find_functions(robot, name);
    if (overloads.empty())
      refuse_function(fmt::format("robot '{}'", robot.tree.name), model, name, function_names(robot));
    if (overloads.front().is->scope == std::string("inertia_factor"))
      refuse(
          derivative, "functions of an inertia factor take an object, not numbers",
          "joint_space_inertia and forward_dynamics have derivatives");
    for (Declared& overload : overloads_with(derivatives_in_turn, std::move(overloads)))
      list.push_back(function_of(std::move(overload), derivatives_in_turn));
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
  const std::vector<Derivative> derivatives = expanded(transforms.derivatives, functions);
  for (const Derivative& derivative : derivatives) {
    const std::vector<Derivative> derivatives_in_turn = in_turn(derivative, derivatives);
    const std::string& name = derivatives_in_turn.front().function;
    const auto place = std::find(names.begin(), names.end(), name);
    if (place == names.end()) refuse_function(fmt::format("model '{}'", transforms.document.name), model, name, names);
    symbolic::Function f = functions[static_cast<std::size_t>(place - names.begin())];
    f.group = kDerivativesGroup;
    for (const Derivative& next : derivatives_in_turn) {
      require_inputs(next, {f.program});
      require_new_names(next, f.program);
      f = differentiated(std::move(f), next, DerivativeMode::cheaper);
    }
    list.push_back(std::move(f));
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
