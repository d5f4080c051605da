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

// Moments are about the origin of the link frame, or of `reference`. Products have positive sign: ixy is the integral
// of x y dm.
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

// A reflection in the plane through the origin that is normal to an axis.
struct Mirror {
  int axis = 0;  // 0 x, 1 y, 2 z
  // Joints turn in the same sense about their reflected axes: all joints, or those listed.
  bool same_sense = false;
  std::vector<Name> joints;
  Span span;
};

// A part, attached to a link.
struct Instance {
  Name part;
  Name name;  // the prefix of all names in it
  std::vector<Argument> arguments;
  std::optional<Placement> placement;  // in the frame of the link; absent: the identity
  std::optional<Mirror> mirror;
  std::optional<Span> keep;  // `keep base`: the base of a robot remains a separate link
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
  std::vector<Instance> instances;  // attached to the link, after `children`
  std::vector<Frame> frames;
  std::vector<std::string> comments;  // before and within this element, in order, with their delimiters
  Span span;
};

// Forces within a joint. Values that are not given are null.
struct Drive {
  ExpressionPtr damping;            // N m s/rad, N s/m
  ExpressionPtr friction;           // N m, N
  ExpressionPtr friction_velocity;  // only with `friction`; rad/s, m/s
  ExpressionPtr armature;           // kg m^2, kg
  ExpressionPtr stiffness;          // N m/rad, N/m
  ExpressionPtr rest;               // only with `stiffness`; rad, m
};

// The rotor of a motor behind a gear. By default it has the joint axis, and the parent link of the joint as its
// carrier.
struct Rotor {
  ExpressionPtr inertia;  // kg m^2, about its axis
  ExpressionPtr ratio;    // rotor velocity over joint velocity: rad/rad, rad/m
  std::optional<Vector> axis;
  std::optional<Name> carrier;  // a link
  Span span;                    // of the keyword
};

// The spring and damper between a joint and its motor.
struct Elasticity {
  ExpressionPtr stiffness;  // N m/rad, N/m
  ExpressionPtr damping;    // N m s/rad, N s/m; or null
  Span span;                // of the keyword
};

// Limits of a joint, which must be constants. Values that are not given are absent.
struct Limits {
  std::optional<std::array<ExpressionPtr, 2>> position;  // lower and upper; rad, m
  ExpressionPtr velocity;                                // rad/s, m/s
  ExpressionPtr effort;                                  // N m, N
};

// The drive and the limits of a joint, or of one of its coordinates.
struct DriveAndLimits {
  Drive drive;
  std::optional<Rotor> rotor;
  std::optional<Elasticity> elasticity;
  Limits limits;
  ExpressionPtr assembled;  // position in which its loops are assembled: rad, m
};

// The drive and the limits of one coordinate of a joint with several.
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
  std::vector<Coordinate> coordinates;  // those that have a block, in the order of coordinate_words
  std::vector<std::string> comments;
  Span span;
};

// Returns the word that begins a joint of this type.
std::string_view word_of(Joint::Type type);
// Returns the words that begin the blocks of the coordinates; empty for types with one coordinate.
std::span<const std::string_view> coordinate_words(Joint::Type type);

// `joint = value`, linear in other joints. If `instance` is given, the joint belongs to this instance of a part, or to
// each instance in turn if it is the variable of a loop: `leg.knee = 2.0 leg.ankle`.
struct Coupling {
  Name joint;
  ExpressionPtr value;
  std::string instance = {};  // the instance or loop variable, or empty
  int loop = kNoLoop;         // index of the enclosing loop

  static constexpr int kNoLoop = -1;
};

// `for variable in { instances } { … }`, which repeats its body for each instance. The body consists of the adjacent
// couplings that have this loop.
struct Loop {
  Name variable;
  std::vector<Name> instances;
};

// A joint that closes a loop: it connects two frames whose links are already connected by joints.
struct LoopJoint {
  Name name;
  std::array<Name, 2> frames;
  Name type;               // one of kLoopTypes; empty text if there is a distance
  ExpressionPtr distance;  // m; or null
  Name branch;             // one of kLoopBranches; or empty text
};

// A linear actuator between two frames. A positive force pushes them apart.
struct Actuator {
  Name name;
  std::array<Name, 2> frames;
};

// A spring and damper along a length that is a sum of joint positions, as the value of a coupling is. Values that are
// not given are null.
struct Tendon {
  Name name;
  ExpressionPtr length;     // rad or m
  ExpressionPtr stiffness;  // N m/rad, N/m
  ExpressionPtr damping;    // N m s/rad, N s/m
  ExpressionPtr rest;       // rad or m
};

// The words for the types of loops. (Not inline: gcc 12 initialises an inline list at run time, clang at compile time, in
// memory that the program must not write. A program with objects of both would crash.)
const std::initializer_list<std::string_view> kLoopTypes = {"point", "hinge", "slider", "weld"};
// How a loop is assembled: as it is drawn, or on the other branch.
const std::initializer_list<std::string_view> kLoopBranches = {"drawn", "other"};

// The elements of a robot or of a part.
struct Body {
  std::vector<Link> links;                     // the base first, then in declaration order
  std::vector<Joint> joints;                   // in declaration order
  std::vector<Coupling> couplings;             // of all blocks, in order
  std::vector<Loop> loops;                     // of couplings, in order
  std::vector<std::string> coupling_comments;  // before and within these blocks
  std::vector<LoopJoint> loop_joints;          // of all blocks, in order
  std::vector<Name> independents;              // joints that are to be independent
  std::vector<Actuator> actuators;             // of all blocks, in order
  std::vector<Tendon> tendons;                 // of all blocks, in order
  std::vector<std::string> loop_comments;      // before and within the blocks of these four
  std::vector<std::string> trailing_comments;  // before the closing brace, and after that of a robot
};

struct PartParameter {
  Name name;
  ExpressionPtr default_value;  // or null
};

// A limb that is described once. It has no base, and its links need no ids.
struct Part : Body {
  Name name;
  std::vector<PartParameter> parameters;
  std::vector<Child> roots;           // joints that carry the part, and their links
  std::vector<std::string> comments;  // before `Part`
};

// `import "file" as name`: imports the parts of another document, and its robot as a part.
struct Import {
  std::string file;
  std::optional<Name> name;  // for the robot, instead of its own name
  std::vector<std::string> comments;
  Span span;  // of the file name, with its quotes
};

// The elements that an instance of a part has become in a plain document, each with its name in the part.
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
  Name robot;                         // empty text in a document that only has parts
  std::vector<std::string> comments;  // before `Robot`
  std::vector<Limb> limbs = {};       // of a plain document that was expanded from one with parts

  bool has_robot() const { return !robot.text.empty(); }
};

// Parses as far as possible and reports every error. The document is valid only if no error was reported; it can be
// printed in any case.
Document parse(std::shared_ptr<const Source> source, Diagnostics& diagnostics);

// Returns the canonical text. parse(print(d)) equals d, except for places; print(parse(print(d))) == print(d).
std::string print(const Document& document);

// Whether the content is the same; places may differ.
bool equal(const Document& a, const Document& b);

Document without_comments(Document document);

}  // namespace robcogen::language::kinematics
