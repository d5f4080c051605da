// Messages about mass properties that make functions of the dynamics undefined.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <utility>

#include "model/plausibility.h"
#include "support/index.h"

namespace robcogen::model {
namespace {

constexpr const char* kSingular = "singular-inertia";
constexpr const char* kSingularBase = "singular-base-inertia";
constexpr const char* kNoInertia = "no-inertia";
constexpr const char* kNoMass = "no-mass";

constexpr std::size_t kMaxNamed = 8;  // joints

const char* missing_inertia(JointType type) {
  switch (type) {
    case JointType::revolute:
      break;
    case JointType::prismatic:
      return "mass";
    case JointType::helical:
      return "mass or inertia about its axis";
    case JointType::spherical:
      return "inertia about every axis through its centre";
  }
  return "inertia about its axis";
}

std::string reason(const KinematicTree& tree, const InertiaDefects::FreeJoint& free) {
  const Joint& joint = tree.joints[at(free.joint)];
  const char* missing = missing_inertia(joint.type);
  return free.locked
             ? fmt::format("nothing that joint '{}' moves has {}", joint.declared_name(), missing)
             : fmt::format(
                   "joint '{}' has no effective inertia while the joints beyond it are free", joint.declared_name());
}

std::string reason_of_base(const KinematicTree& tree) {
  return fmt::format(
      "floating base '{}' has no effective inertia in some direction while the joints are free", tree.links[0].name);
}

// Returns the subject and verb of a message, as in `joints 'a', 'b' and floating base 'trunk' have`.
std::string subject(const KinematicTree& tree) {
  const InertiaDefects& defects = tree.inertia_defects;
  std::vector<std::string> names;
  for (const InertiaDefects::FreeJoint& free : defects.joints)
    if (names.size() < kMaxNamed) names.push_back(fmt::format("'{}'", tree.joints[at(free.joint)].declared_name()));
  if (defects.joints.size() > kMaxNamed) names.push_back(fmt::format("{} more", defects.joints.size() - kMaxNamed));
  std::string text;
  if (!names.empty()) text = fmt::format("joint{} {}", names.size() > 1 ? "s" : "", fmt::join(names, ", "));
  if (defects.free_base) text += fmt::format("{}floating base '{}'", text.empty() ? "" : " and ", tree.links[0].name);
  const bool is_one = defects.joints.size() + (defects.free_base ? 1 : 0) == 1;
  return text + (is_one ? " has" : " have");
}

void report_singular(const KinematicTree& tree, Diagnostics& diagnostics) {
  const InertiaDefects& defects = tree.inertia_defects;
  std::vector<Note> reasons;
  for (const InertiaDefects::FreeJoint& free : defects.joints)
    reasons.push_back({tree.joints[at(free.joint)].place, reason(tree, free)});
  if (defects.free_base) reasons.push_back({tree.links[0].place, reason_of_base(tree)});
  if (reasons.size() > kMaxNamed) reasons.resize(kMaxNamed);
  Diagnostic& warning = diagnostics.warning(
      kSingular, reasons.front().place,
      fmt::format(
          "{} no effective inertia: the joint-space inertia matrix is singular in every position; forward dynamics{} "
          "and "
          "the factor of the matrix are not available",
          subject(tree), defects.locked_base ? ", inverse dynamics of the free base" : ""));
  warning.notes = std::move(reasons);
}

}  // namespace

void report_inertia_defects(const KinematicTree& tree, Diagnostics& diagnostics) {
  const InertiaDefects& defects = tree.inertia_defects;
  if (defects.no_inertia) {
    diagnostics.note(
        kNoInertia, tree.links[0].place,
        fmt::format(
            "no moving link has mass properties: robot '{}' has transforms, Jacobians, velocities and accelerations, "
            "but no dynamics",
            tree.name));
    return;
  }
  if (defects.is_singular()) {
    report_singular(tree, diagnostics);
  } else if (defects.locked_base) {
    // Masses of opposite signs cancel: no acceleration of the base balances the motion of the joints.
    diagnostics.warning(
        kSingularBase, tree.links[0].place,
        fmt::format(
            "floating base '{}' and the links on it have no inertia in some direction in any position; inverse "
            "dynamics of the free base is not available",
            tree.links[0].name));
  }
  if (defects.no_mass) {
    diagnostics.warning(
        kNoMass, tree.links[0].place,
        "the total mass of the moving links is zero; the centre of mass and the centroidal momentum are not available");
  }
}

const std::vector<std::string>& inertia_defect_codes() {
  static const std::vector<std::string> codes = {kSingular, kSingularBase, kNoInertia, kNoMass};
  return codes;
}

}  // namespace robcogen::model
