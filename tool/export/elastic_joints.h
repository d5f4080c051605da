// Series-elastic joints as documents write them: one joint, without the joint and the link that stand for its motor
// (model/elastic_joints.h).
#pragma once

#include <vector>

#include "language/kinematics/document.h"
#include "model/kinematic_tree.h"

namespace robcogen::exporting {

// Indices in the tree.
struct ElasticJoint {
  int joint = -1;
  int motor = -1;
  int tendon = -1;
};

// The elastic joints that can be written as one joint, in the order of the tree: those whose motors have the names,
// places and properties that reading gives them. Empty if their motors are not the last joints, in this order, which
// would change the order of q.
std::vector<ElasticJoint> elastic_joints(const model::KinematicTree& tree);

// The document of the tree in which these joints are written as one joint each.
language::kinematics::Document with_elastic_joints(
    const model::KinematicTree& tree,
    language::kinematics::Document document);

// The robot in which these joints are rigid: without their motors and springs.
model::KinematicTree with_rigid_joints(const model::KinematicTree& tree);

}  // namespace robcogen::exporting
