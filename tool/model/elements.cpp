#include "model/elements.h"

#include <algorithm>
#include <cstddef>
#include <limits>
#include <map>
#include <utility>

#include "support/index.h"

namespace robcogen::model {
namespace {

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

// Whether the loops are assembled elsewhere than next to where their joints are drawn.
bool is_assembled_elsewhere(const KinematicTree& tree, const Closure& closure) {
  return std::any_of(closure.loops.begin(), closure.loops.end(), [&](int index) {
    const LoopJoint& loop = tree.loops[at(index)];
    const auto is_elsewhere = [&](const LoopEnd& end) {
      return std::any_of(
          end.joints.begin(), end.joints.end(), [&](int joint) { return tree.joints[at(joint)].assembled; });
    };
    return loop.takes_other_branch || std::any_of(loop.ends.begin(), loop.ends.end(), is_elsewhere);
  });
}

}  // namespace

std::vector<std::string> names_of(const KinematicTree& tree, const std::vector<int>& joints) {
  std::vector<std::string> names;
  for (const int j : joints) names.push_back(tree.joints[at(j)].name);
  return names;
}

std::vector<std::string> coupled_names(const KinematicTree& tree) {
  return names_of(tree, dependent_joints(tree));
}

std::vector<std::string> link_names(const KinematicTree& tree) {
  std::vector<std::string> names;
  for (const Link& link : tree.links)
    if (!link.is_repeated) names.push_back(link.name);
  return names;
}

std::vector<std::string> frame_names(const KinematicTree& tree) {
  std::vector<std::string> names;
  for (Frame& frame : tree.frames()) names.push_back(std::move(frame.name));
  return names;
}

std::vector<std::string> names_of(const std::vector<Parameter>& parameters) {
  std::vector<std::string> names;
  for (const Parameter& p : parameters) names.push_back(p.name);
  return names;
}

std::vector<int> dependent_joints(const KinematicTree& tree) {
  std::vector<int> joints;
  for (const Coupling& coupling : tree.couplings) joints.push_back(coupling.joint);
  return joints;
}

int parent_link(const KinematicTree& tree, int joint) {
  return tree.joints[at(tree.first_component_of(joint))].parent;
}

int child_link(const KinematicTree& tree, int joint) {
  const int last = tree.joints[at(joint)].spherical.empty() ? joint : tree.first_component_of(joint) + 2;
  return tree.joints[at(last)].child;
}

const Placement& placement_of_joint(const KinematicTree& tree, int joint) {
  return tree.joints[at(tree.first_component_of(joint))].placement;
}

std::vector<int> carrying_joints(const KinematicTree& tree) {
  std::vector<int> carriers(at(tree.link_count()), -1);
  const std::vector<int> joints = independent_joints_first(tree);
  for (std::size_t k = joints.size(); k-- > 0;) carriers[at(child_link(tree, joints[k]))] = static_cast<int>(k);
  return carriers;
}

int place_of_frame(const KinematicTree& tree, const std::string& name) {
  const std::vector<Frame> frames = tree.frames();
  const auto found = std::find_if(frames.begin(), frames.end(), [&](const Frame& f) { return f.name == name; });
  return static_cast<int>(found - frames.begin());
}

std::vector<int> quaternions(const KinematicTree& tree) {
  const std::vector<int> elements = tree.position_elements();
  std::vector<int> first = tree.spherical_joints();
  for (int& joint : first) joint = elements[at(joint)] - 1;
  return first;
}

bool has_own_positions(const KinematicTree& tree) {
  return tree.position_count() != tree.dof();
}

std::vector<Limb> listed_limbs(const KinematicTree& tree) {
  std::map<std::string, int> uses;
  for (const Limb& limb : tree.limbs) ++uses[limb.name];
  std::vector<Limb> limbs = tree.limbs;
  for (Limb& limb : limbs) {
    if (uses[limb.name] > 1) limb.name += "_" + limb.part;
    std::erase_if(limb.joints, [&](const Limb::Element& e) { return tree.coupling_of(e.index) != nullptr; });
    for (Limb::Element& joint : limb.joints) joint.index = tree.coordinate_of(joint.index);
    for (Limb::Element& frame : limb.frames) frame.index = place_of_frame(tree, tree.user_frames[at(frame.index)].name);
  }
  return limbs;
}

std::vector<std::string> limb_names(const KinematicTree& tree) {
  std::vector<std::string> names;
  for (Limb& limb : listed_limbs(tree)) names.push_back(std::move(limb.name));
  return names;
}

DefaultValues::DefaultValues(const std::vector<Parameter>& parameters) {
  for (const Parameter& p : parameters) values_.push_back(default_of(p));
}

std::array<double, 3> DefaultValues::operator()(const std::array<Quantity, 3>& q) const {
  return {(*this)(q[0]), (*this)(q[1]), (*this)(q[2])};
}

double default_of(const Parameter& parameter) {
  return parameter.default_value.value_or(kNone);
}

MassProperties mass_properties(const Link& link, const DefaultValues& value) {
  if (!link.inertia) return {};
  const RigidBodyInertia body = in_link_frame(*link.inertia);
  MassProperties result = {value(body.mass), value(link.inertia->com), {}};
  if (link.inertia->reference) {
    const std::array<double, 3> moment = value(body.first_moment);
    for (std::size_t i = 0; i < 3; ++i) result.com[i] = result.mass != 0.0 ? moment[i] / result.mass : 0.0;
  }
  result.inertia = {value(body.ixx), value(body.iyy), value(body.izz),
                    value(body.ixy), value(body.ixz), value(body.iyz)};
  return result;
}

std::array<double, 8> drive_numbers(const Joint& joint, const DefaultValues& value) {
  const Drive& d = joint.drive;
  return {
      value(d.damping),
      value(d.friction),
      value(d.friction_velocity),
      value(d.armature),
      value(d.stiffness),
      value(d.rest),
      d.rotor ? value(d.rotor->inertia) : 0.0,
      d.rotor ? value(d.rotor->ratio) : 0.0};
}

std::array<double, 3> rotor_axis(const Joint& joint, const DefaultValues& value) {
  return joint.drive.rotor ? value(rotor_axis(joint)) : std::array<double, 3>{};
}

int rotor_carrier(const Joint& joint) {
  return joint.drive.rotor ? joint.drive.rotor->carrier : -1;
}

double assembled_coordinate(const KinematicTree& tree, int joint) {
  return tree.coupling_of(joint) == nullptr ? tree.joints[at(joint)].assembled_position() : 0.0;
}

CouplingNumbers coupling_numbers(const KinematicTree& tree, const Coupling& coupling, const DefaultValues& value) {
  const bool is_linear = coupling.is_linear();
  CouplingNumbers result = {std::vector<double>(at(tree.dof())), is_linear ? value(coupling.offset) : kNone};
  for (const Coupling::Term& term : coupling.terms)
    result.factors[at(tree.coordinate_of(term.joint))] = is_linear ? value(term.factor) : kNone;
  if (!is_linear && is_assembled_elsewhere(tree, tree.closures[at(coupling.closure)]))
    result.assembled = value(coupling.offset);
  return result;
}

TendonNumbers tendon_numbers(const KinematicTree& tree, const Tendon& tendon, const DefaultValues& value) {
  TendonNumbers result = {{}, value(tendon.stiffness), value(tendon.damping), value(tendon.rest)};
  for (const int joint : independent_joints_first(tree)) {
    const auto term =
        std::find_if(tendon.terms.begin(), tendon.terms.end(), [&](const Tendon::Term& t) { return t.joint == joint; });
    result.factors.push_back(term == tendon.terms.end() ? 0.0 : value(term->factor));
  }
  return result;
}

}  // namespace robcogen::model
