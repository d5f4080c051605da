// Plans of a robot over time: goals for the whole-body controller.
#pragma once

#include <algorithm>
#include <cmath>

#include "controller.h"

namespace whole_body {

// The centre of mass above the middle of the contacts.
template <Body B>
Vector3d com_above_contacts(const StateOf<B>& state) {
  Vector3d com = center_of_mass<B>(state);
  com.head<2>() = ContactPoints<B>(state).positions.template topRows<2>().rowwise().mean();
  return com;
}

// Stands, and squats by a depth (m) in some seconds.
template <Body B>
class Stand {
 public:
  explicit Stand(const StateOf<B>& start, double depth = 0, double period = 2)
      : com_(com_above_contacts<B>(start)), depth_(depth), rate_(2 * M_PI / period) {}

  Goal<B> operator()(double time, const StateOf<B>&) const {
    Goal<B> goal;
    const double angle = rate_ * time, half = depth_ / 2;
    goal.com = com_ - Vector3d(0, 0, half * (1 - std::cos(angle)));
    goal.com_velocity = Vector3d(0, 0, -half * rate_ * std::sin(angle));
    goal.com_acceleration = Vector3d(0, 0, -half * rate_ * rate_ * std::cos(angle));
    return goal;
  }

 private:
  Vector3d com_;
  double depth_, rate_;
};

// Trots in place: diagonal pairs of feet take turns in the air, and land where they can stop the robot (the capture
// point of Pratt, Carff, Drakunov, Goswami 2006).
template <Body B>
class Trot {
 public:
  explicit Trot(const StateOf<B>& start) : com_(com_above_contacts<B>(start)) {
    const ContactPoints<B> points(start);
    for (int c = 0; c < B::kContacts; ++c) {
      home_[static_cast<std::size_t>(c)] = points.positions.col(c) - com_;
      lifted_[static_cast<std::size_t>(c)] = points.positions.col(c);
    }
  }

  Goal<B> operator()(double time, const StateOf<B>& state) {
    Goal<B> goal;
    goal.com = com_;
    const double in_step = std::fmod(time, kStep), phase = (in_step - (kStep - kSwing)) / kSwing;
    const bool is_first_pair = static_cast<long>(std::floor(time / kStep)) % 2 == 0;
    const ContactPoints<B> points(state);
    const Vector3d com = center_of_mass<B>(state), velocity = com_velocity<B>(state);
    for (std::size_t c = 0; c < goal.feet.size(); ++c) {
      const bool is_in_first_pair = c == 0 || c == 3;
      if (phase < 0 || time < kStart || is_in_first_pair != is_first_pair) {
        lifted_[c] = points.positions.col(static_cast<int>(c));
        continue;
      }
      if (phase < kAimed) {
        // The foot lands where the robot can stop, a little towards where it started.
        target_[c] = com + home_[c] + std::sqrt(com_.z() / 9.81) * velocity + kBack * (com_ - com);
        target_[c].z() = -kPress;
      }
      goal.feet[c] = in_air(phase, lifted_[c], target_[c]);
    }
    return goal;
  }

 private:
  static constexpr double kStart = 0.3;                // s, all feet on the ground
  static constexpr double kStep = 0.3, kSwing = 0.25;  // s, of a pair; between swings all feet are on the ground
  static constexpr double kAimed = 0.6;                // fraction of a swing until which its end may change
  static constexpr double kBack = 0.2;                 // fraction of the distance to the start, per step
  static constexpr double kLift = 0.08;                // m
  static constexpr double kPress = 0.004;              // m below the ground at which feet aim, to touch it in time

  // A smooth motion from rest to rest, with a rise and fall of the foot.
  static typename Goal<B>::Foot in_air(double s, const Vector3d& from, const Vector3d& to) {
    const double along = s * s * s * (10 - 15 * s + 6 * s * s), up = 16 * s * s * (1 - s) * (1 - s);
    const double along_rate = 30 * s * s * (1 - s) * (1 - s), up_rate = 32 * s * (1 - s) * (1 - 2 * s);
    const double along_bend = 60 * s * (1 - s) * (1 - 2 * s), up_bend = 32 * (1 - 6 * s + 6 * s * s);
    const Vector3d lift(0, 0, kLift);
    return {
        false, from + along * (to - from) + up * lift, (along_rate * (to - from) + up_rate * lift) / kSwing,
        (along_bend * (to - from) + up_bend * lift) / (kSwing * kSwing)};
  }

  Vector3d com_;
  // For each foot: initial position relative to the centre of mass, where it left the ground, where it will land.
  std::array<Vector3d, B::kContacts> home_, lifted_, target_;
};

}  // namespace whole_body
