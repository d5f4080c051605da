// KDL (Orocos): recursive Newton-Euler on trees; on chains also composite inertia and forward dynamics. KDL does not
// read URDF itself: urdfdom reads it, and the links are converted to segments here.
#include <urdf_model/model.h>
#include <urdf_parser/urdf_parser.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <kdl/chaindynparam.hpp>
#include <kdl/chainfdsolver_recursive_newton_euler.hpp>
#include <kdl/chainfksolverpos_recursive.hpp>
#include <kdl/chainidsolver_recursive_newton_euler.hpp>
#include <kdl/chainjnttojacsolver.hpp>
#include <kdl/tree.hpp>
#include <kdl/treefksolverpos_recursive.hpp>
#include <kdl/treeidsolver_recursive_newton_euler.hpp>
#include <kdl/treejnttojacsolver.hpp>
#include <stdexcept>

#include "libraries.h"
#include "order.h"

namespace robcogen::peers {

namespace {

KDL::Vector vector(const urdf::Vector3& v) {
  return {v.x, v.y, v.z};
}

KDL::Rotation rotation(const urdf::Rotation& r) {
  return KDL::Rotation::Quaternion(r.x, r.y, r.z, r.w);
}

KDL::Joint joint(const urdf::Joint& joint, const KDL::Frame& pose) {
  const KDL::Vector axis = pose.M * vector(joint.axis);
  switch (joint.type) {
    case urdf::Joint::FIXED:
      return KDL::Joint(joint.name, KDL::Joint::Fixed);
    case urdf::Joint::REVOLUTE:
    case urdf::Joint::CONTINUOUS:
      return KDL::Joint(joint.name, pose.p, axis, KDL::Joint::RotAxis);
    case urdf::Joint::PRISMATIC:
      return KDL::Joint(joint.name, pose.p, axis, KDL::Joint::TransAxis);
    default:
      throw std::runtime_error("has no joints of the type of " + joint.name);
  }
}

// URDF's tensor is in axes of the inertial frame, KDL's in those of the link.
KDL::RigidBodyInertia inertia(const urdf::Link& link) {
  if (!link.inertial) return KDL::RigidBodyInertia::Zero();
  const urdf::Inertial& body = *link.inertial;
  const urdf::Rotation& r = body.origin.rotation;
  const Eigen::Matrix3d R = Eigen::Quaterniond(r.w, r.x, r.y, r.z).toRotationMatrix();
  Eigen::Matrix3d I;
  I << body.ixx, body.ixy, body.ixz, body.ixy, body.iyy, body.iyz, body.ixz, body.iyz, body.izz;
  I = R * I * R.transpose();
  return KDL::RigidBodyInertia(
      body.mass, vector(body.origin.position),
      KDL::RotationalInertia(I(0, 0), I(1, 1), I(2, 2), I(0, 1), I(0, 2), I(1, 2)));
}

// Whether a link is a frame on a fixed joint that carries nothing and is not needed. KDL would compute its motion
// nevertheless.
bool is_idle(const urdf::Link& link, const Subject& subject) {
  const bool is_massless = !link.inertial || link.inertial->mass == 0;
  return link.child_links.empty() && is_massless && link.name != subject.link &&
         link.parent_joint->type == urdf::Joint::FIXED;
}

void add_children(const urdf::Link& parent, const Subject& subject, KDL::Tree& tree) {
  for (const urdf::LinkSharedPtr& link : parent.child_links) {
    if (is_idle(*link, subject)) continue;
    const urdf::Pose& origin = link->parent_joint->parent_to_joint_origin_transform;
    const KDL::Frame pose(rotation(origin.rotation), vector(origin.position));
    const KDL::Segment segment(link->name, joint(*link->parent_joint, pose), pose, inertia(*link));
    tree.addSegment(segment, parent.name);
    add_children(*link, subject, tree);
  }
}

KDL::Tree tree_of(const Subject& subject) {
  if (subject.floating_base) throw std::runtime_error("has no floating base");
  const urdf::ModelInterfaceSharedPtr model = urdf::parseURDFFile(subject.urdf);
  if (!model) throw std::runtime_error("urdfdom refuses the URDF");
  KDL::Tree tree(model->getRoot()->name);
  add_children(*model->getRoot(), subject, tree);
  return tree;
}

// The order of the joints that move.
Order order_of(const Subject& subject, const std::vector<std::string>& theirs) {
  if (theirs.size() != subject.joints.size()) throw std::runtime_error("finds other joints in the URDF");
  Order order;
  for (const std::string& name : subject.joints) {
    const auto found = std::find(theirs.begin(), theirs.end(), name);
    if (found == theirs.end()) throw std::runtime_error("finds no joint " + name + " in the URDF");
    order.push_back(found - theirs.begin());
  }
  return order;
}

bool moves(const KDL::Segment& segment) {
  return segment.getJoint().getType() != KDL::Joint::Fixed;
}

KDL::JntArray to_kdl(const Order& order, const Eigen::VectorXd& ours) {
  KDL::JntArray theirs(static_cast<unsigned>(order.size()));
  theirs.data = to_library(order, ours);
  return theirs;
}

// Inputs and outputs of both kinds of solvers.
struct Arguments {
  KDL::JntArray q, qd, qdd, tau;
};

std::vector<Arguments> arguments_of(const Order& order, const std::vector<State>& states) {
  std::vector<Arguments> all;
  for (const State& s : states)
    all.push_back({to_kdl(order, s.q), to_kdl(order, s.qd), to_kdl(order, s.qdd), to_kdl(order, s.tau)});
  return all;
}

// KDL's rows are linear first.
Eigen::MatrixXd jacobian_from_kdl(const Order& order, const KDL::Jacobian& J) {
  Eigen::MatrixXd rows(6, J.data.cols());
  rows << J.data.bottomRows<3>(), J.data.topRows<3>();
  return rows(Eigen::all, order);
}

Eigen::MatrixXd pose_from_kdl(const KDL::Frame& pose) {
  Eigen::Matrix4d X = Eigen::Matrix4d::Identity();
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) X(i, j) = pose.M(i, j);
    X(i, 3) = pose.p(i);
  }
  return X;
}

KDL::Vector gravity_of(const Subject& subject) {
  return {subject.gravity.x(), subject.gravity.y(), subject.gravity.z()};
}

std::vector<std::string> joint_names(const KDL::Tree& tree) {
  std::vector<std::string> names(tree.getNrOfJoints());
  for (const auto& [name, element] : tree.getSegments()) {
    if (moves(element.segment)) names[element.q_nr] = element.segment.getJoint().getName();
  }
  return names;
}

class Tree : public Peer {
 public:
  explicit Tree(const Subject& subject)
      : tree_(tree_of(subject)),
        order_(order_of(subject, joint_names(tree_))),
        link_(subject.link),
        inverse_dynamics_(tree_, gravity_of(subject)),
        jacobian_(tree_),
        pose_of_link_(tree_),
        tau_(tree_.getNrOfJoints()),
        J_(tree_.getNrOfJoints()) {
    if (!link_.empty() && tree_.getSegments().count(link_) == 0)
      throw std::runtime_error("finds no link " + link_ + " in the URDF");
  }

  std::string name() const override { return "KDL"; }

  bool has(Quantity quantity) const override {
    return quantity == Quantity::inverse_dynamics || (is_of_link(quantity) && !link_.empty());
  }

  void prepare(const std::vector<State>& states) override { states_ = arguments_of(order_, states); }

  void run(Quantity quantity, std::size_t state) override {
    const Arguments& s = states_[state];
    if (quantity == Quantity::inverse_dynamics) inverse_dynamics_.CartToJnt(s.q, s.qd, s.qdd, no_forces_, tau_);
    if (quantity == Quantity::jacobian) jacobian_.JntToJac(s.q, J_, link_);
    if (quantity == Quantity::transform) pose_of_link_.JntToCart(s.q, pose_, link_);
  }

  Eigen::MatrixXd result(Quantity quantity) const override {
    if (quantity == Quantity::jacobian) return jacobian_from_kdl(order_, J_);
    if (quantity == Quantity::transform) return pose_from_kdl(pose_);
    return vector_from_library(order_, tau_.data);
  }

 private:
  KDL::Tree tree_;
  Order order_;
  std::string link_;
  KDL::TreeIdSolver_RNE inverse_dynamics_;
  KDL::TreeJntToJacSolver jacobian_;
  KDL::TreeFkSolverPos_recursive pose_of_link_;
  KDL::WrenchMap no_forces_;
  std::vector<Arguments> states_;
  KDL::JntArray tau_;
  KDL::Jacobian J_;
  KDL::Frame pose_;
};

KDL::Chain chain_of(const KDL::Tree& tree) {
  std::string tip = tree.getRootSegment()->first;
  for (auto at = tree.getRootSegment(); !at->second.children.empty(); at = at->second.children.front()) {
    if (at->second.children.size() > 1) throw std::runtime_error("is for robots that are one chain");
    tip = at->second.children.front()->first;
  }
  KDL::Chain chain;
  tree.getChain(tree.getRootSegment()->first, tip, chain);
  return chain;
}

std::vector<std::string> joint_names(const KDL::Chain& chain) {
  std::vector<std::string> names;
  for (const KDL::Segment& segment : chain.segments) {
    if (moves(segment)) names.push_back(segment.getJoint().getName());
  }
  return names;
}

// Number of segments up to and including this one; zero if there is none.
int segments_up_to(const KDL::Chain& chain, const std::string& link) {
  const auto is_it = [&](const KDL::Segment& segment) { return segment.getName() == link; };
  const auto found = std::find_if(chain.segments.begin(), chain.segments.end(), is_it);
  return found == chain.segments.end() ? 0 : static_cast<int>(found - chain.segments.begin()) + 1;
}

class Chain : public Peer {
 public:
  explicit Chain(const Subject& subject)
      : chain_(chain_of(tree_of(subject))),
        order_(order_of(subject, joint_names(chain_))),
        segments_to_link_(segments_up_to(chain_, subject.link)),
        inverse_dynamics_(chain_, gravity_of(subject)),
        forward_dynamics_(chain_, gravity_of(subject)),
        parameters_(chain_, gravity_of(subject)),
        jacobian_(chain_),
        pose_of_link_(chain_),
        no_forces_(chain_.getNrOfSegments(), KDL::Wrench::Zero()),
        result_(chain_.getNrOfJoints()),
        H_(static_cast<int>(chain_.getNrOfJoints())),
        J_(chain_.getNrOfJoints()) {}

  std::string name() const override { return "KDL chain"; }

  bool has(Quantity quantity) const override { return !is_of_link(quantity) || segments_to_link_ > 0; }

  void prepare(const std::vector<State>& states) override { states_ = arguments_of(order_, states); }

  void run(Quantity quantity, std::size_t state) override {
    const Arguments& s = states_[state];
    switch (quantity) {
      case Quantity::inverse_dynamics:
        inverse_dynamics_.CartToJnt(s.q, s.qd, s.qdd, no_forces_, result_);
        break;
      case Quantity::forward_dynamics:
        forward_dynamics_.CartToJnt(s.q, s.qd, s.tau, no_forces_, result_);
        break;
      case Quantity::inertia_matrix:
        parameters_.JntToMass(s.q, H_);
        break;
      case Quantity::jacobian:
        jacobian_.JntToJac(s.q, J_, segments_to_link_);
        break;
      case Quantity::transform:
        pose_of_link_.JntToCart(s.q, pose_, segments_to_link_);
        break;
    }
  }

  Eigen::MatrixXd result(Quantity quantity) const override {
    if (quantity == Quantity::jacobian) return jacobian_from_kdl(order_, J_);
    if (quantity == Quantity::transform) return pose_from_kdl(pose_);
    if (quantity == Quantity::inertia_matrix) return matrix_from_library(order_, H_.data);
    return vector_from_library(order_, result_.data);
  }

 private:
  KDL::Chain chain_;
  Order order_;
  int segments_to_link_;
  KDL::ChainIdSolver_RNE inverse_dynamics_;
  KDL::ChainFdSolver_RNE forward_dynamics_;
  KDL::ChainDynParam parameters_;
  KDL::ChainJntToJacSolver jacobian_;
  KDL::ChainFkSolverPos_recursive pose_of_link_;
  KDL::Wrenches no_forces_;
  std::vector<Arguments> states_;
  KDL::JntArray result_;  // of either dynamics
  KDL::JntSpaceInertiaMatrix H_;
  KDL::Jacobian J_;
  KDL::Frame pose_;
};

}  // namespace

std::unique_ptr<Peer> load_kdl_tree(const Subject& subject) {
  return std::make_unique<Tree>(subject);
}

std::unique_ptr<Peer> load_kdl_chain(const Subject& subject) {
  return std::make_unique<Chain>(subject);
}

}  // namespace robcogen::peers
