#include "driver/library.h"

#include <algorithm>
#include <utility>

#include "algorithm/catalogue/transform_functions.h"
#include "algorithm/kinematics/primitive_product.h"
#include "driver/derivatives.h"
#include "support/files.h"

namespace robcogen::driver {
namespace {

backend::PrimitiveConvention convention_of(Primitives primitives) {
  if (!primitives) return backend::PrimitiveConvention::none;
  return *primitives == model::MovedFramePosition::left ? backend::PrimitiveConvention::left
                                                        : backend::PrimitiveConvention::right;
}

backend::ProductData data_of(algorithm::PrimitiveProduct product) {
  backend::ProductData data;
  for (const model::PrimitiveTransform& p : product.primitives)
    data.primitives.push_back({p.rotation, static_cast<int>(p.axis)});
  data.amounts = std::move(product.amounts);
  return data;
}

// -1 if there is no frame of that name.
int index_of(const std::vector<std::string>& frames, const std::string& name) {
  const auto place = std::find(frames.begin(), frames.end(), name);
  return place == frames.end() ? -1 : static_cast<int>(place - frames.begin());
}

backend::Function library_function(
    const Model& model,
    const std::vector<std::string>& frames,
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
  function.labels = std::move(traced.labels);
  function.program = std::move(traced.program);
  function.method = std::move(traced.method);
  function.error = traced.error;
  function.derivatives = std::move(traced.derivatives);
  function.parts = std::move(f.parts);
  function.in_lanes = std::move(f.in_lanes);
  function.limbs_in_lanes = std::move(f.limbs_in_lanes);
  function.solved = std::move(traced.solved);
  const bool is_homogeneous = function.scope == "transforms::homogeneous" && function.derivatives.empty();
  if (const Robot* robot = model.robot()) {
    function.left_frame = index_of(frames, traced.frames.left.name);
    function.right_frame = index_of(frames, traced.frames.right.name);
    if (is_homogeneous && primitives)
      function.product = data_of(algorithm::primitive_product(robot->tree, traced.frames, *primitives));
    return function;
  }
  const model::CoordinateTransforms& document = model.transforms()->document;
  const model::CoordinateTransform& transform = document.transforms[at(f.transform)];
  function.left_frame = index_of(frames, transform.left);
  function.right_frame = index_of(frames, transform.right);
  if (!is_homogeneous) return function;
  if (primitives)
    function.product = data_of(
        algorithm::primitive_product(document, transform, *primitives, algorithm::arguments_of(document, transform)));
  function.factors = data_of(algorithm::primitive_product(
      document, transform, model::MovedFramePosition::right, algorithm::all_arguments(document)));
  return function;
}

bool has_contacts(const Functions& functions) {
  const std::vector<std::string>& groups = algorithm::groups_of_contacts();
  return std::any_of(functions.list.begin(), functions.list.end(), [&](const Function& f) {
    return std::find(groups.begin(), groups.end(), f.traced.group) != groups.end();
  });
}

}  // namespace

backend::Library assemble(
    const Model& model,
    const LibraryNames& names,
    std::vector<std::string> groups,
    Functions functions,
    Primitives primitives) {
  backend::Library result;
  result.name = names.name;
  result.enclosing = names.enclosing;
  result.model_file = model.file.filename().string();
  result.model_hash = hash_text(model.canonical);
  result.generator_version = kVersion;
  result.groups = std::move(groups);
  if (!model.derivatives().empty()) result.groups.emplace_back(kDerivativesGroup);
  result.primitives = convention_of(primitives);
  if (const Robot* robot = model.robot()) {
    result.tree = robot->tree;
    if (has_contacts(functions)) result.contacts = robot->desired.contacts;
  } else {
    result.document = model.transforms()->document;
  }
  const std::vector<std::string> frames = result.frames();
  for (Function& f : functions.list)
    (f.is_stage ? result.right_sides : result.functions)
        .push_back(library_function(model, frames, std::move(f), primitives));
  result.updates = std::move(functions.updates);
  result.numbers = std::move(functions.numbers);
  result.trigonometry = std::move(functions.trigonometry);
  return result;
}

}  // namespace robcogen::driver
