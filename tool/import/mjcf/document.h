// The mechanics in an MJCF model: a tree of bodies, after defaults are applied.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "import/mjcf/defaults.h"
#include "import/mjcf/orientation.h"
#include "import/mjcf/settings.h"
#include "model/description.h"

namespace robcogen::import::from_mjcf {

struct Name {
  std::string text;  // empty if there is none
  Place place;
};

// A named point of a body: a user frame of the model.
struct Site {
  Name name;
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
};

// Returns the inertia of a part of the body that has this pose, in the frame of the pose.
model::Inertia inertia_of(const Part& part, const Pose& body);

struct Joint {
  Name name;
  model::JointType type = model::JointType::revolute;
  Pose frame;                 // of the enclosing `frame` elements, in the frame of the body
  std::array<Number, 3> pos;  // in this frame
  std::array<Number, 3> axis;
  Number reference;  // of hinges and slides: the position in which the bodies have the poses of the file
  model::JointLimits limits;
  model::Drive drive;
  model::DrivePlaces places;
};

struct Body {
  Name name;
  int parent = -1;  // body; -1 for the world
  Pose pose;        // in the frame of the parent
  bool floats = false;
  Place free_joint;           // if the body floats
  std::vector<Joint> joints;  // from the parent to the body
  std::vector<Part> parts;
  std::vector<Site> sites;
};

// y - y0 = a + b (x - x0), where y is the position of the joint, x the position of the joint that it follows, and y0
// and x0 are their reference positions; a is `offset` and b is `factor`.
struct Coupling {
  Name joint;
  Name followed;  // empty text: no such joint, and y = y0 + a
  Number offset;
  Number factor = Number::rational(1);
};

struct Document {
  Name name;
  std::vector<Body> bodies;  // [0] is the world; parents before children, depth first
  std::vector<Coupling> couplings;
  std::map<std::string, int> ignored;  // number of elements that are not read, by name
};

struct Options {
  bool free_equality_joints = false;
};

// Reports what is missing or malformed, and what the model cannot represent.
Document read_document(const Element& root, const Options& options, Diagnostics& diagnostics);

// The state that readers of elements share.
struct Context {
  const Settings& settings;
  const Defaults& defaults;
  Diagnostics& diagnostics;
  const Attribute* childclass = nullptr;
};

// Reads a hinge, a slide or a ball joint; `element` includes its default attributes. nullopt for other types, which are
// reported.
std::optional<Joint> read_joint(const Element& element, const Context& context);

// Reads the masses of a body that moves, from its `inertial` or from its geoms. Reports masses that cannot be computed.
struct PlacedElement {
  Element element;  // including its default attributes
  Pose frame;       // of the enclosing `frame` elements, in the frame of the body
};
std::vector<Part> read_parts(
    const Name& body,
    const Element* inertial,
    const std::vector<PlacedElement>& geoms,
    const Context& context);

// Reads the mass of a geom; nullopt for a geom without mass, and for a geom that is reported.
std::optional<Part> read_geom(const Name& body, const PlacedElement& geom, const Context& context);

}  // namespace robcogen::import::from_mjcf
