#include "driver/library.h"

#include <algorithm>
#include <limits>
#include <utility>

#include "algorithm/catalogue/transform_functions.h"
#include "algorithm/kinematics/primitive_product.h"
#include "driver/model_data.h"
#include "support/files.h"

namespace robcogen::driver {
namespace {

using backend::AmountStep;
using model::Quantity;

AmountStep::Kind kind_of(Quantity::Op op) {
  switch (op) {
    case Quantity::Op::constant:
      return AmountStep::Kind::constant;
    case Quantity::Op::parameter:
      return AmountStep::Kind::parameter;
    case Quantity::Op::variable:
      return AmountStep::Kind::variable;
    case Quantity::Op::negate:
      return AmountStep::Kind::negate;
    case Quantity::Op::add:
      return AmountStep::Kind::add;
    case Quantity::Op::subtract:
      return AmountStep::Kind::subtract;
    case Quantity::Op::multiply:
      return AmountStep::Kind::multiply;
    case Quantity::Op::divide:
      return AmountStep::Kind::divide;
    case Quantity::Op::sine:
      return AmountStep::Kind::sine;
    case Quantity::Op::cosine:
      return AmountStep::Kind::cosine;
    case Quantity::Op::tangent:
      return AmountStep::Kind::tangent;
    case Quantity::Op::square_root:
      break;
  }
  return AmountStep::Kind::square_root;
}

// Appends the steps that compute a quantity.
void append_steps(const Quantity& q, std::vector<AmountStep>& steps) {
  const AmountStep::Kind kind = kind_of(q.op());
  switch (q.op()) {
    case Quantity::Op::constant:
      steps.push_back({kind, q.number().value(), 0});
      return;
    case Quantity::Op::parameter:
    case Quantity::Op::variable:
      steps.push_back({kind, 0, q.index()});
      return;
    case Quantity::Op::add:
    case Quantity::Op::subtract:
    case Quantity::Op::multiply:
    case Quantity::Op::divide:
      append_steps(q.left(), steps);
      append_steps(q.right(), steps);
      break;
    default:
      append_steps(q.left(), steps);
  }
  steps.push_back({kind, 0, 0});
}

std::vector<backend::FactorData> factors_of(
    const model::CoordinateTransforms& document,
    const model::CoordinateTransform& transform) {
  std::vector<backend::FactorData> factors;
  for (const model::PrimitiveTransform& p : transform.primitives) {
    backend::FactorData factor = {{p.rotation, static_cast<int>(p.axis)}, {}};
    append_steps(document.position == model::MovedFramePosition::left ? -p.amount : p.amount, factor.amount);
    factors.push_back(std::move(factor));
  }
  return factors;
}

// The frames of all transforms, each once.
std::vector<backend::FrameData> frames_of(const model::CoordinateTransforms& document) {
  std::vector<backend::FrameData> frames;
  for (const std::string& name : model::motions_of(document).frames) {
    frames.emplace_back();
    frames.back().name = name;
    frames.back().link = -1;
  }
  return frames;
}

backend::PrimitiveConvention convention_of(Primitives primitives) {
  if (!primitives) return backend::PrimitiveConvention::none;
  return *primitives == model::MovedFramePosition::left ? backend::PrimitiveConvention::left
                                                        : backend::PrimitiveConvention::right;
}

void add_product(algorithm::PrimitiveProduct product, backend::Function& function) {
  for (const model::PrimitiveTransform& p : product.primitives)
    function.primitives.push_back({p.rotation, static_cast<int>(p.axis)});
  function.amounts = std::move(product.amounts);
}

// -1: none of that name.
int index_of(const std::vector<backend::FrameData>& frames, const std::string& name) {
  const auto place = std::find_if(frames.begin(), frames.end(), [&](const auto& frame) { return frame.name == name; });
  return place == frames.end() ? -1 : static_cast<int>(place - frames.begin());
}

// The data of a document without robot.
void add_document(const model::CoordinateTransforms& document, backend::Library& library) {
  library.frames = frames_of(document);
  library.variables = document.variables;
  for (const model::Parameter& p : document.parameters)
    library.parameters.push_back({p.name, p.default_value.value_or(std::numeric_limits<double>::quiet_NaN())});
}

backend::Function library_function(
    const Model& model,
    const backend::Library& library,
    Function&& f,
    Primitives primitives) {
  algorithm::RobotFunction& traced = f.traced;
  backend::Function function;
  function.group = std::move(traced.group);
  function.scope = std::move(traced.scope);
  function.name = std::move(traced.name);
  function.kernel = traced.program.name;
  function.summary = std::move(traced.summary);
  function.columns = std::move(traced.columns);
  function.program = std::move(traced.program);
  function.method = std::move(traced.method);
  function.error = traced.error;
  function.parts = std::move(f.parts);
  function.in_lanes = std::move(f.in_lanes);
  function.limbs_in_lanes = std::move(f.limbs_in_lanes);
  const bool has_product = primitives && function.scope == "transforms::homogeneous";
  if (const Robot* robot = model.robot()) {
    function.left_frame = index_of(library.frames, traced.frames.left.name);
    function.right_frame = index_of(library.frames, traced.frames.right.name);
    if (has_product) add_product(algorithm::primitive_product(robot->tree, traced.frames, *primitives), function);
    return function;
  }
  const model::CoordinateTransforms& document = model.transforms()->document;
  const model::CoordinateTransform& transform = document.transforms[at(f.transform)];
  function.left_frame = index_of(library.frames, transform.left);
  function.right_frame = index_of(library.frames, transform.right);
  function.factors = factors_of(document, transform);
  if (has_product) add_product(algorithm::primitive_product(document, transform, *primitives), function);
  return function;
}

}  // namespace

backend::Library assemble(
    const Model& model,
    const LibraryNames& names,
    const std::vector<std::string>& groups,
    Functions functions,
    Primitives primitives) {
  backend::Library result;
  result.name = names.name;
  result.enclosing = names.enclosing;
  result.robot = model.name();
  result.model_file = model.file.filename().string();
  result.model_hash = hash_text(model.canonical);
  result.generator_version = kVersion;
  result.groups = groups;
  result.primitives = convention_of(primitives);
  if (const Robot* robot = model.robot()) {
    result.floating_base = robot->tree.floating_base;
    add_model(robot->tree, result);
  } else {
    add_document(model.transforms()->document, result);
  }
  for (Function& f : functions.list)
    result.functions.push_back(library_function(model, result, std::move(f), primitives));
  result.updates = std::move(functions.updates);
  result.numbers = std::move(functions.numbers);
  result.trigonometry = std::move(functions.trigonometry);
  return result;
}

}  // namespace robcogen::driver
