#include <algorithm>

#include "language/kinematics/document.h"
#include "language/kinematics/keywords.h"

namespace robcogen::language::kinematics {
namespace {

std::string name(const Name& n) {
  return is_keyword(n.text) ? "^" + n.text : n.text;
}

std::string vector(const Vector& v) {
  return "(" + language::print(*v[0]) + ", " + language::print(*v[1]) + ", " + language::print(*v[2]) + ")";
}

std::string comments(const std::vector<std::string>& list, const std::string& indent) {
  std::string out;
  for (const std::string& comment : list) out += indent + comment + "\n";
  return out;
}

std::string placement(const Placement& p, const std::string& indent) {
  return indent + "translation = " + vector(p.translation) + "\n" + indent + "rotation = " + vector(p.rotation) + "\n";
}

std::string arguments(const std::vector<Argument>& list) {
  std::string out;
  for (const Argument& a : list) out += (out.empty() ? "" : ", ") + name(a.name) + " = " + language::print(*a.value);
  return "(" + out + ")";
}

std::string mirror(const Mirror& m) {
  std::string out = std::string(" mirrored ") + "xyz"[m.axis] + (m.same_sense ? " same sense" : "");
  if (m.joints.empty()) return out;
  out += " {";
  for (const Name& joint : m.joints) out += " " + name(joint);
  return out + " }";
}

std::string instance(const Instance& i) {
  const std::string in = "            ";
  std::string out = in + name(i.part) + " " + name(i.name);
  if (!i.arguments.empty() || !i.placement) out += arguments(i.arguments);
  if (i.placement) out += " at {\n" + placement(*i.placement, in + "    ") + in + "}";
  return out + (i.mirror ? mirror(*i.mirror) : "") + (i.keep ? " keep base" : "") + "\n";
}

std::string inertia(const Inertia& i) {
  const std::string in = "            ";
  std::string out = "        inertia_params {\n";
  out += in + "mass = " + language::print(*i.mass) + "\n";
  out += in + "CoM = " + vector(i.com) + "\n";
  out += in + "Ix = " + language::print(*i.ix) + "  Iy = " + language::print(*i.iy) +
         "  Iz = " + language::print(*i.iz) + "\n";
  out += in + "Ixy = " + language::print(*i.ixy) + "  Ixz = " + language::print(*i.ixz) +
         "  Iyz = " + language::print(*i.iyz) + "\n";
  if (i.reference) out += in + "ref_frame = " + name(*i.reference) + "\n";
  return out + "        }\n";
}

std::string link(const Link& l) {
  std::string out = "\n" + comments(l.comments, "    ");
  out += (l.is_base ? "    RobotBase " : "    link ") + name(l.name) + (l.floating ? " floating" : "") + " {\n";
  if (l.id) out += "        id = " + std::to_string(*l.id) + "\n";
  if (l.inertia) out += inertia(*l.inertia);
  if (l.children.empty() && l.instances.empty()) {
    out += "        children {}\n";
  } else {
    out += "        children {\n";
    for (const Child& child : l.children) out += "            " + name(child.link) + " via " + name(child.joint) + "\n";
    for (const Instance& i : l.instances) out += instance(i);
    out += "        }\n";
  }
  if (!l.frames.empty()) {
    out += "        frames {\n";
    for (const Frame& frame : l.frames)
      out += "            " + name(frame.name) + " {\n" + placement(frame.placement, "                ") +
             "            }\n";
    out += "        }\n";
  }
  return out + "    }\n";
}

// ` word = value`, or nothing.
std::string item(const std::string& word, const ExpressionPtr& value) {
  return value ? " " + word + " = " + language::print(*value) : "";
}

std::string drive(const Drive& d, const std::string& indent) {
  std::string out;
  const auto line = [&](const std::string& clause) {
    if (!clause.empty()) out += indent + clause.substr(1) + "\n";
  };
  line(item("damping", d.damping));
  if (d.friction_velocity)
    line(" friction {" + item("force", d.friction) + item("velocity", d.friction_velocity) + " }");
  else
    line(item("friction", d.friction));
  line(item("armature", d.armature));
  if (d.stiffness) line(" spring {" + item("stiffness", d.stiffness) + item("rest", d.rest) + " }");
  return out;
}

std::string rotor(const std::optional<Rotor>& r, const std::string& indent) {
  if (!r) return "";
  return indent + "rotor {" + item("inertia", r->inertia) + item("ratio", r->ratio) +
         (r->axis ? " axis = " + vector(*r->axis) : "") + (r->carrier ? " carrier = " + name(*r->carrier) : "") +
         " }\n";
}

std::string limits(const Limits& l, const std::string& indent) {
  std::string items;
  if (l.position) {
    const auto& [lower, upper] = *l.position;
    items += " position = (" + language::print(*lower) + ", " + language::print(*upper) + ")";
  }
  items += item("velocity", l.velocity) + item("effort", l.effort);
  return items.empty() ? "" : indent + "limits {" + items + " }\n";
}

// Of a joint, or of one of its coordinates.
template <class Owner>
std::string drive_and_limits(const Owner& owner, const std::string& indent) {
  return drive(owner.drive, indent) + rotor(owner.rotor, indent) + limits(owner.limits, indent);
}

std::string joint(const Joint& j) {
  std::string out = "\n" + comments(j.comments, "    ");
  out += "    " + std::string(word_of(j.type)) + " " + name(j.name) + " {\n";
  if (j.id) out += "        id = " + std::to_string(*j.id) + "\n";
  out += "        ref_frame {\n" + placement(j.placement, "            ") + "        }\n";
  if (j.pitch) out += "       " + item("pitch", j.pitch) + "\n";
  for (const Coordinate& c : j.coordinates)
    out += "        " + c.word.text + " {\n" + drive_and_limits(c, "            ") + "        }\n";
  return out + drive_and_limits(j, "        ") + "    }\n";
}

std::string head(const Loop& loop) {
  std::string instances;
  for (const Name& instance : loop.instances) instances += (instances.empty() ? "" : ", ") + name(instance);
  return "        for " + name(loop.variable) + " in { " + instances + " } {\n";
}

std::string coupling(const Coupling& c) {
  const std::string instance = c.instance.empty() ? "" : name(Name{c.instance, {}}) + ".";
  return instance + name(c.joint) + " = " + language::print(*c.value) + "\n";
}

std::string couplings(const Body& d) {
  if (d.couplings.empty()) return comments(d.coupling_comments, "    ");
  std::string out = "\n" + comments(d.coupling_comments, "    ") + "    couplings {\n";
  int loop = Coupling::kNoLoop;
  for (const Coupling& c : d.couplings) {
    if (c.loop != loop && loop != Coupling::kNoLoop) out += "        }\n";
    if (c.loop != loop && c.loop != Coupling::kNoLoop) out += head(d.loops[static_cast<std::size_t>(c.loop)]);
    loop = c.loop;
    out += (loop == Coupling::kNoLoop ? "        " : "            ") + coupling(c);
  }
  if (loop != Coupling::kNoLoop) out += "        }\n";
  return out + "    }\n";
}

std::string loop(const LoopJoint& l) {
  return "        " + name(l.name) + " { frames = " + name(l.frames[0]) + " ~ " + name(l.frames[1]) +
         (l.distance ? item("distance", l.distance) : " type = " + l.type.text) + " }\n";
}

std::string loops(const Body& b) {
  std::string out = comments(b.loop_comments, "    ");
  if (!b.loop_joints.empty()) {
    out += "    loops {\n";
    for (const LoopJoint& l : b.loop_joints) out += loop(l);
    out += "    }\n";
  }
  if (!b.independents.empty()) {
    out += "    independent { ";
    for (std::size_t k = 0; k < b.independents.size(); ++k) out += (k > 0 ? ", " : "") + name(b.independents[k]);
    out += " }\n";
  }
  return out.empty() ? "" : "\n" + out;
}

bool same(const ExpressionPtr& a, const ExpressionPtr& b) {
  return a && b ? language::equal(*a, *b) : a == b;
}

bool same(const Vector& a, const Vector& b) {
  return std::equal(a.begin(), a.end(), b.begin(), [](const auto& x, const auto& y) { return same(x, y); });
}

bool same(const Placement& a, const Placement& b) {
  return same(a.translation, b.translation) && same(a.rotation, b.rotation);
}

bool same(const Inertia& a, const Inertia& b) {
  return same(a.mass, b.mass) && same(a.com, b.com) && same(a.ix, b.ix) && same(a.iy, b.iy) && same(a.iz, b.iz) &&
         same(a.ixy, b.ixy) && same(a.ixz, b.ixz) && same(a.iyz, b.iyz) &&
         a.reference.has_value() == b.reference.has_value() && (!a.reference || a.reference->text == b.reference->text);
}

bool same(const Child& a, const Child& b) {
  return a.link.text == b.link.text && a.joint.text == b.joint.text;
}

bool same(const Name& a, const Name& b) {
  return a.text == b.text;
}

bool same(const Argument& a, const Argument& b) {
  return same(a.name, b.name) && same(a.value, b.value);
}

bool same(const std::optional<Mirror>& a, const std::optional<Mirror>& b) {
  if (!a || !b) return a.has_value() == b.has_value();
  const auto same_name = [](const Name& x, const Name& y) { return same(x, y); };
  return a->axis == b->axis && a->same_sense == b->same_sense &&
         std::equal(a->joints.begin(), a->joints.end(), b->joints.begin(), b->joints.end(), same_name);
}

bool same(const Frame& a, const Frame& b) {
  return a.name.text == b.name.text && same(a.placement, b.placement);
}

bool same(const Coupling& a, const Coupling& b) {
  return a.joint.text == b.joint.text && same(a.value, b.value) && a.instance == b.instance && a.loop == b.loop;
}

bool same(const LoopJoint& a, const LoopJoint& b) {
  return same(a.name, b.name) && same(a.frames[0], b.frames[0]) && same(a.frames[1], b.frames[1]) &&
         same(a.type, b.type) && same(a.distance, b.distance);
}

bool same(const Loop& a, const Loop& b);

bool same(const Instance& a, const Instance& b);
bool same(const Link& a, const Link& b);
bool same(const Joint& a, const Joint& b);
bool same(const Coordinate& a, const Coordinate& b);
bool same(const PartParameter& a, const PartParameter& b);
bool same(const Part& a, const Part& b);
bool same(const Import& a, const Import& b);

template <class T>
bool all_same(const std::vector<T>& a, const std::vector<T>& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](const T& x, const T& y) { return same(x, y); });
}

bool same(const Loop& a, const Loop& b) {
  return same(a.variable, b.variable) && all_same(a.instances, b.instances);
}

bool same(const Instance& a, const Instance& b) {
  return same(a.part, b.part) && same(a.name, b.name) && all_same(a.arguments, b.arguments) &&
         a.placement.has_value() == b.placement.has_value() && (!a.placement || same(*a.placement, *b.placement)) &&
         same(a.mirror, b.mirror) && a.keep.has_value() == b.keep.has_value();
}

bool same(const Link& a, const Link& b) {
  return a.name.text == b.name.text && a.is_base == b.is_base && a.floating == b.floating && a.id == b.id &&
         a.inertia.has_value() == b.inertia.has_value() && (!a.inertia || same(*a.inertia, *b.inertia)) &&
         all_same(a.children, b.children) && all_same(a.instances, b.instances) && all_same(a.frames, b.frames) &&
         a.comments == b.comments;
}

bool same(const Drive& a, const Drive& b) {
  return same(a.damping, b.damping) && same(a.friction, b.friction) && same(a.friction_velocity, b.friction_velocity) &&
         same(a.armature, b.armature) && same(a.stiffness, b.stiffness) && same(a.rest, b.rest);
}

bool same(const Rotor& a, const Rotor& b) {
  return same(a.inertia, b.inertia) && same(a.ratio, b.ratio) && a.axis.has_value() == b.axis.has_value() &&
         (!a.axis || same(*a.axis, *b.axis)) && a.carrier.has_value() == b.carrier.has_value() &&
         (!a.carrier || a.carrier->text == b.carrier->text);
}

bool same(const Limits& a, const Limits& b) {
  const auto same_bound = [](const ExpressionPtr& x, const ExpressionPtr& y) { return same(x, y); };
  return a.position.has_value() == b.position.has_value() &&
         (!a.position || std::equal(a.position->begin(), a.position->end(), b.position->begin(), same_bound)) &&
         same(a.velocity, b.velocity) && same(a.effort, b.effort);
}

template <class Owner>
bool same_drive_and_limits(const Owner& a, const Owner& b) {
  return same(a.drive, b.drive) && a.rotor.has_value() == b.rotor.has_value() &&
         (!a.rotor || same(*a.rotor, *b.rotor)) && same(a.limits, b.limits);
}

bool same(const Coordinate& a, const Coordinate& b) {
  return a.word.text == b.word.text && same_drive_and_limits(a, b);
}

bool same(const Joint& a, const Joint& b) {
  return a.name.text == b.name.text && a.type == b.type && a.id == b.id && same(a.placement, b.placement) &&
         same(a.pitch, b.pitch) && same_drive_and_limits(a, b) && all_same(a.coordinates, b.coordinates) &&
         a.comments == b.comments;
}

bool same(const Body& a, const Body& b) {
  return all_same(a.links, b.links) && all_same(a.joints, b.joints) && all_same(a.couplings, b.couplings) &&
         all_same(a.loops, b.loops) && a.coupling_comments == b.coupling_comments &&
         all_same(a.loop_joints, b.loop_joints) && all_same(a.independents, b.independents) &&
         a.loop_comments == b.loop_comments && a.trailing_comments == b.trailing_comments;
}

bool same(const PartParameter& a, const PartParameter& b) {
  return same(a.name, b.name) && same(a.default_value, b.default_value);
}

bool same(const Part& a, const Part& b) {
  return same(static_cast<const Body&>(a), static_cast<const Body&>(b)) && same(a.name, b.name) &&
         all_same(a.parameters, b.parameters) && all_same(a.roots, b.roots) && a.comments == b.comments;
}

bool same(const Import& a, const Import& b) {
  return a.file == b.file && a.name.has_value() == b.name.has_value() && (!a.name || same(*a.name, *b.name)) &&
         a.comments == b.comments;
}

std::string body(const Body& b) {
  std::string out;
  for (const Link& l : b.links) out += link(l);
  for (const Joint& j : b.joints) out += joint(j);
  out += couplings(b) + loops(b);
  if (!b.trailing_comments.empty()) out += "\n" + comments(b.trailing_comments, "    ");
  return out;
}

std::string import_line(const Import& i) {
  return comments(i.comments, "") + "import \"" + i.file + "\"" + (i.name ? " as " + name(*i.name) : "") + "\n";
}

std::string part(const Part& p) {
  std::string out = comments(p.comments, "") + "Part " + name(p.name);
  std::string parameters;
  for (const PartParameter& parameter : p.parameters)
    parameters += (parameters.empty() ? "" : ", ") + name(parameter.name) +
                  (parameter.default_value ? "[" + language::print(*parameter.default_value) + "]" : "");
  if (!parameters.empty()) out += "(" + parameters + ")";
  out += " {\n";
  for (const Child& root : p.roots) out += "    root " + name(root.link) + " via " + name(root.joint) + "\n";
  return out + body(p) + "}\n\n";
}

void remove_comments(Body& body) {
  body.trailing_comments.clear();
  for (Link& link : body.links) link.comments.clear();
  for (Joint& joint : body.joints) joint.comments.clear();
  body.coupling_comments.clear();
  body.loop_comments.clear();
}

}  // namespace

std::string_view word_of(Joint::Type type) {
  switch (type) {
    case Joint::Type::revolute:
      break;
    case Joint::Type::prismatic:
      return "p_joint";
    case Joint::Type::helical:
      return "h_joint";
    case Joint::Type::cylindrical:
      return "c_joint";
    case Joint::Type::universal:
      return "u_joint";
    case Joint::Type::planar:
      return "planar_joint";
    case Joint::Type::spherical:
      return "s_joint";
  }
  return "r_joint";
}

std::span<const std::string_view> coordinate_words(Joint::Type type) {
  static constexpr std::array<std::string_view, 2> kCylindrical = {"slide", "turn"}, kUniversal = {"turn_x", "turn_z"};
  static constexpr std::array<std::string_view, 3> kPlanar = {"slide_x", "slide_y", "turn"};
  switch (type) {
    case Joint::Type::revolute:
    case Joint::Type::prismatic:
    case Joint::Type::helical:
    case Joint::Type::spherical:
      break;
    case Joint::Type::cylindrical:
      return kCylindrical;
    case Joint::Type::universal:
      return kUniversal;
    case Joint::Type::planar:
      return kPlanar;
  }
  return {};
}

std::string print(const Document& d) {
  std::string out;
  for (const Import& i : d.imports) out += import_line(i);
  if (!d.imports.empty() && (d.has_robot() || !d.parts.empty())) out += "\n";
  for (const Part& p : d.parts) out += part(p);
  if (!d.has_robot() && !(d.imports.empty() && d.parts.empty())) return out + comments(d.trailing_comments, "");
  return out + comments(d.comments, "") + "Robot " + name(d.robot) + " {\n" + body(d) + "}\n";
}

bool equal(const Document& a, const Document& b) {
  return a.robot.text == b.robot.text && a.comments == b.comments && all_same(a.imports, b.imports) &&
         all_same(a.parts, b.parts) && same(static_cast<const Body&>(a), static_cast<const Body&>(b));
}

Document without_comments(Document document) {
  document.comments.clear();
  for (Import& i : document.imports) i.comments.clear();
  for (Part& p : document.parts) {
    p.comments.clear();
    remove_comments(p);
  }
  remove_comments(document);
  return document;
}

}  // namespace robcogen::language::kinematics
