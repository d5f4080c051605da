// The table of inverse kinematics in <name>/reflection.h.
#pragma once

#include "backend/cpp/flat_tables.h"

namespace robcogen::backend::cpp {

// One row for each chain (robcogen::reflection::InverseKinematics).
Table inverse_kinematics(const Api& api);

}  // namespace robcogen::backend::cpp
