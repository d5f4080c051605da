// A kinematics plugin for MoveIt, over the inverse kinematics of a generated robot. robcogen_add_ros_plugins makes one.
//
// The solver of the group's base and tip is chosen at initialisation; both may be any links fixed to its frames.
// Closed forms find all solutions: those within the limits of the robot model and the consistency limits are offered,
// nearest to the seed first. Redundant arms try positions of the given joint, or swivel angles, at the resolution of
// the search.
#pragma once

#if __has_include(<moveit/kinematics_base/kinematics_base.hpp>)
#include <moveit/kinematics_base/kinematics_base.hpp>
#else
#include <moveit/kinematics_base/kinematics_base.h>
#endif
#if __has_include(<moveit/robot_model/robot_model.hpp>)
#include <moveit/robot_model/robot_model.hpp>
#else
#include <moveit/robot_model/robot_model.h>
#endif

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <limits>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "robcogen/ros/chain.h"
#include "robcogen/ros/description.h"
#include "robcogen/ros/inverse_kinematics.h"
#include "robcogen/ros/log.h"

namespace robcogen::ros {

// Any number of threads may call the functions after initialisation. They allocate what they return, if the caller's
// vectors have no capacity yet.
template <class R, class... Solvers>
class MoveItKinematics : public kinematics::KinematicsBase {
 public:
  using JointState = typename R::JointState;
  using Pose = geometry_msgs::msg::Pose;
  using ErrorCode = moveit_msgs::msg::MoveItErrorCodes;
  using Options = kinematics::KinematicsQueryOptions;
  using Vector = std::vector<double>;

  // `types` is the library's kJointTypes.
  template <class Types>
  explicit MoveItKinematics(const reflection::Robot& tables, const Types& types) : tables_(tables) {
    std::copy_n(types.begin(), kDof, types_.begin());
  }

  using KinematicsBase::getPositionIK;
  using KinematicsBase::initialize;
  using KinematicsBase::searchPositionIK;

  bool initialize(
      const rclcpp::Node::SharedPtr& node,
      const moveit::core::RobotModel& robot_model,
      const std::string& group_name,
      const std::string& base_frame,
      const std::vector<std::string>& tip_frames,
      double search_discretization) override {
    is_initialized_ = false;
    node_ = node;
    storeValues(robot_model, group_name, base_frame, tip_frames, search_discretization);
    if (tip_frames_.size() != 1)
      return refuse(
          "group '" + group_name + "' has " + std::to_string(tip_frames_.size()) + " tips; this solver is for one");
    if (robot_model.getURDF()) {
      const std::string difference = difference_of_poses(tables_, *robot_model.getURDF(), R());
      if (!difference.empty()) return refuse(difference);
    }
    const std::string& tip = tip_frames_.front();
    std::string problem = chain_.select(tables_, base_frame_, tip, {});
    if (problem.empty()) problem = choose_solver(tip);
    if (problem.empty()) problem = choose_order();
    if (problem.empty()) problem = read_model(robot_model, group_name);
    if (!problem.empty()) return refuse("group '" + group_name + "': " + problem);
    step_ = search_discretization > 0 ? search_discretization : DEFAULT_SEARCH_DISCRETIZATION;
    if (is_redundant_) {
      if (given_ >= 0) setRedundantJoints(std::vector<unsigned int>{static_cast<unsigned int>(place_of(given_))});
      setSearchDiscretization(step_);
      supported_methods_ = {
          kinematics::DiscretizationMethods::NO_DISCRETIZATION, kinematics::DiscretizationMethods::ALL_DISCRETIZED};
    }
    is_initialized_ = true;
    return true;
  }

  const std::vector<std::string>& getJointNames() const override { return joint_names_; }
  const std::vector<std::string>& getLinkNames() const override { return tip_frames_; }

  bool getPositionFK(const std::vector<std::string>& link_names, const Vector& joint_angles, std::vector<Pose>& poses)
      const override {
    if (!is_initialized_) return refuse("the solver is not initialised");
    if (joint_angles.size() != joint_names_.size()) return refuse(size_of("joint_angles", joint_angles));
    const JointState q = chain_.positions(joint_angles);
    poses.resize(link_names.size());
    for (std::size_t i = 0; i < link_names.size(); ++i) {
      const int link = chain_.find(link_names[i]);
      if (link < 0) return refuse(chain_.no_link(link_names[i]));
      const Eigen::Isometry3d X = chain_.pose(q, link);
      const Eigen::Quaterniond turn(X.linear());
      poses[i].position.x = X.translation().x(), poses[i].position.y = X.translation().y(),
      poses[i].position.z = X.translation().z();
      poses[i].orientation.x = turn.x(), poses[i].orientation.y = turn.y(), poses[i].orientation.z = turn.z(),
      poses[i].orientation.w = turn.w();
    }
    return true;
  }

  // The solution nearest to the seed; other positions of the redundancy are tried only where that of the seed has none.
  bool getPositionIK(
      const Pose& ik_pose,
      const Vector& ik_seed_state,
      Vector& solution,
      ErrorCode& error_code,
      const Options& options = Options()) const override {
    return solve(ik_pose, ik_seed_state, kNoTimeout, nullptr, solution, nullptr, error_code, options);
  }

  // All solutions: those at the seed's position of the redundancy, or with ALL_DISCRETIZED, at all of its positions.
  bool getPositionIK(
      const std::vector<Pose>& ik_poses,
      const Vector& ik_seed_state,
      std::vector<Vector>& solutions,
      kinematics::KinematicsResult& result,
      const Options& options) const override {
    using namespace kinematics::KinematicErrors;  // NOLINT(google-build-using-namespace): names of the interface
    solutions.clear();
    result.solution_percentage = 0;
    const auto fail = [&](kinematics::KinematicError error) {
      result.kinematic_error = error;
      return false;
    };
    if (!is_initialized_) return fail(SOLVER_NOT_ACTIVE);
    if (ik_poses.empty()) return fail(EMPTY_TIP_POSES);
    if (ik_poses.size() != 1) return fail(MULTIPLE_TIPS_NOT_SUPPORTED);
    const bool scans = options.discretization_method == kinematics::DiscretizationMethods::ALL_DISCRETIZED;
    if (std::find(supported_methods_.begin(), supported_methods_.end(), options.discretization_method) ==
        supported_methods_.end())
      return fail(UNSUPORTED_DISCRETIZATION_REQUESTED);
    auto request = request_for(ik_poses.front(), ik_seed_state, nullptr, options);
    if (!request) return fail(NO_SOLUTION);
    request->keeps_given = !scans || options.lock_redundant_joints;
    run(
        *request,
        [&](const JointState& q) {
          solutions.emplace_back();
          write(q, solutions.back());
          return false;
        },
        [] { return false; });
    if (solutions.empty()) return fail(NO_SOLUTION);
    result.kinematic_error = OK;
    result.solution_percentage = 1;
    return true;
  }

  bool searchPositionIK(
      const Pose& ik_pose,
      const Vector& ik_seed_state,
      double timeout,
      Vector& solution,
      ErrorCode& error_code,
      const Options& options = Options()) const override {
    return solve(ik_pose, ik_seed_state, timeout, nullptr, solution, nullptr, error_code, options);
  }
  bool searchPositionIK(
      const Pose& ik_pose,
      const Vector& ik_seed_state,
      double timeout,
      const Vector& consistency_limits,
      Vector& solution,
      ErrorCode& error_code,
      const Options& options = Options()) const override {
    return solve(ik_pose, ik_seed_state, timeout, &consistency_limits, solution, nullptr, error_code, options);
  }
  bool searchPositionIK(
      const Pose& ik_pose,
      const Vector& ik_seed_state,
      double timeout,
      Vector& solution,
      const IKCallbackFn& solution_callback,
      ErrorCode& error_code,
      const Options& options = Options()) const override {
    return solve(ik_pose, ik_seed_state, timeout, nullptr, solution, &solution_callback, error_code, options);
  }
  bool searchPositionIK(
      const Pose& ik_pose,
      const Vector& ik_seed_state,
      double timeout,
      const Vector& consistency_limits,
      Vector& solution,
      const IKCallbackFn& solution_callback,
      ErrorCode& error_code,
      const Options& options = Options()) const override {
    return solve(
        ik_pose, ik_seed_state, timeout, &consistency_limits, solution, &solution_callback, error_code, options);
  }

 private:
  static constexpr std::size_t kDof = static_cast<std::size_t>(R::kDof);
  static constexpr double kNoTimeout = std::numeric_limits<double>::infinity();
  using SolverRequest = Request<JointState, kDof>;

  const reflection::Robot& tables_;
  std::array<JointType, kDof> types_{};
  Chain<R> chain_;
  std::vector<std::string> joint_names_;
  std::array<JointLimits, kDof> limits_{};
  std::size_t solver_ = 0;
  Eigen::Isometry3d before_ = Eigen::Isometry3d::Identity();  // the base in the solver's left frame
  Eigen::Isometry3d behind_ = Eigen::Isometry3d::Identity();  // the solver's right frame in the tip
  int given_ = -1;
  double step_ = 0.1;
  bool is_redundant_ = false, is_initialized_ = false;

  bool refuse(const std::string& text) const { return ros::refuse(tables_.name, text); }
  std::string size_of(const char* name, const Vector& vector) const {
    return wrong_size(name, static_cast<long long>(vector.size()), static_cast<long long>(joint_names_.size()));
  }
  int place_of(int joint) const {
    const auto& joints = chain_.joints();
    return static_cast<int>(std::find(joints.begin(), joints.end(), joint) - joints.begin());
  }

  // Calls visit(solver, index) for each solver.
  template <class Visit>
  static void for_each_solver(const Visit& visit) {
    std::size_t index = 0;
    (visit(Solvers(), index++), ...);
  }

  // Chooses the solver whose frames are fixed to the base and the tip.
  std::string choose_solver(const std::string& tip) {
    const int base_index = base_frame_.empty() ? -1 : find_frame(tables_, base_frame_),
              tip_index = find_frame(tables_, tip);
    bool is_found = false;
    std::string known;
    for_each_solver([&](auto solver, std::size_t index) {
      using Solver = decltype(solver);
      known += (known.empty() ? "" : ", ") + std::string(Solver::kLeft) + ":" + Solver::kRight;
      const int left = find_frame(tables_, Solver::kLeft), right = find_frame(tables_, Solver::kRight);
      const int base_link = base_index < 0 ? 0 : tables_.frames[base_index].link;
      if (is_found || left < 0 || right < 0 || tables_.frames[left].link != base_link ||
          tables_.frames[right].link != tables_.frames[tip_index].link)
        return;
      const Eigen::Isometry3d base =
          base_index < 0 ? Eigen::Isometry3d::Identity() : pose_in_link(tables_.frames[base_index]);
      const Eigen::Isometry3d behind =
          pose_in_link(tables_.frames[tip_index]).inverse(Eigen::Isometry) * pose_in_link(tables_.frames[right]);
      // Without the orientation, the position of another point is not known.
      if (Solver::kTask == Task::point && !behind.translation().isZero(1e-9)) return;
      if (Solver::kTask == Task::axis && !behind.isApprox(Eigen::Isometry3d::Identity(), 1e-9)) return;
      is_found = true;
      solver_ = index;
      before_ = pose_in_link(tables_.frames[left]).inverse(Eigen::Isometry) * base;
      behind_ = behind;
      given_ = -1;
      for (int j = 0; j < R::kDof; ++j)
        if (is_name_of(tables_.joints[j].name, Solver::kGiven)) given_ = j;
      is_redundant_ = given_ >= 0 || Solver::kTask == Task::swivel;
    });
    if (is_found) return "";
    return "the library has no inverse kinematics from '" + base_frame_ + "' to '" + tip + "'; it has " + known +
           " (INVERSE_KINEMATICS of robcogen_add_robot)";
  }

  // Checks that the solver has the joints of the chain.
  std::string choose_order() const {
    std::string problem;
    for_each_solver([&](auto solver, std::size_t index) {
      if (index != solver_) return;
      for (const int j : chain_.joints()) {
        bool has = j == given_;
        for (const auto joint : decltype(solver)::kJoints) has = has || static_cast<int>(joint) == j;
        if (!has) problem = "its inverse kinematics does not move joint '" + std::string(tables_.joints[j].name) + "'";
      }
    });
    return problem;
  }

  // Sets names and limits from those of the model.
  std::string read_model(const moveit::core::RobotModel& model, const std::string& group_name) {
    const moveit::core::JointModelGroup* group = model.getJointModelGroup(group_name);
    if (!group) return "the robot model has no such group";
    joint_names_.clear();
    limits_ = {};
    for (const int j : chain_.joints()) {
      const auto& names = group->getVariableNames();
      const auto at = std::find_if(names.begin(), names.end(), [&](const std::string& name) {
        return is_name_of(tables_.joints[j].name, name);
      });
      if (at == names.end()) return "it does not have joint '" + std::string(tables_.joints[j].name) + "' of the chain";
      joint_names_.push_back(*at);
      const moveit::core::VariableBounds& bounds = model.getVariableBounds(*at);
      JointLimits& limits = limits_[static_cast<std::size_t>(j)];
      if (bounds.position_bounded_) limits.lower = bounds.min_position_, limits.upper = bounds.max_position_;
    }
    return "";
  }

  void write(const JointState& q, Vector& solution) const {
    solution.resize(joint_names_.size());
    for (std::size_t k = 0; k < solution.size(); ++k) solution[k] = q[chain_.joints()[k]];
  }

  // A request within the limits and the consistency limits; nothing, with a message, if the arguments do not fit.
  std::optional<SolverRequest> request_for(
      const Pose& pose,
      const Vector& seed,
      const Vector* consistency,
      const Options& options) const {
    const auto fail = [&](const std::string& text) {
      refuse(text);
      return std::optional<SolverRequest>();
    };
    if (!is_initialized_) return fail("the solver is not initialised");
    if (seed.size() != joint_names_.size()) return fail(size_of("ik_seed_state", seed));
    if (consistency && !consistency->empty() && consistency->size() != joint_names_.size())
      return fail(size_of("consistency_limits", *consistency));
    const auto& p = pose.position;
    const auto& o = pose.orientation;
    const Eigen::Quaterniond turn(o.w, o.x, o.y, o.z);
    const Eigen::Vector3d position(p.x, p.y, p.z);
    if (!(turn.norm() > 0) || !std::isfinite(turn.norm()) || !position.allFinite())
      return fail("the pose has a quaternion that is zero, or is not a number");
    Eigen::Isometry3d X = Eigen::Isometry3d::Identity();
    X.linear() = turn.normalized().toRotationMatrix();
    X.translation() = position;
    SolverRequest request{before_ * X * behind_, chain_.positions(seed), limits_};
    if (!request.seed.allFinite()) return fail("ik_seed_state has an element that is not a number");
    for (std::size_t k = 0; consistency && k < consistency->size(); ++k) {
      JointLimits& limits = request.limits[static_cast<std::size_t>(chain_.joints()[k])];
      limits.lower = std::max(limits.lower, seed[k] - (*consistency)[k]);
      limits.upper = std::min(limits.upper, seed[k] + (*consistency)[k]);
    }
    request.given = given_;
    const double step = given_ < 0 ? 0 : getSearchDiscretization(place_of(given_));
    request.step = step > 0 ? step : step_;
    request.keeps_given = options.lock_redundant_joints;
    request.approximate = options.return_approximate_solution;
    return request;
  }

  template <class Accept, class Stops>
  Outcome run(const SolverRequest& request, const Accept& accept, const Stops& stops) const {
    Outcome outcome = Outcome::none;
    for_each_solver([&](auto solver, std::size_t index) {
      if (index == solver_) outcome = search<decltype(solver)>(types_, request, accept, stops);
    });
    return outcome;
  }

  bool solve(
      const Pose& pose,
      const Vector& seed,
      double timeout,
      const Vector* consistency,
      Vector& solution,
      const IKCallbackFn* callback,
      ErrorCode& error_code,
      const Options& options) const {
    using Clock = std::chrono::steady_clock;
    const auto start = Clock::now();
    error_code.val = ErrorCode::NO_IK_SOLUTION;
    const auto request = request_for(pose, seed, consistency, options);
    if (!request) return false;
    const Outcome outcome = run(
        *request,
        [&](const JointState& q) {
          write(q, solution);
          error_code.val = ErrorCode::SUCCESS;
          if (callback && *callback) (*callback)(pose, solution, error_code);
          return error_code.val == ErrorCode::SUCCESS;
        },
        [&] { return std::chrono::duration<double>(Clock::now() - start).count() > timeout; });
    if (outcome == Outcome::found) return true;
    error_code.val = outcome == Outcome::stopped ? ErrorCode::TIMED_OUT : ErrorCode::NO_IK_SOLUTION;
    return false;
  }
};

}  // namespace robcogen::ros
