#include "urdf_reader.h"

#include <console_bridge/console.h>
#include <urdf_parser/urdf_parser.h>

#include <algorithm>
#include <stdexcept>

namespace robcogen::test {
namespace {

// Collects urdfdom's log during its lifetime.
class Listener : public console_bridge::OutputHandler {
 public:
  Listener() {
    console_bridge::setLogLevel(console_bridge::CONSOLE_BRIDGE_LOG_WARN);
    console_bridge::useOutputHandler(this);
  }
  ~Listener() override { console_bridge::restorePreviousOutputHandler(); }
  void log(const std::string& text, console_bridge::LogLevel, const char*, int) override { heard += text + "\n"; }

  std::string heard;
};

Eigen::Vector3d vector(const urdf::Vector3& v) {
  return {v.x, v.y, v.z};
}

Eigen::Isometry3d isometry(const urdf::Pose& pose) {
  const urdf::Rotation& r = pose.rotation;
  return Eigen::Translation3d(vector(pose.position)) * Eigen::Quaterniond(r.w, r.x, r.y, r.z);
}

bool moves(const urdf::Joint& joint) {
  return joint.type != urdf::Joint::FIXED;
}

bool turns(const urdf::Joint& joint) {
  return joint.type == urdf::Joint::REVOLUTE || joint.type == urdf::Joint::CONTINUOUS;
}

Eigen::Isometry3d motion(const urdf::Joint& joint, double q) {
  if (turns(joint)) return Eigen::Isometry3d(Eigen::AngleAxisd(q, vector(joint.axis)));
  return Eigen::Isometry3d(Eigen::Translation3d(q * vector(joint.axis)));
}

}  // namespace

UrdfReader::UrdfReader(const std::string& text) {
  Listener listener;
  model_ = urdf::parseURDF(text);
  complaints_ = listener.heard;
  if (!model_) throw std::runtime_error("urdfdom refuses the text: " + complaints_);
  base_ = model_->getRoot();
  if (base_->child_joints.size() != 1) return;
  const urdf::Joint& joint = *base_->child_joints.front();
  if (joint.type == urdf::Joint::FLOATING) base_ = model_->getLink(joint.child_link_name);
}

std::map<std::string, Eigen::Isometry3d> UrdfReader::poses(const Positions& q) const {
  std::map<std::string, Eigen::Isometry3d> poses;
  add_poses(*base_, Eigen::Isometry3d::Identity(), q, poses);
  return poses;
}

void UrdfReader::add_poses(
    const urdf::Link& link,
    const Eigen::Isometry3d& pose,
    const Positions& q,
    std::map<std::string, Eigen::Isometry3d>& poses) const {
  poses[link.name] = pose;
  for (const urdf::JointSharedPtr& joint : link.child_joints) {
    const Eigen::Isometry3d origin = pose * isometry(joint->parent_to_joint_origin_transform);
    const urdf::LinkConstSharedPtr child = model_->getLink(joint->child_link_name);
    add_poses(*child, moves(*joint) ? origin * motion(*joint, q.at(joint->name)) : origin, q, poses);
  }
}

Eigen::MatrixXd UrdfReader::inertia_matrix(const std::vector<std::string>& joints, const Positions& q) const {
  const Eigen::Index size = 6 + static_cast<Eigen::Index>(joints.size());
  Eigen::MatrixXd H = Eigen::MatrixXd::Zero(size, size);
  const std::map<std::string, Eigen::Isometry3d> all = poses(q);
  for (const auto& [name, pose] : all) {
    const urdf::LinkConstSharedPtr link = model_->getLink(name);
    if (!link->inertial) continue;
    const urdf::Inertial& body = *link->inertial;
    const Eigen::Isometry3d centre = pose * isometry(body.origin);
    const Eigen::Vector3d p = centre.translation();

    Eigen::MatrixXd J = Eigen::MatrixXd::Zero(6, size);
    J.leftCols<6>().setIdentity();
    J.block<3, 3>(3, 0) << 0, p.z(), -p.y(), -p.z(), 0, p.x(), p.y(), -p.x(), 0;
    for (urdf::LinkConstSharedPtr at = link; at->name != base_->name; at = at->getParent()) {
      const urdf::Joint& joint = *at->parent_joint;
      if (!moves(joint)) continue;
      const auto column = 6 + (std::find(joints.begin(), joints.end(), joint.name) - joints.begin());
      const Eigen::Isometry3d& carried = all.at(at->name);
      const Eigen::Vector3d axis = carried.rotation() * vector(joint.axis);
      J.col(column).tail<3>() = turns(joint) ? axis.cross(p - carried.translation()) : axis;
      if (turns(joint)) J.col(column).head<3>() = axis;
    }

    Eigen::Matrix3d tensor;
    tensor << body.ixx, body.ixy, body.ixz, body.ixy, body.iyy, body.iyz, body.ixz, body.iyz, body.izz;
    Eigen::MatrixXd M = Eigen::MatrixXd::Zero(6, 6);
    M.topLeftCorner<3, 3>() = centre.rotation() * tensor * centre.rotation().transpose();
    M.bottomRightCorner<3, 3>() = body.mass * Eigen::Matrix3d::Identity();
    H += J.transpose() * M * J;
  }
  return H;
}

}  // namespace robcogen::test
