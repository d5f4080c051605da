#include <fmt/format.h>

#include <cstdio>

#include "command/command.h"
#include "export/kinematics.h"
#include "export/urdf.h"
#include "import/kinematics.h"
#include "support/files.h"

namespace robcogen::command {
namespace {

namespace fs = std::filesystem;

struct Options {
  std::string from, to;
  import::UrdfOptions urdf;
  std::string error_format = "gnu";
};

bool is_robot_document(const fs::path& file) {
  return file.extension() == ".kindsl";
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

std::string robot_document(const Robot& robot) {
  language::kinematics::Document document = exporting::kinematics_document(robot.tree);
  document.comments.push_back(fmt::format("// Converted from {}.", robot.model.filename().string()));
  return language::kinematics::print(document);
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

Status convert(const Options& options) {
  const fs::path from = options.from, to = options.to;
  for (const fs::path& file : {from, to}) {
    if (!is_urdf(file) && !is_robot_document(file))
      throw Failure{
          wrong_usage,
          fmt::format("robcogen: error: cannot convert '{}': it is neither .kindsl nor .urdf", file.string())};
  }
  if (is_robot_document(from) && is_robot_document(to))
    throw Failure{
        wrong_usage,
        "robcogen: error: both files are robot documents\nhint: 'robcogen print' writes a document in canonical form"};
  require_urdf(from, options.urdf);
  Diagnostics diagnostics;
  const std::optional<Robot> robot = load_robot(from, {{}, false, options.urdf}, diagnostics);
  if (robot && is_robot_document(to)) mention_lost_limits(*robot, diagnostics);
  fmt::print(stderr, "{}", diagnostics.render(format_of(options.error_format)));
  if (!robot) return wrong_input;
  if (is_urdf(to)) require_values(*robot);
  const std::string text = is_urdf(to) ? exporting::urdf(robot->tree) : robot_document(*robot);
  std::string error;
  const fs::path folder = to.has_parent_path() ? to.parent_path() : fs::path(".");
  if (!write_files_if_changed(folder, {{to.filename(), text}}, error))
    throw Failure{wrong_usage, fmt::format("robcogen: error: {}", error)};
  return ok;
}

}  // namespace

Action declare_convert(CLI::App& application) {
  CLI::App* subcommand = application.add_subcommand("convert", "Writes a model in another language");
  auto options = std::make_shared<Options>();
  subcommand->add_option("from", options->from, "Robot (.kindsl or .urdf)")->required();
  subcommand->add_option("to", options->to, "File to write; its ending says the language: .kindsl or .urdf")
      ->required();
  declare_urdf_options(*subcommand, options->urdf);
  declare_error_format(*subcommand, options->error_format);
  return [options] { return convert(*options); };
}

}  // namespace robcogen::command
