// The arrays that functions share, and their sizes.
#pragma once

#include <vector>

#include "algorithm/catalogue/declaration.h"

namespace robcogen::algorithm::catalogue {

// ---- Conditions on the robot and on the overload.

bool is_floating(const Subject& s);
bool is_fixed(const Subject& s);
bool has_free_base(const Subject& s);  // the robot as one body has a regular inertia
bool takes_gravity(const Subject& s);
bool takes_external(const Subject& s);
bool has_loops(const Subject& s);
bool has_spherical_joints(const Subject& s);
bool is_declared(const model::Coupling& coupling);  // in the document, not through a loop
bool has_declared_couplings(const Subject& s);
bool lacks_inertia_with_cut_loops(const Subject& s);  // some joint then moves no inertia

// ---- Sizes.

template <int count>
int rows(const Subject&) {
  return count;
}
int coordinates(const Subject& s);
int positions(const Subject& s);   // elements of q
int velocities(const Subject& s);  // rows of the joint-space inertia matrix: those of a floating base, coordinates
int joints(const Subject& s);      // those that follow others included
int chain(const Subject& s);       // coordinates that move one frame with respect to the other
int contact_count(const Subject& s);
int contact_rows(const Subject& s);
int velocities_and_contact_rows(const Subject& s);
int rows_of_wrenches(const Subject& s);  // six per link
int actuators(const Subject& s);
int loop_rows(const Subject& s);
std::vector<int> force_counts(const model::KinematicTree& tree);  // by loop: how many numbers describe its force

// ---- Arrays.

using symbolic::Role;

inline constexpr Array q{"q", Role::joint_position, positions};
inline constexpr Array qd{"qd", Role::joint_velocity, coordinates};
inline constexpr Array qdd{"qdd", Role::joint_acceleration, coordinates};
inline constexpr Array tau{"tau", Role::joint_force, coordinates};
inline constexpr Array base_pose{"base_pose", Role::base_pose, rows<7>};
inline constexpr Array base_velocity{"base_velocity", Role::base_velocity, rows<6>, nullptr, is_floating};
inline constexpr Array base_acceleration{"base_acceleration", Role::base_acceleration, rows<6>, nullptr, is_floating};
inline constexpr Array base_wrench{"base_wrench", Role::base_wrench, rows<6>, nullptr, is_floating};
inline constexpr Array gravity{"gravity", Role::gravity, rows<3>, nullptr, takes_gravity};
inline constexpr Array external{"external", Role::link_wrenches, rows_of_wrenches, nullptr, takes_external};

inline const std::vector<Array> motion = {q, qd, qdd, base_velocity, base_acceleration};

constexpr Array value(const char* name, Size rows, Condition exists = nullptr) {
  return {name, Role::value, rows, nullptr, exists};
}
constexpr Array matrix(const char* name, Size rows, Size columns, Condition exists = nullptr) {
  return {name, Role::matrix, rows, columns, exists};
}

// ---- Text.

inline constexpr const char* kConstantWrenches =
    "{external? The wrenches are constant in these coordinates: they move with their links.}";

}  // namespace robcogen::algorithm::catalogue
