// Drives of joints, for the constants of generated models.
#pragma once

namespace robcogen {

// Quantities that the drive of a joint adds to the dynamics, in SI units; all zero without a drive.
struct JointDrive {
  double damping = 0;                // force per velocity
  double friction = 0;               // Coulomb friction: a force against the velocity
  double friction_velocity = 0;      // speed below which friction falls to zero; 0: friction jumps
  double armature = 0;               // inertia that only the motion of this joint feels
  double stiffness = 0;              // force per distance from `rest`
  double rest = 0;                   // rad or m
  double rotor_inertia = 0;          // about the rotor's axis
  double rotor_ratio = 0;            // velocity of the rotor in its carrier per velocity of the joint
  double rotor_axis[3] = {0, 0, 0};  // of unit length, in axes of the carrier
  int rotor_carrier = -1;            // link index; -1: no rotor
};

}  // namespace robcogen
