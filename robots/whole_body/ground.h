// A robot on level ground: rigid contacts that push but do not pull, with Coulomb friction, without rebound.
//
// Time stepping (Moreau 1988; Stewart and Trinkle 1996): each step finds impulses p at the contact points such that the
// points, with velocities u = u_free + W p at its end, leave the ground or rest on it, and slide only against the
// largest friction. Projected sweeps (Jean 1999) over the points find the impulses.
#pragma once

#include <robcogen/generic/simulation.h>

#include <algorithm>

#include "body.h"

namespace whole_body {

template <Body B>
class Ground {
 public:
  using S = Sizes<B>;
  using Robot = typename B::Robot;

  Ground(double friction, double step) : friction_(friction), step_(step) {}

  double step() const { return step_; }

  // The action of the ground in a step.
  struct Contact {
    typename S::PointVector forces = S::PointVector::Zero();      // means over the step (N), world axes
    typename S::PointVector velocities = S::PointVector::Zero();  // of the points at its end
    int sweeps = 0;
  };
  const Contact& contact() const { return contact_; }

  // The state after a step. `push` is a force (N) at the origin of the base, in world axes.
  StateOf<B> operator()(const StateOf<B>& state, const typename Robot::JointState& tau, const Vector3d& push) {
    const Robot robot;
    const typename Robot::JointTrigonometry at(state.q);
    typename Robot::LinkWrenches external;
    external[0] = robcogen::Wrench(Vector3d::Zero(), state.pose.to_base_axes(push));
    const auto free = robot.forward_dynamics(at, state.qd, tau, state.base_velocity, gravity_in_base(state), external);
    const typename Robot::JointState qd = state.qd + step_ * free.qdd;
    const robcogen::Twist base_velocity(state.base_velocity.vector() + step_ * free.base_acceleration.vector());

    const ContactPoints<B> points(state);
    const PointMatrix W = points.map * robot.inverse_contact_inertia(at) * points.map.transpose();
    typename S::PointVector u = points.map * robot.contact_velocity(at, qd, base_velocity);
    typename S::PointVector p = step_ * contact_.forces;  // starts from the last step
    u += W * p;
    contact_.sweeps = sweep(W, points, u, p);
    contact_.forces = p / step_;
    contact_.velocities = u;

    const typename S::Rows wrenches = points.map.transpose() * contact_.forces;
    const typename S::Coordinates by_contacts =
        robot.joint_space_inertia_factor(at).solve(robot.contact_jacobian(at).transpose() * wrenches);
    const typename Robot::GeneralizedAcceleration acceleration{
        free.qdd + by_contacts.template tail<S::kDof>(),
        robcogen::SpatialAcceleration(free.base_acceleration.vector() + by_contacts.template head<6>())};
    return integrate(state, acceleration, step_);
  }

 private:
  using PointMatrix = Eigen::Matrix<double, 3 * S::kPoints, 3 * S::kPoints>;
  static constexpr int kMaxSweeps = 200;
  static constexpr double kImpulse = 1e-9;  // N s: smaller changes end the sweeps
  static constexpr double kRaise = 0.1;     // fraction of a depth below the ground that one step removes

  int sweep(
      const PointMatrix& W,
      const ContactPoints<B>& points,
      typename S::PointVector& u,
      typename S::PointVector& p) const {
    for (int count = 1; count <= kMaxSweeps; ++count) {
      double most = 0;
      for (int i = 0; i < S::kPoints; ++i) {
        const double height = points.positions(2, i), allowed = (height > 0 ? 1 : kRaise) * height / step_;
        const Vector3d before = p.template segment<3>(3 * i);
        Vector3d after = before;
        after.z() = std::max(0.0, before.z() - (u[3 * i + 2] + allowed) / W(3 * i + 2, 3 * i + 2));
        const double compliance = std::max(W(3 * i, 3 * i), W(3 * i + 1, 3 * i + 1));
        after.template head<2>() -= u.template segment<2>(3 * i) / compliance;
        const double sideways = after.template head<2>().norm(), limit = friction_ * after.z();
        if (sideways > limit) after.template head<2>() *= limit / sideways;
        u += W.template middleCols<3>(3 * i) * (after - before);
        p.template segment<3>(3 * i) = after;
        most = std::max(most, (after - before).cwiseAbs().maxCoeff());
      }
      if (most < kImpulse) return count;
    }
    return kMaxSweeps;
  }

  double friction_, step_;
  Contact contact_;
};

}  // namespace whole_body
