#include "algorithm/catalogue/groups.h"

#include <algorithm>
#include <array>
#include <iterator>

#include "algorithm/catalogue/sizes.h"

namespace robcogen::algorithm {
namespace {

using model::KinematicTree;

// What a robot must have for a group's functions: a set of these.
enum Needs : unsigned {
  kNothing = 0,
  kInertia = 1 << 0,
  kMass = 1 << 1,            // functions divide by the total mass
  kRegularInertia = 1 << 2,  // functions divide by the joint-space inertia matrix
  kFewPairs = 1 << 4,        // code without loops has a column for each position and velocity
  kFewOperations = 1 << 3,   // code without loops has many right-hand sides
  kFewElements = 1 << 5,     // a matrix has ten columns per link
  kShapes = 1 << 6,          // collision shapes
};

constexpr unsigned kInertiaInverse = kInertia | kRegularInertia;

struct Group {
  const char* name;
  bool is_default;
  unsigned needs;  // of Needs
};

constexpr Group kGroups[] = {
#define ROBCOGEN_GROUP(name, is_default, needs, functions) {#name, is_default, needs},
#include "algorithm/catalogue/groups.inc"
#undef ROBCOGEN_GROUP
};

const Group* group_of(const std::string& name) {
  const auto found =
      std::find_if(std::begin(kGroups), std::end(kGroups), [&](const Group& group) { return group.name == name; });
  return found == std::end(kGroups) ? nullptr : found;
}

// The program without a loop, which `eval` runs, would take too long to build.
bool has_many_operations(const KinematicTree& tree) {
  constexpr long kMany = 600'000;
  return operations_of_solutions(tree) > kMany;
}

// Second derivatives take about a hundred operations for each such pair.
bool has_many_pairs(const KinematicTree& tree) {
  constexpr long kMany = 150;
  return pairs_of_coordinates(tree) > kMany;
}

// Generated functions return their results by value, and larger ones would not fit the stack: 128 KB, which is also
// Eigen's limit.
bool has_many_elements(const KinematicTree& tree) {
  constexpr int kMany = 16'000;
  const int base = tree.floating_base ? 6 : 0, links = tree.link_count() - (base > 0 ? 0 : 1);
  return (base + tree.dof()) * 10 * links > kMany;
}

struct Requirement {
  Needs need;
  bool (*is_met)(const KinematicTree&);
  const char* reason;
  bool is_of_masses = false;  // diagnostics of the mass properties give the reason, too
};

// They are read where this group is asked for by name.
bool has_shapes(const KinematicTree& tree) {
  const std::vector<model::Shape>& shapes = tree.geometry.shapes;
  return std::any_of(shapes.begin(), shapes.end(), [](const model::Shape& shape) {
    return shape.use == model::Shape::Use::collision;
  });
}

constexpr std::array kRequirements = {
    Requirement{kShapes, has_shapes, "it has no collision shapes, which a URDF, MJCF or SDF can have"},
    Requirement{
        kInertia, [](const KinematicTree& tree) { return !tree.inertia_defects.no_inertia; },
        "no link that moves has mass properties", true},
    Requirement{
        kMass, [](const KinematicTree& tree) { return !tree.inertia_defects.no_mass; },
        "the links that move have no mass", true},
    Requirement{
        kRegularInertia, [](const KinematicTree& tree) { return !tree.inertia_defects.is_singular(); },
        "its joint-space inertia matrix is singular", true},
    Requirement{
        kFewPairs, [](const KinematicTree& tree) { return !has_many_pairs(tree); },
        "with so many joints its code without loops would outgrow the caches of processors"},
    Requirement{
        kFewOperations, [](const KinematicTree& tree) { return !has_many_operations(tree); },
        "with so many joints its code would be too long"},
    Requirement{
        kFewElements, [](const KinematicTree& tree) { return !has_many_elements(tree); },
        "with ten columns for each of so many links its matrix would have more than 16,000 elements, too many for the "
        "stacks of threads"}};

bool lacks(const KinematicTree& tree, const Group& group, const Requirement& requirement) {
  return (group.needs & requirement.need) != 0 && !requirement.is_met(tree);
}

template <class Condition>
std::vector<std::string> names_of_groups(Condition condition) {
  std::vector<std::string> names;
  for (const Group& group : kGroups)
    if (condition(group)) names.emplace_back(group.name);
  return names;
}

}  // namespace

const std::vector<std::string>& groups() {
  static const std::vector<std::string> names = names_of_groups([](const Group&) { return true; });
  return names;
}

const std::vector<std::string>& default_groups() {
  static const std::vector<std::string> names = names_of_groups([](const Group& group) { return group.is_default; });
  return names;
}

bool is_available(const KinematicTree& tree, const std::string& group) {
  const Group* found = group_of(group);
  return found && std::none_of(kRequirements.begin(), kRequirements.end(), [&](const Requirement& r) {
           return lacks(tree, *found, r);
         });
}

std::string reason_of_absence(const KinematicTree& tree, const std::string& group, Reasons reasons) {
  const Group* found = group_of(group);
  if (!found) return "";
  const auto lacking = std::find_if(kRequirements.begin(), kRequirements.end(), [&](const Requirement& r) {
    return (reasons == Reasons::all || !r.is_of_masses) && lacks(tree, *found, r);
  });
  return lacking == kRequirements.end() ? "" : lacking->reason;
}

}  // namespace robcogen::algorithm
