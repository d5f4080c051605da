#include "export/urdf.h"

#include <fmt/format.h>

#include <cassert>
#include <cmath>

#include "export/pose.h"
#include "export/urdf_loops.h"
#include "support/index.h"
#include "support/unique_names.h"

namespace robcogen::exporting {

namespace {

using model::Joint;
using model::JointLimits;
using model::JointType;
using model::KinematicTree;
using model::Link;
using model::UserFrame;

// Components of a unit vector that are this close to 0, 1 or -1 become exactly that.
constexpr Real kNegligible = 1e-15L;

// ---- The frame of the model and the name of each URDF link.

// Whether the user frame may be the URDF frame of its link. In URDF, a revolute joint turns about an axis through the
// origin of its child's frame, and the root has no joint that could place its frame.
bool may_be_link_frame(const KinematicTree& tree, const UserFrame& frame) {
  const int joint = tree.links[at(frame.link)].parent_joint;
  if (joint < 0) return pose_of(frame.placement).is_identity();
  const bool is_on_axis = frame.placement.translation[0].is_zero() && frame.placement.translation[1].is_zero();
  return tree.joints[at(joint)].type == JointType::prismatic || is_on_axis;
}

// By link: the user frame that is its URDF frame, if any.
std::vector<const UserFrame*> own_frames(const KinematicTree& tree) {
  std::vector<const UserFrame*> own(tree.links.size(), nullptr);
  for (const UserFrame& frame : tree.user_frames) {
    const bool is_named_so = !frame.hidden && frame.name == tree.links[at(frame.link)].name;
    if (is_named_so && may_be_link_frame(tree, frame)) own[at(frame.link)] = &frame;
  }
  return own;
}

// A massless link on a fixed joint.
struct FrameLink {
  const UserFrame* frame;
  std::string link, joint;
};

struct Names {
  std::vector<FrameLink> frame_links;
  std::string root_link, root_joint;  // above a floating base
};

Names choose_names(const KinematicTree& tree, const std::vector<const UserFrame*>& own) {
  UniqueNames links, joints;
  for (const Link& link : tree.links) links.reserve(link.name);
  for (const Joint& joint : tree.joints) joints.reserve(joint.name);
  Names names;
  for (const UserFrame& frame : tree.user_frames) {
    if (frame.hidden || own[at(frame.link)] == &frame || is_made_by_loop(tree, frame.name)) continue;
    names.frame_links.push_back({&frame, links.reserve(frame.name) ? frame.name : "", ""});
  }
  // Generated names differ from all given ones.
  for (FrameLink& made : names.frame_links) {
    if (made.link.empty()) made.link = links.add(made.frame->name + "_frame");
    made.joint = joints.add(made.link + "_fixed");
  }
  names.root_link = links.add("world");
  names.root_joint = joints.add("floating_base");
  return names;
}

// ---- Numbers.

// Mass properties about the centre of mass, in the axes of the URDF link.
struct Body {
  double mass;
  Vector3 com;     // m, in the URDF link frame
  Matrix3 tensor;  // kg m^2
};

double value(const model::Quantity& quantity) {
  assert(quantity.is_constant());
  return quantity.number().value();
}

Body body_of(const model::Inertia& inertia, const Pose& urdf_X_link) {
  const Pose pose = inertia.reference ? urdf_X_link * pose_of(*inertia.reference) : urdf_X_link;
  const double mass = value(inertia.mass);
  const Vector3 c{value(inertia.com[0]), value(inertia.com[1]), value(inertia.com[2])};
  // Products of inertia enter the tensor with a negative sign.
  const Real xy = -value(inertia.ixy), xz = -value(inertia.ixz), yz = -value(inertia.iyz);
  Matrix3 I = {{{value(inertia.ixx), xy, xz}, {xy, value(inertia.iyy), yz}, {xz, yz, value(inertia.izz)}}};
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t j = (i + 1) % 3, k = (i + 2) % 3;
    I[i][i] -= mass * (c[j] * c[j] + c[k] * c[k]);
    I[i][j] += mass * c[i] * c[j];
    I[j][i] += mass * c[i] * c[j];
  }
  const Matrix3 R = rotation_matrix(pose);
  Body body{mass, R * c, R * I * transpose(R)};
  for (std::size_t i = 0; i < 3; ++i) body.com[i] += pose.translation[i];
  return body;
}

// The z axis of a link, in its URDF frame.
Vector3 joint_axis(const Pose& link_X_urdf) {
  Vector3 axis = rotation_matrix(link_X_urdf)[2];
  for (Real& x : axis) {
    if (std::abs(x - std::round(x)) < kNegligible) x = std::round(x);
  }
  const Real length = std::hypot(axis[0], axis[1], axis[2]);
  for (Real& x : axis) x /= length;
  return axis;
}

// ---- Text.

std::string escaped(const std::string& text) {
  std::string out;
  for (const char c : text) {
    if (c == '&')
      out += "&amp;";
    else if (c == '<')
      out += "&lt;";
    else if (c == '>')
      out += "&gt;";
    else if (c == '"')
      out += "&quot;";
    else
      out += c;
  }
  return out;
}

std::string number(Real x) {
  return print_double(static_cast<double>(x));
}

std::string triple(const Vector3& v) {
  return fmt::format("{} {} {}", number(v[0]), number(v[1]), number(v[2]));
}

std::string origin(const Pose& pose) {
  const auto [roll, pitch, yaw] = roll_pitch_yaw(pose);
  return fmt::format(R"(<origin xyz="{}" rpy="{}"/>)", triple(pose.translation), triple({roll, pitch, yaw}));
}

std::string inertial(const Body& body) {
  const auto& [x, y, z] = body.tensor;
  std::string text = "    <inertial>\n";
  text += fmt::format("      <origin xyz=\"{}\" rpy=\"0.0 0.0 0.0\"/>\n", triple(body.com));
  text += fmt::format("      <mass value=\"{}\"/>\n", number(body.mass));
  text += fmt::format(
      "      <inertia ixx=\"{}\" ixy=\"{}\" ixz=\"{}\" iyy=\"{}\" iyz=\"{}\" izz=\"{}\"/>\n", number(x[0]),
      number(x[1]), number(x[2]), number(y[1]), number(y[2]), number(z[2]));
  return text + "    </inertial>\n";
}

std::string massless_link(const std::string& name) {
  return fmt::format("  <link name=\"{}\"/>\n", escaped(name));
}

std::string link(const std::string& name, const Body& body) {
  return fmt::format("  <link name=\"{}\">\n{}  </link>\n", escaped(name), inertial(body));
}

// `motion`: the lines of XML that only a moving joint has.
std::string joint(
    const std::string& name,
    const std::string& type,
    const Pose& parent_X_child,
    const std::string& parent,
    const std::string& child,
    const std::string& motion = "",
    const std::string& attributes = "") {
  std::string text = fmt::format("  <joint name=\"{}\" type=\"{}\"{}>\n", escaped(name), type, attributes);
  text += fmt::format("    {}\n", origin(parent_X_child));
  text += fmt::format("    <parent link=\"{}\"/>\n    <child link=\"{}\"/>\n", escaped(parent), escaped(child));
  return text + motion + "  </joint>\n";
}

bool has_bounds(const JointLimits& limits) {
  return std::isfinite(limits.lower) || std::isfinite(limits.upper);
}

const char* type_of(const Joint& joint) {
  assert(joint.type != JointType::helical);
  if (joint.type == JointType::prismatic) return "prismatic";
  return has_bounds(joint.limits) ? "revolute" : "continuous";
}

std::string limit(const Joint& joint) {
  const auto bound = [](double x) { return print_double(std::isfinite(x) ? x : std::copysign(model::kNoLimit, x)); };
  const JointLimits& limits = joint.limits;
  const std::string range = fmt::format(R"(lower="{}" upper="{}" )", bound(limits.lower), bound(limits.upper));
  return fmt::format(
      "    <limit {}effort=\"{}\" velocity=\"{}\"/>\n", type_of(joint) == std::string("continuous") ? "" : range,
      bound(limits.effort), bound(limits.velocity));
}

std::string dynamics(const model::Drive& drive) {
  const double damping = model::evaluate(drive.damping), friction = model::evaluate(drive.friction);
  if (damping == 0 && friction == 0) return "";
  return fmt::format("    <dynamics damping=\"{}\" friction=\"{}\"/>\n", print_double(damping), print_double(friction));
}

std::string motion(const Joint& joint, const Vector3& axis) {
  std::string text = fmt::format("    <axis xyz=\"{}\"/>\n", triple(axis)) + dynamics(joint.drive);
  // Only a continuous joint may lack limits.
  if (joint.type == JointType::revolute && joint.limits == JointLimits()) return text;
  return text + limit(joint);
}

bool is_mimic(const KinematicTree& tree, const model::Coupling& coupling) {
  if (!coupling.is_linear() || coupling.loop >= 0) return false;
  return coupling.terms.size() == 1 || (coupling.terms.empty() && tree.dof() > 0);
}

// The mimic element of a joint that follows one other or stands still. A joint that stands still follows any joint,
// with multiplier 0.
std::string mimic(const KinematicTree& tree, int index) {
  const model::Coupling* coupling = tree.coupling_of(index);
  if (coupling == nullptr || !is_mimic(tree, *coupling)) return "";
  const bool follows = !coupling->terms.empty();
  const int followed = follows ? coupling->terms.front().joint : tree.coordinates().front();
  return fmt::format(
      "    <mimic joint=\"{}\" multiplier=\"{}\" offset=\"{}\"/>\n", escaped(tree.joints[at(followed)].name),
      follows ? number(value(coupling->terms.front().factor)) : "0", number(value(coupling->offset)));
}

// URDF+ marks the joints that follow; if one is marked, all others lead.
std::string followers_attribute(const KinematicTree& tree, int joint) {
  const model::Coupling* coupling = tree.coupling_of(joint);
  return coupling != nullptr && !is_mimic(tree, *coupling) ? " independent=\"false\"" : "";
}

// The position in which loops are assembled. URDF+ does not have this attribute.
std::string assembled_attribute(const model::Joint& joint) {
  return joint.assembled ? fmt::format(" assembled=\"{}\"", number(*joint.assembled)) : "";
}

// A loop of URDF+: the frames of both ends coincide except for their angle about z.
std::string loop(const KinematicTree& tree, const model::LoopJoint& loop, const std::vector<Pose>& link_X_urdf) {
  std::string text = fmt::format("  <loop name=\"{}\" type=\"continuous\">\n", escaped(loop.name));
  for (std::size_t e = 0; e < 2; ++e) {
    const model::LoopEnd& end = loop.ends[e];
    const Pose pose = inverse_of(link_X_urdf[at(end.link)]) * pose_of(end.placement);
    text += fmt::format(
        "    <{0} link=\"{1}\">\n      {2}\n    </{0}>\n", e == 0 ? "predecessor" : "successor",
        escaped(tree.links[at(end.link)].name), origin(pose));
  }
  return text + "    <axis xyz=\"0.0 0.0 1.0\"/>\n  </loop>\n";
}

std::string coupling(const KinematicTree& tree, const model::Coupling& coupling) {
  const LinkCoupling links = *link_coupling(tree, coupling);
  return fmt::format(
      "  <coupling name=\"of_{}\">\n    <predecessor link=\"{}\"/>\n    <successor link=\"{}\"/>\n    <ratio "
      "value=\"{}\"/>\n  </coupling>\n",
      escaped(tree.joints[at(coupling.joint)].name), escaped(tree.links[at(links.predecessor)].name),
      escaped(tree.links[at(links.successor)].name), number(links.ratio));
}

std::string heading(const KinematicTree& tree) {
  return fmt::format(
      "<?xml version=\"1.0\"?>\n"
      "<!-- Generated by robcogen from robot {}. A limit of {} means no limit; URDF requires a number. -->\n",
      escaped(tree.name), print_double(model::kNoLimit));
}

}  // namespace

bool has_urdf_form(const KinematicTree& tree, const model::Coupling& coupling) {
  return !coupling.is_linear() || coupling.loop >= 0 || is_mimic(tree, coupling) || link_coupling(tree, coupling);
}

std::string urdf(const KinematicTree& tree) {
  assert(tree.parameters.empty());
  const std::vector<const UserFrame*> own = own_frames(tree);
  const Names names = choose_names(tree, own);
  std::vector<Pose> link_X_urdf;  // by link
  for (const UserFrame* frame : own) link_X_urdf.push_back(frame == nullptr ? Pose() : pose_of(frame->placement));

  std::string text = heading(tree) + fmt::format("<robot name=\"{}\">\n", escaped(tree.name));
  if (tree.floating_base) text += massless_link(names.root_link);
  for (std::size_t i = 0; i < tree.links.size(); ++i) {
    const Link& from = tree.links[i];
    text +=
        from.inertia ? link(from.name, body_of(*from.inertia, inverse_of(link_X_urdf[i]))) : massless_link(from.name);
  }
  for (const FrameLink& made : names.frame_links) text += massless_link(made.link);

  if (tree.floating_base) text += joint(names.root_joint, "floating", {}, names.root_link, tree.links[0].name);
  for (std::size_t j = 0; j < tree.joints.size(); ++j) {
    const Joint& from = tree.joints[j];
    const Pose& child = link_X_urdf[at(from.child)];
    const Pose pose = inverse_of(link_X_urdf[at(from.parent)]) * pose_of(from.placement) * child;
    text += joint(
        from.name, type_of(from), pose, tree.links[at(from.parent)].name, tree.links[at(from.child)].name,
        motion(from, joint_axis(child)) + mimic(tree, static_cast<int>(j)),
        followers_attribute(tree, static_cast<int>(j)) + assembled_attribute(from));
  }
  for (const FrameLink& made : names.frame_links) {
    const int carrier = made.frame->link;
    const Pose pose = inverse_of(link_X_urdf[at(carrier)]) * pose_of(made.frame->placement);
    text += joint(made.joint, "fixed", pose, tree.links[at(carrier)].name, made.link);
  }
  for (const model::LoopJoint& closing : tree.loops) text += loop(tree, closing, link_X_urdf);
  for (const model::Coupling& given : tree.couplings)
    if (!follows_through_loop(tree, given.joint) && !is_mimic(tree, given)) text += coupling(tree, given);
  return text + "</robot>\n";
}

}  // namespace robcogen::exporting
