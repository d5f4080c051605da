// Stand-in for the class of kinematics solvers of MoveIt, with the functions that its documentation lists.
#pragma once

#include <functional>
#include <map>
#include <moveit/robot_model/robot_model.hpp>
#include <rclcpp/node.hpp>
#include <string>
#include <vector>

namespace geometry_msgs::msg {
struct Pose {
  struct {
    double x = 0, y = 0, z = 0;
  } position;
  struct {
    double x = 0, y = 0, z = 0, w = 1;
  } orientation;
};
}  // namespace geometry_msgs::msg

namespace moveit_msgs::msg {
struct MoveItErrorCodes {
  static constexpr int SUCCESS = 1, TIMED_OUT = -6, NO_IK_SOLUTION = -31;
  int val = 0;
};
}  // namespace moveit_msgs::msg

namespace kinematics {

namespace DiscretizationMethods {
enum DiscretizationMethod { NO_DISCRETIZATION = 1, ALL_DISCRETIZED, SOME_DISCRETIZED };
}
namespace KinematicErrors {
enum KinematicError {
  OK = 1,
  UNSUPORTED_DISCRETIZATION_REQUESTED,
  DISCRETIZATION_NOT_INITIALIZED,
  MULTIPLE_TIPS_NOT_SUPPORTED,
  EMPTY_TIP_POSES,
  IK_SEED_OUTSIDE_LIMITS,
  SOLVER_NOT_ACTIVE,
  NO_SOLUTION
};
}
using DiscretizationMethod = DiscretizationMethods::DiscretizationMethod;
using KinematicError = KinematicErrors::KinematicError;

struct KinematicsQueryOptions {
  bool lock_redundant_joints = false, return_approximate_solution = false;
  DiscretizationMethod discretization_method = DiscretizationMethods::NO_DISCRETIZATION;
};
struct KinematicsResult {
  KinematicError kinematic_error;
  double solution_percentage;
};

class KinematicsBase {
 public:
  using Pose = geometry_msgs::msg::Pose;
  using Error = moveit_msgs::msg::MoveItErrorCodes;
  using Vector = std::vector<double>;
  using Options = KinematicsQueryOptions;
  using IKCallbackFn = std::function<void(const Pose&, const Vector&, Error&)>;
  static constexpr double DEFAULT_SEARCH_DISCRETIZATION = 0.1;

  virtual ~KinematicsBase() = default;
  virtual bool getPositionIK(const Pose&, const Vector&, Vector&, Error&, const Options& = Options()) const = 0;
  virtual bool getPositionIK(
      const std::vector<Pose>&,
      const Vector&,
      std::vector<Vector>&,
      KinematicsResult&,
      const Options&) const = 0;
  virtual bool searchPositionIK(const Pose&, const Vector&, double, Vector&, Error&, const Options& = Options())
      const = 0;
  virtual bool searchPositionIK(
      const Pose&,
      const Vector&,
      double,
      const Vector& consistency,
      Vector&,
      Error&,
      const Options& = Options()) const = 0;
  virtual bool searchPositionIK(
      const Pose&,
      const Vector&,
      double,
      Vector&,
      const IKCallbackFn&,
      Error&,
      const Options& = Options()) const = 0;
  virtual bool searchPositionIK(
      const Pose&,
      const Vector&,
      double,
      const Vector& consistency,
      Vector&,
      const IKCallbackFn&,
      Error&,
      const Options& = Options()) const = 0;
  virtual bool getPositionFK(const std::vector<std::string>& links, const Vector&, std::vector<Pose>&) const = 0;
  virtual bool initialize(
      const rclcpp::Node::SharedPtr&,
      const moveit::core::RobotModel&,
      const std::string& group,
      const std::string& base,
      const std::vector<std::string>& tips,
      double resolution) = 0;
  virtual const std::vector<std::string>& getJointNames() const = 0;
  virtual const std::vector<std::string>& getLinkNames() const = 0;
  virtual const std::vector<std::string>& getTipFrames() const { return tip_frames_; }
  virtual bool setRedundantJoints(const std::vector<unsigned int>& indices) {
    redundant_joint_indices_ = indices;
    setSearchDiscretization(DEFAULT_SEARCH_DISCRETIZATION);
    return true;
  }
  void setSearchDiscretization(double resolution) {
    for (const unsigned int joint : redundant_joint_indices_)
      redundant_joint_discretization_[static_cast<int>(joint)] = resolution;
  }
  double getSearchDiscretization(int joint = 0) const {
    const auto at = redundant_joint_discretization_.find(joint);
    return at == redundant_joint_discretization_.end() ? 0 : at->second;
  }
  std::vector<DiscretizationMethod> getSupportedDiscretizationMethods() const { return supported_methods_; }

 protected:
  rclcpp::Node::SharedPtr node_;
  std::string group_name_, base_frame_;
  std::vector<std::string> tip_frames_;
  std::vector<unsigned int> redundant_joint_indices_;
  std::map<int, double> redundant_joint_discretization_;
  std::vector<DiscretizationMethod> supported_methods_{DiscretizationMethods::NO_DISCRETIZATION};

  void storeValues(
      const moveit::core::RobotModel&,
      const std::string& group,
      const std::string& base,
      const std::vector<std::string>& tips,
      double resolution) {
    group_name_ = group;
    base_frame_ = base;
    tip_frames_ = tips;
    setSearchDiscretization(resolution);
  }
};

}  // namespace kinematics
