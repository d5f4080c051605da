// The checks of derivatives find the mistakes that they are meant to find.
#include "right_subject.h"

namespace robcogen::reference::check_derivatives_test {
namespace {

// The wrench on a link is treated as if its axes did not move with the joints.
TEST(Checks, FindDerivativesUnderWrenchesThatDoNotMove) {
  struct Wrong : RightDerivatives {
    using RightDerivatives::RightDerivatives;
    Derivatives inverse_dynamics_fully_actuated_derivatives(const Motion<double>& m, const Arguments& arguments)
        const override {
      Derivatives d = RightDerivatives::inverse_dynamics_fully_actuated_derivatives(m, arguments);
      d.q = RightDerivatives::inverse_dynamics_fully_actuated_derivatives(m, {arguments.gravity, nullptr}).q;
      return d;
    }
  };
  for (const char* name : {"inverse_dynamics", "inverse_dynamics_fully_actuated"}) {
    const bool floating = std::string(name) != "inverse_dynamics";
    expect_found<Wrong>({std::string(name) + "_derivatives (wrenches): d_q"}, {floating});
  }
}

TEST(Checks, FindABaseThatTurnsWithGravity) {
  struct Wrong : RightDerivatives {
    using RightDerivatives::RightDerivatives;
    Derivatives inverse_dynamics_fully_actuated_derivatives(const Motion<double>& m, const Arguments& arguments)
        const override {
      Derivatives d = RightDerivatives::inverse_dynamics_fully_actuated_derivatives(m, arguments);
      d.base_rotation = -d.base_rotation;
      d.qd.set_block(0, 0, 0.5 * d.qd.col(0));
      return d;
    }
  };
  const std::string name = "inverse_dynamics_fully_actuated_derivatives";
  expect_found<Wrong>({name + " (gravity, wrenches): d_base_rotation", name + " (gravity, wrenches): d_qd"}, {true});
}

TEST(Checks, FindAForwardDynamicsOfTheWrongSign) {
  struct Wrong : RightDerivatives {
    using RightDerivatives::RightDerivatives;
    Derivatives forward_dynamics_derivatives(
        const Motion<double>& m,
        const Vector<double>& tau,
        const Arguments& arguments) const override {
      Derivatives d = RightDerivatives::forward_dynamics_derivatives(m, tau, arguments);
      d.q = -d.q;
      d.last.set_block(0, 0, 1.001 * d.last.col(0));
      return d;
    }
    Derivatives gravity_forces_derivative(const Vector<double>& q, const Arguments& arguments) const override {
      Derivatives d = RightDerivatives::gravity_forces_derivative(q, arguments);
      d.q.set_block(0, 0, 1.001 * d.q.col(0));
      return d;
    }
  };
  expect_found<Wrong>(
      {"forward_dynamics_derivatives: d_q", "forward_dynamics_derivatives (gravity, wrenches): d_tau",
       "gravity_forces_derivative: d_q"});
}

TEST(Checks, FindAGradientOfOtherWeights) {
  struct Wrong : RightDerivatives {
    using RightDerivatives::RightDerivatives;
    Derivatives inverse_dynamics_gradient(
        const Motion<double>& m,
        const Vector<double>& weights,
        const Arguments& arguments) const override {
      return RightDerivatives::inverse_dynamics_gradient(m, 1.001 * weights, arguments);
    }
  };
  const std::string all = "inverse_dynamics_gradient (gravity, wrenches)";
  expect_found<Wrong>({"inverse_dynamics_gradient: d_q", all + ": d_qd", all + ": d_qdd"});
}

TEST(Checks, FindABaseThatIsHeldInDerivatives) {
  struct Wrong : RightDerivatives {
    using RightDerivatives::RightDerivatives;
    Derivatives inverse_dynamics_derivatives(const Motion<double>& m, const Arguments& arguments) const override {
      Derivatives d = RightDerivatives::inverse_dynamics_derivatives(m, arguments);
      d.q = RightDerivatives::inverse_dynamics_fully_actuated_derivatives(m, arguments).q;
      return d;
    }
  };
  expect_found<Wrong>({"inverse_dynamics_derivatives: d_q"}, {true});
}

}  // namespace
}  // namespace robcogen::reference::check_derivatives_test
