// RBDL: recursive Newton-Euler, articulated bodies, composite rigid bodies. Fixed bases only: its URDF reader
// represents a floating base by Euler angles, whose second derivatives are not a spatial acceleration.
#include <rbdl/addons/urdfreader/urdfreader.h>
#include <rbdl/rbdl.h>

#include <stdexcept>

#include "libraries.h"
#include "order.h"
#include "urdf_text.h"

namespace robcogen::peers {

namespace {

namespace rbdl = RigidBodyDynamics;

rbdl::Model model_of(const Subject& subject) {
  if (subject.floating_base) throw std::runtime_error("is compared on fixed bases only");
  rbdl::Model model;
  const std::string urdf = dynamics_text(subject.urdf);
  if (!rbdl::Addons::URDFReadFromString(urdf.c_str(), &model, false)) throw std::runtime_error("refuses the URDF");
  model.gravity = subject.gravity;
  return model;
}

unsigned body_of(const rbdl::Model& model, const std::string& link) {
  const unsigned body = model.GetBodyId(link.c_str());
  if (!model.IsBodyId(body)) throw std::runtime_error("finds no link " + link + " in the URDF");
  return body;
}

// RBDL names bodies, not joints.
Order order_of(const rbdl::Model& model, const Subject& subject) {
  const std::string urdf = dynamics_text(subject.urdf);
  Order order;
  for (const std::string& joint : subject.joints)
    order.push_back(model.mJoints[body_of(model, child_link(urdf, joint))].q_index);
  if (order.size() != model.dof_count) throw std::runtime_error("finds other joints in the URDF");
  return order;
}

struct Arguments {
  Eigen::VectorXd q, qd, qdd, tau;
};

class Rbdl : public Peer {
 public:
  explicit Rbdl(const Subject& subject)
      : model_(model_of(subject)),
        order_(order_of(model_, subject)),
        has_link_(!subject.link.empty()),
        body_(has_link_ ? body_of(model_, subject.link) : 0),
        vector_(Eigen::VectorXd::Zero(model_.dof_count)),
        H_(Eigen::MatrixXd::Zero(model_.dof_count, model_.dof_count)),
        J_(Eigen::MatrixXd::Zero(6, model_.dof_count)) {}

  std::string name() const override { return "RBDL"; }

  bool has(Quantity quantity) const override { return !is_of_link(quantity) || has_link_; }

  void prepare(const std::vector<State>& states) override {
    states_.clear();
    for (const State& s : states)
      states_.push_back(
          {to_library(order_, s.q), to_library(order_, s.qd), to_library(order_, s.qdd), to_library(order_, s.tau)});
  }

  void run(Quantity quantity, std::size_t state) override {
    const Arguments& s = states_[state];
    switch (quantity) {
      case Quantity::inverse_dynamics:
        rbdl::InverseDynamics(model_, s.q, s.qd, s.qdd, vector_);
        break;
      case Quantity::forward_dynamics:
        rbdl::ForwardDynamics(model_, s.q, s.qd, s.tau, vector_);
        break;
      case Quantity::inertia_matrix:
        rbdl::CompositeRigidBodyAlgorithm(model_, s.q, H_);
        break;
      case Quantity::jacobian:
        rbdl::CalcPointJacobian6D(model_, s.q, body_, Eigen::Vector3d::Zero(), J_);
        break;
      case Quantity::transform:
        rbdl::UpdateKinematicsCustom(model_, &s.q, nullptr, nullptr);
        pose_.topLeftCorner<3, 3>() = rbdl::CalcBodyWorldOrientation(model_, s.q, body_, false).transpose();
        pose_.topRightCorner<3, 1>() =
            rbdl::CalcBodyToBaseCoordinates(model_, s.q, body_, Eigen::Vector3d::Zero(), false);
        break;
    }
  }

  Eigen::MatrixXd result(Quantity quantity) const override {
    if (quantity == Quantity::jacobian) return J_(Eigen::all, order_);
    if (quantity == Quantity::transform) return pose_;
    if (quantity == Quantity::inertia_matrix) return matrix_from_library(order_, H_);
    return vector_from_library(order_, vector_);
  }

 private:
  rbdl::Model model_;
  Order order_;
  bool has_link_;
  unsigned body_;
  std::vector<Arguments> states_;
  rbdl::Math::VectorNd vector_;  // of the last run
  rbdl::Math::MatrixNd H_, J_;
  Eigen::Matrix4d pose_ = Eigen::Matrix4d::Identity();
};

}  // namespace

std::unique_ptr<Peer> load_rbdl(const Subject& subject) {
  return std::make_unique<Rbdl>(subject);
}

}  // namespace robcogen::peers
