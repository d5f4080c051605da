// The check of collisions that ends early, for the languages that have one.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "backend/library.h"
#include "driver/steps.h"

namespace robcogen::driver {

// None if the group `collision` was not asked for, or the robot has no collision shapes, or parameters move them.
std::optional<backend::CollisionCheck> collision_check(
    const model::KinematicTree& tree,
    const std::vector<std::string>& groups,
    const Steps& steps);

}  // namespace robcogen::driver
