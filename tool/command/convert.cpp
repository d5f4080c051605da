// Models from one language to another: robots to robots, robots to motions, and both to coordinate transforms.
#include <fmt/format.h>

#include <algorithm>

#include "command/command.h"
#include "command/output.h"
#include "command/usage.h"
#include "export/frames.h"
#include "export/kinematics.h"
#include "export/urdf.h"
#include "import/frames.h"
#include "import/kinematics.h"
#include "support/files.h"

namespace robcogen::command {
namespace {

namespace fs = std::filesystem;

struct Options {
  std::string from, to;
  std::string desired;
  std::string position = "right";
  bool strict = false;
  import::UrdfOptions urdf;
  std::string error_format = "gnu";
};

enum class Language { robot, urdf, motions, transforms };

Language language_of(const fs::path& file) {
  const fs::path extension = file.extension();
  if (extension == ".kindsl") return Language::robot;
  if (extension == ".urdf") return Language::urdf;
  if (extension == ".motdsl") return Language::motions;
  if (extension == ".ctdsl") return Language::transforms;
  throw Failure{
      wrong_usage,
      fmt::format(
          "robcogen: error: cannot convert '{}': the languages are .kindsl, .urdf, .motdsl and .ctdsl", file.string())};
}

// What is read may have any name: its content says whether it is a URDF.
Language language_of_input(const fs::path& file) {
  const fs::path extension = file.extension();
  if (extension == ".motdsl" || extension == ".ctdsl") return language_of(file);
  return is_urdf(file) ? Language::urdf : Language::robot;
}

bool is_robot(Language language) {
  return language == Language::robot || language == Language::urdf;
}

void require_conversion(const Options& options) {
  const Language from = language_of_input(options.from), to = language_of(options.to);
  if (from == to && from != Language::urdf)
    throw Failure{
        wrong_usage,
        "robcogen: error: both files are of one language\nhint: 'robcogen print' writes a document in canonical form"};
  if (from == Language::transforms || (from == Language::motions && to != Language::transforms))
    throw Failure{
        wrong_usage, fmt::format(
                         "robcogen: error: '{}' does not say enough to make '{}'\nhint: robots become motions, and "
                         "robots and motions "
                         "become transforms",
                         options.from, options.to)};
  if (!options.desired.empty() && to != Language::transforms)
    throw Failure{wrong_usage, "robcogen: error: --desired chooses transforms: the file to write must be a .ctdsl"};
  require_urdf(options.from, options.urdf);
}

void require_values(const Robot& robot) {
  if (robot.tree.parameters.empty()) return;
  std::vector<std::string> names;
  for (const model::Parameter& p : robot.tree.parameters) names.push_back(p.name);
  throw Failure{
      wrong_input,
      fmt::format(
          "{}: error: URDF knows no parameters, and robot '{}' has {} [parametric-urdf]\nhint: give them values in the "
          "document",
          robot.model.string(), robot.tree.name, fmt::join(names, ", "))};
}

// Where a document comes from, for its reader.
std::vector<std::string> origin(const Options& options) {
  return {fmt::format("// Converted from {}.", fs::path(options.from).filename().string())};
}

// The robot language knows no joint limits: said once.
void mention_lost_limits(const Robot& robot, Diagnostics& diagnostics) {
  for (const model::Joint& joint : robot.tree.joints) {
    if (joint.limits == model::JointLimits()) continue;
    diagnostics.note(
        "limits-lost", joint.place, "a robot document cannot say joint limits: those of the model are left out");
    return;
  }
}

// Joints that the document declares in another order than the model are in another order in q: said once.
void mention_order(const Robot& robot, Diagnostics& diagnostics) {
  const std::vector<int> order = exporting::joints_parents_first(robot.tree);
  if (std::is_sorted(order.begin(), order.end())) return;
  std::vector<std::string> written, declared;
  for (const int j : order) written.push_back(robot.tree.joints[static_cast<std::size_t>(j)].name);
  for (const model::Joint& joint : robot.tree.joints) declared.push_back(joint.name);
  const model::Joint& first = robot.tree.joints.front();
  diagnostics
      .note(
          "joint-order", first.place,
          fmt::format(
              "the robot document declares parents before their children, so that the order of q changes: it is {}",
              fmt::join(written, ", ")))
      .hint = fmt::format(
      "code generated from {} has the order {}", robot.model.filename().string(), fmt::join(declared, ", "));
}

// What the model says may be what no body has: a warning there, and an error for who reads the URDF.
void mention_implausible(const std::string& text, const Robot& robot, Diagnostics& diagnostics) {
  Diagnostics again;
  import::urdf(std::make_shared<Source>("", text), {}, again);
  for (const Diagnostic& d : again.all()) {
    if (d.severity != Severity::error || (d.code != "inertia-not-positive" && d.code != "negative-mass")) continue;
    diagnostics
        .warning(
            "implausible-urdf", {std::make_shared<Source>(robot.model.string(), ""), {}},
            "the URDF will be refused, as no body has the mass properties that it repeats")
        .hint = "correct them here, or read the URDF with --allow-implausible";
    return;
  }
}

std::string robot_document(const Options& options, const Robot& robot) {
  language::kinematics::Document document =
      exporting::numbered_parents_first(robot.tree, exporting::kinematics_document(robot.tree));
  document.comments = origin(options);
  return language::kinematics::print(document);
}

std::string motion_document(const Options& options, const model::RigidMotions& motions) {
  language::motion::Document document = exporting::motion_document(motions);
  document.header.comments = origin(options);
  return language::motion::print(document);
}

std::string transforms_document(
    const Options& options,
    const model::RigidMotions& motions,
    const std::vector<model::FrameNames>& pairs) {
  const auto position = options.position == "left" ? model::MovedFramePosition::left : model::MovedFramePosition::right;
  language::transforms::Document document =
      exporting::transforms_document(model::transforms_of(motions, pairs, position));
  document.header.comments = origin(options);
  return language::transforms::print(document);
}

std::optional<std::string> convert_robot(const Options& options, Diagnostics& diagnostics) {
  Reading reading;
  if (!options.desired.empty()) reading.desired = options.desired;
  reading.strict = options.strict;
  reading.urdf = options.urdf;
  const std::optional<Robot> robot = load_robot(options.from, reading, diagnostics);
  if (!robot) return std::nullopt;
  switch (language_of(options.to)) {
    case Language::robot:
      mention_lost_limits(*robot, diagnostics);
      mention_order(*robot, diagnostics);
      return robot_document(options, *robot);
    case Language::urdf: {
      require_values(*robot);
      std::string text = exporting::urdf(robot->tree);
      mention_implausible(text, *robot, diagnostics);
      return text;
    }
    case Language::motions:
      return motion_document(options, model::motions_of(robot->tree));
    case Language::transforms:
      break;
  }
  std::vector<model::FrameNames> pairs;
  for (const model::FramePair& pair : robot->desired.transforms) pairs.emplace_back(pair.left.name, pair.right.name);
  return transforms_document(options, model::motions_of(robot->tree), pairs);
}

std::optional<std::string> convert_motions(const Options& options, Diagnostics& diagnostics) {
  const language::motion::Document document = language::motion::parse(read_source(options.from), diagnostics);
  if (diagnostics.has_errors()) return std::nullopt;
  const std::optional<model::RigidMotions> motions = import::rigid_motions(document, diagnostics);
  if (!motions) return std::nullopt;
  std::vector<model::FrameNames> pairs = model::default_transforms(*motions);
  if (!options.desired.empty()) {
    const language::desired::Document list = language::desired::parse(read_source(options.desired), diagnostics);
    if (diagnostics.has_errors()) return std::nullopt;
    pairs = import::desired_frame_pairs(list, *motions, diagnostics);
  }
  if (options.strict) promote_strict_warnings(diagnostics);
  if (diagnostics.has_errors()) return std::nullopt;
  return transforms_document(options, *motions, pairs);
}

Status convert(const Options& options) {
  require_conversion(options);
  Diagnostics diagnostics;
  const std::optional<std::string> text = is_robot(language_of_input(options.from))
                                              ? convert_robot(options, diagnostics)
                                              : convert_motions(options, diagnostics);
  report(diagnostics.render(format_of(options.error_format)));
  if (!text) return wrong_input;
  const fs::path to = options.to;
  const fs::path folder = to.has_parent_path() ? to.parent_path() : fs::path(".");
  std::string error;
  if (!write_files_if_changed(folder, {{to.filename(), *text}}, error))
    throw Failure{wrong_usage, fmt::format("robcogen: error: {}", error)};
  return ok;
}

}  // namespace

Action declare_convert(CLI::App& application) {
  CLI::App* subcommand = application.add_subcommand("convert", "Writes a model in another language");
  auto options = std::make_shared<Options>();
  subcommand->add_option("from", options->from, "Robot (.kindsl, .urdf) or motions (.motdsl)")->required();
  subcommand
      ->add_option(
          "to", options->to,
          "File to write; its ending says the language: .kindsl, .urdf, .motdsl, or .ctdsl for coordinate transforms")
      ->required();
  subcommand->add_option("--desired", options->desired, "Which transforms a .ctdsl gets (.dtdsl)");
  subcommand->add_option("--position", options->position, "Position of the moved frame in a .ctdsl: left or right")
      ->check(one_of({"left", "right"}));
  subcommand->add_flag("--strict", options->strict, kStrictHelp);
  declare_urdf_options(*subcommand, options->urdf);
  declare_error_format(*subcommand, options->error_format);
  return [options] { return convert(*options); };
}

}  // namespace robcogen::command
