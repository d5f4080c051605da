#include "same_physics.h"

#include <Eigen/Core>
#include <algorithm>
#include <stdexcept>

#include "interpreted_robot.h"
#include "robcogen/reference/samples.h"

namespace robcogen::test {
namespace {

using model::Frame;
using model::KinematicTree;
using numeric::InterpretedRobot;
using State = InterpretedRobot::State;
using Vector = reference::Vector<double>;

Eigen::MatrixXd eigen(const reference::Matrix<double>& m) {
  return Eigen::Map<const Eigen::MatrixXd>(m.data(), m.rows(), m.cols());
}

// Coordinate k of one robot is coordinate order[k] of the other.
std::vector<int> joint_order(const KinematicTree& found, const KinematicTree& expected) {
  if (found.dof() != expected.dof() || found.floating_base != expected.floating_base)
    throw std::runtime_error("the robots differ in their joints");
  const std::vector<int> expected_coordinates = expected.coordinates();
  std::vector<int> order;
  for (const int j : found.coordinates()) {
    const std::string& name = found.joints[static_cast<std::size_t>(j)].name;
    const std::optional<int> other = expected.find_joint(name);
    const auto place = std::find(expected_coordinates.begin(), expected_coordinates.end(), other.value_or(-1));
    if (place == expected_coordinates.end()) throw std::runtime_error("no independent joint is called " + name);
    order.push_back(static_cast<int>(place - expected_coordinates.begin()));
  }
  return order;
}

Vector reordered(const Vector& v, const std::vector<int>& order) {
  Vector result(static_cast<int>(order.size()));
  for (std::size_t k = 0; k < order.size(); ++k) result(static_cast<int>(k)) = v(order[k]);
  return result;
}

State reordered(const State& state, const std::vector<int>& order) {
  return {
      reordered(state.q, order), reordered(state.qd, order), reordered(state.qdd, order), state.base_velocity,
      state.base_acceleration};
}

// Permutes the rows of generalised coordinates: the base's six come before the joints'.
Eigen::PermutationMatrix<Eigen::Dynamic> coordinates(const std::vector<int>& order, bool floating) {
  const int base = floating ? 6 : 0;
  Eigen::PermutationMatrix<Eigen::Dynamic> permutation(base + static_cast<int>(order.size()));
  for (int k = 0; k < base; ++k) permutation.indices()[k] = k;
  for (std::size_t k = 0; k < order.size(); ++k) permutation.indices()[base + static_cast<int>(k)] = base + order[k];
  return permutation;
}

double relative(const Eigen::VectorXd& difference, const Eigen::VectorXd& size) {
  if (size.size() == 0 || difference.isZero(0)) return 0;
  return difference.norm() / size.norm();
}

// Also raises the value to NaN.
void raise(double& worst, double value) {
  if (!(value <= worst)) worst = value;
}

void compare_poses(
    const KinematicTree& found,
    const KinematicTree& expected,
    const Vector& found_q,
    const Vector& expected_q,
    double& worst) {
  const reference::Tables found_tables = numeric::reference_tables(found);
  const reference::Tables expected_tables = numeric::reference_tables(expected);
  const auto pose = [](const KinematicTree& tree, const reference::Tables& tables, const Vector& q,
                       const Frame& frame) {
    return eigen(reference::transform(tables.robot(), q, 0, numeric::frame_index(tree, frame)));
  };
  for (const std::string& name : named_frames(expected)) {
    const Eigen::MatrixXd A = pose(found, found_tables, found_q, named_frame(found, name));
    const Eigen::MatrixXd B = pose(expected, expected_tables, expected_q, named_frame(expected, name));
    raise(worst, (A - B).cwiseAbs().maxCoeff() / B.cwiseAbs().maxCoeff());
  }
}

}  // namespace

std::vector<std::string> named_frames(const KinematicTree& tree) {
  std::vector<std::string> names;
  for (const model::Link& link : tree.links) names.push_back(link.name);
  for (const model::UserFrame& frame : tree.user_frames) {
    if (!frame.hidden && !tree.find_link(frame.name)) names.push_back(frame.name);
  }
  return names;
}

Frame named_frame(const KinematicTree& tree, const std::string& name) {
  for (const std::string& candidate : {name, model::implicit_frame_name(name)}) {
    if (const std::optional<Frame> frame = tree.find_frame(candidate)) return *frame;
  }
  throw std::runtime_error("no frame is called " + name);
}

Differences differences(const KinematicTree& found, const KinematicTree& expected, std::uint64_t seed, int states) {
  const std::vector<int> order = joint_order(found, expected);
  const auto to_expected = coordinates(order, expected.floating_base);
  const InterpretedRobot first(found, {}, {}), second(expected, {}, {});
  Differences worst;
  std::mt19937_64 engine(seed);
  for (int i = 0; i < states; ++i) {
    const reference::Sample sample = reference::random_sample(engine, second.tables());
    const State& state = sample.motion;
    const State found_state = reordered(state, order);
    compare_poses(found, expected, found_state.q, state.q, worst.poses);
    if ((found.dof() == 0 && !found.floating_base) || expected.inertia_defects.no_inertia) continue;

    const Eigen::MatrixXd H = eigen(second.joint_space_inertia(state.q));
    const Eigen::MatrixXd found_H =
        to_expected * eigen(first.joint_space_inertia(found_state.q)) * to_expected.transpose();
    // A joint that moves no inertia is compared relative to the largest inertia that another joint moves.
    const Eigen::VectorXd weight = (H.diagonal().array() > 0).select(H.diagonal(), H.diagonal().maxCoeff()).cwiseSqrt();
    const Eigen::MatrixXd size = weight * weight.transpose();
    raise(worst.inertia_matrix, (found_H - H).cwiseQuotient(size).cwiseAbs().maxCoeff());

    const reference::Arguments load{&sample.gravity, nullptr};
    const Eigen::VectorXd tau = eigen(second.inverse_dynamics_fully_actuated(state, load));
    const Eigen::VectorXd found_tau = to_expected * eigen(first.inverse_dynamics_fully_actuated(found_state, load));
    raise(worst.inverse_dynamics, relative((found_tau - tau).cwiseQuotient(weight), tau.cwiseQuotient(weight)));

    if (expected.inertia_defects.is_singular()) continue;
    const Vector force = reference::uniform_vector(engine, expected.dof(), 10);
    const Eigen::VectorXd motion = eigen(second.forward_dynamics(state, force, load));
    const Eigen::VectorXd found_motion =
        to_expected * eigen(first.forward_dynamics(found_state, reordered(force, order), load));
    raise(worst.forward_dynamics, relative((found_motion - motion).cwiseProduct(weight), motion.cwiseProduct(weight)));
  }
  return worst;
}

}  // namespace robcogen::test
