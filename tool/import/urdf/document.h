// The mechanics in a URDF as written: elements that refer to one another by name, and exact numbers.
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

// Pose of a frame in the frame that it is given in: x, y, z in metres, then R = Rz(yaw) Ry(pitch) Rx(roll).
struct Origin {
  std::array<Number, 3> xyz;
  std::array<Number, 3> rpy;  // roll, pitch, yaw
  std::array<Place, 3> rpy_places;
};

// About the centre of mass, the origin, and in the axes of the origin. Elements of the tensor: ixy = - integral of x y
// dm.
struct Inertial {
  Origin origin;
  Number mass;
  Number ixx, ixy, ixz, iyy, iyz, izz;
  Place mass_place;     // of the number
  Place inertia_place;  // of the element `inertia`, or of `inertial` when it is missing
};

struct Link {
  Name name;
  std::optional<Inertial> inertial;  // absent also when all of it is zero
};

enum class JointType { revolute, continuous, prismatic, fixed, floating, planar };

// nullopt for an attribute that is missing.
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
  Place place;
};

struct Joint {
  Name name;
  JointType type = JointType::fixed;
  Place type_place;
  Name parent;  // links
  Name child;
  Origin origin;
  std::array<Number, 3> axis = {Number::rational(1), Number(), Number()};
  std::optional<Limit> limit;
  std::optional<Dynamics> dynamics;
  Number armature;  // of the rotors that its transmissions turn
  std::optional<Mimic> mimic;
  std::optional<bool> is_independent;  // as its attribute says
  Place independent_place;
};

// A frame of one end of a loop.
struct LoopEnd {
  Name link;
  Origin origin;
};

// A joint that closes a loop (URDF+: Chignoli et al., arXiv 2411.19753). Its frames meet, with the axis in both.
struct Loop {
  Name name;
  JointType type = JointType::revolute;
  Place type_place;
  std::array<LoopEnd, 2> ends;  // predecessor, successor
  std::array<Number, 3> axis = {Number::rational(1), Number(), Number()};
};

// The sum of the positions of the joints that lead to the successor is `ratio` times that of those to the predecessor,
// both from the last link that both are carried by.
struct Coupling {
  Name name;
  std::array<Name, 2> links;  // predecessor, successor
  Number ratio = Number::rational(1);
};

// With one coordinate.
inline bool is_movable(const Joint& joint) {
  return joint.type == JointType::revolute || joint.type == JointType::continuous || joint.type == JointType::prismatic;
}

inline bool has_axis(const Joint& joint) {
  return is_movable(joint) || joint.type == JointType::planar;
}

struct Document {
  std::shared_ptr<const Source> source;
  Name name;
  std::string version;  // empty when there is none
  std::vector<Link> links;
  std::vector<Joint> joints;
  std::vector<Loop> loops;
  std::vector<Coupling> couplings;
  std::map<std::string, int> ignored;  // elements without mechanical content, by name
};

// Whether xacro has expanded the document. Reports the first instruction of xacro in an element that is read, or warns
// of the first one elsewhere.
bool check_expanded(const Element& root, const std::shared_ptr<const Source>& source, Diagnostics& diagnostics);

// With the loops and couplings of URDF+. Reports what is missing, malformed or given twice. The document is valid only
// when no error was reported.
Document read_document(const Element& root, std::shared_ptr<const Source> source, Diagnostics& diagnostics);

// The type's name in a URDF.
const char* name_of(JointType type);

// Treats roll, pitch and yaw of the origins of joints and inertials that are within 1e-6 of a multiple of PI/12 and not
// exactly zero: with `snap` they become that multiple, with a note on each; otherwise one note counts them.
void treat_near_multiples(Document& document, bool snap, Diagnostics& diagnostics);

// Reads the rotors of Drake's transmissions, `drake:rotor_inertia` and `drake:gear_ratio` of an actuator: their inertia
// behind the gear becomes armature of the joint, with one note.
void read_transmissions(const Element& root, Document& document, Diagnostics& diagnostics);

// Gives the document to urdfdom, the reader that most programs use. Reports its errors, in its words. Returns the
// limits of each joint: infinite when the document has no limit of that kind; a missing `lower` or `upper` in a `limit`
// is zero, as URDF defines it. Empty when an error was reported.
std::vector<model::JointLimits> read_limits(const Document& document, Diagnostics& diagnostics);

}  // namespace robcogen::import::from_urdf
