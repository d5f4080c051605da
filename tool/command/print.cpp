#include <fmt/format.h>

#include "command/output.h"
#include "command/output_files.h"
#include "command/subcommands.h"
#include "driver/documents.h"
#include "driver/optimise.h"
#include "export/elastic_joints.h"
#include "export/kinematics.h"
#include "language/desired/document.h"
#include "language/kinematics/original.h"
#include "language/motion/document.h"
#include "language/transforms/document.h"
#include "symbolic/text.h"

namespace robcogen::command {
namespace {

language::kinematics::Document robot_document(const PrintOptions& options, Diagnostics& diagnostics) {
  if (!options.expand) return language::kinematics::parse(driver::read_source(options.model.file), diagnostics);
  report_missing_folders(options.model.import_folders, options.model.messages);
  std::optional<import::RobotDocument> read =
      driver::load_robot_document(options.model.file, {.import_folders = options.model.import_folders}, diagnostics);
  if (!read) return {};
  require_apart_from_output(read->imported);
  return std::move(read->document);
}

std::string canonical_robot(const PrintOptions& options, Diagnostics& diagnostics) {
  const language::kinematics::Document document = robot_document(options, diagnostics);
  if (options.original && !diagnostics.has_errors()) language::kinematics::is_original(document, diagnostics);
  return language::kinematics::print(document);
}

std::string canonical_text(const PrintOptions& options, Diagnostics& diagnostics) {
  const std::filesystem::path file = options.model.file;
  switch (driver::language_of(file)) {
    case driver::Language::desired:
      return language::desired::print(language::desired::parse(driver::read_source(file), diagnostics));
    case driver::Language::motions:
      return language::motion::print(language::motion::parse(driver::read_source(file), diagnostics));
    case driver::Language::transforms:
      return language::transforms::print(language::transforms::parse(driver::read_source(file), diagnostics));
    default:
      return canonical_robot(options, diagnostics);
  }
}

// The robot without its locked joints, as a plain document.
Status print_reduced(const PrintOptions& options) {
  if (options.original)
    throw Failure{
        wrong_usage, "robcogen: error: --original checks a document as it is written, without --lock and --keep"};
  const std::optional<driver::Model> model = options.model.load();
  if (!model) return wrong_input;
  require_apart_from_output(model->read);
  const model::KinematicTree& tree = model->robot()->tree;
  write_output(language::kinematics::print(exporting::with_elastic_joints(tree, exporting::kinematics_document(tree))));
  return ok;
}

Status print_document(const PrintOptions& options) {
  const std::filesystem::path file = options.model.file;
  const driver::Language language = driver::language_of(file);
  if (language != driver::Language::robot && driver::is_robot(language))
    throw Failure{
        wrong_usage, fmt::format(
                         "robcogen: error: '{}' is not a robcogen document\nhint: 'robcogen convert' turns it into one",
                         file.string())};
  if ((options.original || options.expand) && language != driver::Language::robot)
    throw Failure{
        wrong_usage, fmt::format(
                         "robcogen: error: --{} applies to robot documents (.kindsl) only",
                         options.original ? "original" : "expand")};
  if (!options.model.format.changes.empty()) return print_reduced(options);
  Diagnostics diagnostics;
  const std::string text = canonical_text(options, diagnostics);
  report(diagnostics.render(options.model.messages));
  if (diagnostics.has_errors()) return wrong_input;
  write_output(text);
  return ok;
}

// Of all functions, only the one with this program is traced.
Status print_program(const PrintOptions& options) {
  std::vector<std::string> named;
  if (algorithm::mentions_collisions(options.program)) named = {algorithm::kCollisionGroup};
  const std::optional<driver::Model> model = options.model.load(named);
  if (!model) return wrong_input;
  require_apart_from_output(model->read);
  driver::Functions functions = driver::declare(*model, algorithm::groups());
  std::vector<std::string> kernels;
  for (const driver::Function& f : functions.list) kernels.push_back(f.kernel);
  std::erase_if(functions.list, [&](const driver::Function& f) { return f.kernel != options.program; });
  if (functions.list.empty())
    throw Failure{
        wrong_usage, with_hint(
                         fmt::format("robcogen: error: the model has no program '{}'", options.program),
                         did_you_mean(options.program, kernels))};
  functions = driver::optimise(*model, std::move(functions), options.model.steps, {});
  write_output(symbolic::print(functions.list.front().program));
  return ok;
}

}  // namespace

Status print(const PrintOptions& options) {
  require_apart_from_output({options.model.file, options.model.desired});
  return options.program.empty() ? print_document(options) : print_program(options);
}

}  // namespace robcogen::command
