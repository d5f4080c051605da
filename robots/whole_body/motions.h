// Motions of the quadruped and the humanoid under whole-body control, simulated on the ground.
#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

namespace whole_body {

inline constexpr double kControlStep = 0.001;  // s
inline constexpr double kFriction = 0.6;       // of the ground

// Recorded every 20 ms.
struct Instant {
  double time;                                      // s
  Eigen::Vector3d com, goal;                        // centre of mass, and where it should be; world
  double tilt;                                      // rad, of the base
  std::vector<double> loads;                        // vertical force of each contact, N
  std::vector<std::vector<Eigen::Vector3d>> lines;  // the robot, in the world
};

struct Motion {
  std::string title;
  std::vector<Instant> instants;
  double push_begins = 0, push_ends = 0;  // s
  Eigen::Vector3d push = {0, 0, 0};       // N
  bool has_fallen = false;  // the simulation ends there: the base tilted by half a radian, or low above the ground
  // Over all steps of the simulation.
  double greatest_slip = 0;      // m, of a point since it touched
  double greatest_friction = 0;  // horizontal divided by vertical force, of a point
  double greatest_depth = 0;     // m, of a point below the ground
  double greatest_torque = 0;    // N m
  double last_speed = 0;         // at the end, of the centre of mass, m/s
  // Momentum (N s) that the ground, gravity and the push gave, and momentum of the centre of mass.
  Eigen::Vector3d momentum_given = {0, 0, 0}, momentum = {0, 0, 0};
  // Results of the controller.
  double greatest_missing = 0;  // wrench on the base that its forces do not provide (N, N m)
  bool is_solved = true;
  std::vector<double> times;  // s, of each call
};

// A force (N) pushes the base for a tenth of a second; afterwards there is time to recover.
Motion quadruped_stands(const Eigen::Vector3d& push);
Motion quadruped_trots(const Eigen::Vector3d& push);
Motion humanoid_stands(const Eigen::Vector3d& push);
// The centre of mass goes down by `depth` (m) and up again, twice.
Motion quadruped_squats(double depth);
Motion humanoid_squats(double depth);

}  // namespace whole_body
