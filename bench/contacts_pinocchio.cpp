// Forward dynamics of the quadruped on its feet, generated and by Pinocchio: the same result, then the time of a call.
//
//     contacts_pinocchio <URDF>
//
// Feet are rigid point contacts that do not accelerate. Pinocchio solves for their forces with its sparse Cholesky
// factor of the whole system, in one step without proximal terms. Exit status 1: the results differ.
#include <pinocchio/algorithm/constrained-dynamics.hpp>
#include <pinocchio/algorithm/joint-configuration.hpp>
#include <pinocchio/parsers/urdf.hpp>

#include <array>
#include <optional>
#include <stdexcept>
#include <string>

#include "contacts.h"

namespace robcogen::bench {
namespace {

template <class T>
using Aligned = std::vector<T, Eigen::aligned_allocator<T>>;

class Comparison {
 public:
  Comparison(const std::string& urdf, const Active& active) : active_(active) {
    pinocchio::urdf::buildModel(urdf, model_);
    data_ = pinocchio::Data(model_);
    std::vector<const char*> names;  // after the universe and the floating joint
    for (std::size_t j = 2; j < model_.names.size(); ++j) names.push_back(model_.names[j].c_str());
    const auto match = match_joints(quadruped::kJointNames, names);
    if (!match.order) throw std::runtime_error(std::string(match.name));
    order_.emplace(*match.order);
    constexpr std::array kFeet = {"fr_LF_foot", "fr_RF_foot", "fr_LH_foot", "fr_RH_foot"};
    for (int k = 0; k < 4; ++k) {
      if (active[k] == 0) continue;
      const char* name = kFeet[static_cast<std::size_t>(k)];
      if (!model_.existFrame(name)) throw std::runtime_error(std::string("finds no link ") + name + " in the URDF");
      const pinocchio::Frame& foot = model_.frames[model_.getFrameId(name)];
      contacts_.emplace_back(
          pinocchio::CONTACT_3D, model_, foot.parentJoint, foot.placement, pinocchio::LOCAL_WORLD_ALIGNED);
      contact_data_.emplace_back(contacts_.back());
    }
    pinocchio::initConstraintDynamics(model_, data_, contacts_);
    q_.resize(model_.nq);
  }

  Call call(std::mt19937_64& engine) const { return random_call(engine); }

  void prepare_timing() {}

  void run_theirs(const Call& c) {
    Eigen::Matrix<double, 7 + kDof, 1> plain;
    to_pinocchio(c.state, *order_, plain.data(), v_.data());
    q_.head<7>() = plain.head<7>();
    // The position of a joint without limits is its cosine and sine.
    for (std::size_t j = 2; j < model_.joints.size(); ++j) {
      const pinocchio::JointModel& joint = model_.joints[j];
      const double angle = plain[7 + static_cast<int>(j) - 2];
      if (joint.nq() == 1)
        q_[joint.idx_q()] = angle;
      else
        q_.segment<2>(joint.idx_q()) << std::cos(angle), std::sin(angle);
    }
    order_->to(c.tau, tau_.data() + 6);
    pinocchio::constraintDynamics(model_, data_, q_, v_, tau_, contacts_, contact_data_, settings_);
  }

  // The difference of the accelerations, relative to the largest.
  double difference(const Call& c) {
    const auto ours = run_generated(c, active_);
    run_theirs(c);
    Eigen::Matrix<double, 6 + kDof, 1> expected;
    expected.head<6>() << ours.base_acceleration.linear(), ours.base_acceleration.angular();
    order_->to(ours.qdd, expected.data() + 6);
    return (data_.ddq - expected).cwiseAbs().maxCoeff() / (1 + expected.cwiseAbs().maxCoeff());
  }

 private:
  Active active_;
  pinocchio::Model model_;
  pinocchio::Data data_{model_};
  std::optional<JointOrder<kDof>> order_;
  Aligned<pinocchio::RigidConstraintModel> contacts_;
  Aligned<pinocchio::RigidConstraintData> contact_data_;
  pinocchio::ProximalSettings settings_;
  Eigen::VectorXd q_, v_ = Eigen::VectorXd::Zero(6 + kDof), tau_ = Eigen::VectorXd::Zero(6 + kDof);
};

}  // namespace
}  // namespace robcogen::bench

int main(int argc, char** argv) {
  using namespace robcogen::bench;
  return compare<Comparison>(
      "contacts_pinocchio", "Pinocchio", {Active(0, 1, 0, 0), Active(1, 0, 0, 1), Active(1, 1, 1, 1)}, argc, argv);
}
