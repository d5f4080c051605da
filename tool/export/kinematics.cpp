#include "export/kinematics.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "export/expression.h"
#include "support/index.h"

namespace robcogen::exporting {

namespace kinematics = language::kinematics;
using language::ExpressionPtr;
using model::Quantity;

namespace {

// The mass properties in the link frame, for a link without a frame that has the pose of their reference.
model::Inertia moved_to_link_frame(const model::Inertia& inertia) {
  const model::RigidBodyInertia body = in_link_frame(inertia);
  model::Inertia moved{body.mass, {}, body.ixx, body.iyy, body.izz, body.ixy, body.ixz, body.iyz, {}};
  const auto R = rotation_matrix(*inertia.reference);
  for (std::size_t i = 0; i < 3; ++i) {
    moved.com[i] = inertia.reference->translation[i] + R[i][0] * inertia.com[0] + R[i][1] * inertia.com[1] +
                   R[i][2] * inertia.com[2];
  }
  return moved;
}

kinematics::Joint::Type type_of(model::JointType type) {
  switch (type) {
    case model::JointType::revolute:
      break;
    case model::JointType::prismatic:
      return kinematics::Joint::Type::prismatic;
    case model::JointType::helical:
      return kinematics::Joint::Type::helical;
    case model::JointType::spherical:
      return kinematics::Joint::Type::spherical;
  }
  return kinematics::Joint::Type::revolute;
}

class Writer {
 public:
  explicit Writer(const model::KinematicTree& tree) : tree_(tree), frames_(tree.links.size()) {
    for (const model::UserFrame& frame : tree.user_frames)
      frames_[static_cast<std::size_t>(frame.link)].push_back(&frame);
  }

  kinematics::Document document() const {
    kinematics::Document document;
    document.robot.text = tree_.name;
    for (std::size_t i = 0; i < tree_.links.size(); ++i)
      if (!tree_.links[i].is_repeated) document.links.push_back(link(i));
    for (const model::Joint& joint : tree_.joints)
      if (joint.is_first()) document.joints.push_back(write(joint));
    for (const model::Coupling& coupling : tree_.couplings)
      if (coupling.is_linear() && coupling.loop < 0) document.couplings.push_back(write(coupling));
    for (const model::LoopJoint& loop : tree_.loops) document.loop_joints.push_back(write(loop));
    for (const model::Tendon& tendon : tree_.tendons) document.tendons.push_back(write(tendon));
    document.independents = independents();
    for (const model::Actuator& actuator : tree_.actuators)
      document.actuators.push_back(
          {{actuator.name, {}}, {kinematics::Name{actuator.frames[0], {}}, {actuator.frames[1], {}}}});
    return document;
  }

 private:
  ExpressionPtr write(const Quantity& quantity) const { return expression(quantity, tree_.parameters); }

  kinematics::Vector write(const std::array<Quantity, 3>& v) const { return {write(v[0]), write(v[1]), write(v[2])}; }

  kinematics::Placement write(const model::Placement& placement) const {
    return {write(placement.translation), write(placement.rotation), {}};
  }

  bool same(const model::Placement& a, const model::Placement& b) const {
    const auto same_quantity = [&](const Quantity& x, const Quantity& y) {
      return language::equal(*write(x), *write(y));
    };
    return std::equal(a.translation.begin(), a.translation.end(), b.translation.begin(), same_quantity) &&
           std::equal(a.rotation.begin(), a.rotation.end(), b.rotation.begin(), same_quantity);
  }

  // The frame of the link that has the pose of the reference of its mass properties, if there is one.
  const model::UserFrame* reference_frame(std::size_t link, const model::Placement& reference) const {
    for (const model::UserFrame* frame : frames_[link]) {
      if (same(frame->placement, reference)) return frame;
    }
    return nullptr;
  }

  kinematics::Inertia inertia_of(std::size_t link) const {
    const model::Inertia& given = *tree_.links[link].inertia;
    const model::UserFrame* frame = given.reference ? reference_frame(link, *given.reference) : nullptr;
    if (frame == nullptr) return write(given.reference ? moved_to_link_frame(given) : given);
    kinematics::Inertia inertia = write(given);
    inertia.reference = kinematics::Name{frame->name, {}};
    return inertia;
  }

  kinematics::Inertia write(const model::Inertia& i) const {
    return {write(i.mass), write(i.com), write(i.ixx), write(i.iyy), write(i.izz),
            write(i.ixy),  write(i.ixz), write(i.iyz), {},           {}};
  }

  kinematics::Link link(std::size_t index) const {
    const model::Link& from = tree_.links[index];
    kinematics::Link link;
    link.name.text = from.name;
    link.is_base = index == 0;
    link.floating = link.is_base && tree_.floating_base;
    if (!link.is_base) link.id = static_cast<int>(index);
    if (from.inertia) link.inertia = inertia_of(index);
    for (const int child : from.child_joints) {
      const model::Joint& joint = tree_.joints[static_cast<std::size_t>(child)];
      const model::Link& carried = tree_.links[static_cast<std::size_t>(joint.child)];
      link.children.push_back({{carried.name, {}}, {joint.declared_name(), {}}});
    }
    for (const model::UserFrame* frame : frames_[index]) link.frames.push_back(write(*frame));
    return link;
  }

  kinematics::Frame write(const model::UserFrame& from) const {
    kinematics::Frame frame;
    frame.name.text = from.name;
    frame.placement = write(from.placement);
    return frame;
  }

  kinematics::Joint write(const model::Joint& from) const {
    kinematics::Joint joint;
    joint.name.text = from.declared_name();
    joint.type = type_of(from.type);
    if (from.type == model::JointType::helical) joint.pitch = write(from.pitch);
    joint.placement = write(from.placement);
    joint.drive = write(from.drive);
    if (from.drive.rotor) joint.rotor = write(*from.drive.rotor, from.parent);
    joint.limits = write(from.limits);
    if (from.assembled) joint.assembled = write(Quantity(*from.assembled));
    return joint;
  }

  // A document leaves out zeros.
  ExpressionPtr given(const Quantity& quantity) const { return quantity.is_zero() ? nullptr : write(quantity); }

  kinematics::Drive write(const model::Drive& drive) const {
    kinematics::Drive written;
    written.damping = given(drive.damping);
    written.friction = given(drive.friction);
    if (written.friction) written.friction_velocity = given(drive.friction_velocity);
    written.armature = given(drive.armature);
    written.stiffness = given(drive.stiffness);
    if (written.stiffness) written.rest = given(drive.rest);
    return written;
  }

  kinematics::Rotor write(const model::Rotor& rotor, int parent) const {
    kinematics::Rotor written;
    written.inertia = write(rotor.inertia);
    written.ratio = write(rotor.ratio);
    if (rotor.axis) written.axis = write(*rotor.axis);
    if (rotor.carrier != parent) written.carrier = kinematics::Name{tree_.links[at(rotor.carrier)].name, {}};
    return written;
  }

  kinematics::Limits write(const model::JointLimits& limits) const {
    // A document gives both bounds of the position.
    const double lower = std::max(limits.lower, -model::kNoLimit), upper = std::min(limits.upper, model::kNoLimit);
    const auto number = [&](double value) { return write(Quantity(value)); };
    kinematics::Limits written;
    // Crossed bounds, which a URDF may have, count as none.
    if ((std::isfinite(limits.lower) || std::isfinite(limits.upper)) && limits.lower <= limits.upper)
      written.position = {number(lower), number(upper)};
    if (std::isfinite(limits.velocity)) written.velocity = number(limits.velocity);
    if (std::isfinite(limits.effort)) written.effort = number(limits.effort);
    return written;
  }

  kinematics::Coupling write(const model::Coupling& from) const {
    const Quantity rad = Quantity::variable(0), m = Quantity::variable(1);
    const auto slides = [&](int joint) { return !model::turns(tree_.joints[at(joint)].type); };
    Quantity value;
    for (const model::Coupling::Term& term : from.terms) {
      // The factor between joints of different kinds has a unit.
      Quantity factor = term.factor;
      if (slides(from.joint) != slides(term.joint)) factor = slides(from.joint) ? factor * m / rad : factor * rad / m;
      value = value + factor * Quantity::variable(2 + term.joint);
    }
    return {
        {tree_.joints[at(from.joint)].name, {}}, expression(value + from.offset, tree_.parameters, names_in_sums())};
  }

  // The length of a tendon is in m if any of its joints slides.
  kinematics::Tendon write(const model::Tendon& from) const {
    const auto slides = [&](const model::Tendon::Term& term) {
      return !model::turns(tree_.joints[at(term.joint)].type);
    };
    const bool is_in_metres = std::any_of(from.terms.begin(), from.terms.end(), slides);
    const Quantity rad = Quantity::variable(0), m = Quantity::variable(1);
    Quantity length;
    for (const model::Tendon::Term& term : from.terms) {
      const Quantity factor = is_in_metres && !slides(term) ? term.factor * m / rad : term.factor;
      length = length + factor * Quantity::variable(2 + term.joint);
    }
    return {
        {from.name, {}},
        expression(length, tree_.parameters, names_in_sums()),
        given(from.stiffness),
        given(from.damping),
        given(from.rest)};
  }

  // The units, then the joints.
  std::vector<std::string> names_in_sums() const {
    std::vector<std::string> names = {"rad", "m"};
    for (const model::Joint& joint : tree_.joints) names.push_back(joint.name);
    return names;
  }

  kinematics::LoopJoint write(const model::LoopJoint& loop) const {
    kinematics::LoopJoint written;
    written.name.text = loop.name;
    for (std::size_t e = 0; e < 2; ++e) written.frames[e].text = loop.ends[e].frame;
    if (loop.type == model::LoopType::distance)
      written.distance = write(loop.length);
    else
      written.type.text = model::kLoopTypes[static_cast<std::size_t>(loop.type)];
    if (loop.takes_other_branch) written.branch.text = "other";
    return written;
  }

  // The joints that stay independent, where loops could choose others.
  std::vector<kinematics::Name> independents() const {
    std::vector<kinematics::Name> names;
    for (const int joint : tree_.coordinates()) {
      const auto is_part_of = [&](const model::LoopJoint& loop) {
        return std::any_of(loop.ends.begin(), loop.ends.end(), [&](const model::LoopEnd& end) {
          return std::find(end.joints.begin(), end.joints.end(), joint) != end.joints.end();
        });
      };
      if (std::any_of(tree_.loops.begin(), tree_.loops.end(), is_part_of))
        names.push_back({tree_.joints[at(joint)].name, {}});
    }
    return names;
  }

  const model::KinematicTree& tree_;
  std::vector<std::vector<const model::UserFrame*>> frames_;  // by link
};

}  // namespace

kinematics::Document kinematics_document(const model::KinematicTree& tree) {
  return Writer(tree).document();
}

std::vector<int> joints_parents_first(const model::KinematicTree& tree) {
  std::vector<int> order;
  std::vector<bool> is_placed(tree.joints.size(), false);
  for (int declared = 0; declared < static_cast<int>(tree.joints.size()); ++declared) {
    std::vector<int> path;  // from this joint towards the base
    for (int j = declared; j >= 0 && !is_placed[at(j)]; j = tree.parent_joint_of(j)) {
      path.push_back(j);
      is_placed[at(j)] = true;
    }
    order.insert(order.end(), path.rbegin(), path.rend());
  }
  return order;
}

kinematics::Document numbered_parents_first(const model::KinematicTree& tree, kinematics::Document document) {
  std::vector<kinematics::Link> links = {std::move(document.links.front())};
  std::vector<kinematics::Joint> joints;
  std::vector<std::size_t> declared;  // by joint: its place in the document
  for (const model::Joint& joint : tree.joints)
    declared.push_back(declared.empty() ? 0 : declared.back() + (joint.is_first() ? 1 : 0));
  for (const int j : joints_parents_first(tree)) {
    if (!tree.joints[at(j)].is_first()) continue;
    const int last = tree.joints[at(j)].spherical.empty() ? j : j + 2;
    links.push_back(std::move(document.links[at(tree.joints[at(last)].child)]));
    links.back().id = static_cast<int>(joints.size()) + 1;
    joints.push_back(std::move(document.joints[declared[at(j)]]));
  }
  document.links = std::move(links);
  document.joints = std::move(joints);
  return document;
}

}  // namespace robcogen::exporting
