// The mechanical content of a URDF as written: elements that refer to one another by name, and exact numbers.
#pragma once

#include <array>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "import/xml/xml.h"
#include "model/kinematic_tree.h"
#include "support/number.h"

namespace robcogen::import::from_urdf {

using xml::Attribute;
using xml::Element;

struct Name {
  std::string text;  // as written
  Place place;
};

// The pose of a frame in its reference frame: x, y, z in metres, then R = Rz(yaw) Ry(pitch) Rx(roll).
struct Origin {
  std::array<Number, 3> xyz;
  std::array<Number, 3> rpy;  // roll, pitch, yaw
  std::array<Place, 3> rpy_places;
};

// Mass properties about the centre of mass, which is at the origin, and in the axes of the origin. The values are
// elements of the tensor: ixy = - integral of x y dm.
struct Inertial {
  Origin origin;
  Number mass;
  Number ixx, ixy, ixz, iyy, iyz, izz;
  bool has_mass = true;
  std::string mass_hint;  // if the mass is missing: what is probably a misspelling of it
  Place mass_place;       // of the number, or of the element that lacks it
  Place inertia_place;    // of the element `inertia`, or of `inertial` if that is missing
};

// A shape without its link and its placement.
struct PlacedShape {
  model::Shape shape;
  Origin origin;
};

struct Link {
  Name name;
  std::optional<Inertial> inertial;      // also absent if all of its values are given and zero
  std::vector<PlacedShape> shapes = {};  // see read_shapes
};

enum class JointType { revolute, continuous, prismatic, fixed, floating, planar };

// nullopt for a missing attribute.
struct Limit {
  std::optional<Number> lower, upper, effort, velocity;
};

// q = multiplier * q_joint + offset, in the units of the joints.
struct Mimic {
  Name joint;
  Number multiplier = Number::rational(1);
  Number offset;
};

// Forces that resist the motion of a joint.
struct Dynamics {
  Number damping;
  Number friction;
  Number armature;
  Place place;
  Place armature_place;  // if it is not zero
};

// The spring and damper between a joint and its motor. URDF does not have this element; other readers ignore it.
struct Elasticity {
  Number stiffness;
  Number damping;
  Place place;
  Place stiffness_place;
  Place damping_place;
};

struct Joint {
  Name name;
  JointType type = JointType::fixed;
  Place type_place;
  Name parent;  // link
  Name child;
  Origin origin;
  std::array<Number, 3> axis = {Number::rational(1), Number(), Number()};
  std::optional<Limit> limit;
  std::optional<Dynamics> dynamics;
  std::optional<Elasticity> elasticity;
  Number armature;  // its own, and from the rotors that its transmissions turn
  std::optional<Mimic> mimic;
  std::optional<bool> is_independent;  // from the attribute
  Place independent_place;
  std::optional<double> assembled;  // from the attribute: a position near which its loops close
  Place assembled_place;
};

// The frame at one end of a loop.
struct LoopEnd {
  Name link;
  Origin origin;
};

// A joint that closes a loop (URDF+: Chignoli et al., arXiv 2411.19753). Its two frames meet, and both contain the
// axis.
struct Loop {
  Name name;
  JointType type = JointType::revolute;
  Place type_place;
  std::array<LoopEnd, 2> ends;  // predecessor, successor
  std::array<Number, 3> axis = {Number::rational(1), Number(), Number()};
};

// The sum of the positions of the joints that lead to the successor is `ratio` times the sum for the predecessor. Both
// chains start at the last link that carries both.
struct Coupling {
  Name name;
  std::array<Name, 2> links;  // predecessor, successor
  Number ratio = Number::rational(1);
};

// Whether the joint has one coordinate.
inline bool is_movable(const Joint& joint) {
  return joint.type == JointType::revolute || joint.type == JointType::continuous || joint.type == JointType::prismatic;
}

inline bool has_axis(const Joint& joint) {
  return is_movable(joint) || joint.type == JointType::planar;
}

struct Document {
  std::shared_ptr<const Source> source;
  Name name;
  std::vector<Link> links;
  std::vector<Joint> joints;
  std::vector<Loop> loops;
  std::vector<Coupling> couplings;
  std::map<std::string, int> ignored;  // number of elements that are not read, by name
};

// Whether xacro has expanded the document. Reports the first xacro instruction in an element that is read, or warns
// about the first one elsewhere.
bool check_expanded(const Element& root, const std::shared_ptr<const Source>& source, Diagnostics& diagnostics);

// Reads a document, including the loops and couplings of URDF+. Reports what is missing, malformed or given twice. The
// document is valid only if no error was reported.
Document read_document(const Element& root, std::shared_ptr<const Source> source, Diagnostics& diagnostics);

// The name of the type in a URDF.
const char* name_of(JointType type);

// Treats roll, pitch and yaw angles of joints and inertials that are within 1e-6 of a multiple of PI/12 and not exactly
// zero. With `snap` they become that multiple, with a note on each; otherwise one note counts them.
void treat_near_multiples(Document& document, bool snap, Diagnostics& diagnostics);

// Returns the inertia (kg m^2) of the rotor of a transmission, in Drake's extension of URDF; nullptr if it has none.
const Attribute* rotor_inertia_of(const Element& transmission);

// Reads the rotors of Drake's transmissions, given by `drake:rotor_inertia` and `drake:gear_ratio` of an actuator.
// Their inertia behind the gear becomes the armature of the joint, with one note. Transmissions without a rotor are
// counted among the elements that are not read.
void read_transmissions(const Element& root, Document& document, Diagnostics& diagnostics);

// Passes the document to urdfdom, the reader that most programs use, and reports its errors in its own words. Returns
// the limits of each joint: infinite if the document has no limit of that kind; a missing `lower` or `upper` in a
// `limit` is zero, as URDF defines it. Empty if an error was reported.
std::vector<model::JointLimits> read_limits(const Document& document, Diagnostics& diagnostics);

}  // namespace robcogen::import::from_urdf
