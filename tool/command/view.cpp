// Pictures of a robot: a drawing, and a page to look at.
#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>

#include "command/output_files.h"
#include "command/subcommands.h"
#include "driver/documents.h"
#include "model/closed_positions.h"
#include "model/elements.h"
#include "view/drawing.h"
#include "view/page.h"

namespace robcogen::command {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void refuse(const std::string& option, const std::string& what, const std::string& hint) {
  throw Failure{wrong_usage, with_hint(fmt::format("robcogen: error: {}: {}", option, what), hint)};
}

double number(const std::string& option, const std::string& text) {
  double value = 0;
  const auto [end, fault] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (fault != std::errc() || end != text.data() + text.size() || !std::isfinite(value))
    refuse(option, fmt::format("'{}' is not a finite decimal number", text), "");
  return value;
}

// Assigns `0.1,0.2` in the order of the names, or `KFE=0.2`, to the values.
void assign(
    const std::string& option,
    const std::vector<std::string>& given,
    const std::vector<std::string>& names,
    std::vector<double>& values) {
  const bool is_named = std::any_of(
      given.begin(), given.end(), [](const std::string& word) { return word.find('=') != std::string::npos; });
  if (!given.empty() && !is_named && given.size() != names.size())
    refuse(
        option, fmt::format("{} numbers are given, but the robot has {}", given.size(), names.size()),
        fmt::format(
            "they are those of {}; or name them: {}=0.5", fmt::join(names, ", "),
            names.empty() ? "joint" : names.front()));
  for (std::size_t k = 0; k < given.size(); ++k) {
    if (!is_named) {
      values[k] = number(option, given[k]);
      continue;
    }
    const std::size_t equals = given[k].find('=');
    if (equals == std::string::npos)
      refuse(option, fmt::format("'{}' has no name, but other values have one", given[k]), "");
    const std::string name = given[k].substr(0, equals);
    const auto at = std::find(names.begin(), names.end(), name);
    if (at == names.end())
      refuse(option, fmt::format("'{}' is not one of {}", name, fmt::join(names, ", ")), did_you_mean(name, names));
    values[static_cast<std::size_t>(at - names.begin())] = number(option, given[k].substr(equals + 1));
  }
}

// Makes the quaternion of unit length, because users type few digits.
void normalise(const std::vector<std::string>& names, std::size_t first, std::vector<double>& q) {
  const double norm = std::hypot(std::hypot(q[first], q[first + 1]), std::hypot(q[first + 2], q[first + 3]));
  if (!(norm > 0) || std::isinf(norm))
    refuse("--q", fmt::format("the quaternion of {} to {} has no direction", names[first], names[first + 3]), "");
  for (std::size_t k = first; k < first + 4; ++k) q[k] /= norm;
}

std::vector<double> parameters(const ViewOptions& options, const view::ViewedRobot& robot) {
  std::vector<std::string> names;
  std::vector<double> values;
  for (const model::Parameter& p : robot.library.tree.parameters) {
    names.push_back(p.name);
    values.push_back(model::default_of(p));
  }
  assign("--parameters", options.parameters, names, values);
  std::vector<std::string> missing;
  for (std::size_t k = 0; k < names.size(); ++k)
    if (std::isnan(values[k])) missing.push_back(names[k]);
  if (!missing.empty())
    refuse(
        "--parameters", fmt::format("these parameters have no value: {}", fmt::join(missing, ", ")),
        fmt::format("--parameters {}=1.0", fmt::join(missing, "=1.0,")));
  return values;
}

// The positions that are not given are zero, or those where loops are assembled, or the limit nearest to these;
// spherical joints are not rotated. Joints that follow others are placed where loops close.
std::vector<double> positions(
    const ViewOptions& options,
    const view::ViewedRobot& robot,
    const model::KinematicTree& tree) {
  std::vector<std::string> names = model::position_names(tree);
  names.resize(names.size() - tree.followers_in_q().size());
  std::vector<double> values;
  for (const int j : tree.coordinates()) {
    const model::Joint& joint = tree.joints[static_cast<std::size_t>(j)];
    const double position = joint.assembled_position();
    if (joint.type == model::JointType::spherical && joint.is_first()) values.push_back(1.0);
    values.push_back(
        joint.limits.lower <= joint.limits.upper ? std::clamp(position, joint.limits.lower, joint.limits.upper)
                                                 : position);
  }
  assign("--q", options.q, names, values);
  for (const int first : model::quaternions(tree)) normalise(names, static_cast<std::size_t>(first), values);
  for (const double position : model::closed_followers(tree, values, parameters(options, robot)))
    values.push_back(position);
  return values;
}

// A file name without an extension, such as /dev/stdout, is accepted too.
void require_extension(const fs::path& file, const std::string& command, const std::vector<std::string>& extensions) {
  std::string extension = file.extension().string();
  std::transform(
      extension.begin(), extension.end(), extension.begin(), [](unsigned char c) { return std::tolower(c); });
  if (extension.empty() || std::count(extensions.begin(), extensions.end(), extension) > 0) return;
  throw Failure{
      wrong_usage, with_hint(
                       fmt::format(
                           "robcogen: error: {} writes {}, not '{}': {}", command, extensions[0].substr(1), extension,
                           file.string()),
                       fmt::format("name a file that ends in {}", fmt::join(extensions, " or ")))};
}

void require_robot(const ViewOptions& options, const std::string& command, const std::vector<std::string>& extensions) {
  if (options.output.empty())
    throw Failure{wrong_usage, fmt::format("robcogen: error: {} needs an output file: -o FILE", command)};
  require_extension(options.output, command, extensions);
  if (!driver::is_robot(driver::language_of(options.model.file)))
    throw Failure{
        wrong_usage, fmt::format("robcogen: error: {} applies to robots only, not to motions and transforms", command)};
}

Status write(const ViewOptions& options, const driver::Model& model, const std::string& text) {
  std::vector<OutputFile> files = {{options.output, text}};
  if (!options.depfile.empty()) {
    std::vector<fs::path> inputs;
    for (const fs::path& read : model.read) inputs.push_back(fs::absolute(read));
    files.push_back({options.depfile, dependency_file(options.output, inputs)});
  }
  write_files("", files, model.read);
  return ok;
}

}  // namespace

Status draw(const ViewOptions& options) {
  require_robot(options, "draw", {".svg"});
  const std::optional<driver::Model> model = options.model.load();
  if (!model) return wrong_input;
  const view::ViewedRobot robot = view::viewed(*model, view::Purpose::drawing);
  view::DrawingOptions drawing = {options.azimuth, options.elevation, nullptr, options.plain};
  view::Pattern pattern;
  if (options.pattern) {
    pattern = view::inertia_pattern(*model);
    drawing.pattern = &pattern;
  }
  const view::Posture posture =
      view::posture(robot, positions(options, robot, model->robot()->tree), parameters(options, robot));
  return write(options, *model, view::draw(robot, posture, drawing));
}

Status view(const ViewOptions& options) {
  require_robot(options, "view", {".html", ".htm"});
  Diagnostics diagnostics;
  ModelOptions with_shapes = options.model;
  if (!options.without_shapes) with_shapes.format.urdf.shapes = {.visuals = true, .collisions = true};
  const std::optional<driver::Model> model = with_shapes.load({}, diagnostics);
  if (!model) return wrong_input;
  const view::ViewedRobot robot = view::viewed(*model, view::Purpose::page);
  const view::PageOptions page = {positions(options, robot, model->robot()->tree), parameters(options, robot)};
  return write(options, *model, view::page(*model, robot, diagnostics, page));
}

}  // namespace robcogen::command
