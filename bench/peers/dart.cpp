// DART: recursive Newton-Euler, articulated bodies, and a mass matrix from unit accelerations.
#include <algorithm>
#include <dart/dynamics/BodyNode.hpp>
#include <dart/dynamics/FreeJoint.hpp>
#include <dart/dynamics/Joint.hpp>
#include <dart/dynamics/Skeleton.hpp>
#include <dart/dynamics/WeldJoint.hpp>
#include <dart/utils/urdf/DartLoader.hpp>
#include <stdexcept>

#include "libraries.h"
#include "order.h"
#include "urdf_text.h"

namespace robcogen::peers {

namespace {

using dart::dynamics::BodyNode;
using dart::dynamics::Joint;
using dart::dynamics::SkeletonPtr;
using dart::utils::DartLoader;

// DART gives a link without <inertial> a mass of 1 kg, or the mass given here; its setter requires a positive mass.
SkeletonPtr skeleton_of(const Subject& subject) {
  DartLoader::Options options;
  options.mDefaultRootJointType =
      subject.floating_base ? DartLoader::RootJointType::FLOATING : DartLoader::RootJointType::FIXED;
  options.mDefaultInertia = dart::dynamics::Inertia(0, Eigen::Vector3d::Zero(), Eigen::Matrix3d::Zero());
  SkeletonPtr skeleton = DartLoader(options).parseSkeletonString(dynamics_text(subject.urdf), dart::common::Uri());
  if (!skeleton) throw std::runtime_error("refuses the URDF");
  return skeleton;
}

// Whether a body is a frame on a fixed joint that carries nothing and is not needed. DART would compute its motion
// nevertheless.
bool is_idle(BodyNode& body, const Subject& subject) {
  return body.getNumChildBodyNodes() == 0 && body.getMass() == 0 && body.getName() != subject.link &&
         body.getParentJoint()->getType() == dart::dynamics::WeldJoint::getStaticType();
}

void remove_idle_frames(const SkeletonPtr& skeleton, const Subject& subject) {
  for (std::size_t i = skeleton->getNumBodyNodes(); i-- > 0;) {
    BodyNode& body = *skeleton->getBodyNode(i);
    if (is_idle(body, subject)) body.remove();
  }
}

// Removes everything except rigid bodies and ideal joints.
void idealize(const SkeletonPtr& skeleton) {
  for (std::size_t i = 0; i < skeleton->getNumJoints(); ++i) {
    Joint& joint = *skeleton->getJoint(i);
    joint.setActuatorType(Joint::FORCE);
    joint.setLimitEnforcement(false);
    for (std::size_t k = 0; k < joint.getNumDofs(); ++k) {
      joint.setDampingCoefficient(k, 0);
      joint.setCoulombFriction(k, 0);
      joint.setSpringStiffness(k, 0);
    }
  }
}

std::size_t base_index(const SkeletonPtr& skeleton) {
  for (std::size_t i = 0; i < skeleton->getNumJoints(); ++i) {
    const Joint& joint = *skeleton->getJoint(i);
    if (joint.getType() == dart::dynamics::FreeJoint::getStaticType()) return joint.getIndexInSkeleton(0);
  }
  throw std::runtime_error("makes no floating base of the URDF");
}

// The velocity of a free joint is the twist of its body in the axes of the body, angular first. The base is at the
// origin here, so it equals that of generated code; the same holds for accelerations and wrenches.
Order order_of(const SkeletonPtr& skeleton, const Subject& subject) {
  Order order;
  if (subject.floating_base) {
    for (std::size_t i = 0; i < 6; ++i) order.push_back(static_cast<Eigen::Index>(base_index(skeleton) + i));
  }
  for (const std::string& name : subject.joints) {
    const Joint* joint = skeleton->getJoint(name);
    if (joint == nullptr || joint->getNumDofs() != 1) throw std::runtime_error("finds no joint " + name);
    order.push_back(static_cast<Eigen::Index>(joint->getIndexInSkeleton(0)));
  }
  if (order.size() != skeleton->getNumDofs()) throw std::runtime_error("finds other joints in the URDF");
  return order;
}

struct Arguments {
  Eigen::VectorXd q, qd, qdd, tau;
};

class Dart : public Peer {
 public:
  explicit Dart(const Subject& subject) : skeleton_(skeleton_of(subject)), floating_(subject.floating_base) {
    remove_idle_frames(skeleton_, subject);
    idealize(skeleton_);
    skeleton_->setGravity(subject.gravity);
    order_ = order_of(skeleton_, subject);
    if (subject.link.empty()) return;
    body_ = skeleton_->getBodyNode(subject.link);
    if (body_ == nullptr) throw std::runtime_error("finds no link " + subject.link + " in the URDF");
  }

  std::string name() const override { return "DART"; }

  bool has(Quantity quantity) const override { return !is_of_link(quantity) || body_ != nullptr; }

  void prepare(const std::vector<State>& states) override {
    const auto converted = [&](const Eigen::Matrix<double, 6, 1>& base, const Eigen::VectorXd& joints) {
      return to_library(order_, coordinates(floating_, base, joints));
    };
    const Eigen::Matrix<double, 6, 1> zero = Eigen::Matrix<double, 6, 1>::Zero();
    states_.clear();
    for (const State& s : states)
      states_.push_back(
          {converted(zero, s.q), converted(s.base_velocity, s.qd), converted(s.base_acceleration, s.qdd),
           converted(zero, s.tau)});
  }

  // A skeleton holds its state and computes lazily: setting the state is part of each call.
  void run(Quantity quantity, std::size_t state) override {
    const Arguments& s = states_[state];
    skeleton_->setPositions(s.q);
    switch (quantity) {
      case Quantity::inverse_dynamics:
        skeleton_->setVelocities(s.qd);
        skeleton_->setAccelerations(s.qdd);
        skeleton_->computeInverseDynamics();
        break;
      case Quantity::forward_dynamics:
        skeleton_->setVelocities(s.qd);
        skeleton_->setForces(s.tau);
        skeleton_->computeForwardDynamics();
        break;
      case Quantity::inertia_matrix:
        skeleton_->getMassMatrix();
        break;
      case Quantity::jacobian:
        body_->getWorldJacobian();
        break;
      case Quantity::transform:
        body_->getWorldTransform();
        break;
    }
  }

  Eigen::MatrixXd result(Quantity quantity) const override {
    switch (quantity) {
      case Quantity::inverse_dynamics:
        return vector_from_library(order_, skeleton_->getForces());
      case Quantity::forward_dynamics:
        return vector_from_library(order_, skeleton_->getAccelerations());
      case Quantity::inertia_matrix:
        return matrix_from_library(order_, skeleton_->getMassMatrix());
      case Quantity::transform:
        return body_->getWorldTransform().matrix();
      case Quantity::jacobian:
        break;
    }
    return jacobian();
  }

 private:
  // DART's Jacobian has only the columns of the coordinates that the body depends on.
  Eigen::MatrixXd jacobian() const {
    const auto& narrow = body_->getWorldJacobian();
    const Eigen::Index size = static_cast<Eigen::Index>(skeleton_->getNumDofs());
    Eigen::MatrixXd all = Eigen::MatrixXd::Zero(6, size);
    for (std::size_t k = 0; k < body_->getNumDependentGenCoords(); ++k)
      all.col(static_cast<Eigen::Index>(body_->getDependentGenCoordIndex(k))) =
          narrow.col(static_cast<Eigen::Index>(k));
    const Eigen::MatrixXd ordered = all(Eigen::all, order_);
    return ordered.rightCols(size - (floating_ ? 6 : 0));
  }

  SkeletonPtr skeleton_;
  bool floating_;
  Order order_;
  BodyNode* body_ = nullptr;
  std::vector<Arguments> states_;
};

}  // namespace

std::unique_ptr<Peer> load_dart(const Subject& subject) {
  return std::make_unique<Dart>(subject);
}

}  // namespace robcogen::peers
