#include "motions.h"

#include <chrono>

#include "ground.h"
#include "humanoid.h"
#include "plans.h"
#include "quadruped.h"

namespace whole_body {
namespace {

constexpr int kStepsPerControl = 4;
constexpr int kControlsPerInstant = 20;
constexpr double kPushTime = 0.1;  // s
// Fraction of the friction of the ground that the controller uses.
constexpr double kShare = 0.8;

double seconds() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

template <Body B>
Instant instant_of(
    double time,
    const StateOf<B>& state,
    const Vector3d& goal,
    const typename Sizes<B>::PointVector& forces) {
  Instant instant{time, center_of_mass<B>(state), goal, 0, std::vector<double>(B::kContacts), B::skeleton(state.q)};
  instant.tilt = std::acos(std::min(1.0, state.pose.rotation()(2, 2)));
  for (int i = 0; i < Sizes<B>::kPoints; ++i)
    instant.loads[static_cast<std::size_t>(i / B::kPointsPerContact)] += forces[3 * i + 2];
  for (auto& line : instant.lines)
    for (Vector3d& place : line) place = state.pose.position() + state.pose.to_world_axes(place);
  return instant;
}

// Whether the robot has fallen; also true for a state that is not finite.
template <Body B>
bool has_fallen(const StateOf<B>& state, const Goal<B>& goal) {
  const bool is_up = state.pose.rotation()(2, 2) > std::cos(0.5) && center_of_mass<B>(state).z() > 0.5 * goal.com.z();
  return !is_up;
}

// Records how far points slide while they touch the ground.
template <Body B>
class Watch {
 public:
  using Vector = typename Sizes<B>::PointVector;

  void see(const typename Ground<B>::Contact& contact, const StateOf<B>& state, double step, Motion& motion) {
    const auto positions = ContactPoints<B>(state).positions;
    for (int i = 0; i < Sizes<B>::kPoints; ++i) {
      const Vector3d force = contact.forces.template segment<3>(3 * i);
      double& slid = slid_[static_cast<std::size_t>(i)];
      slid = force.z() > 0 ? slid + step * contact.velocities.template segment<2>(3 * i).norm() : 0;
      motion.greatest_slip = std::max(motion.greatest_slip, slid);
      motion.greatest_depth = std::max(motion.greatest_depth, -positions(2, i));
      if (force.z() > 0)
        motion.greatest_friction = std::max(motion.greatest_friction, force.template head<2>().norm() / force.z());
    }
  }

 private:
  std::array<double, Sizes<B>::kPoints> slid_ = {};
};

template <Body B, class Plan>
Motion simulate(const std::string& title, Plan plan, double duration, const Vector3d& push, double push_begins) {
  Motion motion;
  motion.title = title;
  motion.push = push;
  motion.push_begins = push_begins;
  motion.push_ends = push_begins + (push.isZero() ? 0 : kPushTime);
  Settings settings;
  settings.friction = kShare * kFriction;
  Controller<B> controller(settings);
  Ground<B> ground(kFriction, kControlStep / kStepsPerControl);
  Watch<B> watch;
  StateOf<B> state = standing_state<B>();
  const int controls = static_cast<int>(std::lround(duration / kControlStep));
  for (int i = 0; i <= controls && !motion.has_fallen; ++i) {
    const double time = i * kControlStep;
    const Goal<B> goal = plan(time, state);
    const double before = seconds();
    const auto command = controller(state, goal);
    const double took = seconds() - before;
    motion.times.push_back(took);
    motion.is_solved = motion.is_solved && command.is_best;
    motion.greatest_missing = std::max(motion.greatest_missing, command.missing.vector().cwiseAbs().maxCoeff());
    motion.greatest_torque = std::max(motion.greatest_torque, command.tau.cwiseAbs().maxCoeff());
    const bool is_pushed = time >= motion.push_begins && time < motion.push_ends;
    for (int k = 0; k < kStepsPerControl; ++k) {
      const Vector3d pushing = is_pushed ? push : Vector3d::Zero();
      state = ground(state, command.tau, pushing);
      motion.momentum_given += ground.step() * (pushing + Vector3d(0, 0, -9.81 * B::kMass));
      for (int point = 0; point < Sizes<B>::kPoints; ++point)
        motion.momentum_given += ground.step() * ground.contact().forces.template segment<3>(3 * point);
      watch.see(ground.contact(), state, ground.step(), motion);
    }
    motion.has_fallen = has_fallen<B>(state, goal);
    if (i % kControlsPerInstant == 0 || motion.has_fallen)
      motion.instants.push_back(instant_of<B>(time + kControlStep, state, goal.com, ground.contact().forces));
  }
  motion.momentum = B::kMass * com_velocity<B>(state);
  motion.last_speed = motion.momentum.norm() / B::kMass;
  return motion;
}

template <Body B>
Motion stands(const Vector3d& push) {
  return simulate<B>(
      std::string("The ") + B::kName + " stands and is pushed", Stand<B>(standing_state<B>()), 4, push, 1);
}

template <Body B>
Motion squats(double depth) {
  return simulate<B>(
      std::string("The ") + B::kName + " squats", Stand<B>(standing_state<B>(), depth), 4, Vector3d::Zero(), 0);
}

}  // namespace

Motion quadruped_stands(const Eigen::Vector3d& push) {
  return stands<Quadruped>(push);
}

Motion humanoid_stands(const Eigen::Vector3d& push) {
  return stands<Humanoid>(push);
}

Motion quadruped_squats(double depth) {
  return squats<Quadruped>(depth);
}

Motion humanoid_squats(double depth) {
  return squats<Humanoid>(depth);
}

Motion quadruped_trots(const Eigen::Vector3d& push) {
  return simulate<Quadruped>(
      "The quadruped trots in place and is pushed", Trot<Quadruped>(standing_state<Quadruped>()), 6, push, 2);
}

}  // namespace whole_body
