#include "model/limbs.h"

#include <algorithm>
#include <cmath>
#include <compare>
#include <map>
#include <tuple>
#include <utility>

#include "support/index.h"

namespace robcogen::model {

namespace {

bool is_on_way(const KinematicTree& tree, int joint, int link) {
  for (int l = link; tree.links[at(l)].parent_joint >= 0; l = tree.joints[at(tree.links[at(l)].parent_joint)].parent)
    if (tree.links[at(l)].parent_joint == joint) return true;
  return false;
}

// The joints that move the carrier of the joint's rotor and do not carry the joint.
std::vector<int> joints_of_rotor(const KinematicTree& tree, std::size_t joint) {
  std::vector<int> joints;
  const std::optional<Rotor>& rotor = tree.joints[joint].drive.rotor;
  int carrier = rotor ? tree.links[at(rotor->carrier)].parent_joint : -1;
  for (; carrier >= 0 && !is_on_way(tree, carrier, tree.joints[joint].parent); carrier = tree.parent_joint_of(carrier))
    joints.push_back(carrier);
  return joints;
}

}  // namespace

std::vector<int> limb_joints(const KinematicTree& tree, const std::vector<int>& shapes, int first) {
  std::vector<int> joints, pending = {first};
  while (!pending.empty()) {
    const int joint = pending.back();
    pending.pop_back();
    joints.push_back(joint);
    std::vector<int> children = tree.links[at(tree.joints[at(joint)].child)].child_joints;
    std::stable_sort(children.begin(), children.end(), [&](int a, int b) { return shapes[at(a)] < shapes[at(b)]; });
    pending.insert(pending.end(), children.rbegin(), children.rend());
  }
  return joints;
}

namespace {

// By joint: numbers that encode its ties to other joints. A joint that is tied to another limb has a unique number.
using Ties = std::vector<std::vector<int>>;

void tie_to_nothing_else(Ties& ties, int joint) {
  ties[at(joint)] = {-1 - joint};
}

std::vector<int> shapes_with(const KinematicTree& tree, const Ties& ties, const std::vector<std::size_t>& distance) {
  std::map<std::tuple<JointType, bool, std::vector<bool>, std::vector<int>, std::vector<int>>, int> known;
  std::vector<int> shape(tree.joints.size(), -1);
  const std::vector<int> order = tree.topological();
  for (auto joint = order.rbegin(); joint != order.rend(); ++joint) {
    std::vector<int> beyond;
    for (int child : tree.links[at(tree.joints[at(*joint)].child)].child_joints) beyond.push_back(shape[at(child)]);
    std::sort(beyond.begin(), beyond.end());
    const auto number = static_cast<int>(known.size());
    const Joint& own = tree.joints[at(*joint)];
    std::vector<bool> drive = own.drive.present(tree.uses_passive_forces);
    drive.resize(drive.size() + distance[at(*joint)]);
    shape[at(*joint)] =
        known
            .try_emplace({own.type, own.pitch.is_zero(), std::move(drive), ties[at(*joint)], std::move(beyond)}, number)
            .first->second;
  }
  return shape;
}

// Returns the last joint that carries all of these joints, or is one of them; -1 if only the base carries all of them.
int common_joint(const KinematicTree& tree, const std::vector<int>& joints) {
  for (int root = joints.front(); root >= 0; root = tree.parent_joint_of(root)) {
    const auto carries = [&](int joint) {
      while (joint >= 0 && joint != root) joint = tree.parent_joint_of(joint);
      return joint == root;
    };
    if (std::all_of(joints.begin(), joints.end(), carries)) return root;
  }
  return -1;
}

// Returns the absolute value of a number that the generator can fold (an integer, or a multiple of PI), one marker for
// all other constants, and another for parameters.
double folding_part(const Quantity& q) {
  constexpr double kOther = 0.5;
  if (!q.is_constant()) return -kOther;
  const double size = std::abs(q.number().value());
  return q.number().is_pi_multiple() || size == std::round(size) ? size : kOther;
}

// A coupling or a tendon: what ties joints to each other.
struct Bond {
  bool is_tendon = false;
  std::vector<int> joints;      // of a coupling: the follower, then the joints that it follows
  std::vector<double> numbers;  // offset and factors, or presence and factors, as far as they fold
  bool may_correspond = true;   // to a bond of another limb
};

Bond bond_of(const Coupling& coupling) {
  Bond bond{false, {coupling.joint}, {folding_part(coupling.offset)}, coupling.is_linear()};
  for (const Coupling::Term& term : coupling.terms) {
    bond.joints.push_back(term.joint);
    bond.numbers.push_back(folding_part(term.factor));
  }
  return bond;
}

Bond bond_of(const Tendon& tendon) {
  Bond bond{true, {}, {}};
  for (const Quantity* q : {&tendon.stiffness, &tendon.damping, &tendon.rest}) bond.numbers.push_back(q->is_zero());
  for (const Tendon::Term& term : tendon.terms) {
    bond.joints.push_back(term.joint);
    bond.numbers.push_back(folding_part(term.factor));
  }
  return bond;
}

// Whether this is the spring of an elastic joint. A limb with such a joint has another shape anyway, for its motor.
bool is_elasticity(const KinematicTree& tree, const Tendon& tendon) {
  const auto is_motor_of_other = [&](const Tendon::Term& term) {
    const std::string& joint = tree.joints[at(term.joint)].motor_of;
    return !joint.empty() && std::any_of(tendon.terms.begin(), tendon.terms.end(), [&](const Tendon::Term& other) {
      return tree.joints[at(other.joint)].name == joint;
    });
  };
  return tendon.terms.size() == 2 && std::any_of(tendon.terms.begin(), tendon.terms.end(), is_motor_of_other);
}

std::vector<Bond> bonds_of(const KinematicTree& tree) {
  std::vector<Bond> bonds;
  for (const Coupling& coupling : tree.couplings) bonds.push_back(bond_of(coupling));
  for (const Tendon& tendon : tree.tendons)
    if (!is_elasticity(tree, tendon)) bonds.push_back(bond_of(tendon));
  return bonds;
}

// A bond within a limb, described independently of the limb: the shape of the limb without the bond, and which of its
// joints it ties.
struct Role {
  bool is_tendon = false;
  int shape = 0;
  std::vector<int> places;  // indices in the limb's joints
  std::vector<double> numbers;
  friend auto operator<=>(const Role&, const Role&) = default;
};

Role role_of(const KinematicTree& tree, const Bond& bond, const std::vector<int>& shapes, int root) {
  const std::vector<int> limb = limb_joints(tree, shapes, root);
  Role role{bond.is_tendon, shapes[at(root)], {}, bond.numbers};
  for (const int joint : bond.joints)
    role.places.push_back(static_cast<int>(std::find(limb.begin(), limb.end(), joint) - limb.begin()));
  return role;
}

// Bonds within limbs are equal if they tie corresponding joints in the same way. A bond between limbs makes the shapes
// of its joints unique, as a loop does.
void tie_bound_joints(const KinematicTree& tree, const std::vector<std::size_t>& distance, Ties& ties) {
  const std::vector<Bond> bonds = bonds_of(tree);
  std::vector<int> roots;
  for (const Bond& bond : bonds) {
    roots.push_back(bond.may_correspond ? common_joint(tree, bond.joints) : -1);
    if (roots.back() >= 0) continue;
    for (const int joint : bond.joints) tie_to_nothing_else(ties, joint);
  }
  const std::vector<int> plain = shapes_with(tree, ties, distance);
  std::map<Role, int> known;
  Ties within(tree.joints.size());
  for (std::size_t b = 0; b < roots.size(); ++b) {
    if (roots[b] < 0) continue;
    const Role role = role_of(tree, bonds[b], plain, roots[b]);
    const int number = known.try_emplace(role, static_cast<int>(known.size())).first->second;
    const std::vector<int>& joints = bonds[b].joints;
    for (std::size_t k = 0; k < joints.size(); ++k)
      within[at(joints[k])].push_back(number * static_cast<int>(tree.joints.size()) + static_cast<int>(k));
  }
  for (std::size_t j = 0; j < ties.size(); ++j) {
    std::sort(within[j].begin(), within[j].end());
    ties[j].insert(ties[j].end(), within[j].begin(), within[j].end());
  }
}

}  // namespace

std::vector<int> limb_shapes(const KinematicTree& tree) {
  Ties ties(tree.joints.size());
  // A rotor beyond its joint stays within the limb; a rotor on another branch ties the two branches.
  std::vector<std::size_t> distance(tree.joints.size());  // by joint: number of joints between it and its rotor
  for (std::size_t j = 0; j < tree.joints.size(); ++j) {
    const std::vector<int> joints = joints_of_rotor(tree, j);
    distance[j] = joints.size();
    if (joints.empty() || joints.back() == static_cast<int>(j)) continue;
    tie_to_nothing_else(ties, static_cast<int>(j));
    for (const int joint : joints) tie_to_nothing_else(ties, joint);
  }
  tie_bound_joints(tree, distance, ties);
  return shapes_with(tree, ties, distance);
}

std::vector<int> LimbClass::corresponding(std::size_t k) const {
  std::vector<int> joints;
  for (const std::vector<int>& limb : limbs) joints.push_back(limb[k]);
  return joints;
}

std::vector<LimbClass> limb_classes(const KinematicTree& tree) {
  const std::vector<int> shape = limb_shapes(tree);
  std::vector<LimbClass> classes;
  std::vector<int> links = {0};
  for (std::size_t i = 0; i < links.size(); ++i) {
    const std::vector<int>& children = tree.links[at(links[i])].child_joints;
    std::map<int, int> count, place;  // by shape: number of limbs; index of the class
    for (int joint : children) ++count[shape[at(joint)]];
    for (int joint : children) {
      if (count[shape[at(joint)]] == 1) {
        links.push_back(tree.joints[at(joint)].child);
        continue;
      }
      const auto [known, fresh] = place.try_emplace(shape[at(joint)], static_cast<int>(classes.size()));
      if (fresh) classes.emplace_back();
      classes[at(known->second)].limbs.push_back(limb_joints(tree, shape, joint));
    }
  }
  return classes;
}

std::vector<std::vector<int>> corresponding_joints(const KinematicTree& tree) {
  std::vector<std::vector<int>> groups;
  for (const LimbClass& limbs : limb_classes(tree))
    for (std::size_t k = 0; k < limbs.length(); ++k) groups.push_back(limbs.corresponding(k));
  return groups;
}

}  // namespace robcogen::model
