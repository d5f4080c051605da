// Whether a robot description is that of a generated library. It is compared by what it means, not by its text: poses
// of links, and the inertia and the gravity forces of joints, in a few positions. Needs urdfdom.
#pragma once

#include <urdf_model/model.h>
#include <urdf_parser/urdf_parser.h>

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <array>
#include <cmath>
#include <cstdio>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "robcogen/ros/chain.h"
#include "robcogen/spatial.h"

namespace robcogen::ros {

// Relative difference (and m per m, rad) above which a description is another robot's. SNAP_ANGLES changes angles by up
// to 1e-6 rad, and a file may have been written with six digits; calibrated robots differ by 1e-3 and more.
inline constexpr double kDescriptionTolerance = 1e-4;

// Sums over the links of a description in a position, computed in the textbook way.
template <class R>
class Description {
 public:
  static constexpr int kDof = R::kDof;
  using JointState = typename R::JointState;

  Description(const reflection::Robot& tables, const urdf::ModelInterface& model) : tables_(&tables), model_(&model) {}

  // Returns the first joint of the library that the description does not move; an empty text if there is none.
  std::string missing_joint() const {
    for (int j = 0; j < kDof; ++j) {
      bool is_there = false;
      for (const auto& [name, joint] : model_->joints_)
        is_there = is_there || (is_name_of(tables_->joints[j].name, name) && moves(*joint));
      if (!is_there) return tables_->joints[j].name;
    }
    return "";
  }

  // Poses of the links in the root, for links that no joint moves that the library does not have; the others are
  // counted. Then inertia and gravity forces, which are complete if there are none of these.
  struct Sums {
    std::map<std::string, Eigen::Isometry3d> poses;
    int unknown = 0;
    Eigen::Matrix<double, kDof, kDof> inertia = Eigen::Matrix<double, kDof, kDof>::Zero();
    JointState gravity_forces = JointState::Zero();
    double gravity_scale = 0;  // of the terms of the forces
  };

  Sums sums(const JointState& q, const Eigen::Vector3d& gravity) const {
    Sums result;
    // For each joint of the library, what it moves at one unit per second: a twist about the root's origin.
    visit(*model_->getRoot(), Eigen::Isometry3d::Identity(), Columns::Zero(), true, q, gravity, result);
    return result;
  }

 private:
  using Columns = Eigen::Matrix<double, 6, kDof>;  // angular first

  const reflection::Robot* tables_;
  const urdf::ModelInterface* model_;

  static bool moves(const urdf::Joint& joint) {
    return joint.type == urdf::Joint::REVOLUTE || joint.type == urdf::Joint::CONTINUOUS ||
           joint.type == urdf::Joint::PRISMATIC;
  }

  static Eigen::Isometry3d pose(const urdf::Pose& pose) {
    Eigen::Isometry3d X = Eigen::Isometry3d::Identity();
    double x = 0, y = 0, z = 0, w = 1;
    pose.rotation.getQuaternion(x, y, z, w);
    X.linear() = Eigen::Quaterniond(w, x, y, z).normalized().toRotationMatrix();
    X.translation() = Eigen::Vector3d(pose.position.x, pose.position.y, pose.position.z);
    return X;
  }

  // The joint of the library that moves a joint of the description, with factor and offset; -1 if there is none.
  struct Follows {
    int joint = -1;
    double factor = 1, offset = 0;
  };
  Follows followed_by(const urdf::Joint& joint, int depth = 0) const {
    for (int j = 0; j < kDof; ++j)
      if (is_name_of(tables_->joints[j].name, joint.name)) return {j};
    if (!joint.mimic || depth > kDof) return {};
    const auto master = model_->joints_.find(joint.mimic->joint_name);
    if (master == model_->joints_.end()) return {};
    Follows follows = followed_by(*master->second, depth + 1);
    follows.factor *= joint.mimic->multiplier;
    follows.offset = joint.mimic->multiplier * follows.offset + joint.mimic->offset;
    return follows;
  }

  void visit(
      const urdf::Link& link,
      const Eigen::Isometry3d& X,
      const Columns& columns,
      bool is_known,
      const JointState& q,
      const Eigen::Vector3d& gravity,
      Sums& sums) const {
    if (is_known) {
      sums.poses.emplace(link.name, X);
      if (link.inertial) add_inertia(*link.inertial, X, columns, gravity, sums);
    } else {
      ++sums.unknown;
    }
    for (const auto& joint : link.child_joints) {
      const auto child = model_->links_.find(joint->child_link_name);
      if (child == model_->links_.end()) continue;
      Eigen::Isometry3d Y = X * pose(joint->parent_to_joint_origin_transform);
      Columns below = columns;
      bool child_is_known = is_known && (moves(*joint) || joint->type == urdf::Joint::FIXED);
      if (moves(*joint) && child_is_known) {
        const Follows follows = followed_by(*joint);
        child_is_known = follows.joint >= 0;
        const double position = child_is_known ? follows.factor * q[follows.joint] + follows.offset : 0;
        const Eigen::Vector3d axis = Eigen::Vector3d(joint->axis.x, joint->axis.y, joint->axis.z).normalized();
        const Eigen::Vector3d direction = Y.linear() * axis;
        Eigen::Matrix<double, 6, 1> twist;
        if (joint->type == urdf::Joint::PRISMATIC) {
          twist << Eigen::Vector3d::Zero(), direction;
          Y.translate(position * axis);
        } else {
          twist << direction, Y.translation().cross(direction);
          Y.rotate(Eigen::AngleAxisd(position, axis));
        }
        if (child_is_known) below.col(follows.joint) += follows.factor * twist;
      }
      visit(*child->second, Y, below, child_is_known, q, gravity, sums);
    }
  }

  static void add_inertia(
      const urdf::Inertial& inertial,
      const Eigen::Isometry3d& X,
      const Columns& columns,
      const Eigen::Vector3d& gravity,
      Sums& sums) {
    const Eigen::Isometry3d C = X * pose(inertial.origin);
    Eigen::Matrix3d I;
    I << inertial.ixx, inertial.ixy, inertial.ixz, inertial.ixy, inertial.iyy, inertial.iyz, inertial.ixz, inertial.iyz,
        inertial.izz;
    const Eigen::Matrix3d inertia = C.linear() * I * C.linear().transpose();
    const auto w = columns.template topRows<3>();
    Eigen::Matrix<double, 3, kDof> v = columns.template bottomRows<3>();
    for (int j = 0; j < kDof; ++j) v.col(j) += columns.col(j).template head<3>().cross(C.translation());
    sums.inertia += inertial.mass * v.transpose() * v + w.transpose() * inertia * w;
    sums.gravity_forces -= inertial.mass * v.transpose() * gravity;
    sums.gravity_scale += (inertial.mass * v.transpose() * gravity).template lpNorm<Eigen::Infinity>();
  }
};

// The positions in which a description is compared: zero, then some without symmetry.
template <class R>
typename R::JointState position_to_compare(int index) {
  typename R::JointState q;
  for (int j = 0; j < R::kDof; ++j) q[j] = index == 0 ? 0.0 : std::sin(1.0 + 2.3 * index + 7.7 * j);
  return q;
}
inline constexpr int kPositionsToCompare = 3;

// Shortens numbers for messages.
inline std::string number_text(double number) {
  std::array<char, 32> text{};
  if (std::abs(number) < 1e-9) number = 0;
  std::snprintf(text.data(), text.size(), "%.3g", number);
  return text.data();
}

// Returns in what the description differs from the library: joints and poses of links; an empty text if in nothing.
// Links that only one of both has are not compared, nor those that move with joints that the library does not have.
template <class R>
std::string difference_of_poses(const reflection::Robot& tables, const urdf::ModelInterface& model, const R& robot) {
  const std::string another =
      "the robot description is not that of the generated robot '" + std::string(tables.name) + "': ";
  if (!model.getRoot()) return another + "it has no root link";
  const Description<R> description(tables, model);
  if (const std::string joint = description.missing_joint(); !joint.empty())
    return another + "it does not have the joint '" + joint + "'";
  Chain<R> chain;
  chain.select_all(tables, {}, robot);
  chain.list_links();
  for (int k = 0; k < kPositionsToCompare; ++k) {
    const typename R::JointState q = position_to_compare<R>(k);
    for (const auto& [name, expected] : description.sums(q, Eigen::Vector3d::Zero()).poses) {
      const int link = chain.find(name);
      if (link < 0) continue;
      const Eigen::Isometry3d found = chain.pose(q, link);
      const double distance = (found.translation() - expected.translation()).norm();
      const double angle = Eigen::AngleAxisd(found.linear().transpose() * expected.linear()).angle();
      if (distance <= kDescriptionTolerance * (1 + expected.translation().norm()) && angle <= kDescriptionTolerance)
        continue;
      return another + "link '" + name + "' is " + number_text(distance) + " m and " + number_text(angle) +
             " rad from where it should be, " +
             (k == 0 ? "with all joints at zero" : "with the joints at other positions");
    }
  }
  return "";
}

// The same for the dynamics, by the joint-space inertia and the gravity forces. Armatures of joints, which descriptions
// do not have, count for the library only. `compared` becomes false where the description has moving links that the
// library does not know, or the library has rotors: these are not compared.
template <class R>
std::string difference_of_dynamics(
    const reflection::Robot& tables,
    const urdf::ModelInterface& model,
    const R& robot,
    bool& compared) {
  using JointState = typename R::JointState;
  const Description<R> description(tables, model);
  Eigen::Matrix<double, R::kDof, R::kDof> armatures = Eigen::Matrix<double, R::kDof, R::kDof>::Zero();
  compared = true;
  for (int j = 0; j < tables.joints.size; ++j) {
    const JointDrive& drive = tables.joints[j].drive;
    if (drive.rotor_inertia != 0) compared = false;
    if (j < R::kDof) {
      armatures(j, j) += drive.armature;
      continue;
    }
    if (drive.armature == 0) continue;  // factors may be no numbers
    const Eigen::Map<const JointState> factors(tables.couplings[j - R::kDof].factors);
    armatures += drive.armature * factors * factors.transpose();
  }
  const Eigen::Vector3d gravity(2, -3, -9);  // in a direction that no robot is made for
  for (int k = 0; k < kPositionsToCompare && compared; ++k) {
    const JointState q = position_to_compare<R>(k);
    const auto expected = description.sums(q, gravity);
    compared = expected.unknown == 0;
    if (!compared) break;
    const auto H = expected.inertia + armatures;
    const auto found = robot.joint_space_inertia(q);
    const JointState forces = robot.gravity_forces(q, typename R::Gravity(gravity));
    const std::string another =
        "the robot description does not have the masses of the generated robot '" + std::string(tables.name) + "': ";
    for (int i = 0; i < R::kDof; ++i) {
      const std::string joint = "joint '" + std::string(tables.joints[i].name) + "'";
      if (std::abs(H(i, i) - found(i, i)) > kDescriptionTolerance * std::abs(H(i, i)))
        return another + "the inertia at " + joint + " is " + number_text(H(i, i)) + ", not " +
               number_text(found(i, i));
      for (int j = 0; j < i; ++j)
        if (std::abs(H(i, j) - found(i, j)) > kDescriptionTolerance * std::sqrt(std::abs(H(i, i) * H(j, j))))
          return another + "the inertia between " + joint + " and joint '" + tables.joints[j].name + "' is " +
                 number_text(H(i, j)) + ", not " + number_text(found(i, j));
      if (std::abs(expected.gravity_forces[i] - forces[i]) > kDescriptionTolerance * expected.gravity_scale)
        return another + "the gravity force at " + joint + " is " + number_text(expected.gravity_forces[i]) + ", not " +
               number_text(forces[i]);
    }
  }
  return "";
}

}  // namespace robcogen::ros
