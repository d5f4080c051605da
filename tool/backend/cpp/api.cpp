#include "backend/cpp/api.h"

#include <algorithm>
#include <map>
#include <set>

#include "backend/cpp/names.h"
#include "support/concat.h"

namespace robcogen::backend::cpp {
namespace {

constexpr const char* kFactorType = "InertiaFactor";

using symbolic::InputArray;
using symbolic::OutputArray;
using symbolic::Program;
using symbolic::Role;

// The name of the array of the values that Parameters holds.
const char* const kParameterValues = "parameter_values";

// A namespace keeps the name that was asked for, unless C++ or a system header uses that name itself.
std::string namespace_name(const std::string& wanted) {
  return is_reserved_namespace(wanted) ? wanted + "_" : wanted;
}

std::string whole_namespace(const Library& library) {
  std::string result;
  std::string rest = library.enclosing;
  while (!rest.empty()) {
    const std::size_t end = std::min(rest.find("::"), rest.size());
    result += namespace_name(rest.substr(0, end)) + "::";
    rest.erase(0, end + 2);
  }
  return result + namespace_name(library.name);
}

std::vector<std::string> enumerators(const std::vector<std::string>& names) {
  NameScope scope;
  return claim_all(scope, names);
}

bool is_joint_array(Role role) {
  return role == Role::joint_position || role == Role::joint_reference || role == Role::joint_velocity ||
         role == Role::joint_acceleration || role == Role::joint_force;
}

// The alias in types.h for a role that has one.
std::string alias(Role role) {
  if (is_joint_array(role)) return "JointState";
  switch (role) {
    case Role::gravity:
      return "Gravity";
    case Role::base_pose:
      return "BasePose";
    case Role::base_velocity:
    case Role::frame_velocity:
      return "Twist";
    case Role::base_acceleration:
    case Role::frame_acceleration:
      return "SpatialAcceleration";
    case Role::base_wrench:
      return "Wrench";
    case Role::link_wrenches:
      return "LinkWrenches";
    case Role::inertia_matrix:
      return "InertiaMatrix";
    case Role::position:
      return "Vector3";
    case Role::energy:
    case Role::mass:
    case Role::distance:
      return "Scalar";
    case Role::parameters:
      return kParametersType;
    default:
      return "";
  }
}

// The type of the runtime (results.h) for these outputs; empty if there is none.
std::string common_structure(const Program& program) {
  if (program.outputs.size() != 2) return "";
  const Role first = program.outputs[0].role, second = program.outputs[1].role;
  if (first == Role::joint_force && second == Role::base_acceleration) return "InverseDynamics";
  if (first == Role::joint_force && second == Role::base_wrench) return "GeneralizedForce";
  if (first == Role::joint_acceleration && second == Role::base_acceleration) return "GeneralizedAcceleration";
  return "";
}

// `transforms::motion` -> `motion`.
std::string last_of(const std::string& scope) {
  const std::size_t separator = scope.rfind(':');
  return separator == std::string::npos ? scope : scope.substr(separator + 1);
}

std::string owner(const Program& program) {
  const bool reads_kept =
      std::any_of(program.inputs.begin(), program.inputs.end(), [](const InputArray& a) { return is_kept(a.role); });
  return reads_kept ? kFactorType : "";
}

// The roles of a function's inputs, with or without gravity.
std::vector<Role> signature(const Program& program, bool with_gravity) {
  std::vector<Role> roles;
  for (const InputArray& input : program.inputs)
    if (with_gravity || input.role != Role::gravity) roles.push_back(input.role);
  return roles;
}

// The names of an input's elements, for a function that takes them one by one.
std::vector<std::string> variable_names(const Api& api, const InputArray& input) {
  const std::vector<std::string>& all = api.library->document.variables;
  std::vector<std::string> names;
  for (const std::string& label : input.elements)
    names.push_back(api.variables[static_cast<std::size_t>(std::find(all.begin(), all.end(), label) - all.begin())]);
  return names;
}

std::vector<std::string> members_of(const std::string& object, const std::vector<std::string>& members) {
  std::vector<std::string> result;
  for (const std::string& member : members) result.push_back(object + "." + member);
  return result;
}

Overload overload(const Api& api, const Callable& callable, bool with_gravity) {
  const Program& program = callable.function->program;
  const std::vector<KernelArray>& names = callable.parameters;
  Overload result{&callable, callable.result, {}, !with_gravity, false, {}, {}};
  for (std::size_t i = 0; i < program.inputs.size(); ++i) {
    const InputArray& input = program.inputs[i];
    if (!with_gravity && input.role == Role::gravity) continue;
    if (input.role == Role::variables) {
      const std::vector<std::string> variables = variable_names(api, input);
      for (const std::string& variable : variables) result.arguments.push_back({"Scalar", variable});
      result.packed.push_back({names[i].name, variables});
      result.inputs.push_back(names[i].name);
    } else if (input.role == Role::parameters && !api.library->has_robot()) {
      result.arguments.push_back({"Parameters", names[i].name});
      result.packed.push_back({kParameterValues, members_of(names[i].name, api.parameters)});
      result.inputs.push_back(kParameterValues);
    } else if (is_kept(input.role)) {
      result.inputs.push_back(kept_name(input.name) + ".data()");
    } else {
      result.arguments.push_back({type_of(input), names[i].name});
      result.inputs.push_back(names[i].name + ".data()");
    }
  }
  return result;
}

Callable callable(
    const Function& f,
    const std::string& kernel,
    const std::string& name,
    const std::string& columns = "",
    const std::string& owner = "") {
  Callable result{&f, kernel, name, columns, owner};
  result.result = result_type(f);
  // In a namespace, functions are named after frames; as a part of another word, such a name would be ambiguous.
  if (returns_own_structure(f.program) && !f.scope.empty())
    result.result = name_of_structure(last_of(f.scope)) + "_" + name;
  result.parameters = parameters(f.program);
  if (f.core) result.core_parameters = parameters(f.core->program);
  result.count = symbolic::cost(f.program);
  return result;
}

// Names the members of the parameter struct, and the arguments that functions of transforms have in addition to the
// usual ones.
void name_values(const Library& library, Api& api) {
  NameScope members({"Scalar"});
  api.parameters = claim_all(members, model::names_of(library.parameters()));
  NameScope arguments({kParameterValues, "Matrix", "Parameters", "Scalar", "X", "kernel", "parameters", "variables"});
  api.variables = claim_all(arguments, library.document.variables);
}

// Names the fields that hold the parameters, and the getters of the interfaces. All are members of one type.
void name_parameters(const Library& library, Api& api) {
  NameScope scope(
      {"DynamicsParameters", "DynamicsValues", "KinematicsParameters", "KinematicsValues", "SharedValues", "robcogen"});
  api.fields = claim_all(scope, model::names_of(library.parameters()));
  for (const std::string& field : api.fields) api.getters.push_back(scope.claim("get_" + field));
}

}  // namespace

std::vector<std::string> Api::scalars() const {
  if (library->has_single_precision) return {"double", "float"};
  return {"double"};
}

std::string Api::scalars_in_words() const {
  return joined(scalars(), " and ");
}

Api api(const Library& library) {
  Api result;
  result.library = &library;
  result.space = whole_namespace(library);
  const model::KinematicTree& tree = library.tree;
  result.joints = enumerators(model::names_of(tree, tree.coordinates()));
  if (model::has_own_positions(tree)) result.positions = enumerators(model::position_names(tree));
  result.coupled = enumerators(model::coupled_names(tree));
  result.links = enumerators(model::link_names(tree));
  result.frames = enumerators(library.frames());
  result.limbs = enumerators(model::limb_names(tree));
  name_values(library, result);

  NameScope kernels;
  std::vector<std::string> wanted;
  for (const Function& f : library.functions) wanted.push_back(f.kernel);
  const std::vector<std::string> kernel_names = claim_all(kernels, wanted);

  // Overloads share a name; different functions must not.
  std::map<std::string, NameScope> taken;
  std::map<std::pair<std::string, std::string>, std::string> names;
  for (const bool legal : {true, false}) {
    for (const Function& f : library.functions) {
      if ((identifier(f.name) == f.name) != legal || names.contains({f.scope, f.name})) continue;
      names[{f.scope, f.name}] = taken[f.scope].claim(f.name);
    }
  }
  for (std::size_t i = 0; i < library.functions.size(); ++i) {
    const Function& f = library.functions[i];
    const std::string& name = names.at({f.scope, f.name});
    const bool jacobian = !f.program.outputs.empty() && symbolic::is_jacobian(f.program.outputs.front().role);
    const auto listed = [&](const Callable& c) { return c.name == name && c.function->scope == f.scope; };
    const auto first = std::find_if(result.callables.begin(), result.callables.end(), listed);
    const bool is_listed = first == result.callables.end() && (jacobian || !f.labels.empty() || !f.row_joints.empty());
    const std::string columns =
        is_listed ? taken[f.scope].claim(name + (f.row_joints.empty() ? "_columns" : "_joints")) : "";
    result.callables.push_back(callable(f, kernel_names[i], name, columns, owner(f.program)));
  }
  for (const Function& f : library.right_sides) result.right_sides.push_back(callable(f, f.kernel, f.name));
  if (!library.updates.empty()) name_parameters(library, result);
  for (const Function& f : library.updates) result.updates.push_back(callable(f, f.kernel, f.name));
  for (const Function& f : library.numbers) result.numbers.push_back(callable(f, f.kernel, f.name));
  if (library.trigonometry) {
    const Function& f = library.trigonometry->addition;
    result.trigonometry.push_back(callable(f, f.kernel, f.name));
  }
  return result;
}

std::string matrix_type(int rows, int columns) {
  return "Matrix<" + std::to_string(rows) + ", " + std::to_string(columns) + ">";
}

std::string type_of(const InputArray& input) {
  const bool is_of_joints = input.role == Role::joint_position || input.role == Role::joint_reference;
  if (is_of_joints && (!input.quaternions.empty() || input.followers > 0)) return "JointPositions";
  if (input.role == Role::homogeneous) return matrix_type(4, 4);
  const std::string name = alias(input.role);
  return name.empty() ? matrix_type(static_cast<int>(input.elements.size()), 1) : name;
}

std::string type_of(const OutputArray& output) {
  const std::string name = alias(output.role);
  return name.empty() ? matrix_type(output.rows, output.columns) : name;
}

bool is_kept(Role role) {
  return role == Role::inertia_factor || role == Role::inverse_diagonal;
}

std::string kept_name(const std::string& array) {
  return array + "_";
}

bool returns_object(const Program& program) {
  return !program.outputs.empty() && is_kept(program.outputs.front().role);
}

std::string result_type(const Function& function) {
  const Program& program = function.program;
  if (returns_object(program)) return kFactorType;
  if (program.outputs.size() == 1) return type_of(program.outputs.front());
  const std::string common = common_structure(program);
  return common.empty() ? name_of_structure(function.name) : common;
}

bool returns_own_structure(const Program& program) {
  return program.outputs.size() > 1 && !returns_object(program) && common_structure(program).empty();
}

std::vector<const Callable*> callables_with_structures(const Api& api) {
  std::vector<const Callable*> result;
  std::set<std::string> types;
  for (const Callable& c : api.callables)
    if (returns_own_structure(c.function->program) && types.insert(c.result).second) result.push_back(&c);
  return result;
}

std::string result_member(const Program& program, const OutputArray& output) {
  return program.outputs.size() == 1 ? "" : output.name;
}

std::vector<Overload> overloads(const Api& api, const std::vector<const Callable*>& callables) {
  std::vector<Overload> result;
  for (const Callable* callable : callables) {
    const Program& program = callable->function->program;
    result.push_back(overload(api, *callable, true));
    if (api.library->tree.floating_base) continue;
    const std::vector<Role> without = signature(program, false);
    const bool optional = std::none_of(callables.begin(), callables.end(), [&](const Callable* other) {
      return signature(other->function->program, true) == without;
    });
    if (optional) result.push_back(overload(api, *callable, false));
  }
  const std::vector<Overload> plain = result;
  for (const Overload& o : plain)
    if (Overload other = with_sines(api, o); other.takes_sines) result.push_back(std::move(other));
  return result;
}

Overload with_sines(const Api& api, const Overload& plain) {
  Overload result = plain;
  if (!api.takes_sines()) return result;
  const Program& program = plain.callable->function->program;
  // Arguments and inputs correspond one to one, except that gravity may have no argument.
  for (std::size_t i = 0, a = 0; i < program.inputs.size(); ++i) {
    const Role role = program.inputs[i].role;
    if (role == Role::gravity && plain.adds_standard_gravity) continue;
    if (role == Role::joint_position) {
      result.takes_sines = true;
      result.arguments[a] = {kTrigonometryType, kTrigonometryName};
      const std::string at = kTrigonometryName;
      std::vector<std::string> inputs = {at + ".q().data()"};
      if (plain.callable->function->core) inputs.insert(inputs.end(), {at + ".sin_data()", at + ".cos_data()"});
      if (!plain.adds_standard_gravity) {
        const auto place = result.inputs.erase(result.inputs.begin() + static_cast<std::ptrdiff_t>(i));
        result.inputs.insert(place, inputs.begin(), inputs.end());
      }
      return result;
    }
    if (!is_kept(role)) ++a;
  }
  return result;
}

std::vector<Overload> overloads(const Api& api, const std::string& group, const std::string& scope) {
  // Functions of one name are grouped at the place of the first of them.
  std::vector<std::string> order;
  std::map<std::string, std::vector<const Callable*>> by_name;
  for (const Callable& c : api.callables) {
    if (c.function->group != group || c.function->scope != scope || !c.owner.empty()) continue;
    if (!by_name.contains(c.name)) order.push_back(c.name);
    by_name[c.name].push_back(&c);
  }
  std::vector<Overload> result;
  for (const std::string& name : order)
    for (Overload& o : overloads(api, by_name[name])) result.push_back(std::move(o));
  return result;
}

std::vector<Overload> members(const Api& api, const std::string& type) {
  std::vector<Overload> result;
  for (const Callable& c : api.callables)
    if (c.owner == type) result.push_back(overload(api, c, true));
  return result;
}

std::vector<std::string> scopes(const Api& api, const std::string& group) {
  std::vector<std::string> result;
  for (const Callable& c : api.callables) {
    if (c.function->group != group || !c.owner.empty()) continue;
    if (std::find(result.begin(), result.end(), c.function->scope) == result.end()) result.push_back(c.function->scope);
  }
  return result;
}

}  // namespace robcogen::backend::cpp
