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

// Returns ` word = value`, or an empty string if there is no value.
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

std::string elasticity(const std::optional<Elasticity>& e, const std::string& indent) {
  if (!e) return "";
  return indent + "elastic {" + item("stiffness", e->stiffness) + item("damping", e->damping) + " }\n";
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

std::string drive_and_limits(const DriveAndLimits& owner, const std::string& indent) {
  const std::string assembled =
      owner.assembled ? indent + "assembled = " + language::print(*owner.assembled) + "\n" : "";
  return drive(owner.drive, indent) + rotor(owner.rotor, indent) + elasticity(owner.elasticity, indent) +
         limits(owner.limits, indent) + assembled;
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
         (l.distance ? item("distance", l.distance) : " type = " + l.type.text) +
         (l.branch.text.empty() ? "" : " branch = " + l.branch.text) + " }\n";
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
  if (!b.actuators.empty()) {
    out += "    actuators {\n";
    for (const Actuator& a : b.actuators)
      out += "        " + name(a.name) + " { from = " + name(a.frames[0]) + " to = " + name(a.frames[1]) + " }\n";
    out += "    }\n";
  }
  if (!b.tendons.empty()) {
    out += "    tendons {\n";
    for (const Tendon& t : b.tendons)
      out += "        " + name(t.name) + " {" + item("length", t.length) + item("stiffness", t.stiffness) +
             item("damping", t.damping) + item("rest", t.rest) + " }\n";
    out += "    }\n";
  }
  return out.empty() ? "" : "\n" + out;
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

}  // namespace

std::string print(const Document& d) {
  std::string out;
  for (const Import& i : d.imports) out += import_line(i);
  if (!d.imports.empty() && (d.has_robot() || !d.parts.empty())) out += "\n";
  for (const Part& p : d.parts) out += part(p);
  if (!d.has_robot() && !(d.imports.empty() && d.parts.empty())) return out + comments(d.trailing_comments, "");
  return out + comments(d.comments, "") + "Robot " + name(d.robot) + " {\n" + body(d) + "}\n";
}

}  // namespace robcogen::language::kinematics
