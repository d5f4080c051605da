// Composite rigid bodies: a link and all beyond it, frozen at the present joint positions.
#pragma once

#include <vector>

#include "algorithm/dynamics/traced_robot.h"

namespace robcogen::algorithm {

// By link, about the link's origin in link axes. The base's only when it floats.
std::vector<MassProperties> composite_bodies(const TracedRobot& robot);

// All that moves, frozen: every link but a fixed base; about the base origin in base axes.
MassProperties moving_body(const TracedRobot& robot, const std::vector<MassProperties>& composite);

// -I^-1 missing: the acceleration of a free body that lacks the wrench `missing`.
Motion free_acceleration(const SpatialInertia& body, const Force& missing);

// Adds to tau[j] the force that a common acceleration of the base takes at joint j.
void add_composite_forces(
    const TracedRobot& robot,
    const std::vector<MassProperties>& composite,
    const Motion& base_acceleration,
    std::vector<Expression>& tau);

// The joint-space inertia matrix H (Featherstone 2008, table 6.2); a floating base's 6 rows and columns first. Zeros
// that branches induce are the constant zero. Of coupled joints G' H G.
SquareMatrix joint_space_inertia(const TracedRobot& robot);
// The same with rows and columns of all joints, those that follow others too.
SquareMatrix inertia_by_joint(const TracedRobot& robot);

// Of a floating base's rows, then of those of all joints.
std::vector<std::string> joint_names(const model::KinematicTree& tree);

// Of the rows of the joint-space inertia matrix: those of a floating base, then coordinates.
std::vector<std::string> coordinate_names(const model::KinematicTree& tree);

}  // namespace robcogen::algorithm
