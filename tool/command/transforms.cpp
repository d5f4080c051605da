#include "command/transforms.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <map>

#include "command/parameter_list.h"
#include "export/frames.h"
#include "import/frames.h"
#include "pass/passes.h"
#include "support/files.h"

namespace robcogen::command {
namespace {

using backend::AmountStep;
using model::FrameNames;
using model::Quantity;

// The pairs of frames that the list asks for; nullopt when an error was reported.
std::optional<std::vector<FrameNames>> desired_pairs(
    const Reading& reading,
    const model::RigidMotions& motions,
    Diagnostics& diagnostics) {
  const language::desired::Document list = language::desired::parse(read_source(*reading.desired), diagnostics);
  if (diagnostics.has_errors()) return std::nullopt;
  std::vector<FrameNames> pairs = import::desired_frame_pairs(list, motions, diagnostics);
  if (reading.strict) promote_strict_warnings(diagnostics);
  if (diagnostics.has_errors()) return std::nullopt;
  return pairs;
}

std::optional<model::RigidMotions> read_motions(const std::shared_ptr<const Source>& source, Diagnostics& diagnostics) {
  const language::motion::Document document = language::motion::parse(source, diagnostics);
  return diagnostics.has_errors() ? std::nullopt : import::rigid_motions(document, diagnostics);
}

std::optional<model::CoordinateTransforms> read_transforms(
    const std::shared_ptr<const Source>& source,
    Diagnostics& diagnostics) {
  const language::transforms::Document document = language::transforms::parse(source, diagnostics);
  return diagnostics.has_errors() ? std::nullopt : import::coordinate_transforms(document, diagnostics);
}

std::optional<Transforms> load_motions(
    const std::shared_ptr<const Source>& source,
    const Reading& reading,
    Diagnostics& diagnostics) {
  const std::optional<model::RigidMotions> motions = read_motions(source, diagnostics);
  if (!motions) return std::nullopt;
  std::optional<std::vector<FrameNames>> pairs = model::default_transforms(*motions);
  if (reading.desired) pairs = desired_pairs(reading, *motions, diagnostics);
  if (!pairs) return std::nullopt;
  return Transforms{
      model::transforms_of(*motions, *pairs), language::motion::print(exporting::motion_document(*motions)), {}, {}};
}

std::optional<Transforms> load_document(
    const std::shared_ptr<const Source>& source,
    const Reading& reading,
    Diagnostics& diagnostics) {
  std::optional<model::CoordinateTransforms> transforms = read_transforms(source, diagnostics);
  if (!transforms) return std::nullopt;
  const std::string canonical = language::transforms::print(exporting::transforms_document(*transforms));
  if (!reading.desired) return Transforms{std::move(*transforms), canonical, {}, {}};
  const auto pairs = desired_pairs(reading, model::motions_of(*transforms), diagnostics);
  if (!pairs) return std::nullopt;
  return Transforms{model::chosen(*transforms, *pairs), canonical, {}, {}};
}

void refuse_one_name_for_two(const Transforms& transforms, Diagnostics& diagnostics, const Place& place) {
  std::map<std::string, const model::CoordinateTransform*> known;
  for (const model::CoordinateTransform& t : transforms.document.transforms) {
    const auto [earlier, is_new] = known.insert({algorithm::name_of(t), &t});
    if (is_new) continue;
    const model::CoordinateTransform& other = *earlier->second;
    diagnostics
        .error(
            "duplicate-name", place,
            fmt::format(
                "two transforms would be called '{}': from frame '{}' to frame '{}', and from '{}' to '{}'",
                earlier->first, other.right, other.left, t.right, t.left))
        .hint = "give one of them a name: `[name]` after its last factor";
  }
}

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

int index_of(const std::vector<backend::FrameData>& frames, const std::string& name) {
  const auto place = std::find_if(frames.begin(), frames.end(), [&](const auto& frame) { return frame.name == name; });
  return static_cast<int>(place - frames.begin());
}

}  // namespace

bool is_motions(const std::filesystem::path& model) {
  return model.extension() == ".motdsl";
}

bool is_transforms(const std::filesystem::path& model) {
  return is_motions(model) || model.extension() == ".ctdsl";
}

std::optional<model::RigidMotions> load_motions_of(const std::filesystem::path& model, Diagnostics& diagnostics) {
  const std::shared_ptr<const Source> source = read_source(model);
  if (is_motions(model)) return read_motions(source, diagnostics);
  const std::optional<model::CoordinateTransforms> transforms = read_transforms(source, diagnostics);
  return transforms ? std::optional(model::motions_of(*transforms)) : std::nullopt;
}

std::optional<Transforms> load_transforms(
    const std::filesystem::path& model,
    const Reading& reading,
    Diagnostics& diagnostics) {
  const std::shared_ptr<const Source> source = read_source(model);
  std::optional<Transforms> transforms =
      is_motions(model) ? load_motions(source, reading, diagnostics) : load_document(source, reading, diagnostics);
  if (!transforms) return std::nullopt;
  refuse_one_name_for_two(*transforms, diagnostics, {source, {}});
  if (reading.strict) promote_strict_warnings(diagnostics);
  if (diagnostics.has_errors()) return std::nullopt;
  if (reading.lists_parameters) list_parameters(transforms->document.parameters, diagnostics);
  transforms->model = model;
  transforms->read.push_back(model);
  if (reading.desired) transforms->read.push_back(*reading.desired);
  return transforms;
}

std::vector<algorithm::TransformFunction> trace(const Transforms& transforms, const Steps& steps) {
  const std::vector<std::string> passes = split(steps).passes;
  std::vector<algorithm::TransformFunction> all = algorithm::transform_functions(transforms.document);
  for (algorithm::TransformFunction& f : all) f.program = pass::run(std::move(f.program), passes);
  return all;
}

backend::Library library(
    const Transforms& transforms,
    const LibraryNames& names,
    const Steps& steps,
    Primitives primitives) {
  const model::CoordinateTransforms& document = transforms.document;
  backend::Library result;
  result.name = names.name;
  result.enclosing = names.enclosing;
  result.robot = document.name;
  result.model_file = transforms.model.filename().string();
  result.model_hash = hash_text(transforms.canonical);
  result.generator_version = kVersion;
  result.groups = {kTransformsGroup};
  result.frames = frames_of(document);
  result.variables = document.variables;
  result.primitives = convention_of(primitives);
  for (const model::Parameter& p : document.parameters)
    result.parameters.push_back({p.name, p.default_value.value_or(std::numeric_limits<double>::quiet_NaN())});
  for (algorithm::TransformFunction& f : trace(transforms, steps)) {
    const model::CoordinateTransform& transform = document.transforms[f.transform];
    backend::Function function;
    function.group = kTransformsGroup;
    function.scope = std::move(f.scope);
    function.name = std::move(f.name);
    function.kernel = f.program.name;
    function.summary = std::move(f.summary);
    function.left_frame = index_of(result.frames, transform.left);
    function.right_frame = index_of(result.frames, transform.right);
    function.program = std::move(f.program);
    function.factors = factors_of(document, transform);
    if (primitives && function.scope == "transforms::homogeneous")
      add_product(algorithm::primitive_product(document, transform, *primitives), function);
    result.functions.push_back(std::move(function));
  }
  return result;
}

}  // namespace robcogen::command
