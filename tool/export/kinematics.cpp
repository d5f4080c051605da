#include "export/kinematics.h"

#include "export/expression.h"

namespace robcogen::exporting {

namespace kinematics = language::kinematics;
using language::ExpressionPtr;
using model::Quantity;

namespace {

class Writer {
 public:
  explicit Writer(const model::KinematicTree& tree) : tree_(tree) {}

  kinematics::Document document() const {
    kinematics::Document document;
    document.robot.text = tree_.name;
    for (std::size_t i = 0; i < tree_.links.size(); ++i) document.links.push_back(link(static_cast<int>(i)));
    for (const model::Joint& joint : tree_.joints) document.joints.push_back(write(joint));
    return document;
  }

 private:
  ExpressionPtr write(const Quantity& quantity) const { return expression(quantity, tree_.parameters); }

  kinematics::Vector write(const std::array<Quantity, 3>& v) const { return {write(v[0]), write(v[1]), write(v[2])}; }

  kinematics::Placement write(const model::Placement& placement) const {
    return {write(placement.translation), write(placement.rotation), {}};
  }

  kinematics::Inertia write(const model::Inertia& inertia) const {
    const model::RigidBodyInertia body = in_link_frame(inertia);
    std::array<Quantity, 3> com = inertia.com;
    if (inertia.reference) {
      for (std::size_t i = 0; i < 3; ++i) com[i] = body.first_moment[i] / body.mass;
    }
    return {
        write(body.mass),
        write(com),
        write(body.ixx),
        write(body.iyy),
        write(body.izz),
        write(body.ixy),
        write(body.ixz),
        write(body.iyz),
        {},
        {}};
  }

  kinematics::Link link(int index) const {
    const model::Link& from = tree_.links[static_cast<std::size_t>(index)];
    kinematics::Link link;
    link.name.text = from.name;
    link.is_base = index == 0;
    link.floating = link.is_base && tree_.floating_base;
    if (!link.is_base) link.id = index;
    if (from.inertia) link.inertia = write(*from.inertia);
    for (const int child : from.child_joints) {
      const model::Joint& joint = tree_.joints[static_cast<std::size_t>(child)];
      const model::Link& carried = tree_.links[static_cast<std::size_t>(joint.child)];
      link.children.push_back({{carried.name, {}}, {joint.name, {}}});
    }
    for (const model::UserFrame& frame : tree_.user_frames) {
      if (frame.link == index) link.frames.push_back({{frame.name, {}}, write(frame.placement)});
    }
    return link;
  }

  kinematics::Joint write(const model::Joint& from) const {
    kinematics::Joint joint;
    joint.name.text = from.name;
    joint.type = from.type == model::JointType::revolute ? kinematics::Joint::Type::revolute
                                                         : kinematics::Joint::Type::prismatic;
    joint.placement = write(from.placement);
    return joint;
  }

  const model::KinematicTree& tree_;
};

}  // namespace

kinematics::Document kinematics_document(const model::KinematicTree& tree) {
  return Writer(tree).document();
}

}  // namespace robcogen::exporting
