// The type of robots that a program picks at run time (any_robot.h). Needs C++20.
#pragma once

#if (defined(_MSVC_LANG) ? _MSVC_LANG : __cplusplus) > 201703L

#include <Eigen/Core>
#include <cstddef>
#include <cstdio>
#include <memory>
#include <span>
#include <stdexcept>
#include <string_view>

#include "robcogen/any/functions.h"
#include "robcogen/matrix.h"
#include "robcogen/reflection.h"

namespace robcogen {

// Matrices that Eigen stores by rows, as it does by default with EIGEN_DEFAULT_TO_ROW_MAJOR.
template <class M>
concept StoredByRows = bool(M::IsRowMajor) && !bool(M::IsVectorAtCompileTime);

class AnyRobot {
 public:
  using In = const Eigen::Ref<const Eigen::VectorXd>&;
  using Out = Eigen::Ref<Eigen::VectorXd>;
  using OutMatrix = Eigen::Ref<DynamicMatrix<double>>;
  // One wrench for each link, in link coordinates about the origin of the link; or none at all.
  using External = std::span<const Wrench>;

  // The tables are those of the robot's library, and exist as long as the program.
  template <class R>
  requires(FixedBaseRobot<R> || FloatingBaseRobot<R>) &&
      std::same_as<typename R::Scalar, double> AnyRobot(const R& robot, const reflection::Robot& tables)
      : tables_(&tables),
  functions_(std::make_shared<const any::FunctionsOf<R>>(robot)) {
    if (tables.dof() != R::kDof || tables.position_count() != kPositionCount<R> || tables.links.size != R::kLinkCount ||
        tables.floating_base != R::kFloatingBase)
      throw std::invalid_argument("AnyRobot: the tables belong to another robot");
  }

  const char* name() const noexcept { return tables_->name; }
  int dof() const noexcept { return tables_->dof(); }
  int position_count() const noexcept { return tables_->position_count(); }
  int size() const noexcept { return dof() + (floating_base() ? 6 : 0); }
  bool floating_base() const noexcept { return tables_->floating_base; }
  // Names of joints, links, frames, transforms and Jacobians. For a robot with parameters, numbers in the tables are
  // those of the default values.
  const reflection::Robot& tables() const noexcept { return *tables_; }

  // The instances of parts in the robot's document. Indices in `limb.joints` are those of elements of qd.
  const Limbs& limbs() const noexcept { return tables_->limbs; }
  // Returns the limb of this name, or nullptr if there is none.
  const Limb* find_limb(std::string_view limb) const noexcept {
    for (const Limb& l : limbs())
      if (limb == l.name) return &l;
    return nullptr;
  }

  // Computes the joint forces tau for joint accelerations qdd (dof() elements). Returns the acceleration of a floating
  // base without a wrench on it; zero for a fixed base.
  SpatialAcceleration inverse_dynamics(In q, In v, In qdd, Out tau) const;
  SpatialAcceleration inverse_dynamics(In q, In v, In qdd, Out tau, const Gravity& gravity, External external = {})
      const;

  // Computes the forces f, the wrench on a floating base first, for accelerations a of base and joints.
  void inverse_dynamics_fully_actuated(In q, In v, In a, Out f) const;
  void inverse_dynamics_fully_actuated(In q, In v, In a, Out f, const Gravity& gravity, External external = {}) const;

  // Computes the accelerations a, a floating base first, under joint forces tau (dof() elements).
  void forward_dynamics(In q, In v, In tau, Out a) const;
  void forward_dynamics(In q, In v, In tau, Out a, const Gravity& gravity, External external = {}) const;

  // f = coriolis_forces(q, v) + gravity_forces(q), plus passive forces of drives, minus the effect of external
  // wrenches.
  void bias_forces(In q, In v, Out f) const;
  void bias_forces(In q, In v, Out f, const Gravity& gravity, External external = {}) const;
  void gravity_forces(In q, Out f) const;
  void gravity_forces(In q, Out f, const Gravity& gravity) const;
  void coriolis_forces(In q, In v, Out f) const;

  // size() x size(), symmetric, base first.
  void joint_space_inertia(In q, OutMatrix H) const;
  template <StoredByRows Rows>
  void joint_space_inertia(In q, const Eigen::MatrixBase<Rows>& H) const {
    joint_space_inertia(q, const_cast<Eigen::MatrixBase<Rows>&>(H).transpose());
  }

  // One for each joint. Drives are in tables().joints[joint].drive.
  std::span<const JointLimits> joint_limits() const noexcept {
    return {functions_->joint_limits(), static_cast<std::size_t>(dof())};
  }

  // Index of a transform or Jacobian by its name in the library, as in `fr_base_X_fr_foot`; -1 when there is none.
  int find_transform(std::string_view transform) const noexcept { return find(tables_->transforms, transform); }
  int find_jacobian(std::string_view jacobian) const noexcept { return find(tables_->jacobians, jacobian); }

  // Transforms by index: homogeneous (4 x 4), and of motion and force vectors (6 x 6, angular first).
  Matrix<double, 4, 4> homogeneous_transform(int transform, In q) const;
  Matrix<double, 6, 6> motion_transform(int transform, In q) const;
  Matrix<double, 6, 6> force_transform(int transform, In q) const;

  // Jacobian by index: 6 rows, angular first, and one column for each joint of the chain, which
  // tables().jacobians[jacobian] lists.
  void jacobian(int jacobian, In q, OutMatrix J) const;
  template <StoredByRows Rows>
  void jacobian(int, In, const Eigen::MatrixBase<Rows>&) const {
    refuse_rows<Rows>();
  }

  // Index of an actuator of tables().actuators by its name; -1 when there is none.
  int find_actuator(std::string_view actuator) const noexcept { return find(tables_->actuators, actuator); }

  // Lengths of the actuators (m) and their rates (m/s), one element per actuator.
  void actuator_lengths(In q, Out lengths) const;
  void actuator_velocities(In q, In v, Out velocities) const;

  // Lever arms: one row per actuator, one column per joint. J^T times the actuator forces gives the joint forces.
  void actuator_jacobian(In q, OutMatrix J) const;
  template <StoredByRows Rows>
  void actuator_jacobian(In, const Eigen::MatrixBase<Rows>&) const {
    refuse_rows<Rows>();
  }

 private:
  template <class Rows>
  static void refuse_rows() {
    static_assert(!StoredByRows<Rows>, "J must be stored by columns: declare it as robcogen::DynamicMatrix<double>");
  }
  [[noreturn]] void refuse(const char* function, const char* what, Eigen::Index is, int must_be) const {
    char message[200];
    std::snprintf(
        message, sizeof message, "%s of %s: %s has %td elements and must have %d", function, name(), what,
        static_cast<std::ptrdiff_t>(is), must_be);
    throw std::invalid_argument(message);
  }
  void expect(const char* function, const char* what, Eigen::Index is, int must_be) const {
    if (is != must_be) refuse(function, what, is, must_be);
  }
  void expect_index(const char* function, int index, int count) const {
    if (index >= 0 && index < count) return;
    char message[200];
    std::snprintf(message, sizeof message, "%s of %s: index %d is out of range", function, name(), index);
    throw std::invalid_argument(message);
  }
  template <class Kernel>
  void expect_kernel(const char* function, const Kernel& kernel) const {
    if (kernel.exists()) return;
    char message[200];
    std::snprintf(
        message, sizeof message, "%s of %s: the robot has no actuators, or its library leaves out this function",
        function, name());
    throw std::invalid_argument(message);
  }
  const Gravity& default_gravity(const char* function) const {
    if (!floating_base()) return kStandardGravity;
    char message[200];
    std::snprintf(
        message, sizeof message, "%s of %s: the base floats: give gravity in base coordinates", function, name());
    throw std::invalid_argument(message);
  }
  any::Functions::Loads loads(const char* function, const Gravity& gravity, External external) const {
    if (external.empty()) return {gravity, nullptr};
    expect(function, "external", static_cast<Eigen::Index>(external.size()), tables_->links.size);
    return {gravity, external.data()};
  }

  template <class Item>
  static int find(const reflection::Table<Item>& table, std::string_view name) noexcept {
    for (int i = 0; i < table.size; ++i)
      if (name == table[i].name) return i;
    return -1;
  }

  template <int n, class Kernel>
  Matrix<double, n, n> of_kernel(const char* function, int index, In q, const Kernel& kernel) const {
    expect_index(function, index, tables_->transforms.size);
    expect(function, "q", q.size(), position_count());
    Matrix<double, n, n> X;
    kernel(tables_->transforms[index])(functions_->cache(), q.data(), X.data());
    return X;
  }

  const reflection::Robot* tables_;
  std::shared_ptr<const any::Functions> functions_;
};

}  // namespace robcogen

#else
#error "robcogen/any/robot.h needs C++20: compile with -std=c++20"
#endif
