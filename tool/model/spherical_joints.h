// Spherical joints of a tree under construction.
#pragma once

#include "model/kinematic_tree.h"

namespace robcogen::model {

// Replaces each spherical joint, which is a single joint so far, by its three components, between repeated links behind
// all others. Indices of joints change; those of links stay.
void expand_spherical_joints(KinematicTree& tree);

}  // namespace robcogen::model
