// Spherical joints of a tree under construction.
#pragma once

#include "model/kinematic_tree.h"

namespace robcogen::model {

// Replaces each spherical joint, which is a single joint until then, by its three components. The repeated links
// between them are added after all other links. Indices of joints change; indices of links stay.
void expand_spherical_joints(KinematicTree& tree);

}  // namespace robcogen::model
