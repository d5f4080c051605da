#include "driver/load.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "algorithm/catalogue/catalogue.h"
#include "algorithm/catalogue/fused.h"
#include "algorithm/catalogue/transform_functions.h"
#include "algorithm/kinematics/inverse_kinematics.h"
#include "driver/documents.h"
#include "driver/fused_functions.h"
#include "driver/option_text.h"
#include "driver/parameter_list.h"
#include "export/frames.h"
#include "export/kinematics.h"
#include "import/frame_patterns.h"
#include "import/frames.h"
#include "import/kinematics.h"
#include "import/mjcf.h"
#include "import/names.h"
#include "import/sdf.h"
#include "import/srdf.h"
#include "model/collision.h"
#include "model/plausibility.h"

namespace robcogen::driver {
namespace {

using model::FrameNames;

std::shared_ptr<const Source> source_of(const std::filesystem::path& file, const import::OpenTexts& open_texts) {
  if (const std::shared_ptr<const Source> open = open_texts ? open_texts(file) : nullptr) return open;
  return read_source(file);
}

// ---- Robots.

// The exact joint limits, for the canonical text: a robot document cannot express single or crossed bounds of a
// position.
std::string limits_text(const model::KinematicTree& tree) {
  std::string text;
  for (const model::Joint& joint : tree.joints) {
    const model::JointLimits& l = joint.limits;
    if (l == model::JointLimits() || !joint.is_first()) continue;
    text += fmt::format(
        "{} {} {} {} {}\n", joint.declared_name(), print_double(l.lower), print_double(l.upper),
        print_double(l.velocity), print_double(l.effort));
  }
  return text;
}

// The model of a tree that is not that of a robot document.
Model foreign_model(model::KinematicTree tree, const LoadOptions& options) {
  std::string text;
  if (options.prints_canonical)
    text = language::kinematics::print(exporting::kinematics_document(tree)) + limits_text(tree);
  return {Robot{std::move(tree), {}}, std::move(text)};
}

std::optional<import::RobotDocument> expanded(
    const std::shared_ptr<const Source>& source,
    const LoadOptions& options,
    Diagnostics& diagnostics) {
  return import::robot_document(
      source, {options.import_folders, &exporting::kinematics_document, options.open_texts}, diagnostics);
}

bool require_robot(
    const language::kinematics::Document& document,
    const std::filesystem::path& file,
    const LoadOptions& options,
    Diagnostics& diagnostics) {
  if (document.has_robot()) return true;
  if (!options.may_be_library)
    diagnostics
        .error("no-robot", {document.source, {}}, fmt::format("'{}' has parts only, and no robot", file.string()))
        .hint = "a robot in another document imports them";
  return false;
}

bool asks_for_collisions(const LoadOptions& options) {
  const auto mentioned = [](const std::string& text) { return algorithm::mentions_collisions(text); };
  return std::count(options.groups.begin(), options.groups.end(), algorithm::kCollisionGroup) > 0 ||
         std::any_of(options.functions.begin(), options.functions.end(), mentioned) ||
         std::any_of(options.derivatives.begin(), options.derivatives.end(), [&](const Derivative& derivative) {
           return mentioned(derivative.function);
         });
}

// The collision shapes, exactly, for the canonical text.
std::string collisions_text(const model::KinematicTree& tree) {
  std::string text;
  const std::vector<model::Capsule> capsules = model::capsules(tree);
  for (const model::Capsule& capsule : capsules) {
    text += capsule.name;
    for (const auto& end : capsule.ends)
      for (const double x : end) text += " " + print_double(x);
    text += " " + print_double(capsule.radius) + "\n";
  }
  for (const auto& [i, k] : model::collision_pairs(tree, capsules)) text += fmt::format("{} {}\n", i, k);
  return text;
}

using import::ShapeOptions;

// Those that were asked for, and those of functions of collision shapes.
ShapeOptions shapes_to_read(const LoadOptions& options) {
  ShapeOptions shapes = options.urdf.shapes;
  shapes.folders = options.import_folders;
  if (asks_for_collisions(options)) shapes.collisions = shapes.are_checked = true;
  return shapes;
}

// A model whose text has the shapes that are checked.
Model model_with_shapes(model::KinematicTree tree, const LoadOptions& options, Diagnostics& diagnostics) {
  if (!asks_for_collisions(options)) return foreign_model(std::move(tree), options);
  const std::size_t pairs = model::collision_pairs(tree, model::capsules(tree)).size();
  if (pairs > model::kMaxCollisionPairs)
    diagnostics
        .warning(
            "too-many-pairs", tree.links[0].place,
            fmt::format(
                "self_distance is left out: {} pairs of shapes would be checked, and at most {} can be", pairs,
                model::kMaxCollisionPairs))
        .hint = "exclude pairs that cannot touch, or write fewer shapes";
  const std::string collisions = options.prints_canonical ? collisions_text(tree) : "";
  Model model = foreign_model(std::move(tree), options);
  model.canonical += collisions;
  return model;
}

std::optional<Model> load_urdf(
    const std::shared_ptr<const Source>& source,
    const LoadOptions& options,
    const model::Changes& changes,
    Diagnostics& diagnostics) {
  import::UrdfOptions urdf = options.urdf;
  urdf.changes = changes;
  urdf.shapes = shapes_to_read(options);
  std::optional<model::KinematicTree> tree = import::urdf(source, urdf, diagnostics);
  if (!tree) return std::nullopt;
  std::vector<std::filesystem::path> read = tree->geometry.files;
  if (options.srdf && urdf.shapes.are_checked) {
    if (!import::read_srdf(source_of(*options.srdf, options.open_texts), *tree, diagnostics)) return std::nullopt;
    read.push_back(*options.srdf);
  }
  Model model = model_with_shapes(std::move(*tree), options, diagnostics);
  model.read = std::move(read);
  return model;
}

std::optional<Model> load_tree(
    const std::shared_ptr<const Source>& source,
    const std::filesystem::path& file,
    const LoadOptions& options,
    Diagnostics& diagnostics) {
  const Language language = language_of(file, *source);
  const std::size_t errors_before = diagnostics.error_count();
  const model::Changes changes = read_changes(options.changes, diagnostics);
  if (diagnostics.error_count() > errors_before) return std::nullopt;
  const ShapeOptions shapes = shapes_to_read(options);
  if (language == Language::mjcf) {
    std::optional<import::Mjcf> read =
        import::mjcf(source, file, {options.urdf.free_mimic_joints, options.robot, changes, shapes}, diagnostics);
    if (!read) return std::nullopt;
    Model model = model_with_shapes(std::move(read->tree), options, diagnostics);
    model.read = std::move(read->included);
    return model;
  }
  if (language == Language::sdf) {
    std::optional<import::Sdf> read = import::sdf(
        source, file,
        {options.urdf.snap_angles, options.urdf.free_mimic_joints, options.robot, options.import_folders, changes,
         shapes},
        diagnostics);
    if (!read) return std::nullopt;
    Model model = model_with_shapes(std::move(read->tree), options, diagnostics);
    model.read = std::move(read->included);
    return model;
  }
  if (language == Language::urdf) return load_urdf(source, options, changes, diagnostics);
  std::optional<import::RobotDocument> read = expanded(source, options, diagnostics);
  if (!read || !require_robot(read->document, file, options, diagnostics)) return std::nullopt;
  std::optional<model::KinematicTree> tree = import::kinematic_tree(read->document, changes, diagnostics);
  if (!tree) return std::nullopt;
  Model model = changes.empty() ? Model{Robot{std::move(*tree), {}}} : foreign_model(std::move(*tree), options);
  if (options.prints_canonical && changes.empty())
    model.canonical = language::kinematics::print(language::kinematics::without_comments(std::move(read->document)));
  model.read = std::move(read->imported);
  return model;
}

void report_absence(const model::KinematicTree& tree, const std::string& group, Diagnostics& diagnostics) {
  const std::string reason = algorithm::reason_of_absence(tree, group, algorithm::Reasons::other_than_masses);
  if (reason.empty()) return;
  Diagnostic& error = diagnostics.error(
      "unavailable-group", tree.links[0].place,
      fmt::format("'{}' of robot '{}' is not available: {}", group, tree.name, reason));
  if (group == "forward_dynamics_derivatives" && algorithm::is_available(tree, "inverse_dynamics_derivatives"))
    error.hint =
        "solve for the columns of inverse_dynamics_derivatives with joint_space_inertia_factor: d_q = -H^-1 d tau/d q";
}

std::vector<import::NamedContact> named_contacts(const std::vector<std::string>& words, Diagnostics& diagnostics) {
  const std::vector<Place> places = places_of("--contacts", words);
  std::vector<import::NamedContact> contacts;
  for (std::size_t k = 0; k < words.size(); ++k) {
    const std::size_t colon = words[k].rfind(':');
    const std::string frame = words[k].substr(0, colon),
                      kind = colon == std::string::npos ? "point" : words[k].substr(colon + 1);
    if (kind != "point" && kind != "surface") {
      Place place = places[k];
      place.span.begin += colon;
      Diagnostic& error = diagnostics.error(
          "unknown-contact-kind", place, fmt::format("'{}' is not a kind of contact: point or surface", kind));
      error.hint = did_you_mean(kind, {"point", "surface"});
    }
    contacts.push_back({frame, kind == "surface", places[k]});
  }
  return contacts;
}

// The value of `tolerance=1e-3`; nullopt if it is not a number.
std::optional<double> tolerance_of(const std::string& text) {
  const std::optional<Number> number = Number::parse(text);
  return number ? std::optional(number->value()) : std::nullopt;
}

// `fr_base:fr_tool`, `fr_base:fr_foot:point`, `fr_base:fr_hand:given=J7`, each with `:tolerance=1e-3`
std::vector<import::NamedInverse> named_inverses(const std::vector<std::string>& words, Diagnostics& diagnostics) {
  const std::vector<Place> places = places_of("--inverse-kinematics", words);
  std::vector<import::NamedInverse> inverses;
  for (std::size_t k = 0; k < words.size(); ++k) {
    std::vector<std::string> parts;
    for (std::size_t begin = 0, end = 0; end != std::string::npos; begin = end + 1) {
      end = words[k].find(':', begin);
      parts.push_back(words[k].substr(begin, end == std::string::npos ? end : end - begin));
    }
    import::NamedInverse inverse;
    inverse.place = places[k];
    const std::string given = "given=", tolerance = "tolerance=";
    const bool has_tolerance = parts.size() > 2 && parts.back().starts_with(tolerance);
    if (has_tolerance) {
      inverse.tolerance = tolerance_of(parts.back().substr(tolerance.size()));
      parts.pop_back();
    }
    const std::string task = parts.size() > 2 ? parts[2] : "";
    using Kind = model::InverseTask::Kind;
    const bool is_given = task.starts_with(given) && task.size() > given.size();
    if (parts.size() < 2 || parts.size() > 3 || (has_tolerance && !inverse.tolerance) ||
        (!task.empty() && task != "point" && task != "axis" && task != "swivel" && !is_given)) {
      diagnostics.error("wrong-inverse", places[k], fmt::format("'{}' does not say what to invert", words[k])).hint =
          "write LEFT:RIGHT for the pose of RIGHT in LEFT, or LEFT:RIGHT:point, LEFT:RIGHT:axis, "
          "LEFT:RIGHT:swivel or LEFT:RIGHT:given=JOINT; :tolerance=1e-3 may be behind them";
      continue;
    }
    inverse.left = parts[0];
    inverse.right = parts[1];
    inverse.kind = task == "point" ? Kind::point : task == "axis" ? Kind::axis : Kind::pose;
    inverse.by_swivel = task == "swivel";
    if (is_given) inverse.given = task.substr(given.size());
    inverses.push_back(std::move(inverse));
  }
  return inverses;
}

std::vector<import::FramePattern> frame_patterns(const std::vector<std::string>& words) {
  const std::vector<Place> places = places_of("--frames", words);
  std::vector<import::FramePattern> patterns;
  for (std::size_t k = 0; k < words.size(); ++k) patterns.push_back({words[k], places[k]});
  return patterns;
}

void require_contacts(const Robot& robot, const std::vector<std::string>& groups, Diagnostics& diagnostics) {
  if (!robot.desired.contacts.empty()) return;
  for (const std::string& group : algorithm::groups_of_contacts())
    if (std::find(groups.begin(), groups.end(), group) != groups.end())
      diagnostics
          .error(
              "no-contacts", robot.tree.links[0].place,
              fmt::format("'{}' of robot '{}' needs contact frames", group, robot.tree.name))
          .hint = "name them: --contacts FRAME… (CONTACTS in CMake), or 'Contacts { … }' in the desired transforms";
}

void require_closed_forms(const Robot& robot, const std::vector<std::string>& groups, Diagnostics& diagnostics) {
  const bool is_asked = std::find(groups.begin(), groups.end(), "inverse_kinematics") != groups.end();
  if (is_asked && robot.desired.inverses.empty())
    diagnostics
        .error(
            "no-inverses", robot.tree.links[0].place,
            fmt::format("'inverse_kinematics' of robot '{}' needs pairs of frames", robot.tree.name))
        .hint =
        "name them: --inverse-kinematics LEFT:RIGHT… (INVERSE_KINEMATICS in CMake), or 'InverseKinematics { … }' "
        "in the desired transforms";
  check_closed_forms(robot, diagnostics);
}

// The transforms and contacts to generate, for a robot that has all groups that were asked for. All functions of frames
// follow from these pairs, so that options limit the frames here and nowhere else.
model::DesiredTransforms desired_of(
    const model::KinematicTree& tree,
    const LoadOptions& options,
    Diagnostics& diagnostics) {
  model::DesiredTransforms result = model::default_desired(tree);
  if (options.desired) {
    const language::desired::Document list =
        language::desired::parse(source_of(*options.desired, options.open_texts), diagnostics);
    if (diagnostics.has_errors()) return result;
    result = import::desired_transforms(list, tree, diagnostics);
    if (!options.frames.empty())
      result = import::limited_by_patterns(result, frame_patterns(options.frames), tree, diagnostics);
  } else if (!options.frames.empty()) {
    result = import::desired_by_patterns(frame_patterns(options.frames), tree, diagnostics);
  }
  if (!options.contacts.empty())
    result.contacts = import::contact_frames(named_contacts(options.contacts, diagnostics), tree, diagnostics);
  if (!options.inverses.empty())
    result.inverses = import::inverse_targets(named_inverses(options.inverses, diagnostics), tree, diagnostics);
  for (model::FusedFunction& f : functions_of_option("--function", options.functions, diagnostics))
    result.functions.push_back(std::move(f));
  if (!diagnostics.has_errors()) check_functions(tree, result, diagnostics);
  return result;
}

void require_functions(const Robot& robot, const std::vector<std::string>& groups, Diagnostics& diagnostics) {
  const bool is_asked = std::find(groups.begin(), groups.end(), algorithm::kFusedGroup) != groups.end();
  if (!is_asked || !robot.desired.functions.empty()) return;
  diagnostics
      .error(
          "no-functions", robot.tree.links[0].place,
          fmt::format("'{}' of robot '{}' needs functions to fuse", algorithm::kFusedGroup, robot.tree.name))
      .hint =
      "define them: --function 'NAME = FUNCTION + FUNCTION' (FUNCTIONS in CMake), or 'Functions { … }' in the "
      "desired transforms";
}

// Adds a note for each group that `all` leaves out.
void list_absent_groups(const Robot& robot, Diagnostics& diagnostics) {
  const std::vector<std::string>& of_contacts = algorithm::groups_of_contacts();
  for (const std::string& group : algorithm::groups()) {
    if (group == algorithm::kCollisionGroup) continue;  // `all` does not ask for it
    std::string reason = algorithm::reason_of_absence(robot.tree, group, algorithm::Reasons::all);
    const bool needs_contacts = std::find(of_contacts.begin(), of_contacts.end(), group) != of_contacts.end();
    if (reason.empty() && needs_contacts && robot.desired.contacts.empty()) reason = "no contact frames are named";
    if (group == algorithm::kFusedGroup && robot.desired.functions.empty()) reason = "no functions to fuse are named";
    if (group == "inverse_kinematics" && robot.desired.inverses.empty()) reason = "no pairs of frames are named";
    if (reason.empty()) continue;
    diagnostics.note(
        "left-out-group", robot.tree.links[0].place,
        fmt::format("'{}' of robot '{}' is left out: {}", group, robot.tree.name, reason));
  }
}

std::optional<Model> load_robot(
    const std::shared_ptr<const Source>& source,
    const std::filesystem::path& file,
    const LoadOptions& options,
    Diagnostics& diagnostics) {
  std::optional<Model> model = load_tree(source, file, options, diagnostics);
  if (!model) return std::nullopt;
  if (options.strict) promote_strict_warnings(diagnostics);
  auto& robot = std::get<Robot>(model->content);
  const model::KinematicTree& tree = robot.tree;
  const auto is_missing = [&](const std::string& group) { return !algorithm::is_available(tree, group); };
  if (std::any_of(options.groups.begin(), options.groups.end(), is_missing)) {
    diagnostics.promote_warnings(model::inertia_defect_codes());
    for (const std::string& group : options.groups) report_absence(tree, group, diagnostics);
    return std::nullopt;
  }
  if (diagnostics.has_errors()) return std::nullopt;
  if (options.lists_parameters) list_parameters(tree.parameters, diagnostics);
  robot.desired = desired_of(tree, options, diagnostics);
  if (diagnostics.has_errors()) return std::nullopt;
  require_contacts(robot, options.groups, diagnostics);
  require_functions(robot, options.groups, diagnostics);
  require_closed_forms(robot, options.groups, diagnostics);
  if (options.lists_absent_groups) list_absent_groups(robot, diagnostics);
  return model;
}

// ---- Coordinate transforms without a robot.

// The pairs of frames that the list asks for; nullopt if an error was reported.
std::optional<std::vector<FrameNames>> desired_pairs(
    const LoadOptions& options,
    const model::RigidMotions& motions,
    Diagnostics& diagnostics) {
  const language::desired::Document list =
      language::desired::parse(source_of(*options.desired, options.open_texts), diagnostics);
  if (diagnostics.has_errors()) return std::nullopt;
  std::vector<FrameNames> pairs = import::desired_frame_pairs(list, motions, diagnostics);
  if (options.strict) promote_strict_warnings(diagnostics);
  if (diagnostics.has_errors()) return std::nullopt;
  return pairs;
}

std::optional<model::RigidMotions> read_motions(const std::shared_ptr<const Source>& source, Diagnostics& diagnostics) {
  const language::motion::Document document = language::motion::parse(source, diagnostics);
  return diagnostics.has_errors() ? std::nullopt : import::rigid_motions(document, diagnostics);
}

std::optional<model::CoordinateTransforms> read_transforms(
    const std::shared_ptr<const Source>& source,
    Diagnostics& diagnostics) {
  const language::transforms::Document document = language::transforms::parse(source, diagnostics);
  return diagnostics.has_errors() ? std::nullopt : import::coordinate_transforms(document, diagnostics);
}

std::optional<Model> load_motions(
    const std::shared_ptr<const Source>& source,
    const LoadOptions& options,
    Diagnostics& diagnostics) {
  const std::optional<model::RigidMotions> motions = read_motions(source, diagnostics);
  if (!motions) return std::nullopt;
  const std::optional<std::vector<FrameNames>> pairs = load_pairs(*motions, options, diagnostics);
  if (!pairs) return std::nullopt;
  Model model = {Transforms{model::transforms_of(*motions, *pairs)}};
  if (options.prints_canonical) model.canonical = language::motion::print(exporting::motion_document(*motions));
  return model;
}

std::optional<Model> load_transforms(
    const std::shared_ptr<const Source>& source,
    const LoadOptions& options,
    Diagnostics& diagnostics) {
  std::optional<model::CoordinateTransforms> transforms = read_transforms(source, diagnostics);
  if (!transforms) return std::nullopt;
  const std::string canonical =
      options.prints_canonical ? language::transforms::print(exporting::transforms_document(*transforms)) : "";
  if (!options.desired) return Model{Transforms{std::move(*transforms)}, canonical};
  const auto pairs = desired_pairs(options, model::motions_of(*transforms), diagnostics);
  if (!pairs) return std::nullopt;
  return Model{Transforms{model::chosen(*transforms, *pairs)}, canonical};
}

void refuse_one_name_for_two(const Transforms& transforms, Diagnostics& diagnostics, const Place& place) {
  std::map<std::string, const model::CoordinateTransform*> known;
  for (const model::CoordinateTransform& t : transforms.document.transforms) {
    const auto [earlier, is_new] = known.insert({algorithm::name_of(t), &t});
    if (is_new) continue;
    const model::CoordinateTransform& other = *earlier->second;
    diagnostics
        .error(
            "duplicate-name", place,
            fmt::format(
                "two transforms would be called '{}': from frame '{}' to frame '{}', and from '{}' to '{}'",
                earlier->first, other.right, other.left, t.right, t.left))
        .hint = "give one of them a name: `[name]` after its last factor";
  }
}

std::optional<Model> load_content(
    const std::filesystem::path& file,
    const LoadOptions& options,
    Diagnostics& diagnostics) {
  const std::shared_ptr<const Source> source = source_of(file, options.open_texts);
  const Language language = language_of(file, *source);
  if (is_robot(language) || language == Language::desired) return load_robot(source, file, options, diagnostics);
  std::optional<Model> model = language == Language::motions ? load_motions(source, options, diagnostics)
                                                             : load_transforms(source, options, diagnostics);
  if (!model) return std::nullopt;
  refuse_one_name_for_two(*model->transforms(), diagnostics, {source, {}});
  if (options.strict) promote_strict_warnings(diagnostics);
  if (options.lists_parameters && !diagnostics.has_errors()) list_parameters(model->parameters(), diagnostics);
  return model;
}

}  // namespace

const std::vector<Derivative>& Model::derivatives() const {
  return robot() ? robot()->derivatives : transforms()->derivatives;
}

const std::string& Model::name() const {
  return robot() ? robot()->tree.name : transforms()->document.name;
}

const std::vector<model::Parameter>& Model::parameters() const {
  return robot() ? robot()->tree.parameters : transforms()->document.parameters;
}

std::optional<Model> load(const std::filesystem::path& file, const LoadOptions& options, Diagnostics& diagnostics) {
  std::optional<Model> model = load_content(file, options, diagnostics);
  if (options.strict) promote_strict_warnings(diagnostics);
  if (!model || diagnostics.has_errors()) return std::nullopt;
  std::visit([&](auto& content) { content.derivatives = options.derivatives; }, model->content);
  model->file = file;
  model->read.insert(model->read.begin(), file);
  if (options.desired) model->read.push_back(*options.desired);
  return model;
}

std::optional<import::RobotDocument> load_robot_document(
    const std::filesystem::path& file,
    const LoadOptions& options,
    Diagnostics& diagnostics) {
  return expanded(source_of(file, options.open_texts), options, diagnostics);
}

std::optional<model::RigidMotions> load_motions_of(
    const std::filesystem::path& file,
    Diagnostics& diagnostics,
    const import::OpenTexts& open_texts) {
  const std::shared_ptr<const Source> source = source_of(file, open_texts);
  if (language_of(file, *source) == Language::motions) return read_motions(source, diagnostics);
  const std::optional<model::CoordinateTransforms> transforms = read_transforms(source, diagnostics);
  return transforms ? std::optional(model::motions_of(*transforms)) : std::nullopt;
}

std::optional<std::vector<FrameNames>> load_pairs(
    const model::RigidMotions& motions,
    const LoadOptions& options,
    Diagnostics& diagnostics) {
  return options.desired ? desired_pairs(options, motions, diagnostics) : model::default_transforms(motions);
}

void promote_strict_warnings(Diagnostics& diagnostics) {
  diagnostics.promote_warnings(import::lenient_codes());
  diagnostics.promote_warnings(import::accident_codes());
}

void check_closed_forms(const Robot& robot, Diagnostics& diagnostics) {
  for (const model::InverseTarget& target : robot.desired.inverses) {
    const algorithm::InverseKinematicsReport report =
        algorithm::report_inverse_kinematics(robot.tree, target.frames, target.task);
    if (!report.has_closed_form)
      diagnostics
          .error(
              "no-closed-form", target.place,
              fmt::format(
                  "{}_X_{} has no inverse in closed form: {}", target.frames.left.name, target.frames.right.name,
                  report.reason))
          .hint = report.hint;
  }
}

}  // namespace robcogen::driver
