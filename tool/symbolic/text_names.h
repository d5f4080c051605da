// The keywords of programs as text.
#pragma once

#include <array>

#include "symbolic/program.h"

namespace robcogen::symbolic {

struct RoleName {
  Role role;
  const char* name;
};
inline constexpr std::array kRoles = {
    RoleName{Role::joint_position, "joint_position"},
    RoleName{Role::joint_reference, "joint_reference"},
    RoleName{Role::joint_sine, "joint_sine"},
    RoleName{Role::joint_cosine, "joint_cosine"},
    RoleName{Role::joint_velocity, "joint_velocity"},
    RoleName{Role::joint_acceleration, "joint_acceleration"},
    RoleName{Role::joint_force, "joint_force"},
    RoleName{Role::gravity, "gravity"},
    RoleName{Role::base_pose, "base_pose"},
    RoleName{Role::base_velocity, "base_velocity"},
    RoleName{Role::base_acceleration, "base_acceleration"},
    RoleName{Role::base_wrench, "base_wrench"},
    RoleName{Role::link_wrenches, "link_wrenches"},
    RoleName{Role::inertia_matrix, "inertia_matrix"},
    RoleName{Role::inertia_factor, "inertia_factor"},
    RoleName{Role::inverse_diagonal, "inverse_diagonal"},
    RoleName{Role::homogeneous, "homogeneous"},
    RoleName{Role::spatial_motion, "spatial_motion"},
    RoleName{Role::spatial_force, "spatial_force"},
    RoleName{Role::jacobian, "jacobian"},
    RoleName{Role::jacobian_in_target, "jacobian_in_target"},
    RoleName{Role::spatial_jacobian, "spatial_jacobian"},
    RoleName{Role::jacobian_derivative, "jacobian_derivative"},
    RoleName{Role::matrix, "matrix"},
    RoleName{Role::frame_velocity, "frame_velocity"},
    RoleName{Role::frame_acceleration, "frame_acceleration"},
    RoleName{Role::frame_bias_acceleration, "frame_bias_acceleration"},
    RoleName{Role::position, "position"},
    RoleName{Role::energy, "energy"},
    RoleName{Role::mass, "mass"},
    RoleName{Role::distance, "distance"},
    RoleName{Role::parameters, "parameters"},
    RoleName{Role::variables, "variables"},
    RoleName{Role::contact_activity, "contact_activity"},
    RoleName{Role::contact_compliance, "contact_compliance"},
    RoleName{Role::residual, "residual"},
    RoleName{Role::value, "value"}};

struct OpName {
  Op op;
  const char* name;
};
inline constexpr std::array kOps = {
    OpName{Op::add, "+"},
    OpName{Op::subtract, "-"},
    OpName{Op::multiply, "*"},
    OpName{Op::divide, "/"},
    OpName{Op::square_root, "sqrt"},
    OpName{Op::sine, "sin"},
    OpName{Op::cosine, "cos"},
    OpName{Op::arc_tangent, "atan2"},
    OpName{Op::gather, "gather"},
    OpName{Op::sum_lanes, "sum_lanes"}};

}  // namespace robcogen::symbolic
