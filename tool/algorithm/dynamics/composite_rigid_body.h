// Composite rigid bodies: a link and all beyond it, frozen at the present joint positions.
#pragma once

#include <vector>

#include "algorithm/dynamics/traced_robot.h"

namespace robcogen::algorithm {

// The composite bodies by link, about the link's origin in link axes; that of the base only if it floats.
std::vector<MassProperties> composite_bodies(const TracedRobot& robot);

// All that moves (every link but a fixed base) as one body, about the base origin in base axes.
MassProperties moving_body(const TracedRobot& robot, const std::vector<MassProperties>& composite);

// -I^-1 missing: the acceleration of a free body that lacks the wrench `missing`.
Motion free_acceleration(const SpatialInertia& body, const Force& missing);

// Adds to tau[j] the force that an acceleration of the base, common to all links, takes at joint j.
void add_composite_forces(
    const TracedRobot& robot,
    const std::vector<MassProperties>& composite,
    const Motion& base_acceleration,
    std::vector<Expression>& tau);

// The joint-space inertia matrix H (Featherstone 2008, table 6.2); a floating base's 6 rows and columns first. Zeros
// that branches induce are the constant zero. With coupled joints it is G' H G.
SquareMatrix joint_space_inertia(const TracedRobot& robot);
// The same with rows and columns of all joints, including those that follow others.
SquareMatrix inertia_by_joint(const TracedRobot& robot);

// Names of the rows of a floating base, then of the rows of all joints.
std::vector<std::string> joint_names(const model::KinematicTree& tree);

// Names of the rows of the joint-space inertia matrix: those of a floating base, then coordinates.
std::vector<std::string> coordinate_names(const model::KinematicTree& tree);

}  // namespace robcogen::algorithm
