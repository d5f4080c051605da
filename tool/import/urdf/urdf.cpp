#include "import/urdf.h"

#include <fmt/format.h>

#include <utility>

#include "import/urdf/describe.h"
#include "import/urdf/mass.h"
#include "import/urdf/shapes.h"
#include "import/xml/frame_names.h"
#include "language/common/content.h"
#include "model/elastic_joints.h"

namespace robcogen::import {

namespace {

using namespace from_urdf;

void note_ignored(const Document& document, Diagnostics& diagnostics) {
  if (document.ignored.empty()) return;
  std::string list;
  for (const auto& [name, count] : document.ignored)
    list += fmt::format("{}{} {}", list.empty() ? "" : ", ", count, name);
  diagnostics.note("ignored-elements", document.name.place, fmt::format("elements that are not read: {}", list));
}

// Other dynamics programs omit damping and friction from inverse dynamics, and many files contain values that were
// tuned for a simulator. Therefore they must be requested.
void note_passive_forces(const Document& document, Diagnostics& diagnostics) {
  for (const Joint& joint : document.joints) {
    if (!joint.dynamics || (joint.dynamics->damping.is_zero() && joint.dynamics->friction.is_zero())) continue;
    diagnostics
        .note(
            "passive-forces-not-used", joint.dynamics->place,
            "damping and friction of joints are constants of the robot, and not part of its dynamics")
        .hint = "--passive-forces (PASSIVE_FORCES in CMake) includes them";
    return;
  }
}

// Unlike damping and friction, armature is always part of the dynamics: it is an inertia.
void note_armature(const Document& document, Diagnostics& diagnostics) {
  std::string list;
  Place first;
  for (const Joint& joint : document.joints) {
    if (!joint.dynamics || joint.dynamics->armature.is_zero()) continue;
    if (list.empty()) first = joint.dynamics->armature_place;
    list += fmt::format("{}'{}'", list.empty() ? "" : ", ", joint.name.text);
  }
  if (!list.empty())
    diagnostics.note(
        "armature-included", first, fmt::format("the armature of these joints is part of the dynamics: {}", list));
}

// Drops the hints on inertias, which apply to documents with moments about the origin of a frame. In a URDF, moments
// are about the centre of mass.
std::optional<model::KinematicTree> build_tree(
    const model::Description& description,
    const model::Changes& changes,
    Diagnostics& diagnostics) {
  Diagnostics of_model;
  auto tree = model::build(description, changes, of_model);
  for (const Diagnostic& d : of_model.all()) {
    Diagnostic& copy = d.severity == Severity::error     ? diagnostics.error(d.code, d.place, d.message)
                       : d.severity == Severity::warning ? diagnostics.warning(d.code, d.place, d.message)
                                                         : diagnostics.note(d.code, d.place, d.message);
    copy.notes = d.notes;
    if (d.code != "triangle-inequality" && d.code != "inertia-not-positive") copy.hint = d.hint;
  }
  return tree;
}

}  // namespace

std::optional<model::KinematicTree> urdf(
    std::shared_ptr<const Source> source,
    const UrdfOptions& options,
    Diagnostics& diagnostics) {
  const std::size_t errors_before = diagnostics.error_count();
  const auto failed = [&] { return diagnostics.error_count() > errors_before; };

  if (language::refuse_foreign(source, diagnostics)) return std::nullopt;
  const std::optional<Element> root = xml::read(source, diagnostics);
  if (!root || !check_expanded(*root, source, diagnostics)) return std::nullopt;
  Document document = read_document(*root, std::move(source), diagnostics);
  read_transmissions(*root, document, diagnostics);
  std::vector<std::filesystem::path> files = read_shapes(*root, options.shapes, document, diagnostics);
  declare_world(document, diagnostics);
  const std::optional<Topology> topology = connect(document, diagnostics);
  const Topology* tree = topology ? &*topology : nullptr;
  check_masses(document, tree, options.floating_base, diagnostics);
  if (!options.allow_implausible) check_inertials(document, tree, options.floating_base, diagnostics);
  const Identifiers identifiers = identifiers_of(document, diagnostics);
  if (topology) check_joints(document, *topology, options.free_mimic_joints, diagnostics);
  if (failed()) return std::nullopt;

  const std::vector<model::JointLimits> limits = read_limits(document, diagnostics);
  if (failed()) return std::nullopt;

  treat_near_multiples(document, options.snap_angles, diagnostics);
  note_ignored(document, diagnostics);
  model::Description description =
      describe(document, *topology, identifiers, limits, options.floating_base, options.free_mimic_joints);
  model::add_motors(description, diagnostics);
  add_loops(document, *topology, identifiers, description, diagnostics);
  if (failed()) return std::nullopt;
  description.uses_passive_forces = options.passive_forces;
  note_armature(document, diagnostics);
  if (options.friction_velocity > 0)
    for (model::DescribedJoint& joint : description.joints)
      if (!joint.drive.friction.is_zero()) joint.drive.friction_velocity = model::Quantity(options.friction_velocity);
  if (!options.passive_forces) note_passive_forces(document, diagnostics);
  rename_hidden_frames(description, diagnostics);
  std::optional<model::KinematicTree> result = build_tree(description, options.changes, diagnostics);
  if (result) result->geometry.files = std::move(files);
  return result;
}

}  // namespace robcogen::import
