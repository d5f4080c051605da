#include <fmt/format.h>

#include <algorithm>
#include <fstream>

#include "backend/cpp/cpp.h"
#include "backend/languages.h"
#include "command/command.h"
#include "command/output.h"
#include "command/usage.h"
#include "support/files.h"

namespace robcogen::command {
namespace {

namespace fs = std::filesystem;

struct Options {
  ModelOptions model;
  std::string output;
  LibraryNames names;
  std::vector<std::string> groups;  // empty: the default ones, of those that a language offers
  std::vector<std::string> languages = {"cpp"};
  std::string primitives;  // convention; empty: no products
  std::string depfile, depfile_target, stamp;
  bool has_batches = false;
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

bool contains(const std::vector<std::string>& list, const std::string& item) {
  return std::find(list.begin(), list.end(), item) != list.end();
}

// What was asked for of what the language offers, in canonical order. A Failure when it was asked for what it does not
// offer.
std::vector<std::string> groups_of(const backend::Language& language, const std::vector<std::string>& asked) {
  std::vector<std::string> ordered;
  for (const std::string& group : algorithm::groups()) {
    const bool is_offered = language.groups.empty() || contains(language.groups, group);
    if (!contains(asked, kAllGroups) && !contains(asked.empty() ? algorithm::default_groups() : asked, group)) continue;
    if (is_offered) {
      ordered.push_back(group);
    } else if (!named_groups(asked).empty()) {
      throw Failure{
          wrong_usage, fmt::format(
                           "robcogen: error: --algorithms {} cannot be had in {}, which offers {}", group,
                           language.name, fmt::join(language.groups, ", "))};
    }
  }
  return ordered;
}

std::vector<const backend::Language*> languages_of(const Options& options) {
  std::vector<const backend::Language*> chosen;
  for (const backend::Language& language : backend::languages())
    if (contains(options.languages, language.name)) chosen.push_back(&language);
  return chosen;
}

Primitives primitives_of(const Options& options) {
  if (options.primitives.empty()) return std::nullopt;
  return options.primitives == "left" ? model::MovedFramePosition::left : model::MovedFramePosition::right;
}

// Files of languages whose names follow from the model: those of an earlier run that are made no more must not stay.
// They are known from a list that every run leaves beside them.
struct Listed {
  fs::path list;                   // relative to the output folder
  std::vector<std::string> files;  // made now
  std::vector<std::string> made_before;
};

Listed list_files(const Options& options, const std::string& folder, const std::vector<OutputFile>& files) {
  Listed listed = {fs::path(folder) / (options.names.name + ".files"), {}, {}};
  for (const OutputFile& file : files) listed.files.push_back((fs::path(folder) / file.path).generic_string());
  std::ifstream earlier(fs::path(options.output) / listed.list);
  for (std::string line; std::getline(earlier, line);) listed.made_before.push_back(line);
  return listed;
}

void remove_stale(const Options& options, const Listed& listed) {
  for (const std::string& file : listed.made_before) {
    const fs::path path(file);
    const bool is_below = path.is_relative() && std::find(path.begin(), path.end(), "..") == path.end();
    std::error_code ignored;
    if (is_below && !contains(listed.files, file)) fs::remove(fs::path(options.output) / path, ignored);
  }
}

// Unlike generated sources, a stamp and a dependency file must get a new time even when their text stays.
void write(const fs::path& path, const std::string& text) {
  std::ofstream file(path, std::ios::binary | std::ios::trunc);
  file << text;
  file.close();
  if (!file) throw Failure{wrong_usage, fmt::format("robcogen: error: cannot write '{}'", path.string())};
}

// A library for one language, made of the model.
using MakeLibrary = std::function<backend::Library(const backend::Language& language)>;

Status write_libraries(const Options& options, const std::vector<fs::path>& read, const MakeLibrary& library_for) {
  std::vector<OutputFile> files;
  std::vector<Listed> lists;
  std::string hash;
  for (const backend::Language* language : languages_of(options)) {
    backend::Library lib = library_for(*language);
    lib.has_batches = options.has_batches;
    hash = lib.model_hash;
    std::vector<OutputFile> printed = language->print(lib);
    if (language->name == "cpp") {
      files = std::move(printed);
      continue;
    }
    const Listed& listed = lists.emplace_back(list_files(options, language->name, printed));
    for (OutputFile& file : printed) files.push_back({fs::path(language->name) / file.path, std::move(file.text)});
    files.push_back({listed.list, fmt::format("{}\n", fmt::join(listed.files, "\n"))});
  }
  std::string error;
  if (!write_files_if_changed(options.output, files, error))
    throw Failure{wrong_usage, fmt::format("robcogen: error: {}", error)};
  for (const Listed& listed : lists) remove_stale(options, listed);
  if (!options.depfile.empty()) {
    const std::string target = options.depfile_target.empty() ? options.stamp : options.depfile_target;
    std::vector<fs::path> inputs;
    for (const fs::path& file : read) inputs.push_back(fs::absolute(file));
    write(options.depfile, dependency_file(target, inputs));
  }
  if (!options.stamp.empty()) write(options.stamp, hash + "\n");
  return ok;
}

Status generate_robot(const Options& options) {
  const std::optional<Robot> robot = options.model.load(options.groups);
  if (!robot) return wrong_input;
  return write_libraries(options, robot->read, [&](const backend::Language& language) {
    const std::vector<std::string> groups = groups_of(language, options.groups);
    backend::Library made = language.caches_parameters
                                ? library_for_vectors(*robot, options.names, groups, options.model.steps)
                                : library(*robot, options.names, groups, options.model.steps, primitives_of(options));
    if (language.takes_sines) split_angles(made);
    return made;
  });
}

Status generate_transforms(const Options& options) {
  require_groups_of_transforms(options.groups);
  if (options.has_batches)
    throw Failure{wrong_usage, "robcogen: error: --batch is of robots: motions and transforms have none"};
  for (const backend::Language* language : languages_of(options))
    if (!language->takes_transforms)
      throw Failure{
          wrong_usage, fmt::format(
                           "robcogen: error: --language {} prints robots: transforms of a document cannot be had in it",
                           language->name)};
  const std::optional<Transforms> transforms = options.model.load_transforms();
  if (!transforms) return wrong_input;
  return write_libraries(options, transforms->read, [&](const backend::Language&) {
    return library(*transforms, options.names, options.model.steps, primitives_of(options));
  });
}

Status generate(const Options& options) {
  if (options.output.empty()) throw Failure{wrong_usage, "robcogen: error: generate needs -o DIR"};
  return is_transforms(options.model.model) ? generate_transforms(options) : generate_robot(options);
}

// The files whose names follow from the options alone: those of C++.
Status list_outputs(const Options& options) {
  const bool transforms = is_transforms(options.model.model);
  for (const backend::Language* language : languages_of(options)) {
    if (language->name != "cpp") continue;
    const std::vector<std::string> groups =
        transforms ? std::vector<std::string>{kTransformsGroup} : groups_of(*language, options.groups);
    const std::string folder = backend::cpp::folder(options.names.name, options.names.enclosing);
    for (const std::string& file : backend::cpp::outputs(folder, groups, !transforms, options.has_batches))
      print_output("{}\n", file);
  }
  return ok;
}

std::vector<std::string> language_names() {
  std::vector<std::string> names;
  for (const backend::Language& language : backend::languages()) names.push_back(language.name);
  return names;
}

}  // namespace

Action declare_generate(CLI::App& application) {
  CLI::App* subcommand =
      application.add_subcommand("generate", "Generates the library of a robot or of coordinate transforms");
  auto options = std::make_shared<Options>();
  options->model.declare(*subcommand);
  options->model.lists_parameters = true;
  subcommand->get_option("model")->required(false);
  subcommand->add_option("-o,--output", options->output, "Folder for the generated files");
  subcommand->add_option("--name", options->names.name, "Folder and namespace of the code")->required();
  subcommand->add_option(
      "--namespace", options->names.enclosing, "Enclosing namespace, a::b; files go to the folder a/b/NAME");
  const std::string default_groups = fmt::format("{}", fmt::join(algorithm::default_groups(), ", "));
  declare_groups(*subcommand, options->groups, "What to generate; default " + default_groups);
  subcommand->add_flag(
      "--batch", options->has_batches,
      "cpp: each function also over many states at once, compiled for several processors; robots only");
  subcommand->add_option("--language", options->languages, "Target languages; default cpp. Others go to DIR/<language>")
      ->check(one_of(language_names()));
  subcommand
      ->add_option(
          "--primitives", options->primitives,
          "matlab, maxima: transforms also as products of your own Rx, Tx, …; left or right: where the moved frame is")
      ->check(one_of({"left", "right"}));
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
