#include "command/model_options.h"

#include <fmt/format.h>

#include <algorithm>
#include <system_error>
#include <utility>

#include "command/output.h"
#include "driver/derivatives.h"
#include "driver/documents.h"

namespace robcogen::command {
namespace {

// The groups that were named, or all, in canonical order.
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

std::string about(const driver::Model& model) {
  if (const driver::Robot* robot = model.robot())
    return fmt::format(
        "{} joints, {} base; default gravity, no external forces", robot->tree.dof(),
        robot->tree.floating_base ? "floating" : "fixed");
  const model::CoordinateTransforms& document = model.transforms()->document;
  return fmt::format(
      "{} transforms of {} variables and {} parameters", document.transforms.size(), document.variables.size(),
      document.parameters.size());
}

}  // namespace

std::vector<std::string> named_groups(const std::vector<std::string>& asked) {
  return std::count(asked.begin(), asked.end(), kAllGroups) > 0 ? std::vector<std::string>() : asked;
}

void require_format(const std::filesystem::path& model, const FormatOptions& options) {
  const import::UrdfOptions& urdf = options.urdf;
  if (urdf.friction_velocity > 0 && !urdf.passive_forces)
    throw Failure{
        wrong_usage,
        "robcogen: error: --friction-velocity needs --passive-forces: without them, friction is not part of the "
        "dynamics"};
  if (!options.changes.empty() && !driver::is_robot(driver::language_of(model)))
    throw Failure{
        wrong_usage, fmt::format(
                         "robcogen: error: {} applies to robots only, not to motions and transforms",
                         !options.changes.locks.empty()  ? "--lock"
                         : !options.changes.kept.empty() ? "--keep"
                                                         : "--parameters")};
  const bool for_urdf = urdf.floating_base || urdf.snap_angles || urdf.passive_forces || urdf.allow_implausible;
  if (!for_urdf && !urdf.free_mimic_joints && options.robot.empty()) return;
  const driver::Language language = driver::language_of(model);
  const bool may_have_several = language == driver::Language::mjcf || language == driver::Language::sdf;
  if (!options.robot.empty() && !may_have_several)
    throw Failure{
        wrong_usage,
        fmt::format(
            "robcogen: error: --robot is for MJCF and SDF, whose scenes have several; '{}' has one", model.string())};
  if (!for_urdf && !urdf.free_mimic_joints) return;
  if (language == driver::Language::urdf) return;
  if (language == driver::Language::mjcf && !for_urdf) return;
  const bool for_urdf_alone = urdf.floating_base || urdf.passive_forces || urdf.allow_implausible;
  if (language == driver::Language::sdf && !for_urdf_alone) return;
  throw Failure{
      wrong_usage, fmt::format(
                       "robcogen: error: --floating-base, --snap-angles, --free-mimic-joints, --passive-forces, "
                       "--friction-velocity and --allow-implausible are for URDF; '{}' states these properties itself",
                       model.string())};
}

void report_missing_folders(const std::vector<std::filesystem::path>& folders, const Rendering& messages) {
  Diagnostics diagnostics;
  std::error_code ignored;
  for (const std::filesystem::path& folder : folders)
    if (!std::filesystem::is_directory(folder, ignored))
      diagnostics.warning("no-import-folder", {}, fmt::format("-I: folder '{}' does not exist", folder.string()));
  report(diagnostics.render(messages));
}

void require_groups_of_transforms(const std::vector<std::string>& asked) {
  for (const std::string& group : named_groups(asked)) {
    if (group == driver::kTransformsGroup) continue;
    throw Failure{wrong_usage, fmt::format("robcogen: error: --algorithms {} applies to robots only", group)};
  }
}

std::optional<driver::Model> ModelOptions::load(const std::vector<std::string>& groups) const {
  Diagnostics diagnostics;
  return load(groups, diagnostics);
}

std::optional<driver::Model> ModelOptions::load(const std::vector<std::string>& groups, Diagnostics& diagnostics)
    const {
  require_format(file, format);
  const char* const for_robots = !contacts.empty()    ? "--contacts"
                                 : !inverses.empty()  ? "--inverse-kinematics"
                                 : !frames.empty()    ? "--frames"
                                 : !functions.empty() ? "--function"
                                                      : nullptr;
  if (for_robots != nullptr && !driver::is_robot(driver::language_of(file)))
    throw Failure{
        wrong_usage,
        fmt::format("robcogen: error: {} applies to robots only, not to motions and transforms", for_robots)};
  if (!srdf.empty() && driver::language_of(file) != driver::Language::urdf)
    throw Failure{
        wrong_usage,
        fmt::format("robcogen: error: --srdf names pairs of links of a URDF, and '{}' is not a URDF", file)};
  if (!quiet) report_missing_folders(import_folders, messages);
  driver::LoadOptions options;
  if (!desired.empty()) options.desired = desired;
  options.strict = strict;
  options.urdf = format.urdf;
  options.robot = format.robot;
  options.changes = format.changes;
  options.import_folders = import_folders;
  options.lists_parameters = lists_parameters;
  options.groups = named_groups(groups);
  // `all` does not have it: shapes, and the meshes of their files, are read on request.
  const bool has_collisions = std::count(groups.begin(), groups.end(), algorithm::kCollisionGroup) > 0;
  if (options.groups.empty() && has_collisions) options.groups = {algorithm::kCollisionGroup};
  using symbolic::DerivativeForm;
  for (const auto& [texts, form] :
       {std::pair{&derivatives, DerivativeForm::matrix},
        {&gradients, DerivativeForm::gradient},
        {&tangents, DerivativeForm::tangent}})
    for (const std::string& text : *texts) options.derivatives.push_back(driver::parse_derivative(text, form));
  options.contacts = contacts;
  options.inverses = inverses;
  options.frames = frames;
  options.functions = functions;
  if (!srdf.empty()) options.srdf = srdf;
  options.lists_absent_groups = std::count(groups.begin(), groups.end(), kAllGroups) > 0;
  std::optional<driver::Model> model = driver::load(file, options, diagnostics);
  report((quiet ? errors_of(diagnostics) : diagnostics).render(messages));
  return model;
}

std::optional<Programs> ModelOptions::load_programs(
    const std::vector<std::string>& groups,
    const backend::Features& features) const {
  if (!driver::is_robot(driver::language_of(file))) require_groups_of_transforms(groups);
  const std::optional<driver::Model> model = load(groups);
  if (!model) return std::nullopt;
  driver::Functions traced = driver::programs(*model, ordered_groups(groups), steps, features);
  Programs programs = {model->robot() ? "robot" : "model", model->name(), about(*model), {}, model->read};
  for (driver::Function& f : traced.list)
    programs.list.push_back(
        {dotted(f.scope, f.name), f.in_lanes ? std::move(*f.in_lanes) : std::move(f.program), std::move(f.method),
         f.error, std::move(f.limbs_in_lanes), std::move(f.without_lanes)});
  if (model->robot()) programs.unlike_limbs = model::unlike_limbs(model->robot()->tree);
  for (symbolic::Function& f : traced.updates) programs.list.push_back({dotted(f.scope, f.name), std::move(f.program)});
  return programs;
}

}  // namespace robcogen::command
