#include <fmt/format.h>

#include "command/command.h"
#include "command/output.h"
#include "import/frames.h"
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

// Checks a list against the model; what the model itself gives is reported already.
void check_list(const Options& options, const std::string& list, const std::string& model, Diagnostics& diagnostics) {
  const language::desired::Document document = language::desired::parse(read_source(list), diagnostics);
  if (diagnostics.has_errors()) return;
  Diagnostics again;
  if (is_transforms(model)) {
    if (const auto motions = load_motions_of(model, again))
      import::desired_frame_pairs(document, *motions, diagnostics);
  } else if (const auto robot = load_robot(model, {{}, false, options.urdf}, again)) {
    import::desired_transforms(document, robot->tree, diagnostics);
  }
}

// A list of desired transforms is checked against the model when exactly one is given with it.
Status check(const Options& options) {
  std::vector<std::string> models, lists;
  for (const std::string& file : options.files) (is_desired(file) ? lists : models).push_back(file);
  Diagnostics diagnostics;
  for (const std::string& model : models) {
    const Reading reading = {{}, options.strict, options.urdf, true};
    if (is_transforms(model))
      load_transforms(model, reading, diagnostics);
    else
      load_robot(model, reading, diagnostics);
  }
  for (const std::string& list : lists) {
    if (models.size() == 1)
      check_list(options, list, models.front(), diagnostics);
    else
      language::desired::parse(read_source(list), diagnostics);
  }
  if (options.strict) promote_strict_warnings(diagnostics);
  report(diagnostics.render(format_of(options.error_format)));
  return diagnostics.has_errors() ? wrong_input : ok;
}

}  // namespace

Action declare_check(CLI::App& application) {
  CLI::App* subcommand = application.add_subcommand("check", "Reads documents and reports what is wrong with them");
  auto options = std::make_shared<Options>();
  subcommand->add_option("files", options->files, "Documents (.kindsl, .urdf, .motdsl, .ctdsl, .dtdsl)")->required();
  subcommand->add_flag("--strict", options->strict, kStrictHelp);
  declare_urdf_options(*subcommand, options->urdf);
  declare_error_format(*subcommand, options->error_format);
  return [options] { return check(*options); };
}

}  // namespace robcogen::command
