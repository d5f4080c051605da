// <name>/<name>.h, which declares the functions over Eigen types, and <name>/detail/functions.inc, which defines them
// over the kernels and collects them as static members of a type. The first file includes the second once per
// precision.
//
// The functions are inline and therefore compiled with the user's options, so that the options of the library's own
// translation units can never change how Eigen lays out the arguments and results.
#include <algorithm>
#include <set>

#include "backend/cpp/layout.h"
#include "backend/cpp/lower.h"
#include "backend/cpp/printers.h"
#include "support/index.h"

namespace robcogen::backend::cpp {
namespace {

// The alias of the namespace into which <name>/detail/functions.inc is included, one per precision. Members of Robot
// call the functions there.
constexpr const char* kHere = "here";

// Defined while that file is included, so that a build that compiles each header by itself succeeds.
constexpr const char* kIncluded = "ROBCOGEN_DEFINITIONS";

std::vector<std::string> parameter_list(const Overload& overload) {
  std::vector<std::string> list;
  for (const Argument& a : overload.arguments)
    list.push_back((a.type == "Scalar" ? a.type + " " : "const " + a.type + "& ") + a.name);
  return list;
}

// Whether the output is returned as a plain number. All other results are Eigen matrices or have `data()`.
bool is_scalar(const symbolic::OutputArray& output) {
  return symbolic::is_number(output.role);
}

std::string kernel_of(const Overload& overload) {
  const bool is_core = overload.takes_sines && overload.callable->function->core;
  return std::string(is_core ? "kernel::core::" : "kernel::") + overload.callable->kernel;
}

std::string call_of_kernel(const Overload& overload, std::size_t indent = 2) {
  const symbolic::Program& program = overload.callable->function->program;
  std::string arrays;
  for (const Packed& p : overload.packed) arrays += numbered_list("const Scalar " + p.name + "[]", p.elements, 2);
  std::vector<std::string> arguments = overload.inputs;
  std::string result = overload.callable->parameters[program.inputs.size()].name;
  if (program.outputs.size() > 1) result = "result";
  for (const symbolic::OutputArray& output : program.outputs) {
    const std::string member = result_member(program, output);
    const std::string place = result + (member.empty() ? "" : "." + member);
    arguments.push_back(is_scalar(output) ? "&" + place : place + ".data()");
  }
  const std::string margin(indent, ' ');
  return arrays + margin + overload.result + " " + result + ";\n" + call(kernel_of(overload), arguments, indent) +
         margin + "return " + result + ";\n";
}

// The arguments for the overload that also takes gravity, if this one does not.
std::vector<std::string> passed_on(const Overload& overload) {
  std::vector<std::string> arguments;
  for (std::size_t p = 0, a = 0; p < overload.callable->function->program.inputs.size(); ++p) {
    const bool gravity = overload.callable->function->program.inputs[p].role == symbolic::Role::gravity;
    if (gravity && overload.adds_standard_gravity)
      arguments.push_back("Gravity::standard()");
    else
      arguments.push_back(overload.arguments[a++].name);
  }
  return arguments;
}

std::string body(const Overload& overload) {
  if (overload.adds_standard_gravity) return call("return " + overload.callable->name, passed_on(overload), 2);
  if (!returns_object(overload.callable->function->program)) return call_of_kernel(overload);
  return call("return " + overload.result, passed_on(overload), 2);
}

std::string function(const Overload& overload) {
  const std::string head = "inline " + overload.result + " " + overload.callable->name;
  return declaration(head, parameter_list(overload), " noexcept {") + body(overload) + "}\n";
}

// The constructor that makes the object from the arguments of the function that returns it.
std::string constructor(const Overload& maker) {
  std::vector<std::string> arguments = maker.inputs;
  for (const symbolic::OutputArray& output : maker.callable->function->program.outputs)
    arguments.push_back(kept_name(output.name) + ".data()");
  return declaration("explicit Basic" + maker.result, parameter_list(maker), " noexcept {", 2) +
         call(kernel_of(maker), arguments, 4) + "  }\n";
}

std::string method(const Overload& overload) {
  std::string text;
  for (const std::string& line : overload.callable->function->summary) text += comment(line, 2);
  const std::string head = overload.result + " " + overload.callable->name;
  return text + declaration(head, parameter_list(overload), " const noexcept {", 2) + call_of_kernel(overload, 4) +
         "  }\n";
}

// Aliases for the names of types inside the class template of a factor.
std::string types_of_members(const Api& api) {
  const std::string size = api.library->tree.floating_base ? "6 + kDof" : "kDof";
  std::string text =
      "  template <int kRows, int kColumns>\n  using Matrix = robcogen::Matrix<Scalar, kRows, kColumns>;\n  using "
      "InertiaMatrix = Matrix<" +
      size + ", " + size + ">;\n  using JointState = JointVector<Scalar>;\n";
  if (model::has_own_positions(api.library->tree)) text += "  using JointPositions = PositionVector<Scalar>;\n";
  if (api.takes_sines())
    text += "  using " + std::string(kTrigonometryType) + " = Basic" + kTrigonometryType + "<Scalar>;\n";
  return text;
}

std::string columns_constant(const Api& api, const Callable& callable) {
  if (callable.columns.empty()) return "";
  if (const std::vector<std::string>& labels = callable.function->labels; !labels.empty()) {
    return text_list(
        "inline constexpr std::array<const char*, " + std::to_string(labels.size()) + "> " + callable.columns, labels);
  }
  std::vector<std::string> joints;
  const Function& f = *callable.function;
  for (int joint : f.row_joints.empty() ? f.columns : f.row_joints)
    joints.push_back("Joint::" + api.joints[static_cast<std::size_t>(joint)]);
  return numbered_list(
      "inline constexpr std::array<Joint, " + std::to_string(joints.size()) + "> " + callable.columns, joints);
}

// The declarations of the functions of one name. A remark on how an overload differs from those above it is made once.
std::string declarations(const Api& api, const std::vector<Overload>& set) {
  std::string text;
  std::set<std::string> said;
  const bool alone = std::count_if(set.begin(), set.end(), [](const Overload& o) { return !o.takes_sines; }) == 1;
  bool has_sines = false;
  for (const Overload& o : set) {
    std::string remark;
    if (o.takes_sines) {
      if (!has_sines && !alone) remark = comment("The same with precomputed sines and cosines.");
      has_sines = true;
    } else if (o.adds_standard_gravity) {
      remark = comment("Under standard gravity.");
    } else {
      for (const std::string& line : o.callable->function->summary)
        if (said.insert(line).second) remark += comment(line);
    }
    text += (text.empty() || remark.empty() ? "" : "\n") + remark;
    if (!o.takes_sines && !o.adds_standard_gravity) text += columns_constant(api, *o.callable);
    text += declaration(o.result + " " + o.callable->name, parameter_list(o), " noexcept;");
  }
  return text;
}

// The overloads of one name, grouped.
std::vector<std::vector<Overload>> sets(const Api& api, const std::string& group, const std::string& scope) {
  std::vector<std::vector<Overload>> result;
  for (Overload& o : overloads(api, group, scope)) {
    if (result.empty() || result.back().front().callable->name != o.callable->name) result.emplace_back();
    result.back().push_back(std::move(o));
  }
  return result;
}

std::string in_scope(const std::string& scope, const std::string& text) {
  return scope.empty() ? text : in_namespace(scope, text);
}

std::string declarations(const Api& api, const std::string& group) {
  std::vector<std::string> parts;
  for (const std::string& scope : scopes(api, group)) {
    std::vector<std::string> functions;
    for (const std::vector<Overload>& set : sets(api, group, scope)) functions.push_back(declarations(api, set));
    parts.push_back(in_scope(scope, paragraphs(functions)));
  }
  return paragraphs(parts);
}

std::string definitions(const Api& api, const std::string& group) {
  std::vector<std::string> parts;
  for (const std::string& scope : scopes(api, group)) {
    std::vector<std::string> functions;
    for (const Overload& o : overloads(api, group, scope)) functions.push_back(function(o));
    parts.push_back(in_scope(scope, paragraphs(functions)));
  }
  return paragraphs(parts);
}

// An object of a robot with parameters holds them.
std::string member_function(const Overload& overload) {
  const bool carries = !overload.arguments.empty() && overload.arguments.front().type == kParametersType;
  const std::string head = (carries ? "" : "static ") + overload.result + " " + overload.callable->name;
  const std::string tail = carries ? " const noexcept {" : " noexcept {";
  std::vector<std::string> parameters = parameter_list(overload);
  if (carries) parameters.erase(parameters.begin());
  std::vector<std::string> names;
  for (const Argument& a : overload.arguments) names.push_back(a.name);
  const auto body = [&](std::size_t indent) {
    return call("return " + std::string(kHere) + "::" + overload.callable->name, names, indent);
  };
  const std::string statement = body(0);
  const std::string line =
      declaration(head, parameters, tail + " " + statement.substr(0, statement.size() - 1) + " }", 2);
  const bool fits = line.size() <= kColumns + 1 && line.find('\n') == line.size() - 1;
  return fits ? line : declaration(head, parameters, tail, 2) + body(4) + "  }\n";
}

// `{0, 5}`.
std::string numbers_of(const std::vector<int>& numbers) {
  std::vector<std::string> texts;
  for (const int number : numbers) texts.push_back(std::to_string(number));
  return braced(texts);
}

std::string robot_type(const Api& api) {
  const Library& library = *api.library;
  const model::KinematicTree& tree = library.tree;
  const auto constant = [](const std::string& type, const std::string& name, const std::string& value) {
    return "  static constexpr " + type + " " + name + " = " + value + ";\n";
  };
  std::string types;
  std::vector<std::string> names = {"Gravity",      "InertiaMatrix", "JointState",
                                    "LinkWrenches", "Scalar",        "SpatialAcceleration",
                                    "Twist",        "Vector3",       "Wrench"};
  if (library.tree.floating_base)
    names.insert(names.begin(), {"InverseDynamics", "GeneralizedAcceleration", "GeneralizedForce"});
  for (const Callable& c : api.callables)
    if (returns_object(c.function->program)) names.push_back(result_type(*c.function));
  for (const Callable* c : callables_with_structures(api)) names.push_back(c->result);
  if (api.takes_sines()) names.push_back(kTrigonometryType);
  if (model::has_own_positions(library.tree)) names.emplace_back("JointPositions");
  std::sort(names.begin(), names.end());
  for (const std::string& name : names) types += "  using " + name + " = " + kHere + "::" + name + ";\n";
  types +=
      std::string("  template <int kRows, int kColumns>\n  using Matrix = ") + kHere + "::Matrix<kRows, kColumns>;\n";
  std::string positions;
  if (model::has_own_positions(library.tree)) {
    const std::vector<int> first = model::quaternions(tree);
    positions = constant("int", "kPositions", std::to_string(tree.position_count())) +
                constant("std::array<int, " + std::to_string(first.size()) + ">", "kQuaternions", numbers_of(first));
  }
  if (const std::vector<int> followers = tree.followers_in_q(); !followers.empty()) {
    std::vector<std::string> assembled;
    for (const int j : followers) assembled.push_back(model_number(model::evaluate(tree.coupling_of(j)->offset)));
    positions += constant(
        "std::array<double, " + std::to_string(assembled.size()) + ">", "kAssembledFollowers", braced(assembled));
  }
  const std::vector<int> joints = tree.coordinates();
  const auto position = [&](int joint) { return tree.joints[at(joint)].assembled_position(); };
  if (std::any_of(joints.begin(), joints.end(), [&](int joint) { return position(joint) != 0; })) {
    std::vector<std::string> assembled;
    for (const int joint : joints) assembled.push_back(model_number(position(joint)));
    positions += constant("std::array<double, kDof>", "kAssembledCoordinates", braced(assembled));
  }
  std::vector<std::string> parts = {
      types,
      constant("int", "kDof", std::to_string(tree.dof())) + positions +
          constant("int", "kLinkCount", std::to_string(tree.link_count())) +
          constant("bool", "kFloatingBase", library.tree.floating_base ? "true" : "false") +
          constant("auto", "kJointLimits", "::" + api.space + "::kJointLimits") +
          (api.limbs.empty() ? "" : constant("auto", "limbs", "::" + api.space + "::limbs")) +
          (library.tree.has_drives() ? constant("auto", "kJointDrives", "::" + api.space + "::kJointDrives") : "") +
          (library.tree.has_pitches() ? constant("auto", "kJointPitches", "::" + api.space + "::kJointPitches") : "")};
  for (const std::string& group : library.groups) {
    std::string members;
    for (const Overload& o : overloads(api, group, "")) members += member_function(o);
    parts.push_back(members);
  }
  if (api.is_parametric()) {
    parts.front() += "  using Parameters = ::" + api.space + "::Parameters<Scalar>;\n";
    for (const std::string type : {"KinematicsParameters", "DynamicsParameters", "ParameterValues", "ParameterArray"})
      parts.front() += "  using " + type + " = ::" + api.space + "::" + type + ";\n";
    parts.push_back("  Parameters parameters;\n");
  }
  return "// The robot as a type, for code that is generic over robots.\nstruct Robot {\n" + paragraphs(parts) + "};\n";
}

// The options of CMake and of the command line for what a user may miss here.
std::string options_for_more(const Library& library) {
  std::string text;
  const auto& groups = library.groups;
  if (library.has_robot() && std::any_of(groups.begin(), groups.end(), is_kinematics))
    text += " Functions of other frames: FRAMES (--frames) or DESIRED (--desired).";
  if (!library.has_single_precision) text += " In single precision, f32: SINGLE_PRECISION (--single-precision).";
  return text;
}

// The conventions that hold for all functions.
std::string conventions(const Api& api) {
  const Library& library = *api.library;
  std::string text = "All functions are pure: no state, no allocation, no exceptions. Units are SI, angles in rad.";
  if (library.has_robot()) text += " Joint vectors are in the order of " + api.space + "::Joint.";
  if (model::has_own_positions(library.tree)) text += " Positions are in the order of " + api.space + "::Position";
  if (!library.tree.spherical_joints().empty())
    text += "; their quaternions must be of unit length (robcogen/positions.h)";
  if (!library.tree.followers_in_q().empty()) text += "; close_loops computes the last ones";
  if (model::has_own_positions(library.tree)) text += ".";
  const bool single = library.has_single_precision;
  if (single) text += " " + api.space + "::f32 has the same types and functions in single precision.";
  if (!library.has_robot()) return comment(text + options_for_more(library));
  text += " " + api.space + (single ? "::Robot, and f32::Robot, have" : "::Robot has") +
          " all functions but transforms and Jacobians as members, for code that is generic over robots.";
  if (api.takes_sines())
    text += std::string(" If sines and cosines of the joints are known, pass a ") + kTrigonometryType +
            " in place of positions.";
  return comment(text + options_for_more(library));
}

// The lines that include the definitions into the namespace of a precision.
std::string definitions_in(const Api& api, const std::string& space) {
  const std::string alias =
      api.library->has_robot() ? "namespace " + std::string(kHere) + " = ::" + space + ";\n" : std::string();
  return "namespace " + space + " {\n" + alias + includes({cpp::quoted(functions_path(folder(*api.library)))}) +
         "}  // namespace " + space + "\n";
}

}  // namespace

std::string factor_type(const Api& api) {
  for (const Callable& c : api.callables) {
    if (!returns_object(c.function->program)) continue;
    const Overload maker = overloads(api, {&c}).front();
    std::string getters, data;
    for (const symbolic::OutputArray& output : c.function->program.outputs) {
      const std::string type = matrix_type(output.rows, output.columns), name = kept_name(output.name);
      getters += "  const " + type + "& " + output.name + "() const noexcept { return " + name + "; }\n";
      data += "  " + type + " " + name + ";\n";
    }
    std::string constructors = constructor(maker);
    if (const Overload other = with_sines(api, maker); other.takes_sines) constructors += constructor(other);
    std::vector<std::string> parts = {constructors, getters};
    for (const Overload& member : members(api, maker.result)) parts.push_back(method(member));
    return comment("The result of " + c.name + ".") + "template <class Scalar>\nclass ROBCOGEN_ALIGNED Basic" +
           maker.result + " {\n" + types_of_members(api) + "\n public:\n" + paragraphs(parts) + "\n private:\n" + data +
           "};\n";
  }
  return "";
}

std::string print_umbrella(const Api& api, const std::string& path) {
  const Library& library = *api.library;
  const bool single = library.has_single_precision;
  std::vector<std::string> groups;
  bool tables = false;
  for (const Callable& c : api.callables) tables = tables || !c.columns.empty();
  for (const std::string& group : library.groups) groups.push_back(declarations(api, group));
  std::vector<std::string> headers;
  for (const char* stem : {"model", "types"}) headers.push_back(header_path(folder(library), stem));
  if (api.is_parametric()) headers.push_back(header_path(folder(library), kParameters));
  for (std::string& header : headers) header = cpp::quoted(header);
  return paragraphs(
      {banner(library, path, library.has_robot() ? "its functions" : "its coordinate transforms") + "//\n" +
           conventions(api),
       "#pragma once\n", tables ? includes({"<array>"}) : "", includes(headers), identity_reference(api, "functions"),
       in_namespace(api.space, paragraphs(groups)),
       comment(single ? "The definitions in each precision." : "The definitions.") +
           includes({cpp::quoted(kernels_path(folder(library)))}),
       std::string("#define ") + kIncluded + "\n" + definitions_in(api, api.space),
       (single ? definitions_in(api, api.space + "::f32") : std::string()) + "#undef " + kIncluded + "\n"});
}

std::string print_definitions(const Api& api, const std::string& path) {
  const Library& library = *api.library;
  std::vector<std::string> parts = {
      banner(library, path, "definitions of its functions") +
      comment(
          umbrella_path(folder(library)) + " includes this file in the namespace" +
          (library.has_single_precision ? "s of both precisions" : "") + "; included directly, it is empty.") +
      "#ifdef " + kIncluded + "\n"};
  for (const std::string& group : library.groups) parts.push_back(definitions(api, group));
  if (library.has_robot()) parts.push_back(robot_type(api));
  parts.push_back("#endif\n");
  return paragraphs(parts);
}

}  // namespace robcogen::backend::cpp
