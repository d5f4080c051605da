// A robot as an importer reads it: elements that refer to one another by name, not yet checked to form a tree.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "model/kinematic_tree.h"

namespace robcogen::model {

struct DescribedChild {
  std::string link;
  std::string joint;
  Place link_place;
  Place joint_place;
};

struct DescribedFrame {
  std::string name;
  Placement placement;
  Place place;
  bool by_name_only = false;  // as in UserFrame
};

struct DescribedLink {
  std::string name;
  Place place;
  std::optional<int> id;
  Place id_place;
  std::optional<Inertia> inertia;  // `build` fills `reference` from reference_frame
  Place inertia_place;
  Place mass_place;  // of the number
  std::optional<std::string> reference_frame;
  Place reference_place;
  std::vector<DescribedChild> children;
  std::vector<DescribedFrame> frames;
  std::vector<Shape> shapes = {};
  bool is_virtual = false;  // as in Link
};

// Where the document gives the values of a drive and the limits.
struct DrivePlaces {
  Place damping;
  Place friction;
  Place friction_velocity;
  Place armature;
  Place stiffness;
  Place rest;
  Place rotor;
  Place rotor_inertia;
  Place rotor_ratio;
  Place rotor_axis;
  Place rotor_carrier;
  Place position_limits;
  Place velocity_limit;
  Place effort_limit;
};

// The spring and damper between a joint and its motor.
struct DescribedElasticity {
  Quantity stiffness;
  Quantity damping;
  Place place;
  Place stiffness_place = {};
  Place damping_place = {};
};

struct DescribedJoint {
  std::string name;
  Place place;
  JointType type = JointType::revolute;
  Placement placement;
  JointLimits limits = {};
  Drive drive = {};
  DrivePlaces drive_places = {};
  std::optional<std::string> rotor_carrier = {};  // default: the parent of the joint
  Quantity pitch = {};                            // of a helical joint: m/rad
  std::optional<double> assembled = {};           // position in which its loops are assembled
  Place assembled_place = {};
  std::optional<DescribedElasticity> elasticity = {};  // see elastic_joints.h
  std::string motor_of = {};                           // as in Joint
};

// The position of a joint as a sum over other joints, which may follow further joints themselves.
struct DescribedCoupling {
  struct Term {
    std::string joint;
    Quantity factor;
    Place place;
  };
  std::string joint;
  Place place;
  std::vector<Term> terms;
  Quantity offset;
};

struct DescribedLoop {
  std::string name;
  Place place;
  LoopType type = LoopType::point;
  std::array<std::string, 2> frames;
  std::array<Place, 2> frame_places;
  Quantity length = {};  // of LoopType::distance: m
  bool takes_other_branch = false;
};

// Terms of the same joint add up.
struct DescribedTendon {
  std::string name;
  Place place;
  std::vector<DescribedCoupling::Term> terms;
  Quantity stiffness;
  Quantity damping;
  Quantity rest;
  Place stiffness_place = {};
  Place damping_place = {};
};

struct DescribedActuator {
  std::string name;
  Place place;
  std::array<std::string, 2> frames;
  std::array<Place, 2> frame_places;
};

// A joint that is to be an independent coordinate.
struct DescribedIndependent {
  std::string joint;
  Place place;
};

// How the format of the document writes DescribedJoint::assembled: not at all, `assembled = 0.5`, `assembled="0.5"`, or
// as an element of a `key` of MJCF.
enum class AssembledForm { none, item, attribute, key };

// Like Limb, with names instead of indices.
struct DescribedLimb {
  struct Element {
    std::string own;
    std::string name;
  };
  std::string name;
  std::string part;
  std::string first_link;
  std::vector<Element> links, joints, frames;
};

struct Description {
  std::string name;
  Place place;
  bool floating_base = false;
  bool uses_passive_forces = true;
  DescribedLink base;
  std::vector<DescribedLink> links;    // in declaration order
  std::vector<DescribedJoint> joints;  // in declaration order
  std::vector<DescribedCoupling> couplings = {};
  std::vector<DescribedLoop> loops = {};
  std::vector<DescribedIndependent> independents = {};  // empty: they are chosen automatically
  // Joints that do not follow others as long as joints without drives can. Those with a rotor, armature or a limit of
  // effort are among them anyway.
  std::vector<std::string> driven = {};
  std::vector<DescribedTendon> tendons = {};
  std::vector<DescribedActuator> actuators = {};
  std::vector<Parameter> parameters;
  std::vector<DescribedLimb> limbs = {};
  AssembledForm assembled_form = AssembledForm::none;
};

// Link 0 is the base; the other links follow in declaration order.
inline const DescribedLink& described_link(const Description& description, std::size_t index) {
  return index == 0 ? description.base : description.links[index - 1];
}

// Connects the elements and checks them: every link has one parent, there are no islands and no cycles, every name is
// unique, every joint is used once, and reference frames and couplings are valid. Warns about ids, about implausible
// mass properties (with the numbers), and about joints that make the inertia matrix singular for every q. nullopt if an
// error was reported.
std::optional<KinematicTree> build(const Description& description, Diagnostics& diagnostics);

}  // namespace robcogen::model
