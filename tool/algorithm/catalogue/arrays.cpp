#include "algorithm/catalogue/arrays.h"

#include <algorithm>

#include "algorithm/kinematics/kinematics.h"
#include "algorithm/kinematics/loop_functions.h"
#include "model/loops.h"
#include "support/index.h"

namespace robcogen::algorithm::catalogue {

bool is_floating(const Subject& s) {
  return s.tree.floating_base;
}
bool is_fixed(const Subject& s) {
  return !s.tree.floating_base;
}
bool has_free_base(const Subject& s) {
  return is_floating(s) && !s.tree.inertia_defects.locked_base;
}
bool takes_gravity(const Subject& s) {
  return s.loads != Loads::standard_gravity;
}
bool takes_external(const Subject& s) {
  return s.loads == Loads::gravity_and_external;
}
bool has_loops(const Subject& s) {
  return !s.tree.loops.empty();
}
bool has_spherical_joints(const Subject& s) {
  return !s.tree.spherical_joints().empty();
}
bool is_declared(const model::Coupling& coupling) {
  return coupling.is_linear() && coupling.loop < 0;
}
bool has_declared_couplings(const Subject& s) {
  return std::any_of(s.tree.couplings.begin(), s.tree.couplings.end(), is_declared);
}
bool lacks_inertia_with_cut_loops(const Subject& s) {
  return has_loops(s) && model::with_free_joints(s.tree).inertia_defects.is_singular();
}

int coordinates(const Subject& s) {
  return s.tree.dof();
}
int positions(const Subject& s) {
  return s.tree.position_count();
}
int velocities(const Subject& s) {
  return (s.tree.floating_base ? 6 : 0) + s.tree.dof();
}
int joints(const Subject& s) {
  return static_cast<int>(s.tree.joints.size());
}
int chain(const Subject& s) {
  return static_cast<int>(chain_coordinates(s.tree, s.frames).size());
}
int contact_count(const Subject& s) {
  return static_cast<int>(s.contacts.size());
}
int contact_rows(const Subject& s) {
  int rows = 0;
  for (const model::ContactFrame& contact : s.contacts) rows += contact.is_surface ? 6 : 3;
  return rows;
}
int velocities_and_contact_rows(const Subject& s) {
  return velocities(s) + contact_rows(s);
}
int rows_of_wrenches(const Subject& s) {
  const auto& links = s.tree.links;
  const auto own = std::count_if(links.begin(), links.end(), [](const model::Link& link) { return !link.is_repeated; });
  return 6 * static_cast<int>(own);
}
int actuators(const Subject& s) {
  return static_cast<int>(s.tree.actuators.size());
}

int loop_rows(const Subject& s) {
  int sum = 0;
  for (const model::LoopJoint& loop : s.tree.loops) sum += rows_of(loop.type);
  return sum;
}

// Loops that formulas close in a plane have no moment.
std::vector<int> force_counts(const model::KinematicTree& tree) {
  std::vector<int> counts(tree.loops.size());
  for (const std::vector<model::Closure>* closures : {&tree.parallelograms, &tree.closures})
    for (const model::Closure& closure : *closures)
      for (const int loop : closure.loops) {
        const model::LoopType type = tree.loops[at(loop)].type;
        const bool is_whole = closure.method == model::Closure::Method::iterative && type != model::LoopType::point;
        counts[at(loop)] = type == model::LoopType::distance ? 1 : is_whole ? 6 : 3;
      }
  return counts;
}

}  // namespace robcogen::algorithm::catalogue
