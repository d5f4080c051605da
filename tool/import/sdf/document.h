// The mechanical content of an SDF model: frames, links and joints, with the models around them resolved.
#pragma once

#include <array>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "import/body_shape.h"
#include "import/pose.h"
#include "import/sdf.h"
#include "import/xml/located.h"
#include "model/description.h"

namespace robcogen::import::from_sdf {

using xml::Name;
using Attribute = xml::LocatedAttribute;
using Element = xml::LocatedElement;

// The frame of the world, and the link index that stands for the world.
constexpr int kWorld = 0;
constexpr int kWorldLink = -1;

// A frame: of a link, a joint, a model, or one that the file declares. Indices are those of Document::frames.
struct Frame {
  Name name;         // with the names of the models around it: `hand::finger`
  Pose pose;         // in the frame `reference`
  int scope = 0;     // the model, or the world, in which the next name is looked up
  Name relative_to;  // names the reference; empty: it is `reference`
  int reference = kWorld;
  int inner_scope = 0;  // in which the next two names are looked up: the model itself for the frame of a model
  Name attached_to;     // names the frame that this one moves with; empty: it is `carrier`
  int carrier = kWorld;
  Name placement;  // of a model: the frame of which `pose` is the pose; empty: the frame of the model
  bool is_of_joint = false;
  bool is_declared = false;  // by an element `frame`: a user frame of the robot
  int link = kWorldLink;     // what the frame is attached to in the end
  int depth = 0;             // number of references up to the world
};

// The names in a model, or in the world, which is scope 0.
struct Scope {
  std::string prefix;  // of names: `hand::`
  int frame = kWorld;  // `__model__`
  int names = 0;       // the scope that has its names: itself, unless the model is merged into the one around it
  std::map<std::string, int> frames;  // of links, declared frames, joints and nested models
  std::map<std::string, int> joints;
  std::map<std::string, int> scopes;  // of nested models
};

// Mass properties about the centre of mass, which is at the origin of the pose, and in the axes of the pose. The values
// are elements of the tensor: ixy = - integral of x y dm.
struct Inertial {
  Pose pose;  // in the frame of the link
  Number mass = Number::rational(1);
  Number ixx = Number::rational(1), iyy = Number::rational(1), izz = Number::rational(1);
  Number ixy, ixz, iyz;
  std::string defaults;  // what the file does not give: `'mass'`, `'mass' and 'inertia'`
  Place mass_place;
  Place inertia_place;
  bool is_automatic = false;  // to be computed from collisions
};

// A shape, which has a frame of its own: its pose may be given in that of another element.
struct FramedShape {
  BodyShape shape;  // its pose is in this frame
  int frame = kWorld;
};

struct Link {
  Name name;
  int frame = kWorld;
  Inertial inertial;
  std::vector<FramedShape> shapes = {};
};

enum class JointType { revolute, continuous, prismatic, fixed, ball, universal, screw };

// q = multiplier * (q_joint - reference) + offset
struct Mimic {
  Name joint;
  bool second_axis = false;  // of that joint
  Number multiplier = Number::rational(1);
  Number offset, reference;
};

struct Axis {
  std::array<Number, 3> xyz = {Number(), Number(), Number::rational(1)};
  Name expressed_in;  // names the frame; empty: it is that of the joint
  int frame = -1;     // of `expressed_in`, or -1
  model::JointLimits limits;
  model::Drive drive;
  model::DrivePlaces places;
  std::optional<Mimic> mimic;
};

struct Joint {
  Name name;
  JointType type = JointType::fixed;
  Place type_place;
  int scope = 0;
  int frame = kWorld;
  Name parent, child;  // frames
  std::vector<Axis> axes;
  model::Quantity pitch;  // of a screw: m/rad
  // Indices of links, after the frames are resolved.
  int parent_link = kWorldLink, child_link = kWorldLink;
};

struct Document {
  Name name;
  bool is_static = false;
  int model = kWorld;  // the frame of the robot's model
  std::vector<Frame> frames;
  std::vector<Scope> scopes;
  std::vector<Link> links;
  std::vector<Joint> joints;
  std::map<std::string, int> ignored;  // number of elements that are not read, by name
};

// The name of the type in the file.
const char* name_of(JointType type);

// The number of coordinates with an axis; a ball joint has three others.
inline std::size_t axis_count(JointType type) {
  return type == JointType::fixed || type == JointType::ball ? 0 : type == JointType::universal ? 2 : 1;
}

}  // namespace robcogen::import::from_sdf
