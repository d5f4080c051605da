// Code that must not compile: one case per run, chosen by a macro. Without a macro, the rest compiles.
#include <everywhere_fixed/everywhere_fixed.h>
#include <everywhere_floating/everywhere_floating.h>
#include <everywhere_undeclared/everywhere_undeclared.h>

namespace defaults = everywhere_fixed;
namespace none = everywhere_undeclared;
namespace floating = everywhere_floating;

// Has only one getter of the interface.
class Incomplete : public defaults::DynamicsParameters {
  double get_trunk_mass() const noexcept override { return 1; }
};

double use() {
  const defaults::Parameters<> parameters;
  const none::Parameters<> given{none::ParameterValues()};
  const Eigen::Vector4d q = Eigen::Vector4d::Zero();
  double sum = defaults::gravity_forces(parameters, q)(0) + none::gravity_forces(given, q)(0);
#ifdef NO_VALUES
  none::Parameters<> missing;
  sum += none::gravity_forces(missing, q)(0);
#endif
#ifdef NO_VALUES_IN_ROBOT
  none::Robot robot;
  sum += robot.gravity_forces(q)(0);
#endif
#ifdef NO_PARAMETERS
  sum += defaults::gravity_forces(q)(0);
#endif
#ifdef PARAMETERS_OF_ANOTHER_ROBOT
  sum += defaults::gravity_forces(given, q)(0);
#endif
#ifdef PARAMETERS_OF_ANOTHER_PRECISION
  sum += defaults::gravity_forces(defaults::Parameters<float>(), q)(0);
#endif
#ifdef VALUES_FOR_PARAMETERS
  sum += defaults::gravity_forces(defaults::ParameterValues(), q)(0);
#endif
  const floating::Parameters<> carried;
  [[maybe_unused]] const robcogen::Twist velocity;
  sum += floating::gravity_forces(carried, q, robcogen::kStandardGravity).tau(0);
#ifdef NO_GRAVITY
  sum += floating::forward_dynamics(carried, q, q, q, velocity).qdd(0);
#endif
#ifdef NO_GRAVITY_IN_ROBOT
  sum += floating::Robot{carried}.bias_forces(q, q, velocity).tau(0);
#endif
#ifdef NO_GRAVITY_IN_SINGLE_PRECISION
  sum += floating::f32::gravity_forces(floating::Parameters<float>(), q.cast<float>()).tau(0);
#endif
#ifdef WRENCHES_WITHOUT_GRAVITY
  sum += floating::inverse_dynamics(carried, q, q, q, velocity, floating::LinkWrenches()).tau(0);
#endif
#ifdef WRONG_SIZE
  sum += defaults::gravity_forces(parameters, Eigen::Vector3d(Eigen::Vector3d::Zero()))(0);
#endif
#ifdef TOO_MANY_VALUES
  sum += defaults::Parameters<>(std::array<double, 99>()).data()[0];
#endif
#ifdef GETTER_MISSING
  sum += Incomplete().get_size();
#endif
#ifdef UPDATE_OF_SHARED
  parameters.update(defaults::ParameterValues());
#endif
  return sum;
}
