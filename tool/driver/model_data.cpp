#include "driver/model_data.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "support/index.h"

namespace robcogen::driver {
namespace {

backend::JointType type_of(model::JointType type) {
  switch (type) {
    case model::JointType::revolute:
      break;
    case model::JointType::prismatic:
      return backend::JointType::prismatic;
    case model::JointType::helical:
      return backend::JointType::helical;
    case model::JointType::spherical:
      return backend::JointType::spherical;
  }
  return backend::JointType::revolute;
}

// Evaluates the constants of the model with the defaults of the parameters.
class Constants {
 public:
  explicit Constants(const model::KinematicTree& tree) : tree_(tree) {
    for (const model::Parameter& p : tree.parameters)
      defaults_.push_back(p.default_value.value_or(std::numeric_limits<double>::quiet_NaN()));
  }

  backend::LinkData of(const model::Link& link) const {
    backend::LinkData data;
    data.name = link.name;
    data.parent_joint = link.parent_joint;
    if (!link.inertia) return data;
    const model::RigidBodyInertia body = model::in_link_frame(*link.inertia);
    data.mass = value(body.mass);
    data.com = values(link.inertia->com);
    if (link.inertia->reference) {
      const std::array<double, 3> moment = values(body.first_moment);
      for (std::size_t i = 0; i < 3; ++i) data.com[i] = data.mass != 0.0 ? moment[i] / data.mass : 0.0;
    }
    data.inertia = {value(body.ixx), value(body.iyy), value(body.izz),
                    value(body.ixy), value(body.ixz), value(body.iyz)};
    return data;
  }

  // A component of a spherical joint connects the links that the whole joint connects.
  backend::JointData of_joint(int index) const {
    const model::Joint& joint = tree_.joints[at(index)];
    const int first_index = tree_.first_component_of(index);
    const model::Joint& first = tree_.joints[at(first_index)];
    const model::Joint& last = tree_.joints[at(joint.spherical.empty() ? index : first_index + 2)];
    return {
        joint.name,
        type_of(joint.type),
        first.parent,
        last.child,
        values(first.placement.translation),
        values(first.placement.rotation),
        {joint.limits.lower, joint.limits.upper, joint.limits.velocity, joint.limits.effort},
        drive_of(joint),
        value(joint.pitch),
        tree_.coupling_of(index) == nullptr ? joint.assembled_position() : 0.0};
  }

  std::optional<backend::DriveData> drive_of(const model::Joint& joint) const {
    const model::Drive& drive = joint.drive;
    if (drive.is_absent()) return std::nullopt;
    backend::DriveData data;
    data.damping = value(drive.damping);
    data.friction = value(drive.friction);
    data.friction_velocity = value(drive.friction_velocity);
    data.armature = value(drive.armature);
    data.stiffness = value(drive.stiffness);
    data.rest = value(drive.rest);
    if (drive.rotor) {
      data.rotor_inertia = value(drive.rotor->inertia);
      data.rotor_ratio = value(drive.rotor->ratio);
      data.rotor_axis = values(model::rotor_axis(joint));
      data.rotor_carrier = drive.rotor->carrier;
    }
    return data;
  }

  backend::CoupledJointData of(const model::Coupling& coupling) const {
    // A joint that follows through a loop has no numbers, because it does not follow by a sum.
    constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
    const bool is_linear = coupling.is_linear();
    backend::CoupledJointData data = {of_joint(coupling.joint), {}, is_linear ? value(coupling.offset) : kNone};
    for (const int j : tree_.coordinates()) {
      const auto term = std::find_if(
          coupling.terms.begin(), coupling.terms.end(), [&](const auto& candidate) { return candidate.joint == j; });
      data.factors.push_back(term == coupling.terms.end() ? 0.0 : is_linear ? value(term->factor) : kNone);
    }
    if (!is_linear && is_assembled_elsewhere(tree_.closures[at(coupling.closure)]))
      data.assembled = value(coupling.offset);
    return data;
  }

  backend::LoopData of(const model::LoopJoint& loop, const std::vector<backend::FrameData>& frames) const {
    return {
        loop.name, std::string(model::kLoopTypes[at(static_cast<int>(loop.type))]),
        index_of(loop.ends[0].frame, frames), index_of(loop.ends[1].frame, frames), value(loop.length)};
  }

  backend::ActuatorData of(const model::Actuator& actuator, const std::vector<backend::FrameData>& frames) const {
    return {actuator.name, index_of(actuator.frames[0], frames), index_of(actuator.frames[1], frames)};
  }

  static int index_of(const std::string& name, const std::vector<backend::FrameData>& frames) {
    const auto found = std::find_if(frames.begin(), frames.end(), [&](const auto& f) { return f.name == name; });
    return static_cast<int>(found - frames.begin());
  }

  backend::FrameData of(const model::Frame& frame) const {
    backend::FrameData data;
    data.name = frame.name;
    data.link = tree_.link_of(frame);
    const auto index = static_cast<std::size_t>(frame.index);
    if (frame.kind == model::Frame::Kind::link) return data;
    const model::Placement& placement =
        frame.kind == model::Frame::Kind::joint ? tree_.joints[index].placement : tree_.user_frames[index].placement;
    data.translation = values(placement.translation);
    data.rotation = values(placement.rotation);
    return data;
  }

 private:
  // Whether the loops are assembled elsewhere than next to where their joints are drawn.
  bool is_assembled_elsewhere(const model::Closure& closure) const {
    return std::any_of(closure.loops.begin(), closure.loops.end(), [&](int index) {
      const model::LoopJoint& loop = tree_.loops[at(index)];
      const auto is_elsewhere = [&](const model::LoopEnd& end) {
        return std::any_of(
            end.joints.begin(), end.joints.end(), [&](int joint) { return tree_.joints[at(joint)].assembled; });
      };
      return loop.takes_other_branch || std::any_of(loop.ends.begin(), loop.ends.end(), is_elsewhere);
    });
  }

  double value(const model::Quantity& q) const { return model::evaluate(q, defaults_); }
  std::array<double, 3> values(const std::array<model::Quantity, 3>& q) const {
    return {value(q[0]), value(q[1]), value(q[2])};
  }

  const model::KinematicTree& tree_;
  std::vector<double> defaults_;
};

std::vector<backend::LimbData> limbs_of(const model::KinematicTree& tree, const backend::Library& library) {
  std::map<std::string, int> uses, frames;
  for (const model::Limb& limb : tree.limbs) ++uses[limb.name];
  for (std::size_t i = 0; i < library.frames.size(); ++i) frames.insert({library.frames[i].name, static_cast<int>(i)});
  std::vector<backend::LimbData> limbs;
  for (const model::Limb& limb : tree.limbs) {
    backend::LimbData data = {limb.name, limb.part, limb.first_link, {}, {}, {}};
    if (uses[limb.name] > 1) data.name += "_" + limb.part;
    for (const auto& [own, index] : limb.links) data.links.push_back({own, index});
    for (const auto& [own, index] : limb.joints)
      if (tree.coupling_of(index) == nullptr) data.joints.push_back({own, tree.coordinate_of(index)});
    for (const auto& [own, index] : limb.frames)
      data.frames.push_back({own, frames.at(tree.user_frames[at(index)].name)});
    limbs.push_back(std::move(data));
  }
  return limbs;
}

}  // namespace

void add_model(const model::KinematicTree& tree, backend::Library& library) {
  const Constants constants(tree);
  for (const model::Link& link : tree.links)
    if (!link.is_repeated) library.links.push_back(constants.of(link));
  for (const int j : tree.coordinates()) library.joints.push_back(constants.of_joint(j));
  if (tree.position_count() != tree.dof()) library.positions = model::position_names(tree);
  const std::vector<int> order = model::independent_joints_first(tree);
  for (const int joint : tree.followers_in_q()) {
    const auto place = std::find(order.begin(), order.end(), joint);
    library.followers.push_back(
        {static_cast<int>(place - order.begin()), model::evaluate(tree.coupling_of(joint)->offset)});
  }
  for (const model::Coupling& coupling : tree.couplings) library.coupled.push_back(constants.of(coupling));
  const std::vector<backend::JointData> joints = library.all_joints();
  // For a spherical joint, this is the first component.
  for (std::size_t k = joints.size(); k-- > 0;) library.links[at(joints[k].child)].parent_joint = static_cast<int>(k);
  for (const model::Frame& frame : tree.frames()) library.frames.push_back(constants.of(frame));
  library.limbs = limbs_of(tree, library);
  for (const model::LoopJoint& loop : tree.loops) library.loops.push_back(constants.of(loop, library.frames));
  for (const model::Actuator& a : tree.actuators) library.actuators.push_back(constants.of(a, library.frames));
  for (const model::Parameter& p : tree.parameters) {
    backend::ParameterData data = {p.name};
    if (p.default_value) data.default_value = *p.default_value;
    data.is_kinematics = model::is_kinematics(p);
    data.is_dynamics = model::is_dynamics(p);
    library.parameters.push_back(std::move(data));
  }
}

}  // namespace robcogen::driver
