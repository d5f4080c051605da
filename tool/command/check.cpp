#include <fmt/format.h>

#include <cstdio>

#include "command/command.h"
#include "import/kinematics.h"

namespace robcogen::command {
namespace {

struct Options {
  std::vector<std::string> files;
  import::UrdfOptions urdf;
  bool strict = false;
  std::string error_format = "gnu";
};

bool is_desired(const std::string& file) {
  return std::filesystem::path(file).extension() == ".dtdsl";
}

// A desired-transforms document is checked against the robot when exactly one robot document is given with it.
Status check(const Options& options) {
  std::vector<std::string> robots, lists;
  for (const std::string& file : options.files) (is_desired(file) ? lists : robots).push_back(file);
  Diagnostics diagnostics;
  for (const std::string& robot : robots) load_robot(robot, {{}, options.strict, options.urdf}, diagnostics);
  for (const std::string& list : lists) {
    if (robots.size() != 1) {
      language::desired::parse(read_source(list), diagnostics);
      continue;
    }
    Diagnostics again;  // what the robot itself gave is reported already
    const std::optional<Robot> robot = load_robot(robots.front(), {{}, false, options.urdf}, again);
    const language::desired::Document document = language::desired::parse(read_source(list), diagnostics);
    if (robot && !diagnostics.has_errors()) import::desired_transforms(document, robot->tree, diagnostics);
  }
  if (options.strict) promote_desired_warnings(diagnostics);
  fmt::print(stderr, "{}", diagnostics.render(format_of(options.error_format)));
  return diagnostics.has_errors() ? wrong_input : ok;
}

}  // namespace

Action declare_check(CLI::App& application) {
  CLI::App* subcommand = application.add_subcommand("check", "Reads documents and reports what is wrong with them");
  auto options = std::make_shared<Options>();
  subcommand->add_option("files", options->files, "Documents (.kindsl, .urdf, .dtdsl)")->required();
  subcommand->add_flag("--strict", options->strict, "Warnings of desired-transforms documents are errors");
  declare_urdf_options(*subcommand, options->urdf);
  declare_error_format(*subcommand, options->error_format);
  return [options] { return check(*options); };
}

}  // namespace robcogen::command
