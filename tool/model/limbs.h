// Congruent limbs of a kinematic tree, such as the legs of a quadruped or the arms of a humanoid. They agree in
// topology and joint types; dimensions and masses may differ.
#pragma once

#include <vector>

#include "model/kinematic_tree.h"

namespace robcogen::model {

// Two or more congruent limbs on one link. limbs[i][k] is joint k of limb i, with parents before children. Joints of
// the same k correspond: they have the same type, their parents correspond, and so do their children.
struct LimbClass {
  std::vector<std::vector<int>> limbs;

  std::size_t count() const { return limbs.size(); }
  std::size_t length() const { return limbs.front().size(); }
  // Joint k of every limb.
  std::vector<int> corresponding(std::size_t k) const;
};

// Numbers the shapes of the subtrees of joints: two joints have the same number if and only if their types agree and
// the subtrees on their links can be paired, shape by shape. Couplings within a limb are part of its shape. A joint
// that is coupled to a joint of another limb, or through a loop, has a shape of its own.
std::vector<int> limb_shapes(const KinematicTree& tree);

// Returns the joints from this one on, depth first, with children sorted by shape and children of equal shape in the
// order of the document. So the joints of two limbs of the same shape correspond one by one.
std::vector<int> limb_joints(const KinematicTree& tree, const std::vector<int>& shapes, int first);

// Returns the classes of congruent limbs, from the base outwards. Limbs within a limb of a class are not searched: the
// fingers of two congruent arms correspond from arm to arm, not within a hand. Limbs stand in the order of the
// document's children, and so do the interchangeable branches of a limb.
std::vector<LimbClass> limb_classes(const KinematicTree& tree);

// The joints of all classes, corresponding ones together: {LF_HAA, RF_HAA, LH_HAA, RH_HAA}, …
std::vector<std::vector<int>> corresponding_joints(const KinematicTree& tree);

}  // namespace robcogen::model
