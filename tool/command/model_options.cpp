#include <fmt/format.h>

#include <algorithm>

#include "command/command.h"
#include "command/output.h"
#include "command/usage.h"

namespace robcogen::command {
namespace {

// Those of all groups that were asked for, or all, in canonical order.
std::vector<std::string> ordered_groups(const std::vector<std::string>& asked) {
  std::vector<std::string> ordered;
  const std::vector<std::string> named = named_groups(asked);
  for (const std::string& group : algorithm::groups())
    if (named.empty() || std::count(named.begin(), named.end(), group) > 0) ordered.push_back(group);
  return ordered;
}

Diagnostics errors_of(const Diagnostics& all) {
  Diagnostics errors;
  for (const Diagnostic& d : all.all())
    if (d.severity == Severity::error) errors.error(d.code, d.place, d.message) = d;
  return errors;
}

constexpr const char* kNoSteps = "none";

std::vector<std::string> words_for_steps() {
  std::vector<std::string> words = all_steps();
  words.emplace_back(kNoSteps);
  return words;
}

std::vector<std::string> chosen_steps(const std::vector<std::string>& words) {
  if (std::count(words.begin(), words.end(), kNoSteps) == 0) return words;
  if (words.size() > 1) throw CLI::ValidationError("--passes", "'none' excludes other steps");
  return {};
}

}  // namespace

std::vector<std::string> named_groups(const std::vector<std::string>& asked) {
  return std::count(asked.begin(), asked.end(), kAllGroups) > 0 ? std::vector<std::string>() : asked;
}

std::string dotted(const std::string& scope, const std::string& name) {
  std::string result = scope.empty() ? name : scope + "::" + name;
  for (std::size_t at; (at = result.find("::")) != std::string::npos;) result.replace(at, 2, ".");
  return result;
}

ErrorFormat format_of(const std::string& name) {
  return name == "msvc" ? ErrorFormat::msvc : ErrorFormat::gnu;
}

void declare_error_format(CLI::App& subcommand, std::string& format) {
  subcommand.add_option("--error-format", format, "How messages name places: gnu or msvc")
      ->check(one_of({"gnu", "msvc"}));
}

void declare_urdf_options(CLI::App& subcommand, import::UrdfOptions& options) {
  subcommand.add_flag("--floating-base", options.floating_base, "URDF: the root link floats");
  subcommand.add_flag(
      "--snap-angles", options.snap_angles, "URDF: angles within 1e-6 of a multiple of PI/12 become that multiple");
  subcommand.add_flag(
      "--free-mimic-joints", options.free_mimic_joints, "URDF: a joint that mimics another is a joint of its own");
  subcommand.add_flag(
      "--allow-implausible", options.allow_implausible, "URDF: masses and inertias that no body has are warnings");
}

void require_urdf(const std::filesystem::path& model, const import::UrdfOptions& options) {
  const bool given =
      options.floating_base || options.snap_angles || options.free_mimic_joints || options.allow_implausible;
  if (!given || is_urdf(model)) return;
  throw Failure{
      wrong_usage, fmt::format(
                       "robcogen: error: --floating-base, --snap-angles, --free-mimic-joints and --allow-implausible "
                       "are for URDF; '{}' "
                       "says such things itself",
                       model.string())};
}

void declare_groups(CLI::App& subcommand, std::vector<std::string>& groups, const std::string& description) {
  std::vector<std::string> names = algorithm::groups();
  names.emplace_back(kAllGroups);
  subcommand.add_option("--algorithms", groups, description)->delimiter(',')->check(one_of(names));
}

void require_groups_of_transforms(const std::vector<std::string>& asked) {
  for (const std::string& group : named_groups(asked)) {
    if (group == kTransformsGroup) continue;
    throw Failure{
        wrong_usage,
        fmt::format("robcogen: error: --algorithms {} is of robots: motions and transforms have none", group)};
  }
}

void ModelOptions::declare(CLI::App& subcommand) {
  subcommand.add_option("model", model, "Robot (.kindsl or .urdf), motions (.motdsl) or transforms (.ctdsl)")
      ->required();
  subcommand.add_option("--desired", desired, "Desired transforms and Jacobians (.dtdsl)");
  subcommand.add_flag("--strict", strict, kStrictHelp);
  subcommand
      .add_option_function<std::vector<std::string>>(
          "--passes", [this](const std::vector<std::string>& names) { steps.names = chosen_steps(names); },
          "Which steps of optimisation run: a comma-separated list, or none")
      ->delimiter(',')
      ->allow_extra_args(false)
      ->check(one_of(words_for_steps()));
  subcommand
      .add_option(
          "--effort", steps.effort,
          "How long to look for link frames in which the dynamics cost less: 0 not at all, 1 two seconds for forty "
          "joints, n that many times as long")
      ->check(CLI::Range(0, 1000));
  declare_urdf_options(subcommand, urdf);
  declare_error_format(subcommand, error_format);
}

Reading ModelOptions::reading() const {
  require_urdf(model, urdf);
  Reading result;
  if (!desired.empty()) result.desired = desired;
  result.strict = strict;
  result.urdf = urdf;
  result.lists_parameters = lists_parameters;
  return result;
}

void ModelOptions::report_all(const Diagnostics& diagnostics) const {
  report((quiet ? errors_of(diagnostics) : diagnostics).render(format_of(error_format)));
}

std::optional<Robot> ModelOptions::load(const std::vector<std::string>& groups) const {
  Diagnostics diagnostics;
  Reading how = reading();
  how.groups = named_groups(groups);
  std::optional<Robot> robot = load_robot(model, how, diagnostics);
  report_all(diagnostics);
  return robot;
}

std::optional<Transforms> ModelOptions::load_transforms() const {
  Diagnostics diagnostics;
  std::optional<Transforms> transforms = command::load_transforms(model, reading(), diagnostics);
  report_all(diagnostics);
  return transforms;
}

std::optional<Programs> ModelOptions::load_programs(const std::vector<std::string>& groups, bool cached) const {
  if (is_transforms(model)) {
    require_groups_of_transforms(groups);
    const std::optional<Transforms> transforms = load_transforms();
    if (!transforms) return std::nullopt;
    const model::CoordinateTransforms& document = transforms->document;
    Programs programs = {
        "model",
        document.name,
        fmt::format(
            "{} transforms of {} variables and {} parameters", document.transforms.size(), document.variables.size(),
            document.parameters.size()),
        {}};
    for (algorithm::TransformFunction& f : trace(*transforms, steps))
      programs.list.push_back({dotted(f.scope, f.name), std::move(f.program)});
    return programs;
  }
  const std::optional<Robot> robot = load(groups);
  if (!robot) return std::nullopt;
  Programs programs = {
      "robot",
      robot->tree.name,
      fmt::format(
          "{} joints, {} base; default gravity, no external forces", robot->tree.dof(),
          robot->tree.floating_base ? "floating" : "fixed"),
      {}};
  if (cached) {
    backend::Library library = library_for_vectors(*robot, {}, ordered_groups(groups), steps);
    for (std::vector<backend::Function>* functions : {&library.functions, &library.updates})
      for (backend::Function& f : *functions)
        programs.list.push_back(
            {dotted(f.scope, f.name), lanes && f.in_lanes ? std::move(*f.in_lanes) : std::move(f.program),
             std::move(f.method), f.error});
    return programs;
  }
  for (algorithm::RobotFunction& f : trace(*robot, ordered_groups(groups), steps))
    programs.list.push_back({dotted(f.scope, f.name), std::move(f.program), std::move(f.method), f.error});
  return programs;
}

}  // namespace robcogen::command
