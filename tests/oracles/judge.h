// Other libraries as judges of this project's results for a robot.
#pragma once

#include <functional>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "peers/peer.h"
#include "robcogen/reference/samples.h"
#include "robcogen/reference/subject.h"

namespace robcogen::oracles {

// The quantities to judge.
struct Judged {
  std::string urdf;  // path
  reflection::Robot tables;
  // Follows the conventions of peers::Peer::result; not used for Jacobians. `tau` is for forward dynamics.
  std::function<Eigen::MatrixXd(
      peers::Quantity,
      const reference::Motion<double>&,
      const reference::Vector<double>& tau,
      const reference::Vector<double>& gravity)>
      dynamics;
  // `index` refers to the tables.
  std::function<reference::Matrix<double>(int index, const reference::Vector<double>& q)> jacobian;
  // Names of joints and links in the URDF that are not identifiers, by their names in the tables.
  std::map<std::string, std::string> urdf_names = {};
};

// Robots that a library is known not to represent: an unexpected refusal is a failure, and so is an unexpected success.
struct Refusal {
  std::string library;
  std::string robot;
  std::string reason;  // a part of the message; a comment at the table says why it is justified
};

// Cases in which a library is less accurate than others; a comment at the table says why.
struct Tolerance {
  std::string library;
  std::string robot;
  double relative;
};

struct Decisions {
  std::vector<Refusal> refusals;
  std::vector<Tolerance> tolerances;
};

// Registers a test <robot>.<library> for each library: every quantity that it has, over random states, with standard
// gravity and with another one. `make` is called when the test runs; `decisions` must outlive the tests.
void register_tests(const std::string& robot, const std::function<Judged()>& make, const Decisions& decisions);

inline Eigen::MatrixXd to_eigen(const reference::Matrix<double>& m) {
  return Eigen::Map<const Eigen::MatrixXd>(m.data(), m.rows(), m.cols());
}

// `robot` has the members of reference::CompiledRobot.
template <class Robot>
Judged judged(const std::string& urdf, const reflection::Robot& tables, std::shared_ptr<const Robot> robot) {
  Judged result{urdf, tables, {}, {}};
  result.dynamics = [robot](
                        peers::Quantity quantity, const reference::Motion<double>& motion,
                        const reference::Vector<double>& tau, const reference::Vector<double>& gravity) {
    const reference::Arguments arguments{&gravity, nullptr};
    if (quantity == peers::Quantity::inverse_dynamics)
      return to_eigen(robot->inverse_dynamics_fully_actuated(motion, arguments));
    if (quantity == peers::Quantity::forward_dynamics) return to_eigen(robot->forward_dynamics(motion, tau, arguments));
    return to_eigen(robot->joint_space_inertia(motion.q));
  };
  result.jacobian = [robot](int index, const reference::Vector<double>& q) { return robot->jacobian(index, q); };
  return result;
}

}  // namespace robcogen::oracles
