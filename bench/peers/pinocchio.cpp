// Pinocchio: recursive Newton-Euler, articulated bodies, composite rigid bodies.
#include <cmath>
#include <pinocchio/algorithm/aba.hpp>
#include <pinocchio/algorithm/crba.hpp>
#include <pinocchio/algorithm/frames.hpp>
#include <pinocchio/algorithm/joint-configuration.hpp>
#include <pinocchio/algorithm/kinematics.hpp>
#include <pinocchio/algorithm/rnea.hpp>
#include <pinocchio/parsers/urdf.hpp>
#include <stdexcept>

#include "libraries.h"
#include "order.h"
#include "urdf_text.h"

namespace robcogen::peers {

namespace {

bool is_floating(const pinocchio::JointModel& joint) {
  return joint.shortname() == pinocchio::JointModelFreeFlyer::classname();
}

// A floating joint is added if the URDF has none.
pinocchio::Model model_of(const Subject& subject) {
  const std::string urdf = dynamics_text(subject.urdf);
  pinocchio::Model model;
  if (subject.floating_base && urdf.find("\"floating\"") == std::string::npos)
    pinocchio::urdf::buildModelFromXML(urdf, pinocchio::JointModelFreeFlyer(), model);
  else
    pinocchio::urdf::buildModelFromXML(urdf, model);
  model.gravity.linear(subject.gravity);
  return model;
}

const pinocchio::JointModel& base_joint(const pinocchio::Model& model) {
  for (const pinocchio::JointModel& joint : model.joints) {
    if (is_floating(joint)) return joint;
  }
  throw std::runtime_error("makes no floating base of the URDF");
}

const pinocchio::JointModel& joint_of(const pinocchio::Model& model, const std::string& name) {
  if (!model.existJointName(name)) throw std::runtime_error("finds no joint " + name + " in the URDF");
  return model.joints[model.getJointId(name)];
}

// The velocity of a floating joint is its link's twist, linear first, in the axes of the link.
Order order_of(const pinocchio::Model& model, const Subject& subject) {
  Order order;
  if (subject.floating_base) {
    for (const int row : {3, 4, 5, 0, 1, 2}) order.push_back(base_joint(model).idx_v() + row);
  }
  for (const std::string& name : subject.joints) order.push_back(joint_of(model, name).idx_v());
  if (order.size() != static_cast<std::size_t>(model.nv)) throw std::runtime_error("finds other joints in the URDF");
  return order;
}

struct Arguments {
  Eigen::VectorXd q, v, a, tau;
};

class Pinocchio : public Peer {
 public:
  explicit Pinocchio(const Subject& subject)
      : subject_(subject),
        model_(model_of(subject)),
        data_(model_),
        order_(order_of(model_, subject)),
        J_(Eigen::MatrixXd::Zero(6, model_.nv)) {
    if (!subject.link.empty() && !model_.existBodyName(subject.link))
      throw std::runtime_error("finds no link " + subject.link + " in the URDF");
    if (!subject.link.empty()) link_ = model_.getBodyId(subject.link);
  }

  std::string name() const override { return "Pinocchio"; }

  bool has(Quantity quantity) const override { return !is_of_link(quantity) || !subject_.link.empty(); }

  void prepare(const std::vector<State>& states) override {
    const auto converted = [&](const Eigen::Matrix<double, 6, 1>& base, const Eigen::VectorXd& joints) {
      return to_library(order_, coordinates(subject_.floating_base, base, joints));
    };
    states_.clear();
    for (const State& s : states)
      states_.push_back(
          {positions(s.q), converted(s.base_velocity, s.qd), converted(s.base_acceleration, s.qdd),
           converted(Eigen::Matrix<double, 6, 1>::Zero(), s.tau)});
  }

  void run(Quantity quantity, std::size_t state) override {
    const Arguments& s = states_[state];
    switch (quantity) {
      case Quantity::inverse_dynamics:
        pinocchio::rnea(model_, data_, s.q, s.v, s.a);
        break;
      case Quantity::forward_dynamics:
        pinocchio::aba(model_, data_, s.q, s.v, s.tau);
        break;
      case Quantity::inertia_matrix:
        pinocchio::crba(model_, data_, s.q);
        break;
      case Quantity::jacobian:
        pinocchio::computeFrameJacobian(model_, data_, s.q, link_, pinocchio::LOCAL_WORLD_ALIGNED, J_);
        break;
      case Quantity::transform:
        pinocchio::forwardKinematics(model_, data_, s.q);
        pinocchio::updateFramePlacement(model_, data_, link_);
        break;
    }
  }

  Eigen::MatrixXd result(Quantity quantity) const override {
    switch (quantity) {
      case Quantity::inverse_dynamics:
        return vector_from_library(order_, data_.tau);
      case Quantity::forward_dynamics:
        return vector_from_library(order_, data_.ddq);
      case Quantity::inertia_matrix:  // Pinocchio computes the upper triangle only
        return matrix_from_library(order_, data_.M.selfadjointView<Eigen::Upper>());
      case Quantity::transform:
        return data_.oMf[link_].toHomogeneousMatrix();
      case Quantity::jacobian:
        break;
    }
    Eigen::MatrixXd rows(6, J_.cols());
    rows << J_.bottomRows<3>(), J_.topRows<3>();
    return rows(Eigen::all, order_).rightCols(static_cast<Eigen::Index>(subject_.joints.size()));
  }

 private:
  // The base is at the origin; the position of a joint without limits is its cosine and sine.
  Eigen::VectorXd positions(const Eigen::VectorXd& q) const {
    Eigen::VectorXd result = pinocchio::neutral(model_);
    for (std::size_t j = 0; j < subject_.joints.size(); ++j) {
      const pinocchio::JointModel& joint = joint_of(model_, subject_.joints[j]);
      const double angle = q(static_cast<Eigen::Index>(j));
      if (joint.nq() == 1)
        result(joint.idx_q()) = angle;
      else
        result.segment<2>(joint.idx_q()) << std::cos(angle), std::sin(angle);
    }
    return result;
  }

  Subject subject_;
  pinocchio::Model model_;
  pinocchio::Data data_;
  Order order_;
  pinocchio::FrameIndex link_ = 0;
  std::vector<Arguments> states_;
  Eigen::MatrixXd J_;
};

}  // namespace

std::unique_ptr<Peer> load_pinocchio(const Subject& subject) {
  return std::make_unique<Pinocchio>(subject);
}

}  // namespace robcogen::peers
