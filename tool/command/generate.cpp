#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <system_error>
#include <variant>

#include "algorithm/catalogue/fused.h"
#include "backend/c/c.h"
#include "backend/casadi/casadi.h"
#include "backend/common/names.h"
#include "backend/compatibility/compatibility.h"
#include "backend/cpp/cpp.h"
#include "backend/gpu/gpu.h"
#include "backend/languages.h"
#include "backend/selfcheck/selfcheck.h"
#include "backend/vamp/vamp.h"
#include "command/output.h"
#include "command/output_files.h"
#include "command/spherical_joints.h"
#include "command/subcommands.h"
#include "driver/derivatives.h"
#include "driver/documents.h"
#include "import/frame_patterns.h"

namespace robcogen::command {
namespace {

namespace fs = std::filesystem;

bool is_identifier(const std::string& name) {
  const auto letter = [](char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_'; };
  return !name.empty() && letter(name.front()) &&
         std::all_of(name.begin(), name.end(), [&](char c) { return letter(c) || (c >= '0' && c <= '9'); });
}

std::string name_after(const std::string& file) {
  const std::string stem = fs::path(file).stem().string();
  if (is_identifier(stem)) return stem;
  throw Failure{
      wrong_usage, fmt::format(
                       "robcogen: error: '{}' cannot name the code, as '{}' is not a valid identifier\nhint: "
                       "'--name NAME' gives another name",
                       file, stem)};
}

void check_names(const driver::LibraryNames& names) {
  if (!is_identifier(names.name))
    throw Failure{wrong_usage, fmt::format("robcogen: error: --name '{}' is not a valid identifier", names.name)};
  std::string rest = names.enclosing;
  while (!rest.empty()) {
    const std::size_t end = std::min(rest.find("::"), rest.size());
    if (!is_identifier(rest.substr(0, end)))
      throw Failure{
          wrong_usage, fmt::format("robcogen: error: --namespace '{}' is not a valid namespace", names.enclosing)};
    rest.erase(0, std::min(end + 2, rest.size()));
  }
}

// Letters, digits, '_' and '-' in folders below the output folder.
void check_include_path(const GenerateOptions& options) {
  const std::string& path = options.include_path;
  if (path.empty()) return;
  if (options.compatibility.empty())
    throw Failure{wrong_usage, "robcogen: error: --include-path needs --compatibility"};
  const auto is_legal = [](char c) { return is_identifier(std::string(1, c)) || (c >= '0' && c <= '9') || c == '-'; };
  bool begins = true;  // a folder
  bool good = true;
  for (const char c : path) {
    good = good && (is_legal(c) || (c == '/' && !begins));
    begins = c == '/';
  }
  if (!good || begins)
    throw Failure{
        wrong_usage, fmt::format(
                         "robcogen: error: --include-path '{}' is not a folder as #include lines name it, such as "
                         "iit/robots/hyq",
                         path)};
}

bool contains(const std::vector<std::string>& list, const std::string& item) {
  return std::find(list.begin(), list.end(), item) != list.end();
}

// Without a list, these are the default groups, and those whose frames are given. If functions are given, so is their
// group. Headers of the first RobCoGen and for VAMP call functions of further groups.
std::vector<std::string> asked_groups(const GenerateOptions& options) {
  const ModelOptions& model = options.model;
  std::vector<std::string> groups = options.groups;
  if (groups.empty() &&
      !(model.contacts.empty() && model.inverses.empty() && model.functions.empty() && options.vamp.empty()))
    groups = algorithm::default_groups();
  if (options.groups.empty() && !model.contacts.empty()) groups.emplace_back("contacts");
  if (options.groups.empty() && !model.inverses.empty()) groups.emplace_back("inverse_kinematics");
  if (!model.functions.empty()) groups.emplace_back(algorithm::kFusedGroup);
  if (!groups.empty() && !options.compatibility.empty())
    groups.insert(groups.end(), backend::compatibility::groups().begin(), backend::compatibility::groups().end());
  if (!options.vamp.empty())
    groups.insert(groups.end(), backend::vamp::groups().begin(), backend::vamp::groups().end());
  return groups;
}

std::string include_path(const GenerateOptions& options) {
  return options.include_path.empty() ? backend::compatibility::default_include_path(options.names.name)
                                      : options.include_path;
}

// Adds what the headers of the first RobCoGen need. Returns false if the robot is not one that they can describe.
bool prepare_compatibility(const GenerateOptions& options, driver::Model& model) {
  driver::Robot& robot = std::get<driver::Robot>(model.content);
  Diagnostics diagnostics;
  backend::compatibility::check(robot.tree, diagnostics);
  report(diagnostics.render(options.model.messages));
  if (diagnostics.has_errors()) return false;
  backend::compatibility::add_link_transforms(robot.tree, robot.desired);
  return true;
}

// Adds the transform of the end effector, which becomes the name of its frame. Returns false if VAMP cannot plan for
// the robot, or the robot has no such frame.
bool prepare_vamp(GenerateOptions& options, driver::Model& model) {
  driver::Robot& robot = std::get<driver::Robot>(model.content);
  Diagnostics diagnostics;
  backend::vamp::check(robot.tree, diagnostics);
  const model::DesiredTransforms pairs = import::desired_by_patterns({{options.vamp, {}}}, robot.tree, diagnostics);
  for (const model::FramePair& pair : pairs.transforms) {
    if (robot.tree.link_of(pair.left) != 0) continue;
    options.vamp = pair.right.name;
    auto& desired = robot.desired.transforms;
    if (std::find(desired.begin(), desired.end(), pair) == desired.end()) desired.push_back(pair);
  }
  report(diagnostics.render(options.model.messages));
  return !diagnostics.has_errors();
}

// The groups that were named, in canonical order. Throws a Failure if the language does not offer one of them.
std::vector<std::string> groups_of(const backend::Language& language, const std::vector<std::string>& asked) {
  std::vector<std::string> ordered;
  for (const std::string& group : algorithm::groups()) {
    const bool is_offered = language.groups.empty() || contains(language.groups, group);
    const bool is_of_all = contains(asked, kAllGroups) && group != algorithm::kCollisionGroup;
    if (!is_of_all && !contains(asked.empty() ? algorithm::default_groups() : asked, group)) continue;
    if (is_offered) {
      ordered.push_back(group);
    } else if (!named_groups(asked).empty()) {
      throw Failure{
          wrong_usage, fmt::format(
                           "robcogen: error: --algorithms {} is not available in {}, which offers {}", group,
                           language.name, fmt::join(language.groups, ", "))};
    }
  }
  return ordered;
}

std::vector<const backend::Language*> languages_of(const GenerateOptions& options) {
  std::vector<const backend::Language*> chosen;
  for (const backend::Language& language : backend::languages())
    if (contains(options.languages, language.name)) chosen.push_back(&language);
  return chosen;
}

// The processors above the baseline, lowest first.
std::vector<std::string> levels_of(const GenerateOptions& options) {
  std::vector<std::string> levels;
  for (const char* level : {"avx2", "avx512"})
    if (contains(options.processors, level)) levels.emplace_back(level);
  return levels;
}

driver::Primitives primitives_of(const GenerateOptions& options) {
  if (options.primitives.empty()) return std::nullopt;
  return options.primitives == "left" ? model::MovedFramePosition::left : model::MovedFramePosition::right;
}

// In some languages, the names of files depend on the model. Files of an earlier run that are no longer generated must
// be removed, so every run writes a list of its files next to them.
struct Listed {
  fs::path list;                   // relative to the output folder
  std::vector<std::string> files;  // of this run
  std::vector<std::string> made_before;
};

Listed list_files(const GenerateOptions& options, const std::string& folder, const std::vector<OutputFile>& files) {
  Listed listed = {fs::path(folder) / (options.names.name + ".files"), {}, {}};
  for (const OutputFile& file : files) listed.files.push_back((fs::path(folder) / file.path).generic_string());
  std::ifstream earlier(fs::path(options.output) / listed.list);
  for (std::string line; std::getline(earlier, line);) listed.made_before.push_back(line);
  return listed;
}

// Files that were read are kept, whatever the list says.
void remove_stale(const GenerateOptions& options, const Listed& listed, const std::vector<fs::path>& read) {
  for (const std::string& file : listed.made_before) {
    const fs::path path(file);
    const bool is_below = path.is_relative() && std::find(path.begin(), path.end(), "..") == path.end();
    std::error_code ignored;
    const fs::path stale = fs::path(options.output) / path;
    if (is_below && !contains(listed.files, file) && !overlap({stale}, read)) fs::remove(stale, ignored);
  }
}

// Unlike generated sources, a stamp and a dependency file get a new time even when their text does not change.
void write(const fs::path& path, const std::string& text) {
  std::ofstream file(path, std::ios::binary | std::ios::trunc);
  file << text;
  file.close();
  if (!file) throw Failure{wrong_usage, fmt::format("robcogen: error: cannot write '{}'", path.string())};
}

Status write_libraries(const GenerateOptions& options, const driver::Model& model) {
  if (!options.primitives.empty() && model.robot())
    refuse_spherical_joints(
        model.robot()->tree, "products of primitives (--primitives) have no rotations by quaternions");
  std::vector<OutputFile> files;
  std::vector<Listed> lists;
  std::string hash;
  for (const backend::Language* language : languages_of(options)) {
    // The library in C has both precisions, and so has its self-check.
    const bool has_single_precision = options.has_single_precision || language->name == "c";
    const backend::Library library = driver::library(
        model,
        {options.names, groups_of(*language, asked_groups(options)), options.model.steps, primitives_of(options),
         options.has_batches, levels_of(options), has_single_precision},
        language->features);
    hash = library.model_hash;
    std::vector<OutputFile> printed = language->print(library);
    if (options.checks_c && language->name == "c")
      for (OutputFile& file : backend::selfcheck::print(library)) printed.push_back(std::move(file));
    if (language->name == "cpp") {
      files = std::move(printed);
      if (!options.vamp.empty()) files.push_back(backend::vamp::print(library, options.vamp));
      if (options.compatibility.empty()) continue;
      for (OutputFile& file : backend::compatibility::print(library, {options.names.enclosing, include_path(options)}))
        files.push_back(std::move(file));
      continue;
    }
    const Listed& listed = lists.emplace_back(list_files(options, language->name, printed));
    for (OutputFile& file : printed) files.push_back({fs::path(language->name) / file.path, std::move(file.text)});
    files.push_back({listed.list, fmt::format("{}\n", fmt::join(listed.files, "\n"))});
  }
  std::vector<fs::path> others;
  for (const std::string& other : {options.depfile, options.stamp})
    if (!other.empty()) others.emplace_back(other);
  write_generated_files(options.output, files, model.read, others);
  for (const Listed& listed : lists) remove_stale(options, listed, model.read);
  if (!options.depfile.empty()) {
    const std::string target = options.depfile_target.empty() ? options.stamp : options.depfile_target;
    std::vector<fs::path> inputs;
    for (const fs::path& file : model.read) inputs.push_back(fs::absolute(file));
    write(options.depfile, dependency_file(target, inputs));
  }
  if (!options.stamp.empty()) write(options.stamp, hash + "\n");
  return ok;
}

bool is_transforms(const GenerateOptions& options) {
  return !driver::is_robot(driver::language_of(options.model.file));
}

void require_options_of_transforms(const GenerateOptions& options) {
  require_groups_of_transforms(options.groups);
  if (options.has_batches)
    throw Failure{wrong_usage, "robcogen: error: --batch applies to robots only, not to motions and transforms"};
  if (!levels_of(options).empty())
    throw Failure{wrong_usage, "robcogen: error: --processors applies to robots only, not to motions and transforms"};
  if (!options.compatibility.empty())
    throw Failure{
        wrong_usage, "robcogen: error: --compatibility applies to robots only, not to motions and transforms"};
  if (!options.vamp.empty())
    throw Failure{wrong_usage, "robcogen: error: --vamp applies to robots only, not to motions and transforms"};
  if (options.checks_c)
    throw Failure{wrong_usage, "robcogen: error: --c-selfcheck applies to robots only, not to motions and transforms"};
  for (const backend::Language* language : languages_of(options))
    if (!language->takes_transforms)
      throw Failure{
          wrong_usage,
          fmt::format(
              "robcogen: error: --language {} applies to robots only, not to motions and transforms", language->name)};
}

// Refuses an option that none of the languages heeds, because it would be ignored.
void require_languages(const GenerateOptions& options) {
  struct Heeded {
    bool is_given;
    const char* option;
    std::vector<std::string> languages;
  };
  const Heeded heeded[] = {
      {options.has_batches, "--batch", {"cpp"}},
      {!options.processors.empty(), "--processors", {"cpp"}},
      {options.has_single_precision, "--single-precision", {"cpp"}},
      {options.is_double_only, "--double-only", {"cpp"}},
      {!options.compatibility.empty(), "--compatibility", {"cpp"}},
      {!options.vamp.empty(), "--vamp", {"cpp"}},
      {options.checks_c, "--c-selfcheck", {"c"}},
      {!options.primitives.empty(), "--primitives", {"matlab", "maxima", "javascript"}}};
  const auto is_asked = [&](const std::string& language) { return contains(options.languages, language); };
  for (const Heeded& h : heeded)
    if (h.is_given && std::none_of(h.languages.begin(), h.languages.end(), is_asked))
      throw Failure{
          wrong_usage, fmt::format(
                           "robcogen: error: {} is for --language {}, not for {}", h.option,
                           fmt::join(h.languages, " or "), fmt::join(options.languages, ", "))};
}

// Lists the files whose names depend on the options only: those of C++, C, GPUs and Python.
Status list_outputs(const GenerateOptions& options) {
  const bool transforms = is_transforms(options);
  for (const backend::Language* language : languages_of(options)) {
    if (language->name == "python")
      for (const char* end : {".cpp", ".pyi"}) print_output("python/{}{}\n", options.names.name, end);
    if (language->name != "cpp" && language->name != "c" && language->name != "gpu") continue;
    std::vector<std::string> groups =
        transforms ? std::vector<std::string>{driver::kTransformsGroup} : groups_of(*language, asked_groups(options));
    if (options.model.asks_for_derivatives()) groups.emplace_back(driver::kDerivativesGroup);
    if (language->name == "gpu") {
      const std::string prefix = backend::flat(options.names.enclosing, options.names.name);
      for (const std::string& file : backend::gpu::outputs(prefix, groups)) print_output("gpu/{}\n", file);
      continue;
    }
    if (language->name == "c") {
      if (!transforms) groups.insert(groups.begin(), backend::c::kParametersGroup);
      const std::string prefix = backend::flat(options.names.enclosing, options.names.name);
      for (const std::string& file : backend::c::outputs(prefix, groups)) print_output("c/{}\n", file);
      print_output("c/{}\n", backend::casadi::output(prefix));
      if (options.checks_c)
        for (const std::string& file : backend::selfcheck::outputs(options.names.name, options.names.enclosing))
          print_output("c/{}\n", file);
      continue;
    }
    const std::string folder = backend::cpp::folder(options.names.name, options.names.enclosing);
    for (const std::string& file :
         backend::cpp::outputs(folder, groups, !transforms, options.has_batches, levels_of(options)))
      print_output("{}\n", file);
    if (!options.vamp.empty()) print_output("{}\n", backend::vamp::output(options.names.name));
    if (options.compatibility.empty()) continue;
    for (const std::string& file : backend::compatibility::outputs(folder, include_path(options)))
      print_output("{}\n", file);
  }
  return ok;
}

}  // namespace

Status generate(GenerateOptions options) {
  const std::string& file = options.model.file;
  if (options.names.name.empty()) {
    if (file.empty()) throw Failure{wrong_usage, "robcogen: error: generate needs a model"};
    options.names.name = name_after(file);
  }
  check_names(options.names);
  check_include_path(options);
  require_languages(options);
  if (options.list_outputs) {
    require_apart_from_output({file});
    return list_outputs(options);
  }
  if (file.empty()) throw Failure{wrong_usage, "robcogen: error: generate needs a model"};
  if (options.output.empty()) throw Failure{wrong_usage, "robcogen: error: generate needs an output folder: -o DIR"};
  if (is_transforms(options)) require_options_of_transforms(options);
  std::vector<std::string> groups = options.groups;
  if (!options.vamp.empty()) groups.emplace_back(algorithm::kCollisionGroup);
  std::optional<driver::Model> model = options.model.load(groups);
  if (model && !options.vamp.empty() && !prepare_vamp(options, *model)) return wrong_input;
  if (model && !options.compatibility.empty() && !prepare_compatibility(options, *model)) return wrong_input;
  return model ? write_libraries(options, *model) : wrong_input;
}

}  // namespace robcogen::command
