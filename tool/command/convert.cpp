// Models from one language to another: robots to robots, robots to motions, and both to coordinate transforms.
#include <fmt/format.h>

#include <algorithm>

#include "command/model_options.h"
#include "command/output.h"
#include "command/output_files.h"
#include "command/spherical_joints.h"
#include "command/subcommands.h"
#include "driver/documents.h"
#include "export/elastic_joints.h"
#include "export/frames.h"
#include "export/kinematics.h"
#include "export/urdf.h"
#include "export/urdf_loops.h"
#include "import/frames.h"
#include "import/kinematics.h"

namespace robcogen::command {
namespace {

namespace fs = std::filesystem;

using driver::is_robot;
using driver::Language;
using driver::Robot;

Language language_to_write(const fs::path& file) {
  const std::optional<Language> language = driver::language_of_suffix(file);
  if (language && language != Language::desired && language != Language::sdf) return *language;
  throw Failure{
      wrong_usage,
      fmt::format(
          "robcogen: error: cannot convert '{}': the languages are .kindsl, .urdf, .motdsl and .ctdsl", file.string())};
}

void require_conversion(const ConvertOptions& options) {
  const Language from = driver::language_of(options.from), to = language_to_write(options.to);
  if (from == to && from != Language::urdf)
    throw Failure{
        wrong_usage,
        "robcogen: error: both files are in the same language\nhint: 'robcogen print' writes a document in canonical "
        "form"};
  if (from == Language::transforms || (from == Language::motions && to != Language::transforms))
    throw Failure{
        wrong_usage, fmt::format(
                         "robcogen: error: '{}' cannot be converted to '{}'\nhint: robots become motions, and "
                         "robots and motions "
                         "become transforms",
                         options.from, options.to)};
  if (!options.desired.empty() && to != Language::transforms)
    throw Failure{wrong_usage, "robcogen: error: --desired selects transforms: the output must be a .ctdsl file"};
  require_format(options.from, options.format);
}

void require_values(const driver::Model& model, const Robot& robot) {
  if (robot.tree.parameters.empty()) return;
  std::vector<std::string> names;
  for (const model::Parameter& p : robot.tree.parameters) names.push_back(p.name);
  throw Failure{
      wrong_input,
      fmt::format(
          "{}: error: URDF has no parameters, but robot '{}' has {} [parametric-urdf]\nhint: give them values in the "
          "document",
          model.file.string(), robot.tree.name, fmt::join(names, ", "))};
}

// Fails if the robot has loops.
void require_no_loops(const driver::Model& model, const Robot& robot, std::string_view reason) {
  if (robot.tree.loops.empty()) return;
  throw Failure{
      wrong_input, fmt::format(
                       "{}: error: {}, but robot '{}' has loop '{}' [loop-lost]", model.file.string(), reason,
                       robot.tree.name, robot.tree.loops.front().name)};
}

// Fails if URDF+ cannot express a loop.
void require_hinges(const driver::Model& model, const Robot& robot) {
  for (const model::LoopJoint& loop : robot.tree.loops) {
    if (exporting::may_be_urdf_loop(loop)) continue;
    const std::string owner = fmt::format("loop '{}' of robot '{}'", loop.name, robot.tree.name);
    const std::string message =
        loop.type == model::LoopType::hinge
            ? fmt::format(
                  "URDF+ cannot express that {} is assembled on the other branch [loop-lost]\nhint: turn the "
                  "placements of its joints to where it is assembled, or give them 'assembled' positions near it",
                  owner)
            : fmt::format(
                  "URDF+ has only hinges, but {} is of type {} [loop-lost]", owner,
                  model::kLoopTypes[static_cast<std::size_t>(loop.type)]);
    throw Failure{wrong_input, fmt::format("{}: error: {}", model.file.string(), message)};
  }
}

// Adds one note: readers of plain URDF ignore the elements of URDF+.
void mention_urdf_plus(const Robot& robot, Diagnostics& diagnostics) {
  if (robot.tree.loops.empty()) return;
  diagnostics.note(
      "urdf-plus", robot.tree.loops.front().place,
      "loops are elements of URDF+: readers of plain URDF leave them open, and the joints that follow move freely");
}

// Fails if a joint follows several others in a way that URDF+ cannot express.
void require_couplings(const driver::Model& model, const Robot& robot) {
  for (const model::Coupling& coupling : robot.tree.couplings) {
    if (exporting::has_urdf_form(robot.tree, coupling)) continue;
    throw Failure{
        wrong_input,
        fmt::format(
            "{}: error: a joint of a URDF mimics at most one joint, but joint '{}' of robot '{}' follows {} "
            "[coupling-urdf]",
            model.file.string(), robot.tree.joints[static_cast<std::size_t>(coupling.joint)].name, robot.tree.name,
            coupling.terms.size())};
  }
}

std::vector<std::string> names_of(const Robot& robot, model::JointType type) {
  std::vector<std::string> names;
  for (const model::Joint& joint : robot.tree.joints)
    if (joint.type == type && joint.is_first()) names.push_back(fmt::format("'{}'", joint.declared_name()));
  return names;
}

void require_urdf_types(const driver::Model& model, const Robot& robot) {
  refuse_spherical_joints(
      robot.tree, "URDF has no spherical joints",
      "three continuous joints in a row with massless links between them have the same motions, except in their "
      "singular positions");
  const std::vector<std::string> helical = names_of(robot, model::JointType::helical);
  if (helical.empty()) return;
  throw Failure{
      wrong_input, fmt::format(
                       "{}: error: URDF has no helical joints, but robot '{}' has {} [helical-urdf]\nhint: a p_joint "
                       "that is coupled to an r_joint moves in the same way",
                       model.file.string(), robot.tree.name, fmt::join(helical, ", "))};
}

// A comment that names the source of the document.
std::vector<std::string> origin(const ConvertOptions& options) {
  return {fmt::format("// Converted from {}.", fs::path(options.from).filename().string())};
}

// Adds one warning that lists the parts of drives that URDF cannot express.
void mention_lost_drives(const Robot& robot, Diagnostics& diagnostics) {
  std::vector<std::string> lost;
  const auto add = [&](const model::Joint& joint, const char* what, bool given) {
    if (given) lost.push_back(fmt::format("{} of '{}'", what, joint.name));
  };
  for (const model::Joint& joint : robot.tree.joints) {
    add(joint, "armature", !joint.drive.armature.is_zero());
    add(joint, "spring", !joint.drive.stiffness.is_zero());
    add(joint, "rotor", joint.drive.rotor.has_value());
    add(joint, "velocity of the friction", !joint.drive.friction_velocity.is_zero());
  }
  if (lost.empty()) return;
  diagnostics.warning(
      "drive-lost", robot.tree.joints.front().place,
      fmt::format("a URDF cannot hold these properties of drives, which are left out: {}", fmt::join(lost, ", ")));
}

// Adds one warning that lists the actuators between frames, which URDF does not have.
void mention_lost_actuators(const Robot& robot, Diagnostics& diagnostics) {
  if (robot.tree.actuators.empty()) return;
  std::vector<std::string> lost;
  for (const model::Actuator& actuator : robot.tree.actuators) lost.push_back(fmt::format("'{}'", actuator.name));
  diagnostics.warning(
      "actuator-lost", robot.tree.actuators.front().place,
      fmt::format("a URDF has no actuators between frames; these are left out: {}", fmt::join(lost, ", ")));
}

// Adds a warning that lists the elastic joints, which become rigid, and one that lists other tendons.
void mention_lost_tendons(const Robot& robot, Diagnostics& diagnostics) {
  std::vector<std::string> rigid, lost;
  std::vector<bool> is_spring(robot.tree.tendons.size());
  for (const exporting::ElasticJoint& elastic : exporting::elastic_joints(robot.tree)) {
    rigid.push_back(fmt::format("'{}'", robot.tree.joints[static_cast<std::size_t>(elastic.joint)].name));
    is_spring[static_cast<std::size_t>(elastic.tendon)] = true;
  }
  for (std::size_t t = 0; t < is_spring.size(); ++t)
    if (!is_spring[t]) lost.push_back(fmt::format("'{}'", robot.tree.tendons[t].name));
  if (!rigid.empty())
    diagnostics.warning(
        "elasticity-lost", robot.tree.joints.front().place,
        fmt::format(
            "a URDF has no elastic joints; these become rigid, without the inertia of their motors: {}",
            fmt::join(rigid, ", ")));
  if (!lost.empty())
    diagnostics.warning(
        "tendon-lost", robot.tree.tendons.front().place,
        fmt::format("a URDF has no tendons; these are left out: {}", fmt::join(lost, ", ")));
}

// Adds one note if the dynamics of the URDF do not include damping and friction, because those of a robot document do.
void mention_passive_forces(const Robot& robot, Diagnostics& diagnostics) {
  if (robot.tree.uses_passive_forces) return;
  for (const model::Joint& joint : robot.tree.joints) {
    if (!joint.drive.is_passive()) continue;
    diagnostics.note(
        "passive-forces-used", joint.place,
        "damping and friction are part of the dynamics of the robot document, as of the URDF with --passive-forces");
    return;
  }
}

// `c to e come after a, b comes first`: the fewest names that change their place, `declared` becoming `written`.
std::string moved_names(const std::vector<std::string>& declared, const std::vector<std::string>& written) {
  const std::size_t n = written.size();
  std::vector<std::size_t> was(n), length(n, 1),
      before(n, n);  // of the longest list that keeps its order and ends at i
  for (std::size_t i = 0; i < n; ++i) {
    was[i] = static_cast<std::size_t>(std::find(declared.begin(), declared.end(), written[i]) - declared.begin());
    for (std::size_t k = 0; k < i; ++k)
      if (was[k] < was[i] && length[k] >= length[i]) length[i] = length[k] + 1, before[i] = k;
  }
  std::vector<bool> stays(n, false);
  for (auto i = static_cast<std::size_t>(std::max_element(length.begin(), length.end()) - length.begin()); i < n;
       i = before[i])
    stays[i] = true;
  std::vector<std::string> moves;
  for (std::size_t i = 0; i < n; ++i) {
    if (stays[i]) continue;
    std::size_t last = i;
    while (last + 1 < n && !stays[last + 1] && was[last + 1] == was[last] + 1) ++last;
    moves.push_back(fmt::format(
        "{}{} come{} {}", written[i], last > i ? " to " + written[last] : "", last > i ? "" : "s",
        i == 0 ? "first" : "after " + written[i - 1]));
    i = last;
  }
  return fmt::format("{}", fmt::join(moves, ", "));
}

// Adds one note if the document declares joints in another order than the model, which changes the order of q.
void mention_order(const fs::path& file, const Robot& robot, Diagnostics& diagnostics) {
  const std::vector<int> order = exporting::joints_parents_first(robot.tree);
  if (std::is_sorted(order.begin(), order.end())) return;
  std::vector<std::string> written, declared;
  for (const int j : order)
    if (robot.tree.coupling_of(j) == nullptr && robot.tree.joints[static_cast<std::size_t>(j)].is_first())
      written.push_back(robot.tree.joints[static_cast<std::size_t>(j)].declared_name());
  for (const int j : robot.tree.coordinates())
    if (robot.tree.joints[static_cast<std::size_t>(j)].is_first())
      declared.push_back(robot.tree.joints[static_cast<std::size_t>(j)].declared_name());
  if (written == declared) return;
  constexpr std::size_t kMaxNames = 8;
  const bool lists_names = written.size() <= kMaxNames;
  const std::string name = file.filename().string();
  Diagnostic& note = diagnostics.note(
      "joint-order", robot.tree.joints.front().place,
      fmt::format(
          "the robot document declares parents before their children, which changes the order of q{} {}",
          lists_names ? " to" : ":",
          lists_names ? fmt::format("{}", fmt::join(written, ", ")) : moved_names(declared, written)));
  note.hint = lists_names ? fmt::format("code generated from {} has the order {}", name, fmt::join(declared, ", "))
                          : fmt::format("code generated from {} has its order", name);
}

// Impossible mass properties are warnings in a robot document, but errors in a URDF.
void mention_implausible(const std::string& text, const fs::path& file, Diagnostics& diagnostics) {
  Diagnostics again;
  import::urdf(std::make_shared<Source>("", text), {}, again);
  for (const Diagnostic& d : again.all()) {
    if (d.severity != Severity::error || (d.code != "inertia-not-positive" && d.code != "negative-mass")) continue;
    diagnostics
        .warning(
            "implausible-urdf", {std::make_shared<Source>(file.string(), ""), {}},
            "readers will refuse the URDF: it has the same impossible mass properties")
        .hint = "correct them in this document, or read the URDF with --allow-implausible";
    return;
  }
}

std::string robot_document(const ConvertOptions& options, const Robot& robot) {
  language::kinematics::Document document = exporting::with_elastic_joints(
      robot.tree, exporting::numbered_parents_first(robot.tree, exporting::kinematics_document(robot.tree)));
  document.comments = origin(options);
  return language::kinematics::print(document);
}

std::string motion_document(const ConvertOptions& options, const model::RigidMotions& motions) {
  language::motion::Document document = exporting::motion_document(motions);
  document.header.comments = origin(options);
  return language::motion::print(document);
}

std::string transforms_document(
    const ConvertOptions& options,
    const model::RigidMotions& motions,
    const std::vector<model::FrameNames>& pairs) {
  const auto position = options.position == "left" ? model::MovedFramePosition::left : model::MovedFramePosition::right;
  language::transforms::Document document =
      exporting::transforms_document(model::transforms_of(motions, pairs, position));
  document.header.comments = origin(options);
  return language::transforms::print(document);
}

driver::LoadOptions load_options(const ConvertOptions& options) {
  driver::LoadOptions result;
  if (!options.desired.empty()) result.desired = options.desired;
  result.strict = options.strict;
  result.urdf = options.format.urdf;
  result.robot = options.format.robot;
  result.changes = options.format.changes;
  result.import_folders = options.import_folders;
  return result;
}

std::string text_of_robot(const ConvertOptions& options, const driver::Model& model, Diagnostics& diagnostics) {
  const Robot& robot = *model.robot();
  switch (language_to_write(options.to)) {
    case Language::robot:
      mention_passive_forces(robot, diagnostics);
      mention_order(model.file, robot, diagnostics);
      return robot_document(options, robot);
    case Language::urdf: {
      require_values(model, robot);
      require_hinges(model, robot);
      require_couplings(model, robot);
      require_urdf_types(model, robot);
      mention_urdf_plus(robot, diagnostics);
      mention_lost_drives(robot, diagnostics);
      mention_lost_actuators(robot, diagnostics);
      mention_lost_tendons(robot, diagnostics);
      std::string text = exporting::urdf(exporting::with_rigid_joints(robot.tree));
      mention_implausible(text, model.file, diagnostics);
      return text;
    }
    case Language::motions:
      require_no_loops(model, robot, "documents of motions have no loops");
      refuse_spherical_joints(robot.tree, "documents of motions have no spherical joints");
      return motion_document(options, model::motions_over_coordinates(robot.tree));
    default:
      break;
  }
  require_no_loops(model, robot, "documents of transforms have no loops");
  refuse_spherical_joints(robot.tree, "documents of transforms have no spherical joints");
  std::vector<model::FrameNames> pairs;
  for (const model::FramePair& pair : robot.desired.transforms) pairs.emplace_back(pair.left.name, pair.right.name);
  return transforms_document(options, model::motions_over_coordinates(robot.tree), pairs);
}

// The text to write, and the files that were read for it.
struct Converted {
  std::string text;
  std::vector<fs::path> read;
};

std::optional<Converted> convert_robot(const ConvertOptions& options, Diagnostics& diagnostics) {
  const std::optional<driver::Model> model = driver::load(options.from, load_options(options), diagnostics);
  if (!model) return std::nullopt;
  return Converted{text_of_robot(options, *model, diagnostics), model->read};
}

std::optional<Converted> convert_motions(const ConvertOptions& options, Diagnostics& diagnostics) {
  const std::optional<model::RigidMotions> motions = driver::load_motions_of(options.from, diagnostics);
  if (!motions) return std::nullopt;
  const auto pairs = driver::load_pairs(*motions, load_options(options), diagnostics);
  if (options.strict) driver::promote_strict_warnings(diagnostics);
  if (!pairs || diagnostics.has_errors()) return std::nullopt;
  std::vector<fs::path> read = {options.from};
  if (!options.desired.empty()) read.emplace_back(options.desired);
  return Converted{transforms_document(options, *motions, *pairs), std::move(read)};
}

}  // namespace

Status convert(const ConvertOptions& options) {
  require_conversion(options);
  report_missing_folders(options.import_folders, options.messages);
  Diagnostics diagnostics;
  const std::optional<Converted> converted = is_robot(driver::language_of(options.from))
                                                 ? convert_robot(options, diagnostics)
                                                 : convert_motions(options, diagnostics);
  report(diagnostics.render(options.messages));
  if (!converted) return wrong_input;
  write_file(options.to, converted->text, converted->read);
  return ok;
}

}  // namespace robcogen::command
