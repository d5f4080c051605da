// What a URDF says of a robot's mechanics, before it means anything: elements that refer to one another by name, and
// exact numbers.
#pragma once

#include <array>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "import/urdf/xml.h"
#include "model/kinematic_tree.h"
#include "support/number.h"

namespace robcogen::import::from_urdf {

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

// About the centre of mass, which is the origin, in its axes. Elements of the tensor: ixy = - integral of x y dm.
struct Inertial {
  Origin origin;
  Number mass;
  Number ixx, ixy, ixz, iyy, iyz, izz;
  Place place;
};

struct Link {
  Name name;
  std::optional<Inertial> inertial;  // absent, too, when all of it is zero
};

enum class JointType { revolute, continuous, prismatic, fixed, floating, planar };

// The attributes that are there.
struct Limit {
  std::optional<Number> lower, upper, effort, velocity;
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
  std::optional<Name> mimic;  // the joint that this one follows
};

inline bool is_movable(const Joint& joint) {
  return joint.type == JointType::revolute || joint.type == JointType::continuous || joint.type == JointType::prismatic;
}

struct Document {
  std::shared_ptr<const Source> source;
  Name name;
  std::string version;  // empty when there is none
  std::vector<Link> links;
  std::vector<Joint> joints;
  std::map<std::string, int> ignored;  // elements that say nothing of mechanics, by name
};

// Whether xacro has expanded the document. Reports the first of its instructions that are left in what is read here, or
// warns of the first elsewhere.
bool check_expanded(const Element& root, const std::shared_ptr<const Source>& source, Diagnostics& diagnostics);

// Reports what is missing, malformed or given twice. The document is of use only when nothing was.
Document read_document(const Element& root, std::shared_ptr<const Source> source, Diagnostics& diagnostics);

// The type's name in a URDF.
const char* name_of(JointType type);

// Roll, pitch and yaw of the joints' origins, and of those of inertials, that are within 1e-6 of a multiple of PI/12
// but not exactly zero: with `snap` they become that multiple and each is noted, else one note counts them.
void treat_near_multiples(Document& document, bool snap, Diagnostics& diagnostics);

// Gives the document to urdfdom, the reader that most programs have. Reports what it refuses, in its words. Returns the
// limits of each joint: infinite where the document has no limit of that kind; a missing `lower` or `upper` beside
// others is zero, as URDF has it. Nothing when an error was reported.
std::vector<model::JointLimits> read_limits(const Document& document, Diagnostics& diagnostics);

}  // namespace robcogen::import::from_urdf
