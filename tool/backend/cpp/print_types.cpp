// <name>/types.h: the types of arguments and results.
#include <algorithm>
#include <cmath>

#include "backend/cpp/layout.h"
#include "backend/cpp/printers.h"
#include "support/number.h"

namespace robcogen::backend::cpp {
namespace {

std::string matrix_alias(const std::string& scalar) {
  return "template <int kRows, int kColumns>\nusing Matrix = robcogen::Matrix<" + scalar + ", kRows, kColumns>;\n";
}

std::string parameters_struct(const Api& api, const std::string& scalar) {
  if (api.parameters.empty()) return "";
  std::string members;
  for (std::size_t i = 0; i < api.parameters.size(); ++i) {
    const double value = model::default_of(api.library->parameters()[i]);
    const std::string none = "std::numeric_limits<Scalar>::quiet_NaN()";
    members += "  Scalar " + api.parameters[i] + " = " +
               (std::isnan(value) ? none : "Scalar(" + print_double(value) + ")") + ";\n";
  }
  return comment("Values of the model's parameters, m or rad. A parameter without default is NaN until it is set.") +
         "struct Parameters {\n  using Scalar = " + scalar + ";\n\n" + members + "};\n";
}

bool takes_pose(const Api& api) {
  return std::any_of(api.callables.begin(), api.callables.end(), [](const Callable& c) {
    const auto& inputs = c.function->program.inputs;
    return std::any_of(
        inputs.begin(), inputs.end(), [](const auto& array) { return array.role == symbolic::Role::base_pose; });
  });
}

// One set of aliases; the text is the same for both scalars.
std::string aliases(const Api& api, const std::string& scalar) {
  const Library& library = *api.library;
  const std::string size = library.tree.floating_base ? "6 + kDof" : "kDof";
  std::string result =
      "using Scalar = " + scalar + ";\n" + "using Vector3 = Eigen::Matrix<" + scalar + ", 3, 1>;\n" +
      "using JointState = JointVector<" + scalar + ">;\n" +
      (model::has_own_positions(library.tree) ? "using JointPositions = PositionVector<" + scalar + ">;\n" : "") +
      "using InertiaMatrix = robcogen::Matrix<" + scalar + ", " + size + ", " + size + ">;\n" +
      "using LinkWrenches = robcogen::LinkWrenches<" + scalar + ", Link, kLinkCount>;\n";
  for (const std::string type : {"Gravity", "Twist", "SpatialAcceleration", "Wrench"})
    result += "using " + type + " = robcogen::Basic" + type + "<" + scalar + ">;\n";
  if (takes_pose(api)) result += "using BasePose = robcogen::BasicBasePose<" + scalar + ">;\n";
  if (library.tree.floating_base)
    for (const std::string type : {"InverseDynamics", "GeneralizedForce", "GeneralizedAcceleration"})
      result += "using " + type + " = robcogen::" + type + "<" + scalar + ", kDof>;\n";
  return result + "\n" + matrix_alias(scalar);
}

// The aliases, in this precision, of the library's own class templates.
std::string aliases_of_classes(const Api& api, const std::string& scalar) {
  std::string text;
  const auto add = [&](const std::string& name) {
    text += "using " + name + " = Basic" + name + "<" + scalar + ">;\n";
  };
  if (api.takes_sines()) add(kTrigonometryType);
  for (const Callable& c : api.callables)
    if (returns_object(c.function->program)) add(result_type(*c.function));
  for (const Callable* c : callables_with_structures(api)) add(c->result);
  return text;
}

// The types that functions of transforms take and return.
std::string transform_types(const Api& api, const std::string& scalar) {
  return paragraphs(
      {"using Scalar = " + scalar + ";\n" + aliases_of_classes(api, scalar), matrix_alias(scalar),
       parameters_struct(api, scalar)});
}

// The type of a member of a result structure, in any precision: that of a function which returns this output alone.
std::string member_type(const Api& api, const symbolic::OutputArray& output) {
  const std::string type = type_of(output);
  for (const std::string of_runtime : {"Twist", "SpatialAcceleration", "Wrench", "Gravity"})
    if (type == of_runtime) return "robcogen::Basic" + type + "<Scalar>";
  if (type == "Scalar") return type;
  if (type == "JointState" && output.rows == static_cast<int>(api.joints.size())) return "JointVector<Scalar>";
  return "robcogen::Matrix<Scalar, " + std::to_string(output.rows) + ", " + std::to_string(output.columns) + ">";
}

// The structures that functions with several results return.
std::string structures(const Api& api) {
  std::vector<std::string> texts;
  for (const Callable* c : callables_with_structures(api)) {
    std::string members;
    for (const symbolic::OutputArray& output : c->function->program.outputs)
      members += "  " + member_type(api, output) + " " + output.name + ";\n";
    texts.push_back(
        comment("The results of " + c->name + ".") + "template <class Scalar>\nstruct ROBCOGEN_ALIGNED Basic" +
        c->result + " {\n" + members + "};\n");
  }
  return paragraphs(texts);
}

// The same types in namespace f32; empty if the library has no single precision.
std::string in_single_precision(const Library& library, const std::string& types) {
  if (!library.has_single_precision) return "";
  return "// The same in single precision.\n" + in_namespace("f32", types);
}

}  // namespace

std::string print_types(const Api& api, const std::string& path) {
  const Library& library = *api.library;
  if (!library.has_robot()) {
    const std::string types = paragraphs(
        {structures(api), transform_types(api, "double"), in_single_precision(library, transform_types(api, "float"))});
    return paragraphs(
        {banner(library, path, "types of arguments and results"), "#pragma once\n", includes({"<Eigen/Core>"}),
         library.parameters().empty() ? "" : includes({"<limits>"}), includes({"\"robcogen/matrix.h\""}),
         includes({"\"" + header_path(folder(library), "model") + "\""}), in_namespace(api.space, types)});
  }
  std::vector<std::string> runtime = {"\"robcogen/link_wrenches.h\""};
  runtime.push_back("\"robcogen/matrix.h\"");
  if (takes_pose(api)) runtime.push_back("\"robcogen/pose.h\"");
  runtime.push_back("\"robcogen/spatial.h\"");
  if (library.tree.floating_base) runtime.push_back("\"robcogen/results.h\"");
  std::vector<std::string> headers = {header_path(folder(library), "model")};
  if (api.is_parametric()) headers.push_back(header_path(folder(library), kParameters));
  const std::string trigonometry = trigonometry_type(api), factor = factor_type(api);
  if (!trigonometry.empty() || !factor.empty()) headers.push_back(kernels_path(folder(library)));
  for (std::string& header : headers) header = cpp::quoted(header);
  const auto both = [&](const std::string& scalar) {
    return paragraphs({aliases(api, scalar), aliases_of_classes(api, scalar)});
  };
  const std::string body = paragraphs(
      {"// One value per joint, in the order of Joint.\ntemplate <class Scalar>\nusing JointVector = "
       "robcogen::Matrix<Scalar, kDof, 1>;\n",
       model::has_own_positions(library.tree)
           ? comment(
                 "Positions, in the order of Position." +
                 std::string(
                     !library.tree.spherical_joints().empty()
                         ? " Quaternions must be of unit length, which is not checked: rounding errors are harmless, "
                           "and robcogen/positions.h normalises quaternions."
                         : "") +
                 (library.tree.followers_in_q().empty()
                      ? ""
                      : " The last ones follow through loops: close_loops computes them.")) +
                 "template <class Scalar>\nusing PositionVector = robcogen::Matrix<Scalar, kPositions, 1>;\n"
           : "",
       trigonometry, factor, structures(api), both("double"), in_single_precision(library, both("float"))});
  return paragraphs(
      {banner(library, path, "types of arguments and results"), "#pragma once\n", includes({"<Eigen/Core>"}),
       trigonometry.empty() ? "" : includes({"<array>"}), includes(runtime), includes(headers),
       in_namespace(api.space, body)});
}

}  // namespace robcogen::backend::cpp
