#include <fmt/format.h>

#include "command/command.h"
#include "command/output.h"
#include "command/usage.h"
#include "language/desired/document.h"
#include "language/kinematics/document.h"
#include "language/motion/document.h"
#include "language/transforms/document.h"
#include "symbolic/text.h"

namespace robcogen::command {
namespace {

struct Options {
  ModelOptions model;
  std::string program;
};

// In the language that the file's ending says.
std::string canonical_text(const std::filesystem::path& file, Diagnostics& diagnostics) {
  const std::shared_ptr<const Source> source = read_source(file);
  if (file.extension() == ".dtdsl") return language::desired::print(language::desired::parse(source, diagnostics));
  if (file.extension() == ".motdsl") return language::motion::print(language::motion::parse(source, diagnostics));
  if (file.extension() == ".ctdsl")
    return language::transforms::print(language::transforms::parse(source, diagnostics));
  return language::kinematics::print(language::kinematics::parse(source, diagnostics));
}

Status print_document(const Options& options) {
  const std::filesystem::path file = options.model.model;
  if (is_urdf(file))
    throw Failure{
        wrong_usage, fmt::format(
                         "robcogen: error: '{}' is no document of the project's languages\nhint: 'robcogen convert' "
                         "makes it one",
                         file.string())};
  Diagnostics diagnostics;
  const std::string text = canonical_text(file, diagnostics);
  report(diagnostics.render(format_of(options.model.error_format)));
  if (diagnostics.has_errors()) return wrong_input;
  write_output(text);
  return ok;
}

Status print_program(const Options& options) {
  const std::optional<Programs> programs = options.model.load_programs();
  if (!programs) return wrong_input;
  std::vector<std::string> kernels;
  for (const NamedProgram& f : programs->list) {
    if (f.program.name == options.program) {
      write_output(symbolic::print(f.program));
      return ok;
    }
    kernels.push_back(f.program.name);
  }
  throw Failure{
      wrong_usage, with_hint(
                       fmt::format("robcogen: error: the model has no program '{}'", options.program),
                       did_you_mean(options.program, kernels))};
}

}  // namespace

Action declare_print(CLI::App& application) {
  CLI::App* subcommand =
      application.add_subcommand("print", "Prints a document in canonical form, or a model's program as text");
  auto options = std::make_shared<Options>();
  options->model.declare(*subcommand);
  subcommand->add_option("--program", options->program, "Print this program of the model (e.g. inverse_dynamics)");
  return [options] { return options->program.empty() ? print_document(*options) : print_program(*options); };
}

}  // namespace robcogen::command
