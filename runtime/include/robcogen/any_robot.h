// A robot that a program picks at run time: one type for all generated libraries, fixed and floating base. Needs C++20.
//
//     #include <hyl/hyl.h>
//     #include <hyl/reflection.h>
//     const robcogen::AnyRobot robot = robcogen::make_any<hyl::Robot>(hyl::reflection::robot);
//     robot.inverse_dynamics(q, v, qdd, tau);
//
// Vectors of positions q have position_count() elements (positions.h: more than dof() with spherical joints), those of
// joint forces tau dof() elements. Velocities v, accelerations a and generalised forces
// f have size() elements: with a floating base, its twist, spatial acceleration or wrench (angular first, base
// coordinates), then the joints; otherwise only the joints. All units are SI.
//
// Gravity (m/s^2) is in base coordinates. With a fixed base it may be omitted: the default is standard gravity. With a
// floating base it encodes the orientation of the base, and without it std::invalid_argument is thrown.
//
// The size of every argument is checked, and std::invalid_argument names the one that is wrong.
// Nothing else throws, and nothing allocates after construction, as long as arguments are vectors or contiguous parts
// of them: Eigen evaluates expressions such as q + dq, and rows of matrices, into memory of its own. A call costs a
// virtual call and copies of the arguments. Copies of an AnyRobot share their content, which never changes; any number
// of threads may use one.
#pragma once

#if (defined(_MSVC_LANG) ? _MSVC_LANG : __cplusplus) > 201703L

#include <Eigen/Core>
#include <cstdio>
#include <memory>
#include <span>
#include <stdexcept>
#include <string_view>

#include "robcogen/concepts.h"
#include "robcogen/joint_limits.h"
#include "robcogen/reflection.h"

namespace robcogen {

namespace any {

// The functions of each robot, on plain arrays of the right sizes. `external` may be null.
class Functions {
 public:
  virtual ~Functions() = default;
  struct Loads {
    const Gravity& gravity;
    const Wrench* external;
  };
  virtual SpatialAcceleration inverse_dynamics(
      const double* q,
      const double* v,
      const double* qdd,
      double* tau,
      const Loads& loads) const noexcept = 0;
  virtual void inverse_dynamics_fully_actuated(
      const double* q,
      const double* v,
      const double* a,
      double* f,
      const Loads& loads) const noexcept = 0;
  virtual void forward_dynamics(const double* q, const double* v, const double* tau, double* a, const Loads& loads)
      const noexcept = 0;
  virtual void bias_forces(const double* q, const double* v, double* f, const Loads& loads) const noexcept = 0;
  virtual void gravity_forces(const double* q, double* f, const Gravity& gravity) const noexcept = 0;
  virtual void coriolis_forces(const double* q, const double* v, double* f) const noexcept = 0;
  virtual void joint_space_inertia(const double* q, Eigen::Ref<Eigen::MatrixXd> H) const noexcept = 0;
  // The first input of kernels of a robot with parameters; otherwise null.
  virtual const double* cache() const noexcept = 0;
  virtual const JointLimits* joint_limits() const noexcept = 0;
};

template <class R>
class FunctionsOf final : public Functions {
 public:
  explicit FunctionsOf(const R& robot) : robot_(robot) {}

  SpatialAcceleration inverse_dynamics(
      const double* q,
      const double* v,
      const double* qdd,
      double* tau,
      const Loads& loads) const noexcept override {
    return with(loads, [&](const auto&... extra) {
      if constexpr (R::kFloatingBase) {
        const auto result = robot_.inverse_dynamics(positions(q), qd_of(v), joints(qdd), Twist(base(v)), extra...);
        Eigen::Map<JointState>{tau} = result.tau;
        return result.base_acceleration;
      } else {
        Eigen::Map<JointState>{tau} = robot_.inverse_dynamics(positions(q), qd_of(v), joints(qdd), extra...);
        return SpatialAcceleration();
      }
    });
  }
  void inverse_dynamics_fully_actuated(const double* q, const double* v, const double* a, double* f, const Loads& loads)
      const noexcept override {
    with(loads, [&](const auto&... extra) {
      if constexpr (R::kFloatingBase) {
        set_forces(
            f, robot_.inverse_dynamics_fully_actuated(
                   positions(q), qd_of(v), qd_of(a), Twist(base(v)), SpatialAcceleration(base(a)), extra...));
      } else {
        set_forces(f, robot_.inverse_dynamics(positions(q), joints(v), joints(a), extra...));
      }
    });
  }
  void forward_dynamics(const double* q, const double* v, const double* tau, double* a, const Loads& loads)
      const noexcept override {
    with(loads, [&](const auto&... extra) {
      if constexpr (R::kFloatingBase) {
        const auto result = robot_.forward_dynamics(positions(q), qd_of(v), joints(tau), Twist(base(v)), extra...);
        Eigen::Map<Vector6>{a} = result.base_acceleration.vector();
        Eigen::Map<JointState>{a + 6} = result.qdd;
      } else {
        Eigen::Map<JointState>{a} = robot_.forward_dynamics(positions(q), joints(v), joints(tau), extra...);
      }
    });
  }
  void bias_forces(const double* q, const double* v, double* f, const Loads& loads) const noexcept override {
    with(loads, [&](const auto&... extra) {
      if constexpr (R::kFloatingBase) {
        set_forces(f, robot_.bias_forces(positions(q), qd_of(v), Twist(base(v)), extra...));
      } else {
        set_forces(f, robot_.bias_forces(positions(q), joints(v), extra...));
      }
    });
  }
  void gravity_forces(const double* q, double* f, const Gravity& gravity) const noexcept override {
    set_forces(f, robot_.gravity_forces(positions(q), gravity));
  }
  void coriolis_forces(const double* q, const double* v, double* f) const noexcept override {
    if constexpr (R::kFloatingBase) {
      set_forces(f, robot_.coriolis_forces(positions(q), qd_of(v), Twist(base(v))));
    } else {
      set_forces(f, robot_.coriolis_forces(positions(q), joints(v)));
    }
  }
  void joint_space_inertia(const double* q, Eigen::Ref<Eigen::MatrixXd> H) const noexcept override {
    H = robot_.joint_space_inertia(positions(q));
  }
  const JointLimits* joint_limits() const noexcept override { return R::kJointLimits.data(); }
  const double* cache() const noexcept override {
    if constexpr (requires { robot_.parameters.data(); }) {
      return robot_.parameters.data();
    } else {
      return nullptr;
    }
  }

 private:
  using JointState = typename R::JointState;
  using Vector6 = Eigen::Matrix<double, 6, 1>;

  static JointPositions<R> positions(const double* q) noexcept { return Eigen::Map<const JointPositions<R>>(q); }
  static JointState joints(const double* v) noexcept { return Eigen::Map<const JointState>(v); }
  static JointState qd_of(const double* v) noexcept { return joints(v + (R::kFloatingBase ? 6 : 0)); }
  static Eigen::Map<const Vector6> base(const double* v) noexcept { return Eigen::Map<const Vector6>(v); }

  template <class Forces>
  static void set_forces(double* f, const Forces& forces) noexcept {
    if constexpr (R::kFloatingBase) {
      Eigen::Map<Vector6>{f} = forces.base_wrench.vector();
      Eigen::Map<JointState>{f + 6} = forces.tau;
    } else {
      Eigen::Map<JointState>{f} = forces;
    }
  }

  // Calls the overload that takes these loads.
  template <class Call>
  static auto with(const Loads& loads, const Call& call) noexcept {
    if (loads.external == nullptr) return call(loads.gravity);
    typename R::LinkWrenches wrenches;
    for (int i = 0; i < R::kLinkCount; ++i) wrenches[i] = loads.external[i];
    return call(loads.gravity, wrenches);
  }

  R robot_;
};

}  // namespace any

class AnyRobot {
 public:
  using In = const Eigen::Ref<const Eigen::VectorXd>&;
  using Out = Eigen::Ref<Eigen::VectorXd>;
  using OutMatrix = Eigen::Ref<Eigen::MatrixXd>;
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
  // Names of joints, links and frames, transforms and Jacobians; of a robot with parameters, numbers are of the
  // defaults.
  const reflection::Robot& tables() const noexcept { return *tables_; }

  // What the instances of parts in its document have become: `limb.joints` are places in q.
  const Limbs& limbs() const noexcept { return tables_->limbs; }
  // By its name; nullptr where there is none.
  const Limb* find_limb(std::string_view limb) const noexcept {
    for (const Limb& l : limbs())
      if (limb == l.name) return &l;
    return nullptr;
  }

  // Joint forces for joint accelerations qdd (dof() elements). Returns the acceleration of a floating base
  // without a wrench on it; zero for a fixed base.
  SpatialAcceleration inverse_dynamics(In q, In v, In qdd, Out tau) const {
    return inverse_dynamics(q, v, qdd, tau, default_gravity("inverse_dynamics"));
  }
  SpatialAcceleration inverse_dynamics(In q, In v, In qdd, Out tau, const Gravity& gravity, External external = {})
      const {
    constexpr const char* kFunction = "inverse_dynamics";
    expect(kFunction, "q", q.size(), position_count());
    expect(kFunction, "v", v.size(), size());
    expect(kFunction, "qdd", qdd.size(), dof());
    expect(kFunction, "tau", tau.size(), dof());
    return functions_->inverse_dynamics(
        q.data(), v.data(), qdd.data(), tau.data(), loads(kFunction, gravity, external));
  }

  // Forces f, the wrench on a floating base first, for accelerations a of base and joints.
  void inverse_dynamics_fully_actuated(In q, In v, In a, Out f) const {
    inverse_dynamics_fully_actuated(q, v, a, f, default_gravity("inverse_dynamics_fully_actuated"));
  }
  void inverse_dynamics_fully_actuated(In q, In v, In a, Out f, const Gravity& gravity, External external = {}) const {
    constexpr const char* kFunction = "inverse_dynamics_fully_actuated";
    expect(kFunction, "q", q.size(), position_count());
    expect(kFunction, "v", v.size(), size());
    expect(kFunction, "a", a.size(), size());
    expect(kFunction, "f", f.size(), size());
    functions_->inverse_dynamics_fully_actuated(
        q.data(), v.data(), a.data(), f.data(), loads(kFunction, gravity, external));
  }

  // Accelerations a, of a floating base first, under joint forces tau (dof() elements).
  void forward_dynamics(In q, In v, In tau, Out a) const {
    forward_dynamics(q, v, tau, a, default_gravity("forward_dynamics"));
  }
  void forward_dynamics(In q, In v, In tau, Out a, const Gravity& gravity, External external = {}) const {
    constexpr const char* kFunction = "forward_dynamics";
    expect(kFunction, "q", q.size(), position_count());
    expect(kFunction, "v", v.size(), size());
    expect(kFunction, "tau", tau.size(), dof());
    expect(kFunction, "a", a.size(), size());
    functions_->forward_dynamics(q.data(), v.data(), tau.data(), a.data(), loads(kFunction, gravity, external));
  }

  // f = coriolis_forces(q, v) + gravity_forces(q), plus passive forces of drives, minus the effect of external
  // wrenches.
  void bias_forces(In q, In v, Out f) const { bias_forces(q, v, f, default_gravity("bias_forces")); }
  void bias_forces(In q, In v, Out f, const Gravity& gravity, External external = {}) const {
    constexpr const char* kFunction = "bias_forces";
    expect(kFunction, "q", q.size(), position_count());
    expect(kFunction, "v", v.size(), size());
    expect(kFunction, "f", f.size(), size());
    functions_->bias_forces(q.data(), v.data(), f.data(), loads(kFunction, gravity, external));
  }
  void gravity_forces(In q, Out f) const { gravity_forces(q, f, default_gravity("gravity_forces")); }
  void gravity_forces(In q, Out f, const Gravity& gravity) const {
    constexpr const char* kFunction = "gravity_forces";
    expect(kFunction, "q", q.size(), position_count());
    expect(kFunction, "f", f.size(), size());
    functions_->gravity_forces(q.data(), f.data(), gravity);
  }
  void coriolis_forces(In q, In v, Out f) const {
    constexpr const char* kFunction = "coriolis_forces";
    expect(kFunction, "q", q.size(), position_count());
    expect(kFunction, "v", v.size(), size());
    expect(kFunction, "f", f.size(), size());
    functions_->coriolis_forces(q.data(), v.data(), f.data());
  }

  // size() x size(), symmetric, base first.
  void joint_space_inertia(In q, OutMatrix H) const {
    constexpr const char* kFunction = "joint_space_inertia";
    expect(kFunction, "q", q.size(), position_count());
    expect(kFunction, "H, in rows,", H.rows(), size());
    expect(kFunction, "H, in columns,", H.cols(), size());
    functions_->joint_space_inertia(q.data(), H);
  }

  // One for each joint. Drives are in tables().joints[joint].drive.
  std::span<const JointLimits> joint_limits() const noexcept {
    return {functions_->joint_limits(), static_cast<std::size_t>(dof())};
  }

  // Index of a transform or Jacobian by its name in the library, as in `fr_base_X_fr_foot`; -1 when there is none.
  int find_transform(std::string_view transform) const noexcept { return find(tables_->transforms, transform); }
  int find_jacobian(std::string_view jacobian) const noexcept { return find(tables_->jacobians, jacobian); }

  // By index: 4 x 4; 6 x 6, angular first.
  Eigen::Matrix4d homogeneous_transform(int transform, In q) const {
    return of_kernel<4>("homogeneous_transform", transform, q, [](const auto& t) { return t.homogeneous; });
  }
  Eigen::Matrix<double, 6, 6> motion_transform(int transform, In q) const {
    return of_kernel<6>("motion_transform", transform, q, [](const auto& t) { return t.motion; });
  }
  Eigen::Matrix<double, 6, 6> force_transform(int transform, In q) const {
    return of_kernel<6>("force_transform", transform, q, [](const auto& t) { return t.force; });
  }

  // 6 rows, angular first, and a column for each joint of the chain, which tables().jacobians[jacobian] lists.
  void jacobian(int jacobian, In q, OutMatrix J) const {
    constexpr const char* kFunction = "jacobian";
    expect_index(kFunction, jacobian, tables_->jacobians.size);
    const reflection::Jacobian& table = tables_->jacobians[jacobian];
    expect(kFunction, "q", q.size(), position_count());
    expect(kFunction, "J, in rows,", J.rows(), 6);
    expect(kFunction, "J, in columns,", J.cols(), table.column_count);
    if (J.outerStride() != 6) throw std::invalid_argument("jacobian: the columns of J must be contiguous");
    table.kernel(functions_->cache(), q.data(), J.data());
  }

  // Index of an actuator of tables().actuators by its name; -1 when there is none.
  int find_actuator(std::string_view actuator) const noexcept { return find(tables_->actuators, actuator); }

  // An element an actuator: its length (m), and the rate of that (m/s).
  void actuator_lengths(In q, Out lengths) const {
    constexpr const char* kFunction = "actuator_lengths";
    const reflection::MatrixKernel& kernel = tables_->actuator_kernels.lengths;
    expect_kernel(kFunction, kernel);
    expect(kFunction, "q", q.size(), position_count());
    expect(kFunction, "lengths", lengths.size(), tables_->actuators.size);
    kernel(functions_->cache(), q.data(), lengths.data());
  }
  void actuator_velocities(In q, In v, Out velocities) const {
    constexpr const char* kFunction = "actuator_velocities";
    const reflection::RateKernel& kernel = tables_->actuator_kernels.velocities;
    expect_kernel(kFunction, kernel);
    expect(kFunction, "q", q.size(), position_count());
    expect(kFunction, "v", v.size(), size());
    expect(kFunction, "velocities", velocities.size(), tables_->actuators.size);
    kernel(functions_->cache(), q.data(), v.data() + (size() - dof()), velocities.data());
  }

  // Lever arms: a row an actuator, a column a joint. Its transpose times the forces of actuators are joint forces.
  void actuator_jacobian(In q, OutMatrix J) const {
    constexpr const char* kFunction = "actuator_jacobian";
    const reflection::MatrixKernel& kernel = tables_->actuator_kernels.jacobian;
    expect_kernel(kFunction, kernel);
    const int actuators = tables_->actuators.size;
    expect(kFunction, "q", q.size(), position_count());
    expect(kFunction, "J, in rows,", J.rows(), actuators);
    expect(kFunction, "J, in columns,", J.cols(), dof());
    if (J.outerStride() != actuators)
      throw std::invalid_argument("actuator_jacobian: the columns of J must be contiguous");
    kernel(functions_->cache(), q.data(), J.data());
  }

 private:
  [[noreturn]] void refuse(const char* function, const char* what, Eigen::Index is, int must_be) const {
    char message[200];
    std::snprintf(
        message, sizeof message, "%s of %s: %s has %td elements and must have %d", function, name(), what, is, must_be);
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
        message, sizeof message, "%s of %s: the base floats, so gravity must be given, in base coordinates", function,
        name());
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
  Eigen::Matrix<double, n, n> of_kernel(const char* function, int index, In q, const Kernel& kernel) const {
    expect_index(function, index, tables_->transforms.size);
    expect(function, "q", q.size(), position_count());
    Eigen::Matrix<double, n, n> X;
    kernel(tables_->transforms[index])(functions_->cache(), q.data(), X.data());
    return X;
  }

  const reflection::Robot* tables_;
  std::shared_ptr<const any::Functions> functions_;
};

// The robot of a library: hyl::Robot with hyl::reflection::robot. One with parameters carries their values.
template <class R>
AnyRobot make_any(const reflection::Robot& tables, const R& robot = R()) {
  return AnyRobot(robot, tables);
}

}  // namespace robcogen

#else
#error "robcogen/any_robot.h needs C++20: compile with -std=c++20"
#endif
