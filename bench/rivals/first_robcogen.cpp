// C++ code that the first RobCoGen generated for one robot, with its runtime iit::rbd. Compiled once per robot, with
//     ROBCOGEN_RIVAL_NAMESPACE   the namespace of the generated code, `rcg::Quadruped`
// and the folder of that code as include directory.
#include <traits.h>

#include <Eigen/Core>
#include <vector>

#include "rivals/rival.h"

namespace robcogen::rivals {
namespace {

namespace generated = ROBCOGEN_RIVAL_NAMESPACE;
using Traits = generated::Traits;
using Joints = Traits::JointState;
using Vector6 = Eigen::Matrix<double, 6, 1>;
constexpr int kJoints = Traits::joints_count;
constexpr bool kFloating = Traits::floating_base;
constexpr int kBase = kFloating ? 6 : 0;

// The first RobCoGen rounds every number of the document to single precision.
constexpr double kSinglePrecision = 1e-4;

struct Arguments {
  Joints q, qd, qdd, tau;
  Vector6 base_velocity, base_acceleration;
};

// The objects of its code hold the transforms that their functions fill; vectors are angular first, as here.
template <class T>
class Robot {
 public:
  void prepare(const States& s) {
    states_.clear();
    for (std::size_t i = 0; i < s.count; ++i)
      states_.push_back(
          {joints(s.q, i), joints(s.qd, i), joints(s.qdd, i), joints(s.tau, i), vector6(s.base_velocity, i),
           vector6(s.base_acceleration, i)});
    gravity_ << 0, 0, 0, s.gravity[0], s.gravity[1], s.gravity[2];
  }

  void run(Function function, std::size_t state) {
    const Arguments& s = states_[state];
    switch (function) {
      case Function::inverse_dynamics:
        if constexpr (T::floating_base)
          inverse_dynamics_.id_fully_actuated(
              base_, joints_, gravity_, s.base_velocity, s.base_acceleration, s.q, s.qd, s.qdd);
        else
          inverse_dynamics_.id(joints_, s.q, s.qd, s.qdd);
        break;
      case Function::forward_dynamics:
        if constexpr (T::floating_base)
          forward_dynamics_.fd(joints_, base_, s.base_velocity, gravity_, s.q, s.qd, s.tau);
        else
          forward_dynamics_.fd(joints_, s.q, s.qd, s.tau);
        break;
      case Function::inertia_matrix:
        inertia_.update(s.q);
        break;
    }
  }

  void result(Function function, double* values) const {
    if (function == Function::inertia_matrix) {
      constexpr int kSize = kBase + kJoints;
      // It writes both triangles of the joints' part.
      Eigen::Map<Eigen::Matrix<double, kSize, kSize>> H(values);
      H = inertia_;
      return;
    }
    if (kFloating) Eigen::Map<Vector6>(values, 6) = base_;
    Eigen::Map<Joints>(values + kBase) = joints_;
  }

 private:
  typename T::InertiaProperties properties_;
  typename T::MotionTransforms motion_transforms_;
  typename T::ForceTransforms force_transforms_;
  typename T::InvDynEngine inverse_dynamics_{properties_, motion_transforms_};
  typename T::FwdDynEngine forward_dynamics_{properties_, motion_transforms_};
  typename T::JSIM inertia_{properties_, force_transforms_};
  std::vector<Arguments> states_;
  Vector6 gravity_ = Vector6::Zero(), base_ = Vector6::Zero();
  Joints joints_ = Joints::Zero();

  static Joints joints(const double* all, std::size_t state) { return Eigen::Map<const Joints>(all + state * kJoints); }
  static Vector6 vector6(const double* all, std::size_t state) { return Eigen::Map<const Vector6>(all + state * 6); }
};

Robot<Traits>& robot() {
  static Robot<Traits> only;
  return only;
}

const Rival kRival = {
    "first RobCoGen",
    kSinglePrecision,
    kJoints,
    kFloating,
    [](const States& states) { robot().prepare(states); },
    [](Function function, std::size_t state) { robot().run(function, state); },
    [](Function function, double* values) { robot().result(function, values); }};

}  // namespace
}  // namespace robcogen::rivals

extern "C" const robcogen::rivals::Rival* robcogen_rival_first_robcogen() {
  return &robcogen::rivals::kRival;
}
