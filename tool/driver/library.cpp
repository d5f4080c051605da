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

// The function with its frames in the library, and with the products that are asked for.
symbolic::Function in_library(
    symbolic::Function function,
    const Model& model,
    const std::vector<std::string>& frames,
    Primitives primitives) {
  function.left_frame = index_of(frames, function.left);
  function.right_frame = index_of(frames, function.right);
  if (function.scope != "transforms::homogeneous" || !function.derivatives.empty()) return function;
  if (const Robot* robot = model.robot()) {
    const model::FramePair pair = {*robot->tree.find_frame(function.left), *robot->tree.find_frame(function.right)};
    if (primitives) function.product = data_of(algorithm::primitive_product(robot->tree, pair, *primitives));
    return function;
  }
  const model::CoordinateTransforms& document = model.transforms()->document;
  const auto transform = std::find_if(document.transforms.begin(), document.transforms.end(), [&](const auto& t) {
    return algorithm::name_of(t) == function.name;
  });
  if (primitives)
    function.product = data_of(
        algorithm::primitive_product(document, *transform, *primitives, algorithm::arguments_of(document, *transform)));
  function.factors = data_of(algorithm::primitive_product(
      document, *transform, model::MovedFramePosition::right, algorithm::all_arguments(document)));
  return function;
}

bool has_contacts(const Functions& functions) {
  return std::any_of(functions.list.begin(), functions.list.end(), [](const Function& f) {
    return f.declared && f.declared->is->of == algorithm::Of::contacts && f.derivatives_in_turn.empty();
  });
}

}  // namespace

backend::Library library_of(
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
    result.inverses = robot->desired.inverses;
  } else {
    result.document = model.transforms()->document;
  }
  const std::vector<std::string> frames = result.frames();
  for (Function& f : functions.list)
    (f.is_stage ? result.right_sides : result.functions).push_back(in_library(std::move(f), model, frames, primitives));
  result.updates = std::move(functions.updates);
  result.numbers = std::move(functions.numbers);
  result.trigonometry = std::move(functions.trigonometry);
  return result;
}

}  // namespace robcogen::driver
