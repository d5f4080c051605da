#include "functions.h"

#include <algorithm>
#include <cmath>

#include "backend/matlab/dialect.h"
#include "driver/derivatives.h"

namespace robcogen::octave {
namespace {

using symbolic::InputArray;
using symbolic::OutputArray;
using symbolic::Role;

// Converts `a::b` to `a.b.`.
std::string dotted(const std::string& scope) {
  std::string text = scope;
  for (std::size_t at = text.find("::"); at != std::string::npos; at = text.find("::")) text.replace(at, 2, ".");
  return text.empty() ? "" : text + ".";
}

Argument argument(const backend::Library& library, const InputArray& array) {
  Argument result{array.name, static_cast<int>(array.elements.size())};
  result.quaternions = array.quaternions;
  // Loops close only near the position in which they are assembled.
  if (array.role == Role::joint_position && !library.tree.loops.empty()) result.limit = 0.1;
  if (array.role == Role::link_wrenches) {
    result.rows = 6;
    result.columns = library.tree.link_count();
  }
  if (array.role == Role::variables) result.kind = "scalars";
  if (array.role == Role::inertia_factor)
    result.rows = result.columns = static_cast<int>(std::lround(std::sqrt(static_cast<double>(result.rows))));
  if (array.role == Role::parameters) {
    result.kind = "struct";
    const std::vector<model::Parameter>& parameters = library.parameters();
    for (const model::Parameter& p : parameters) result.around.push_back(p.default_value.value_or(1.0));
    for (const std::string& field : backend::matlab::fields(model::names_of(parameters)))
      result.kind += (result.kind == "struct" ? ":" : ",") + field;
  }
  return result;
}

}  // namespace

std::optional<backend::Library> load(
    const std::filesystem::path& model,
    const std::string& desired,
    const std::string& name,
    const std::string& primitives,
    const std::vector<std::string>& groups,
    const driver::Steps& steps,
    const std::vector<std::string>& derivatives) {
  driver::LibraryOptions options = {.names = {name}, .groups = groups, .steps = steps};
  if (primitives != kNone)
    options.primitives = primitives == "left" ? model::MovedFramePosition::left : model::MovedFramePosition::right;
  driver::LoadOptions reading;
  if (desired != kNone) reading.desired = desired;
  for (const std::string& text : derivatives) reading.derivatives.push_back(driver::parse_derivative(text));
  Diagnostics diagnostics;
  const auto loaded = driver::load(model, reading, diagnostics);
  return loaded ? std::optional(driver::library(*loaded, options)) : std::nullopt;
}

Call shape(const backend::Library& library, const backend::Function& function) {
  Call call;
  call.function = dotted(library.enclosing) + library.name + "." + dotted(function.scope) + function.name;
  // `inverse` is a built-in function of MATLAB.
  if (function.name == "inverse") call.function += function.scope == "inertia_factor" ? "_H" : "_";
  for (const InputArray& array : function.program.inputs) call.arguments.push_back(argument(library, array));
  for (const OutputArray& array : function.program.outputs)
    call.results.push_back({array.name, array.rows, array.columns});
  return call;
}

std::optional<Call> shape_of_product(const backend::Library& library, const backend::Function& function) {
  if (library.primitives == backend::PrimitiveConvention::none || !function.product) return std::nullopt;
  backend::Function product = function;
  product.scope = "transforms::product";
  return shape(library, product);
}

bool may_omit_gravity(const backend::Library& library, const backend::Function& function) {
  const std::vector<InputArray>& inputs = function.program.inputs;
  if (library.tree.floating_base || inputs.empty() || inputs.back().role != Role::gravity) return false;
  return std::none_of(library.functions.begin(), library.functions.end(), [&](const backend::Function& other) {
    return other.scope == function.scope && other.name == function.name && other.program.inputs.size() < inputs.size();
  });
}

}  // namespace robcogen::octave
