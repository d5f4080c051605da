#include "backend/compatibility/words.h"

#include <algorithm>
#include <cctype>
#include <limits>
#include <utility>

#include "backend/compatibility/compatibility.h"
#include "backend/cpp/compiled_kernels.h"
#include "backend/cpp/layout.h"
#include "backend/cpp/names.h"
#include "backend/cpp/printers.h"
#include "support/concat.h"
#include "support/index.h"

namespace robcogen::backend::compatibility {
namespace {

using Words = std::map<std::string, std::string>;

constexpr const char* kKernels[] = {
    "inverse_dynamics",
    "inverse_dynamics_gravity",
    "inverse_dynamics_external",
    "inverse_dynamics_fully_actuated",
    "inverse_dynamics_fully_actuated_external",
    "gravity_forces",
    "gravity_forces_gravity",
    "coriolis_forces",
    "forward_dynamics",
    "forward_dynamics_gravity",
    "forward_dynamics_external",
    "joint_space_inertia",
    "joint_space_inertia_factor",
    "inertia_factor_inverse",
    "center_of_mass"};

// The pattern for each item, which @ITEM@ stands for.
std::string for_each(const std::vector<std::string>& items, const std::string& pattern) {
  std::string text;
  for (const std::string& item : items) text += replaced(pattern, "@ITEM@", item);
  return text;
}

// A member that is the kernel of this name; Absent if there is none.
std::string kernel_member(const cpp::Api& api, const std::string& member, const std::string& kernel) {
  const bool exists = std::any_of(
      api.callables.begin(), api.callables.end(), [&](const cpp::Callable& c) { return c.kernel == kernel; });
  return "  template <class Scalar>\n  static constexpr " +
         (exists ? "auto " + member + " = ::" + api.space + "::kernel::" + kernel + "<Scalar>;\n"
                 : "::robcogen::compatibility::Absent " + member + "{};\n");
}

// The functions of a scope between two frames, without derivatives.
std::vector<const cpp::Callable*> functions_of(const cpp::Api& api, const std::string& scope) {
  std::vector<const cpp::Callable*> list;
  for (const cpp::Callable& c : api.callables)
    if (c.function->scope == scope && !c.function->left.empty() && c.function->derivatives.empty() &&
        is_kinematics(c.function->group))
      list.push_back(&c);
  return list;
}

// What a pair of frames is to the templates of the runtime: that of a link and its parent, with the joint between them,
// one of frames of one link, or another.
std::string pair(const model::KinematicTree& tree, const std::string& left, const std::string& right) {
  for (std::size_t j = 0; j < tree.joints.size(); ++j) {
    const auto frame = [&](int link) { return model::implicit_frame_name(tree.links[at(link)].name); };
    const std::string parent = frame(tree.joints[j].parent), child = frame(tree.joints[j].child);
    if (left == parent && right == child) return "ChildToParent<" + std::to_string(j) + ">";
    if (left == child && right == parent) return "ParentToChild<" + std::to_string(j) + ">";
  }
  const auto link = [&](const std::string& frame) { return tree.link_of(*tree.find_frame(frame)); };
  return link(left) == link(right) ? "ConstantPair" : "FramePair";
}

void add_transforms(const cpp::Api& api, Words& words) {
  const std::vector<const cpp::Callable*> list = functions_of(api, "transforms::homogeneous");
  for (const cpp::Callable* f : list)
    words["TRANSFORM_ROWS"] +=
        "ROBCOGEN_TRANSFORM(" + f->name + ", " + pair(api.library->tree, f->function->left, f->function->right) + ")\n";
  words["FIRST_TRANSFORM"] = list.front()->name;
}

void add_jacobians(const cpp::Api& api, Words& words) {
  words["JACOBIAN_ROWS"] = "";
  for (const cpp::Callable* f : functions_of(api, "jacobians")) {
    const std::string columns = std::to_string(f->function->program.outputs.front().columns);
    words["JACOBIAN_ROWS"] += "ROBCOGEN_JACOBIAN(" + f->name + ", " + columns + ")\n";
  }
}

// The constructors and the assignment of a class whose members refer to it: to its parameters, which these getters
// provide, or to its state.
std::string constructors(const std::string& type, const std::vector<std::string>& getters) {
  std::vector<std::string> arguments, pointers;
  for (const std::string& getter : getters) {
    const std::string name = getter.substr(getter.find('_') + 1);
    arguments.push_back("const " + getter + "& " + name);
    pointers.push_back("&" + name);
  }
  const std::string with_getters =
      getters.empty() ? "" : "  explicit @T@(" + joined(arguments) + ") : Base(" + joined(pointers) + ") {}\n";
  const std::string text =
      "  @T@() = default;\n" + with_getters +
      "  @T@(const @T@& other) : @T@() { *this = other; }\n  @T@& operator=(const @T@&) = default;\n";
  return replaced(text, "@T@", type);
}

// The parameters of a kind: their structure, the interface that provides them, and how the library takes either.
struct ParameterTypes {
  std::vector<std::string> names = {};
  std::string text = {};
};

ParameterTypes parameter_types(
    const cpp::Api& api,
    const std::string& structure,
    const std::string& getter,
    bool (*is_of)(const model::Parameter&)) {
  ParameterTypes types;
  std::string defaults, values, called;
  for (std::size_t i = 0; i < api.library->parameters().size(); ++i) {
    const model::Parameter& p = api.library->parameters()[i];
    if (!is_of(p)) continue;
    const std::string to = "  to[" + std::to_string(i) + "] = from.";
    types.names.push_back(p.name);
    if (p.default_value) defaults += " " + p.name + " = " + cpp::model_number(*p.default_value) + ";";
    values += to + p.name + ";\n";
    called += to + "getValue_" + p.name + "();\n";
  }
  const std::string unused = types.names.empty() ? "[[maybe_unused]] " : "";
  const auto store = [&](const std::string& type, const std::string& body) {
    return "\ninline void store(" + unused + "const " + type + "& from, " + unused + "double* to) {\n" + body + "}\n";
  };
  types.text = "struct " + structure + " {\n" + for_each(types.names, "  double @ITEM@;\n") + "  " + structure +
               "() { defaults(); }\n  void defaults() {" + defaults + " }\n};\n\nclass " + getter +
               " {\n public:\n  virtual ~" + getter + "() = default;\n" +
               for_each(types.names, "  virtual double getValue_@ITEM@() const = 0;\n") + "};\n" +
               store(structure, values) + store(getter, called);
  return types;
}

void add_parameters(const cpp::Api& api, Words& words) {
  const ParameterTypes lengths = parameter_types(
      api, "Params_lengths", "ParamsGetter_lengths",
      [](const model::Parameter& p) { return p.kind == model::ParameterKind::length; });
  const ParameterTypes angles = parameter_types(
      api, "Params_angles", "ParamsGetter_angles",
      [](const model::Parameter& p) { return p.kind == model::ParameterKind::angle; });
  const ParameterTypes inertial =
      parameter_types(api, "RuntimeInertiaParams", "RuntimeParamsGetter", model::is_dynamics);
  std::vector<std::string> getters;
  if (!lengths.names.empty()) getters.emplace_back("ParamsGetter_lengths");
  if (!angles.names.empty()) getters.emplace_back("ParamsGetter_angles");
  words["LENGTHS"] = lengths.text;
  words["ANGLES"] = angles.text;
  words["INERTIAL_PARAMETERS"] = inertial.text;
  words["DEFAULT_GETTERS"] =
      for_each(inertial.names, "  double getValue_@ITEM@() const override { return values.@ITEM@; }\n");
  words["TRANSFORM_CONSTRUCTORS"] = constructors("Transforms", getters);
  words["JACOBIAN_CONSTRUCTORS"] = getters.empty() ? "" : constructors("Jacobians", getters);
  for (std::string& getter : getters) getter = "const " + getter + "*";
  words["GETTER_POINTERS"] = joined(getters);
  words["HAS_PARAMETERS"] = api.is_parametric() ? "true" : "false";
  words["INERTIA_CONSTRUCTORS"] =
      api.is_parametric() ? "  InertiaProperties() = default;\n  explicit InertiaProperties(const RuntimeParamsGetter& "
                            "getter) : Base(&getter) {}\n\n"
                          : "";
}

std::string constant_numbers(const model::KinematicTree& tree) {
  const model::DefaultValues value(tree.parameters);
  std::string text =
      "  // Of each link: mass, centre of mass, moments xx yy zz, products xy xz yz.\n"
      "  static constexpr std::array<std::array<double, 10>, kLinks> kLinkNumbers = {{\n";
  for (const model::Link& link : tree.links) {
    const auto [mass, com, inertia] = model::mass_properties(link, value);
    std::vector<double> numbers = {mass};
    numbers.insert(numbers.end(), com.begin(), com.end());
    numbers.insert(numbers.end(), inertia.begin(), inertia.end());
    text += "      {" + cpp::braced(cpp::model_numbers(numbers)) + "},  // " + link.name + "\n";
  }
  return text + "  }};\n";
}

std::string parametric_numbers(const cpp::Api& api) {
  std::vector<double> defaults;
  std::vector<std::string> kinematic, sizes;
  for (const model::Parameter& p : api.library->parameters()) {
    defaults.push_back(p.default_value.value_or(std::numeric_limits<double>::quiet_NaN()));
    kinematic.emplace_back(model::is_kinematics(p) ? "true" : "false");
  }
  for (const symbolic::OutputArray& output : api.library->numbers.front().program.outputs)
    sizes.push_back(std::to_string(output.rows * output.columns));
  return "  template <class Scalar>\n  using Parameters = ::" + api.space +
         "::Parameters<Scalar>;\n  using ParameterArray = ::" + api.space +
         "::ParameterArray;\n  static constexpr ParameterArray kDefaults = {" +
         cpp::braced(cpp::model_numbers(defaults)) + "};\n  static constexpr std::array<bool, " +
         std::to_string(defaults.size()) + "> kIsKinematics = {" + cpp::braced(kinematic) +
         "};\n  static void link_numbers(const double* parameters, double* links) {\n    std::array<double, " +
         sizes[1] + "> joints;\n    std::array<double, " + sizes[2] + "> frames;\n    ::" + api.space +
         "::kernel::model_numbers(parameters, links, joints.data(), frames.data());\n  }\n";
}

std::string includes(const cpp::Api& api) {
  const std::string folder = cpp::folder(*api.library);
  std::vector<std::string> files = {folder + "/kernel/compiled.h", cpp::header_path(folder, "model")};
  if (api.is_parametric()) files.push_back(cpp::header_path(folder, "parameters"));
  for (const std::string& group : groups())
    if (!cpp::callables_of(api, group).empty()) files.push_back(cpp::kernel_path(folder, group));
  std::sort(files.begin(), files.end());
  return for_each(files, "#include \"@ITEM@\"\n");
}

void add_links(const model::KinematicTree& tree, Words& words) {
  const std::vector<std::string> ids = link_identifiers(tree);
  for (std::size_t i = tree.floating_base ? 0 : 1; i < ids.size(); ++i) {
    const auto add = [&](const char* word, const std::string& pattern) {
      words[word] += replaced(replaced(pattern, "@LINK@", tree.links[i].name), "@ID@", ids[i]);
    };
    add("INERTIA_GETTERS",
        "  const IMatrix& getTensor_@LINK@() const { return this->tensor(@ID@); }\n"
        "  Scalar getMass_@LINK@() const { return this->mass(@ID@); }\n"
        "  const Vec3d& getCOM_@LINK@() const { return this->com(@ID@); }\n");
    if (i > 0)
      add("MOTION_GETTERS",
          "  const Velocity& getVelocity_@LINK@() const { return this->velocity(@ID@); }\n"
          "  const Acceleration& getAcceleration_@LINK@() const { return this->acceleration(@ID@); }\n");
    add("MOTION_GETTERS", "  const Force& getForce_@LINK@() const { return this->force(@ID@); }\n");
  }
}

}  // namespace

std::vector<std::string> link_identifiers(const model::KinematicTree& tree) {
  std::vector<std::string> result;
  for (const model::Link& link : tree.links) {
    std::string name = link.name;
    for (char& c : name) c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
    result.push_back(cpp::identifier(name));
  }
  return result;
}

std::map<std::string, std::string> words(const cpp::Api& api, const std::string& space) {
  const model::KinematicTree& tree = api.library->tree;
  const std::vector<std::string> links = link_identifiers(tree);
  const std::string folder = cpp::folder(*api.library);
  Words words = {
      {"OLD", space},
      {"NEW", api.space},
      {"FOLDER", folder},
      {"MODEL", cpp::header_path(folder, "model")},
      {"KERNEL_INCLUDES", includes(api)},
      {"JOINTS", std::to_string(tree.dof())},
      {"LINKS", std::to_string(links.size())},
      {"COORDINATES", std::to_string(tree.dof() + (tree.floating_base ? 6 : 0))},
      {"IS_FLOATING", tree.floating_base ? "true" : "false"},
      {"NUMBERS", api.is_parametric() ? parametric_numbers(api) : constant_numbers(tree)},
      {"JOINT_ENUMERATORS", for_each(api.joints, "  @ITEM@,\n")},
      {"LINK_ENUMERATORS", for_each(links, "  @ITEM@,\n")},
      {"ORDERED_IDS", cpp::numbered_list("static constexpr JointIdentifiers orderedJointIDs[jointsCount]", api.joints) +
                          cpp::numbered_list("static constexpr LinkIdentifiers orderedLinkIDs[linksCount]", links)},
  };
  for (const char* kernel : kKernels) words["KERNELS"] += kernel_member(api, kernel, kernel);
  add_transforms(api, words);
  add_jacobians(api, words);
  add_parameters(api, words);
  add_links(tree, words);
  return words;
}

std::string filled(const std::string& text, const std::map<std::string, std::string>& words) {
  std::string result;
  for (std::size_t from = 0; from < text.size();) {
    const std::size_t begin = text.find('@', from), end = text.find('@', begin + 1);
    result += text.substr(from, begin - from);
    if (begin == std::string::npos) break;
    result += words.at(text.substr(begin + 1, end - begin - 1));
    from = end + 1;
  }
  return result;
}

}  // namespace robcogen::backend::compatibility
