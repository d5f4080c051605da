#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <fstream>

#include "backend/cpp/cpp.h"
#include "command/command.h"
#include "support/files.h"

namespace robcogen::command {
namespace {

namespace fs = std::filesystem;

struct Options {
  ModelOptions model;
  std::string output;
  LibraryNames names;
  std::vector<std::string> groups = algorithm::groups();
  std::vector<std::string> languages = {"cpp"};
  std::vector<std::string> import_dirs;
  std::string depfile, depfile_target, stamp;
  bool list_outputs = false;
};

bool is_identifier(const std::string& name) {
  const auto letter = [](char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_'; };
  return !name.empty() && letter(name.front()) &&
         std::all_of(name.begin(), name.end(), [&](char c) { return letter(c) || (c >= '0' && c <= '9'); });
}

void check_names(const LibraryNames& names) {
  if (!is_identifier(names.name))
    throw Failure{wrong_usage, fmt::format("robcogen: error: --name '{}' is no identifier", names.name)};
  std::string rest = names.enclosing;
  while (!rest.empty()) {
    const std::size_t end = std::min(rest.find("::"), rest.size());
    if (!is_identifier(rest.substr(0, end)))
      throw Failure{wrong_usage, fmt::format("robcogen: error: --namespace '{}' is no namespace", names.enclosing)};
    rest.erase(0, std::min(end + 2, rest.size()));
  }
}

std::vector<std::string> in_canonical_order(const std::vector<std::string>& chosen) {
  std::vector<std::string> ordered;
  for (const std::string& group : algorithm::groups())
    if (std::find(chosen.begin(), chosen.end(), group) != chosen.end()) ordered.push_back(group);
  return ordered;
}

// Parametric robots have programs and can be evaluated, but the generated interface takes no parameters.
void refuse_parameters(const Robot& robot) {
  if (robot.tree.parameters.empty()) return;
  std::string names;
  for (const model::Parameter& p : robot.tree.parameters) names += (names.empty() ? "" : ", ") + p.name;
  throw Failure{
      wrong_input,
      fmt::format(
          "{}: error: robot '{}' has parameters ({}), and C++ code with parameters cannot be generated "
          "[parametric-cpp]\nhint: give them values in the document, or evaluate the robot with 'robcogen eval'",
          robot.model.string(), robot.tree.name, names)};
}

// Unlike generated sources, a stamp and a dependency file must get a new time even when their text stays.
void write(const fs::path& path, const std::string& text) {
  std::ofstream file(path, std::ios::binary | std::ios::trunc);
  file << text;
  file.close();
  if (!file) throw Failure{wrong_usage, fmt::format("robcogen: error: cannot write '{}'", path.string())};
}

Status generate(const Options& options) {
  if (options.output.empty()) throw Failure{wrong_usage, "robcogen: error: generate needs -o DIR"};
  const std::optional<Robot> robot = options.model.load();
  if (!robot) return wrong_input;
  refuse_parameters(*robot);
  const backend::Library lib = library(*robot, options.names, in_canonical_order(options.groups), options.model.passes);
  std::string error;
  if (!write_files_if_changed(options.output, backend::cpp::print(lib), error))
    throw Failure{wrong_usage, fmt::format("robcogen: error: {}", error)};
  if (!options.depfile.empty()) {
    const std::string target = options.depfile_target.empty() ? options.stamp : options.depfile_target;
    std::vector<fs::path> inputs;
    for (const fs::path& file : robot->read) inputs.push_back(fs::absolute(file));
    write(options.depfile, dependency_file(target, inputs));
  }
  if (!options.stamp.empty()) write(options.stamp, lib.model_hash + "\n");
  return ok;
}

Status list_outputs(const Options& options) {
  for (const std::string& file : backend::cpp::outputs(options.names.name, in_canonical_order(options.groups)))
    fmt::print("{}\n", file);
  return ok;
}

}  // namespace

Action declare_generate(CLI::App& application) {
  CLI::App* subcommand = application.add_subcommand("generate", "Generates a robot's library");
  auto options = std::make_shared<Options>();
  options->model.declare(*subcommand);
  subcommand->get_option("model")->required(false);
  subcommand->add_option("-o,--output", options->output, "Folder for the generated files");
  subcommand->add_option("--name", options->names.name, "Folder and namespace of the code")->required();
  subcommand->add_option("--namespace", options->names.enclosing, "Enclosing namespace, a::b");
  subcommand->add_option("--algorithms", options->groups, "What to generate; default all")
      ->check(CLI::IsMember(algorithm::groups()));
  subcommand->add_option("--language", options->languages, "Target languages; default cpp")
      ->check(CLI::IsMember({"cpp"}));
  subcommand->add_option("-I", options->import_dirs, "Folders of imported documents")->allow_extra_args(false);
  subcommand->add_option("--depfile", options->depfile, "Write what was read as a dependency file");
  subcommand->add_option("--depfile-target", options->depfile_target, "Its target; default the stamp");
  subcommand->add_option("--stamp", options->stamp, "File to touch when all is written");
  subcommand->add_flag("--list-outputs", options->list_outputs, "Print the names of the generated files, and stop");
  return [options] {
    check_names(options->names);
    if (options->list_outputs) return list_outputs(*options);
    if (options->model.model.empty()) throw Failure{wrong_usage, "robcogen: error: generate needs a model"};
    return generate(*options);
  };
}

}  // namespace robcogen::command
