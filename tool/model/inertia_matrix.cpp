// Finds motions without inertia, for which the joint-space inertia matrix H is singular in every position.
//
// H is singular if a pivot (inertia_pivots.h) is zero. As the determinant of H is analytic in q, H is singular
// everywhere if it is singular at a position without special angles.
//
// A computed zero is zero only up to rounding, and the scale of rounding depends on the units and sizes of the robot.
// Therefore a small inertia is added to every articulated inertia, in proportion to it: a pivot that doubles when this
// addition doubles consists of the addition only.
#include <algorithm>
#include <cmath>
#include <utility>

#include "model/inertia_pivots.h"
#include "model/plausibility.h"
#include "support/index.h"

namespace robcogen::model {

namespace {

// Large compared with the rounding of one recursion step, small compared with any real inertia of a robot.
constexpr double kAddition = 1e-12;

// Tells which pivots are zero, from the pivots with the addition and with twice the addition.
std::vector<bool> zeros(const std::vector<double>& once, const std::vector<double>& twice) {
  std::vector<bool> result(once.size());
  for (std::size_t i = 0; i < once.size(); ++i) {
    // The ratio is 1/2 for a zero and close to 0 for an inertia; the comparison is false after an overflow.
    result[i] = twice[i] - once[i] >= 0.4 * std::abs(twice[i]);
  }
  return result;
}

struct Zeros {
  std::vector<bool> joints;
  std::vector<bool> base;
};

// No programs are generated for larger robots; here, their joints are treated as if they were not coupled.
constexpr std::size_t kMaxCoupled = 2000;

bool is_matrix_needed(const KinematicTree& tree) {
  return !tree.couplings.empty() && tree.joints.size() <= kMaxCoupled;
}

Zeros zero_pivots(const KinematicTree& tree, Beyond beyond) {
  Pivots once = pivots_of(tree, beyond, kAddition);
  Pivots twice = pivots_of(tree, beyond, 2.0 * kAddition);
  if (is_matrix_needed(tree)) {
    // With locked joints, couplings make no difference to the base.
    for (auto [pivots, factor] : {std::pair(&once, 1.0), std::pair(&twice, 2.0)}) {
      Pivots coupled = pivots_of_coordinates(tree, beyond, factor * kAddition);
      if (beyond == Beyond::locked) coupled.base = pivots->base;
      *pivots = std::move(coupled);
    }
  }
  return {zeros(once.joints, twice.joints), zeros(once.base, twice.base)};
}

bool any(const std::vector<bool>& flags) {
  return std::find(flags.begin(), flags.end(), true) != flags.end();
}

bool moves(const KinematicTree& tree, std::size_t link) {
  return link > 0 || tree.floating_base;
}

bool has_inertia(const Link& link) {
  if (!link.inertia) return false;
  const Inertia& i = *link.inertia;
  for (const Quantity* q : {&i.mass, &i.ixx, &i.iyy, &i.izz, &i.ixy, &i.ixz, &i.iyz})
    if (!q->is_constant() || q->number().value() != 0.0) return true;
  return false;
}

bool has_no_mass(const KinematicTree& tree) {
  const std::vector<double> parameters = OrdinaryNumbers().next(tree.parameters.size());
  double sum = 0.0, size = 0.0;
  for (std::size_t i = 0; i < tree.links.size(); ++i) {
    if (!moves(tree, i) || !tree.links[i].inertia) continue;
    const double mass = evaluate(tree.links[i].inertia->mass, parameters);
    sum += mass;
    size += std::abs(mass);
  }
  return std::abs(sum) <= kAddition * size;
}

}  // namespace

InertiaDefects inertia_defects(const KinematicTree& tree) {
  InertiaDefects defects;
  bool some_move = false, some_have = false;
  for (std::size_t i = 0; i < tree.links.size(); ++i) {
    some_move = some_move || moves(tree, i);
    some_have = some_have || (moves(tree, i) && has_inertia(tree.links[i]));
  }
  for (const Joint& joint : tree.joints) some_have = some_have || joint.drive.has_inertia();
  if (!some_move) return defects;
  const Zeros free = zero_pivots(tree, Beyond::free);
  const Zeros locked = zero_pivots(tree, Beyond::locked);
  defects.no_inertia = !some_have;
  defects.no_mass = has_no_mass(tree);
  const std::vector<int> coordinates = tree.coordinates();
  for (std::size_t k = 0; k < free.joints.size(); ++k) {
    if (!free.joints[k]) continue;
    const int joint = is_matrix_needed(tree) ? coordinates[k] : static_cast<int>(k);
    // A spherical joint is listed once, by one of its components.
    const std::string& name = tree.joints[at(joint)].declared_name();
    const auto same = std::find_if(defects.joints.begin(), defects.joints.end(), [&](const auto& known) {
      return tree.joints[at(known.joint)].declared_name() == name;
    });
    if (same == defects.joints.end())
      defects.joints.push_back({joint, locked.joints[k]});
    else
      same->locked = same->locked || locked.joints[k];
  }
  defects.free_base = any(free.base);
  defects.locked_base = any(locked.base);
  return defects;
}

}  // namespace robcogen::model
