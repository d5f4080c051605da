#include "import/urdf/describe.h"

#include <algorithm>
#include <utility>

#include "import/urdf/mass.h"
#include "model/compound.h"
#include "support/index.h"

namespace robcogen::import::from_urdf {

namespace {

// The model frame of a moving link is the frame of its joint, whose z axis is along the joint axis.
Rotation joint_axes(const Joint& joint) {
  return rotation_to_axis(joint.axis);
}

// The pose of the joint frame, about or along whose z axis the joint moves.
model::Placement placement(const Joint& joint, const Carried& parent) {
  return placement_of(parent.pose * pose_of(joint.origin) * Pose{{}, joint_axes(joint)});
}

model::DescribedCompound described_planar(const Joint& joint, const std::string& name, const Carried& parent) {
  model::DescribedCompound result;
  result.name = name;
  result.place = joint.name.place;
  result.type = model::CompoundType::planar;
  result.placement = placement(joint, parent);
  result.coordinates.resize(model::coordinates_of(result.type).size());
  return result;
}

model::DescribedJoint described(
    const Joint& joint,
    const std::string& name,
    const Carried& parent,
    const model::JointLimits& limits) {
  model::DescribedJoint result;
  result.name = name;
  result.place = joint.name.place;
  result.type = joint.type == JointType::prismatic ? model::JointType::prismatic : model::JointType::revolute;
  result.placement = placement(joint, parent);
  result.limits = limits;
  result.assembled = joint.assembled;
  result.assembled_place = joint.assembled_place;
  result.drive.armature = model::Quantity(joint.armature);
  if (joint.dynamics) {
    result.drive.damping = model::Quantity(joint.dynamics->damping);
    result.drive.friction = model::Quantity(joint.dynamics->friction);
  }
  if (const auto& spring = joint.elasticity)
    result.elasticity = model::DescribedElasticity{
        model::Quantity(spring->stiffness), model::Quantity(spring->damping), spring->place, spring->stiffness_place,
        spring->damping_place};
  return result;
}

model::DescribedCoupling coupling(
    const Document& document,
    const Identifiers& identifiers,
    const std::string& joint,
    const Mimic& mimic) {
  const auto followed = std::find_if(
      document.joints.begin(), document.joints.end(), [&](const Joint& j) { return j.name.text == mimic.joint.text; });
  const std::string& name = identifiers.joints[static_cast<std::size_t>(followed - document.joints.begin())];
  const Place& place = mimic.joint.place;
  return {joint, place, {{name, model::Quantity(mimic.multiplier), place}}, model::Quantity(mimic.offset)};
}

}  // namespace

std::vector<Carried> carry(const Document& document, const Topology& topology) {
  std::vector<Carried> carried(document.links.size());
  for (const int link : topology.order) {
    const int j = topology.parent_joint[at(link)];
    if (j < 0 || document.joints[at(j)].type == JointType::floating) {
      carried[at(link)].body = link;
      continue;
    }
    const Joint& joint = document.joints[at(j)];
    const Carried& parent = carried[at(topology.parent[at(j)])];
    if (joint.type == JointType::fixed) {
      carried[at(link)] = {parent.body, parent.pose * pose_of(joint.origin)};
    } else {
      carried[at(link)] = {link, {{}, inverse(joint_axes(joint))}};
    }
  }
  // A root that carries only a floating joint is not part of the robot.
  for (const Joint& joint : document.joints)
    if (joint.type == JointType::floating) carried[at(topology.root)].body = -1;
  return carried;
}

model::Description describe(
    const Document& document,
    const Topology& topology,
    const Identifiers& identifiers,
    const std::vector<model::JointLimits>& limits,
    bool floating_base,
    bool free_mimic_joints) {
  int base = topology.root;
  bool floats = floating_base;
  for (std::size_t j = 0; j < document.joints.size(); ++j) {
    if (document.joints[j].type == JointType::floating) base = topology.child[j], floats = true;
  }
  const std::vector<Carried> carried = carry(document, topology);

  std::vector<model::DescribedLink> bodies(document.links.size());
  std::vector<std::vector<PlacedInertial>> inertials(document.links.size());
  for (std::size_t l = 0; l < document.links.size(); ++l) {
    const Link& link = document.links[l];
    const Carried& own = carried[l];
    if (own.body < 0) continue;
    bodies[at(own.body)].frames.push_back({identifiers.links[l], placement_of(own.pose), link.name.place});
    for (const PlacedShape& placed : link.shapes) {
      model::Shape& shape = bodies[at(own.body)].shapes.emplace_back(placed.shape);
      shape.body = identifiers.links[l];
      shape.placement = placement_of(own.pose * pose_of(placed.origin));
    }
    if (!link.inertial) continue;
    std::vector<PlacedInertial>& parts = inertials[at(own.body)];
    if (parts.empty()) {
      bodies[at(own.body)].inertia_place = link.inertial->inertia_place;
      bodies[at(own.body)].mass_place = link.inertial->mass_place;
    }
    parts.push_back({&*link.inertial, own.pose});
  }

  model::Description description;
  description.name = identifiers.robot;
  description.place = document.name.place;
  description.floating_base = floats;
  description.assembled_form = model::AssembledForm::attribute;
  for (std::size_t j = 0; j < document.joints.size(); ++j) {
    const Joint& joint = document.joints[j];
    if (!has_axis(joint)) continue;
    const Carried& parent = carried[at(topology.parent[j])];
    bodies[at(parent.body)].children.push_back(
        {identifiers.links[at(topology.child[j])], identifiers.joints[j], joint.child.place, joint.name.place});
    if (joint.mimic && !free_mimic_joints)
      description.couplings.push_back(coupling(document, identifiers, identifiers.joints[j], *joint.mimic));
  }
  for (std::size_t l = 0; l < document.links.size(); ++l) {
    const int link = static_cast<int>(l);
    if (carried[l].body != link) continue;
    model::DescribedLink& body = bodies[l];
    body.name = identifiers.links[l];
    body.place = document.links[l].name.place;
    body.inertia = lumped(inertials[l]);
    if (link == base) {
      description.base = std::move(body);
    } else {
      description.links.push_back(std::move(body));
    }
  }
  for (std::size_t j = 0; j < document.joints.size(); ++j) {
    const Joint& joint = document.joints[j];
    const std::string& name = identifiers.joints[j];
    if (!has_axis(joint)) continue;
    const Carried& parent = carried[at(topology.parent[j])];
    Diagnostics constants_alone;  // without parameters there is nothing to report
    if (joint.type == JointType::planar)
      model::add_compound(described_planar(joint, name, parent), description, constants_alone);
    else
      description.joints.push_back(described(joint, name, parent, limits[j]));
  }
  return description;
}

}  // namespace robcogen::import::from_urdf
