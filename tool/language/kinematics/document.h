// A Kinematics-DSL document (.kindsl) as written: the syntax tree of a robot description.
#pragma once

#include <array>
#include <initializer_list>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "language/common/expression.h"
#include "support/diagnostics.h"

namespace robcogen::language::kinematics {

struct Name {
  std::string text;
  Span span;
};

using Vector = std::array<ExpressionPtr, 3>;

// A pose: translate, then rotate about the intrinsic axes x, y', z''.
struct Placement {
  Vector translation;  // m
  Vector rotation;     // rad
  Span span;
};

struct Frame {
  Name name;
  Placement placement;
};

// Moments are about the origin of the link frame (or of `reference`). ixy is the integral of x y dm, with positive
// sign.
struct Inertia {
  ExpressionPtr mass;
  Vector com;
  ExpressionPtr ix, iy, iz, ixy, ixz, iyz;
  std::optional<Name> reference;  // a user frame of the same link
  Span span;
};

struct Child {
  Name link;
  Name joint;
};

struct Argument {
  Name name;
  ExpressionPtr value;
};

// The mirror image in a plane through the origin, normal to an axis.
struct Mirror {
  int axis = 0;  // 0 x, 1 y, 2 z
  // Joints turn in the same sense about their reflected axes: all of them, or those listed.
  bool same_sense = false;
  std::vector<Name> joints;
  Span span;
};

// A part, attached to a link.
struct Instance {
  Name part;
  Name name;  // the prefix of all names in it
  std::vector<Argument> arguments;
  std::optional<Placement> placement;  // in the frame of the link; the identity where none is given
  std::optional<Mirror> mirror;
  std::optional<Span> keep;  // `keep base`: the base of a robot remains a link of its own
};

// The base has no `id`; a link has no `floating`.
struct Link {
  Name name;
  bool is_base = false;
  bool floating = false;
  std::optional<int> id;
  Span id_span;
  std::optional<Inertia> inertia;
  std::vector<Child> children;
  std::vector<Instance> instances;  // attached to it, after `children`
  std::vector<Frame> frames;
  std::vector<std::string> comments;  // before this element and in it, in order, with their delimiters
  Span span;
};

// Forces that a joint meets in itself, as far as they are given.
struct Drive {
  ExpressionPtr damping;            // N m s/rad, N s/m
  ExpressionPtr friction;           // N m, N
  ExpressionPtr friction_velocity;  // only with `friction`; rad/s, m/s
  ExpressionPtr armature;           // kg m^2, kg
  ExpressionPtr stiffness;          // N m/rad, N/m
  ExpressionPtr rest;               // only with `stiffness`; rad, m
};

// The rotor of a motor behind a gear. Axis and carrier are those of the joint and its parent link where none is given.
struct Rotor {
  ExpressionPtr inertia;  // kg m^2, about its axis
  ExpressionPtr ratio;    // of its velocity to that of the joint: rad/rad, rad/m
  std::optional<Vector> axis;
  std::optional<Name> carrier;  // a link
  Span span;                    // of the word
};

// As far as they are given: constants.
struct Limits {
  std::optional<std::array<ExpressionPtr, 2>> position;  // lower and upper; rad, m
  ExpressionPtr velocity;                                // rad/s, m/s
  ExpressionPtr effort;                                  // N m, N
};

// What a joint, or one of its coordinates, says of what drives and limits it.
struct DriveAndLimits {
  Drive drive;
  std::optional<Rotor> rotor;
  Limits limits;
  ExpressionPtr assembled;  // its position where the loops that it is part of are assembled: rad, m
};

// What a joint of several coordinates says of one of them.
struct Coordinate : DriveAndLimits {
  Name word;  // `turn`
};

struct Joint : DriveAndLimits {
  enum class Type { revolute, prismatic, helical, cylindrical, universal, planar, spherical };
  Name name;
  Type type = Type::revolute;
  std::optional<int> id;
  Placement placement;
  ExpressionPtr pitch;                  // of a helical joint: m/rad
  std::vector<Coordinate> coordinates;  // those of which something is said, in the order of coordinate_words
  std::vector<std::string> comments;
  Span span;
};

// The word that begins a joint of this type.
std::string_view word_of(Joint::Type type);
// The words that begin what a joint of several coordinates says of them; of other types none.
std::span<const std::string_view> coordinate_words(Joint::Type type);

// `joint = value`, linear in other joints. Where `instance` is given, the joint is that of this instance of a part, or
// of each in turn, where it is the variable of a loop: `leg.knee = 2.0 leg.ankle`.
struct Coupling {
  Name joint;
  ExpressionPtr value;
  std::string instance = {};  // or empty
  int loop = kNoLoop;         // the one that it stands in

  static constexpr int kNoLoop = -1;
};

// `for variable in { instances } { … }`, once for each instance. Couplings that stand one after another with the same
// loop are its body.
struct Loop {
  Name variable;
  std::vector<Name> instances;
};

// Between two frames whose links are connected by joints already: it closes a loop.
struct LoopJoint {
  Name name;
  std::array<Name, 2> frames;
  Name type;               // one of kLoopTypes; without text where there is a distance
  ExpressionPtr distance;  // m; or none
  Name branch;             // one of kLoopBranches; or without text
};

// A linear actuator between two frames, which it pushes apart.
struct Actuator {
  Name name;
  std::array<Name, 2> frames;
};

// The words of types.
inline const std::initializer_list<std::string_view> kLoopTypes = {"point", "hinge", "slider", "weld"};
// How a loop is assembled: as it is drawn, or the other way.
inline const std::initializer_list<std::string_view> kLoopBranches = {"drawn", "other"};

// The elements of a robot or of a part.
struct Body {
  std::vector<Link> links;                     // the base first, then in declaration order
  std::vector<Joint> joints;                   // in declaration order
  std::vector<Coupling> couplings;             // of all blocks, in order
  std::vector<Loop> loops;                     // of couplings, in order
  std::vector<std::string> coupling_comments;  // before these blocks and in them
  std::vector<LoopJoint> loop_joints;          // of all blocks, in order
  std::vector<Name> independents;              // joints that are to be coordinates
  std::vector<Actuator> actuators;             // of all blocks, in order
  std::vector<std::string> loop_comments;      // before the blocks of these three and in them
  std::vector<std::string> trailing_comments;  // before the closing brace, and after that of a robot
};

struct PartParameter {
  Name name;
  ExpressionPtr default_value;  // or none
};

// A limb that is described once: no base, and links without ids.
struct Part : Body {
  Name name;
  std::vector<PartParameter> parameters;
  std::vector<Child> roots;           // joints that carry it, and their links
  std::vector<std::string> comments;  // before `Part`
};

// `import "file" as name`: the parts of another document, and its robot as a part.
struct Import {
  std::string file;
  std::optional<Name> name;  // for the robot, in place of its own
  std::vector<std::string> comments;
  Span span;  // of the file, with its quotes
};

// What an instance of a part has become in a plain document: its elements, each with its name in the part.
struct Limb {
  struct Element {
    std::string own;
    std::string name;
  };
  Name name;
  std::string part;
  std::string first_link;
  std::vector<Element> links, joints, frames;
};

struct Document : Body {
  std::shared_ptr<const Source> source;
  std::vector<Import> imports;
  std::vector<Part> parts;
  Name robot;                         // without text in a document of parts only
  std::vector<std::string> comments;  // before `Robot`
  std::vector<Limb> limbs = {};       // of a plain document that was made from one with parts

  bool has_robot() const { return !robot.text.empty(); }
};

// Reads as far as possible and reports every error. The document is valid only when no error was reported; it can be
// printed in any case.
Document parse(std::shared_ptr<const Source> source, Diagnostics& diagnostics);

// The canonical text. parse(print(d)) equals d, except for places; print(parse(print(d))) == print(d).
std::string print(const Document& document);

// Same content; places may differ.
bool equal(const Document& a, const Document& b);

Document without_comments(Document document);

}  // namespace robcogen::language::kinematics
