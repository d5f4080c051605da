// <name>/<group>.h, Eigen functions over the kernels, and <name>/robot.h, the same as static members of a type.
//
// The functions are inline: compiled with the user's options, so that options of the library's own translation units
// can never change how Eigen lays out what crosses the border.
#include <algorithm>

#include "backend/cpp/layout.h"
#include "backend/cpp/lower.h"
#include "backend/cpp/printers.h"

namespace robcogen::backend::cpp {
namespace {

std::vector<std::string> parameter_list(const Overload& overload) {
  std::vector<std::string> list;
  for (const Argument& a : overload.arguments) {
    const std::string type = a.type == "Scalar" ? a.type + " " : "const " + a.type + "& ";
    list.push_back(type + a.name + (a.default_value.empty() ? "" : " = " + a.default_value));
  }
  return list;
}

// Returned as a plain number, where all else is an Eigen matrix or has its `data()`.
bool is_scalar(const symbolic::OutputArray& output) {
  return output.role == symbolic::Role::energy || output.role == symbolic::Role::mass;
}

std::string kernel_of(const Overload& overload) {
  const bool is_core = overload.takes_sines && overload.callable->function->parts;
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
    arguments.push_back(is_scalar(output) ? "&" + result : result + (member.empty() ? "" : "." + member) + ".data()");
  }
  const std::string margin(indent, ' ');
  return arrays + margin + result_type(program) + " " + result + ";\n" + call(kernel_of(overload), arguments, indent) +
         margin + "return " + result + ";\n";
}

// Arguments passed on to an overload that takes gravity too, if this one does not.
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

std::string documentation(const Overload& overload) {
  if (overload.takes_sines) return comment("As above, with sines and cosines that are known.");
  if (overload.adds_standard_gravity) return comment("As above, under standard gravity.");
  std::string result;
  for (const std::string& line : overload.callable->function->summary) result += comment(line);
  return result;
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

// Makes the object from the arguments of the function that returns it.
std::string constructor(const Overload& maker) {
  std::vector<std::string> arguments = maker.inputs;
  for (const symbolic::OutputArray& output : maker.callable->function->program.outputs)
    arguments.push_back(kept_name(output.name) + ".data()");
  return declaration("explicit " + maker.result, parameter_list(maker), " noexcept {", 2) +
         call(kernel_of(maker), arguments, 4) + "  }\n";
}

std::string method(const Overload& overload, bool documented) {
  std::string text;
  if (documented)
    for (const std::string& line : overload.callable->function->summary) text += comment(line, 2);
  const std::string head = overload.result + " " + overload.callable->name;
  return text + declaration(head, parameter_list(overload), " const noexcept {", 2) + call_of_kernel(overload, 4) +
         "  }\n";
}

// The type of what a function returns, where it has one of its own.
std::string object_type(const Api& api, const Overload& maker, bool documented) {
  std::string getters, data;
  for (const symbolic::OutputArray& output : maker.callable->function->program.outputs) {
    const std::string type = matrix_type(output.rows, output.columns), name = kept_name(output.name);
    getters += "  const " + type + "& " + output.name + "() const noexcept { return " + name + "; }\n";
    data += "  " + type + " " + name + ";\n";
  }
  std::string constructors = constructor(maker);
  if (const Overload other = with_sines(api, maker); other.takes_sines) constructors += constructor(other);
  std::vector<std::string> parts = {constructors, getters};
  for (const Overload& member : members(api, maker.result)) parts.push_back(method(member, documented));
  const std::string remark = documented ? comment("What " + maker.callable->name + " returns.") : "";
  return remark + "class " + maker.result + " {\n public:\n" + paragraphs(parts) + "\n private:\n" + data + "};\n";
}

std::string columns_constant(const Api& api, const Callable& callable) {
  if (callable.columns.empty()) return "";
  std::vector<std::string> joints;
  for (int joint : callable.function->columns)
    joints.push_back("Joint::" + api.joints[static_cast<std::size_t>(joint)]);
  return numbered_list(
      "inline constexpr std::array<Joint, " + std::to_string(joints.size()) + "> " + callable.columns, joints);
}

// The functions of one scope. Documentation and constants stand with the first precision only.
std::string scope_text(const Api& api, const std::string& group, const std::string& scope, bool single_precision) {
  std::vector<std::string> parts;
  for (const Overload& o : overloads(api, group, scope)) {
    const bool is_first = !o.takes_sines;
    if (is_first && returns_object(o.callable->function->program))
      parts.push_back(object_type(api, o, !single_precision));
    if (single_precision) {
      parts.push_back(function(o));
      continue;
    }
    if (is_first) parts.push_back(columns_constant(api, *o.callable));
    parts.push_back(documentation(o) + function(o));
  }
  const std::string prefix = single_precision ? (scope.empty() ? "f32" : "f32::") : "";
  if (prefix.empty() && scope.empty()) return paragraphs(parts);
  return in_namespace(prefix + scope, paragraphs(parts));
}

// A robot with parameters carries them.
std::string member_function(const Overload& overload, const std::string& space) {
  const bool carries = !overload.arguments.empty() && overload.arguments.front().type == kParametersType;
  const std::string head = (carries ? "" : "static ") + overload.result + " " + overload.callable->name;
  const std::string tail = carries ? " const noexcept {" : " noexcept {";
  std::vector<std::string> parameters = parameter_list(overload);
  if (carries) parameters.erase(parameters.begin());
  std::vector<std::string> names;
  for (const Argument& a : overload.arguments) names.push_back(a.name);
  const auto body = [&](std::size_t indent) {
    return call("return " + space + "::" + overload.callable->name, names, indent);
  };
  const std::string statement = body(0);
  const std::string line =
      declaration(head, parameters, tail + " " + statement.substr(0, statement.size() - 1) + " }", 2);
  const bool fits = line.size() <= kColumns + 1 && line.find('\n') == line.size() - 1;
  return fits ? line : declaration(head, parameters, tail, 2) + body(4) + "  }\n";
}

std::string robot_type(const Api& api, const std::string& scalar, const std::string& space) {
  const Library& library = *api.library;
  const auto constant = [](const std::string& type, const std::string& name, const std::string& value) {
    return "  static constexpr " + type + " " + name + " = " + value + ";\n";
  };
  std::string types = "  using Scalar = " + scalar + ";\n";
  std::vector<std::string> names = {"Gravity", "InertiaMatrix", "JointState", "LinkWrenches", "SpatialAcceleration",
                                    "Twist",   "Vector3",       "Wrench"};
  if (library.floating_base)
    names.insert(names.begin(), {"InverseDynamics", "GeneralizedAcceleration", "GeneralizedForce"});
  for (const Callable& c : api.callables)
    if (returns_object(c.function->program)) names.push_back(result_type(c.function->program));
  if (api.takes_sines()) names.push_back(kTrigonometryType);
  std::sort(names.begin(), names.end());
  for (const std::string& name : names) types += "  using " + name + " = " + space + "::" + name + ";\n";
  std::vector<std::string> parts = {
      types, constant("int", "kDof", std::to_string(library.joints.size())) +
                 constant("int", "kLinkCount", std::to_string(library.links.size())) +
                 constant("bool", "kFloatingBase", library.floating_base ? "true" : "false") +
                 constant("auto", "kJointLimits", "::" + api.space + "::kJointLimits")};
  for (const std::string& group : library.groups) {
    std::string members;
    for (const Overload& o : overloads(api, group, "")) members += member_function(o, space);
    parts.push_back(members);
  }
  if (api.is_parametric()) {
    parts.front() += "  using Parameters = ::" + api.space + "::Parameters<" + scalar + ">;\n";
    for (const std::string type : {"KinematicsParameters", "DynamicsParameters", "ParameterValues", "ParameterArray"})
      parts.front() += "  using " + type + " = ::" + api.space + "::" + type + ";\n";
    parts.push_back("  Parameters parameters;\n");
  }
  return "struct Robot {\n" + paragraphs(parts) + "};\n";
}

std::vector<std::string> group_headers(const Library& library) {
  std::vector<std::string> headers;
  for (const std::string& group : library.groups) headers.push_back("\"" + header_path(folder(library), group) + "\"");
  return headers;
}

// What every function's declaration needs.
std::vector<std::string> base_headers(const Api& api) {
  std::vector<std::string> headers = {"\"" + header_path(folder(*api.library), "types") + "\""};
  if (api.is_parametric()) headers.push_back("\"" + header_path(folder(*api.library), kParameters) + "\"");
  if (api.takes_sines()) headers.push_back("\"" + header_path(folder(*api.library), kTrigonometry) + "\"");
  return headers;
}

}  // namespace

std::string print_interface(const Api& api, const std::string& group, const std::string& path) {
  const Library& library = *api.library;
  std::vector<std::string> kernels, cores, parts;
  bool tables = false;
  for (const Callable& c : api.callables) {
    if (c.function->group != group) continue;
    kernels.push_back(kernel_declaration(c));
    if (c.function->parts) cores.push_back(core_declaration(c));
    tables = tables || !c.columns.empty();
  }
  kernels.push_back(in_namespace("core", paragraphs(cores)));
  parts.push_back(in_namespace("kernel", paragraphs(kernels)));
  for (const std::string& scope : scopes(api, group)) parts.push_back(scope_text(api, group, scope, false));
  for (const std::string& scope : scopes(api, group)) parts.push_back(scope_text(api, group, scope, true));
  return paragraphs(
      {banner(library, path, "functions over Eigen types, in double and (namespace f32) single precision"),
       "#pragma once\n", tables ? includes({"<array>"}) : "", includes(base_headers(api)),
       in_namespace(api.space, paragraphs(parts))});
}

std::string print_robot(const Api& api, const std::string& path) {
  const Library& library = *api.library;
  std::vector<std::string> headers = group_headers(library);
  for (const std::string& header : base_headers(api)) headers.push_back(header);
  const std::string body = paragraphs(
      {"// The robot as a type, for code that is generic over robots.\n" + robot_type(api, "double", "::" + api.space),
       in_namespace("f32", robot_type(api, "float", "::" + api.space + "::f32"))});
  return paragraphs(
      {banner(library, path, "the robot as a type"), "#pragma once\n", includes(headers),
       in_namespace(api.space, body)});
}

std::string print_umbrella(const Api& api, const std::string& path) {
  std::vector<std::string> headers = group_headers(*api.library);
  for (const std::string& stem : stems(api.library->has_robot()))
    if (stem != "reflection" && (stem != kParameters || api.is_parametric()) &&
        (stem != kTrigonometry || api.takes_sines()))
      headers.push_back("\"" + header_path(folder(*api.library), stem) + "\"");
  return paragraphs(
      {banner(*api.library, path, "everything but the tables of " + header_path(folder(*api.library), "reflection")),
       "#pragma once\n", includes(headers)});
}

}  // namespace robcogen::backend::cpp
