// Searches the branches of generated inverse kinematics, and the positions of a redundant joint or a swivel angle, for
// the plugin for MoveIt. It does not depend on ROS.
//
// A solver is a struct over one function of the library, which robcogen_add_ros_plugins writes:
//
//     struct Solver {
//       static constexpr const char *kLeft = "fr_base", *kRight = "tool", *kGiven = "";
//       static constexpr auto kTask = robcogen::ros::Task::pose;
//       static constexpr const auto& kJoints = arm::inverse_kinematics::fr_base_X_tool_joints;
//       template <class... A>
//       static auto branches(const A&... arguments) { return arm::inverse_kinematics::fr_base_X_tool(arguments...); }
//     };
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

#include "robcogen/inverse_kinematics.h"

namespace robcogen::ros {

// What the function inverts: the pose, also with the joint kGiven given, the pose with a swivel angle, the position of
// the origin, or that and the direction of the z axis.
enum class Task { pose, swivel, point, axis };

template <class JointState, std::size_t kDof>
struct Request {
  Eigen::Isometry3d X;  // of the right frame in the left one
  JointState seed;
  std::array<JointLimits, kDof> limits;
  int given = -1;            // the joint of kGiven
  double step = 0.1;         // of the given joint (rad, m) or the swivel angle
  bool keeps_given = false;  // only the given position or swivel angle of the seed is tried
  bool approximate = false;  // where the seed's branches do not exist, one of least misfit is a result
};

enum class Outcome { found, none, stopped };

namespace inverse_kinematics_detail {

template <class Solver, class JointState>
auto branches(const Eigen::Isometry3d& X, [[maybe_unused]] double swivel, const JointState& reference) noexcept {
  if constexpr (Solver::kTask == Task::swivel)
    return Solver::branches(X.matrix(), Eigen::Matrix<double, 1, 1>(swivel), reference);
  else if constexpr (Solver::kTask == Task::point)
    return Solver::branches(Eigen::Vector3d(X.translation()), reference);
  else
    return Solver::branches(X.matrix(), reference);
}

}  // namespace inverse_kinematics_detail

// Calls accept(q) with positions within limits that solve the request, nearest to the seed first for each position of
// the redundancy, from that of the seed away, until accept returns true; stops(): whether to give up.
template <class Solver, class Types, class JointState, std::size_t kDof, class Accept, class Stops>
Outcome search(const Types& types, const Request<JointState, kDof>& request, const Accept& accept, const Stops& stops) {
  namespace detail = inverse_kinematics_detail;
  constexpr double kHalfTurn = 3.14159265358979323846;
  const bool is_given = request.given >= 0;
  double center = 0;
  JointLimits range;
  if (is_given) {
    center = request.seed[request.given];
    range = request.limits[static_cast<std::size_t>(request.given)];
  } else if constexpr (Solver::kTask == Task::swivel) {
    center = Solver::redundancy(request.seed)[0];
  }
  // Without limits, a turn is all there is to try.
  range.lower = std::max(range.lower, center - kHalfTurn);
  range.upper = std::min(range.upper, center + kHalfTurn);
  const bool scans = (is_given || Solver::kTask == Task::swivel) && !request.keeps_given && request.step > 0;
  const double farthest = scans ? std::max(range.upper - center, center - range.lower) : 0;
  const int steps = static_cast<int>(std::floor(std::max(farthest, 0.0) / request.step));

  const auto try_branches = [&](double value, bool takes_least) {
    JointState reference = request.seed;
    if (is_given) reference[request.given] = value;
    auto all = detail::branches<Solver>(request.X, value, reference);
    const double largest_misfit = takes_least ? double(all.misfit.minCoeff()) : kLargestMisfit<double>;
    for (Eigen::Index tries = all.misfit.size(); tries > 0; --tries) {
      const auto best = nearest_branch(all, Solver::kJoints, types, request.limits, reference, largest_misfit);
      if (best.branch < 0) return false;
      if (accept(best.q)) return true;
      all.misfit[best.branch] = std::numeric_limits<double>::infinity();
    }
    return false;
  };
  // center, center + step, center - step, center + 2 step, …
  for (int k = 0; k <= 2 * steps; ++k) {
    if (k > 0 && stops()) return Outcome::stopped;
    const double value = center + (k % 2 == 1 ? 1 : -1) * ((k + 1) / 2) * request.step;
    constexpr double kRounding = 1e-12;  // of a seed at its limit
    if (value < range.lower - kRounding || value > range.upper + kRounding) continue;
    if (try_branches(value, false)) return Outcome::found;
  }
  return request.approximate && try_branches(center, true) ? Outcome::found : Outcome::none;
}

}  // namespace robcogen::ros
