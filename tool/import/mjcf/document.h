// The mechanics in an MJCF model: a tree of bodies, after defaults are applied.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "import/body_shape.h"
#include "import/mjcf.h"
#include "import/mjcf/defaults.h"
#include "import/mjcf/meshes.h"
#include "import/mjcf/orientation.h"
#include "import/mjcf/settings.h"
#include "model/description.h"

namespace robcogen::import::from_mjcf {

using xml::Name;

// A name in the file, from which `replicate` makes several by suffixes.
struct Written {
  std::string text;
  std::string suffix;
};

// A named point of a body: a user frame of the model.
struct Site {
  Name name;
  Written written;
  Pose pose;  // in the frame of the body
};

// A part of a body that has mass. Its inertia is about its centre of mass, which is the origin of `pose`, and in the
// axes of `pose`.
struct Part {
  Pose pose;  // in the frame of the body
  Number mass;
  Number xx, yy, zz, xy, xz, yz;  // elements of the tensor: xy = - integral of x y dm
  Place mass_place;
  Place inertia_place;
  bool has_given_axes = false;  // the axes of the pose are those of MuJoCo's principal moments
};

// Returns the inertia of a part of the body that has this pose, in the frame of the pose.
model::Inertia inertia_of(const Part& part, const Pose& body);

// Stiffness and damping of a joint by the motion that they make: see resolve_spring_dampers.
struct SpringDamper {
  Number time_constant;  // s
  Number damping_ratio;
  Place place;
};

struct Joint {
  Name name;
  Written written;
  model::JointType type = model::JointType::revolute;
  Pose frame;                 // of the enclosing `frame` elements, in the frame of the body
  std::array<Number, 3> pos;  // in this frame
  std::array<Number, 3> axis;
  Number reference;         // of hinges and slides: the position in which the bodies have the poses of the file
  Number spring_reference;  // of hinges and slides: the position in which MuJoCo measures springs
  model::JointLimits limits;
  model::Drive drive;
  model::DrivePlaces places;
  std::optional<SpringDamper> spring_damper;
  model::Quantity added_damping;  // by actuators
  bool is_pulled = false;         // by an actuator, by one of a tendon, or by the spring of a tendon
  std::vector<double> key;        // its position in the first `key`: a number, or a quaternion; empty if there is none
};

struct PlacedElement {
  Element element;  // including its default attributes
  Pose frame;       // of the enclosing `frame` elements, in the frame of the body
};

// Of a body that floats.
struct FreeJoint {
  Written written;
  Place place;
  std::optional<bool> is_aligned;  // from the attribute `align`
  Place align_place;
};

// `contype` and `conaffinity`: two geoms collide if a bit of the first one of one is in the second one of the other.
struct ContactBits {
  std::uint32_t type = 1, affinity = 1;
};

struct Body {
  Name name;
  Written written;
  bool is_mocap = false;
  int parent = -1;  // body; -1 for the world
  Pose pose;        // in the frame of the parent
  bool moves = false;
  std::optional<FreeJoint> free_joint;
  std::vector<Joint> joints;  // from the parent to the body
  std::optional<Element> inertial;
  std::vector<PlacedElement> geoms;
  std::vector<Part> parts;           // see read_masses
  std::vector<BodyShape> shapes;     // see read_shapes
  std::vector<ContactBits> contact;  // of those that are checked
  std::vector<Site> sites;

  bool floats() const { return free_joint.has_value(); }
};

// y - y0 = a + b (x - x0), where y is the position of the joint, x the position of the joint that it follows, and y0
// and x0 are their reference positions; a is `offset` and b is `factor`.
struct Coupling {
  Name joint;     // as written
  Name followed;  // as written; empty text: no such joint, and y = y0 + a
  Number offset;
  Number factor = Number::rational(1);
};

// A point and axes that a body carries.
struct Anchor {
  std::size_t body = 0;
  Pose pose;      // in the frame of the body
  int site = -1;  // index into the sites of the body; -1 if the document has no name for it
  Place place;
};

// A constraint between two anchors.
struct Loop {
  std::string name;  // as written, or made from the names of its ends
  Place place;
  model::LoopType type = model::LoopType::point;
  std::array<Anchor, 2> ends;
  Number length;  // of a distance
};

struct Tendon {
  // fixed: a sum over joints. straight: between two sites. winding: through more sites, around geoms or over pulleys.
  enum class Kind { fixed, straight, winding };
  struct Term {
    Name joint;
    Number factor;
  };
  Name name;
  Kind kind = Kind::winding;
  std::vector<Term> terms;    // of a fixed tendon
  std::array<Name, 2> sites;  // of a straight one
  bool is_used = false;       // by a coupling, a loop or a cylinder, or for its force
  // Of a fixed tendon: those of its spring and damper.
  Number stiffness, damping;
  std::optional<Number> rest;  // absent: its length where the joints are at their spring references
  Place stiffness_place, damping_place;

  bool has_force() const { return !stiffness.is_zero() || !damping.is_zero(); }
};

// The sum of factor (q - q0) over joints equals the offset, where q0 are their reference positions.
struct TendonCoupling {
  Name tendon;
  std::vector<Tendon::Term> terms;
  Number offset;
};

// A straight tendon that actuators pull.
struct Cylinder {
  Name name;
  std::array<Anchor, 2> ends;
};

// Whether the name refers to this element, or to all of its copies.
template <class Element>
bool is_named(const Element& element, const std::string& name) {
  return !name.empty() && (element.written.text == name || element.name.text == name);
}

// The bodies that are the robot. The base is the floating body, or the world.
struct Robot {
  std::size_t base = 0;
  std::vector<bool> has;  // by body
};

struct Document {
  Name name;
  std::vector<Body> bodies;  // [0] is the world; parents before children, depth first
  Robot robot;
  std::vector<Coupling> couplings;
  std::vector<Tendon> tendons;
  std::vector<TendonCoupling> tendon_couplings;
  std::vector<Loop> loops;
  std::vector<Cylinder> cylinders;
  std::vector<std::array<Name, 2>> excludes;  // pairs of bodies, as written, that are not checked
  bool has_key = false;                       // the joints have the positions of a `key`
  Place key_place;
  std::map<std::string, int> ignored;  // number of elements that are not read, by name
};

// The name of a body, or the one that it gets.
std::string label_of(const Document& document, std::size_t body);

// Reports what is missing or malformed, and what the model cannot represent. Appends files of meshes to `read`.
Document read_document(
    const Element& root,
    const std::filesystem::path& file,
    const MjcfOptions& options,
    std::vector<std::filesystem::path>& read,
    Diagnostics& diagnostics);

// The state that readers of elements share.
struct Context {
  const Settings& settings;
  const Defaults& defaults;
  Diagnostics& diagnostics;
  Meshes& meshes;
};

// Reads a hinge, a slide or a ball joint; `element` includes its default attributes. nullopt for other types, which are
// reported.
std::optional<Joint> read_joint(const Element& element, const Settings& settings, Diagnostics& diagnostics);

// Reads the masses of a body that moves, from its `inertial` or from its geoms. Reports masses that cannot be computed.
std::vector<Part> read_parts(const Body& body, const Context& context);

// Reads the mass of a geom; nullopt for a geom without mass, and for a geom that is reported.
std::optional<Part> read_geom(const Name& body, const PlacedElement& geom, const Context& context);

}  // namespace robcogen::import::from_mjcf
