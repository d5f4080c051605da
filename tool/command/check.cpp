#include <fmt/format.h>

#include "algorithm/kinematics/inverse_kinematics.h"
#include "command/model_options.h"
#include "command/output.h"
#include "command/subcommands.h"
#include "driver/declare.h"
#include "driver/documents.h"
#include "driver/fused_functions.h"
#include "import/frames.h"

namespace robcogen::command {
namespace {

// How each desired chain is inverted, or that from the base to each link without children and each user frame, or why
// it is not.
std::string kinematics_of(const driver::Robot& robot) {
  std::vector<model::InverseTarget> targets = robot.desired.inverses;
  if (targets.empty())
    for (const model::FramePair& pair : model::default_desired(robot.tree).jacobians) targets.push_back({pair});
  std::string text;
  for (const model::InverseTarget& target : targets) {
    const algorithm::InverseKinematicsReport report =
        algorithm::report_inverse_kinematics(robot.tree, target.frames, target.task);
    text += fmt::format(
        "{}_X_{}: {}{}\n", target.frames.left.name, target.frames.right.name,
        report.has_closed_form ? "" : "no closed form: ", report.reason);
    if (report.has_closed_form)
      for (const std::string& step : algorithm::inverse_kinematics_steps(robot.tree, target.frames, target.task))
        text += "  " + step + "\n";
    else if (!report.hint.empty())
      text += "  hint: " + report.hint + "\n";
  }
  return text;
}

// Checks a list against the model, whose own errors were reported before. Returns what is to be printed.
std::string check_list(
    const CheckOptions& options,
    const std::string& list,
    const std::string& model,
    Diagnostics& diagnostics) {
  const language::desired::Document document = language::desired::parse(driver::read_source(list), diagnostics);
  if (diagnostics.has_errors()) return "";
  Diagnostics again;
  if (!driver::is_robot(driver::language_of(model))) {
    if (const auto motions = driver::load_motions_of(model, again))
      import::desired_frame_pairs(document, *motions, diagnostics);
  } else if (
      const auto loaded = driver::load(
          model,
          {.urdf = options.format.urdf,
           .robot = options.format.robot,
           .changes = options.format.changes,
           .import_folders = options.import_folders},
          again)) {
    const driver::Robot robot = {
        loaded->robot()->tree, driver::checked_desired_transforms(document, loaded->robot()->tree, diagnostics)};
    driver::check_closed_forms(robot, diagnostics);
    if (options.lists_kinematics) return kinematics_of(robot);
  }
  return "";
}

}  // namespace

// A list of desired transforms is checked against the model when exactly one is given with it.
Status check(const CheckOptions& options) {
  std::vector<std::string> models, lists;
  for (const std::string& file : options.files)
    (driver::language_of_suffix(file) == driver::Language::desired ? lists : models).push_back(file);
  for (const std::string& model : models) require_format(model, options.format);
  report_missing_folders(options.import_folders, options.messages);
  Diagnostics diagnostics;
  std::string kinematics;
  for (const std::string& model : models) {
    const auto loaded = driver::load(
        model,
        {.strict = options.strict,
         .urdf = options.format.urdf,
         .robot = options.format.robot,
         .changes = options.format.changes,
         .lists_parameters = true,
         .import_folders = options.import_folders,
         .may_be_library = true},
        diagnostics);
    if (loaded) driver::mention_joint_limit(*loaded, diagnostics);
    if (loaded && loaded->robot() && options.lists_kinematics && lists.empty())
      kinematics += kinematics_of(*loaded->robot());
  }
  for (const std::string& list : lists) {
    if (models.size() == 1)
      kinematics += check_list(options, list, models.front(), diagnostics);
    else
      language::desired::parse(driver::read_source(list), diagnostics);
  }
  if (options.strict) driver::promote_strict_warnings(diagnostics);
  report(diagnostics.render(options.messages));
  if (!diagnostics.has_errors()) write_output(kinematics);
  return diagnostics.has_errors() ? wrong_input : ok;
}

}  // namespace robcogen::command
