// What the resolution of loops knows of the joints of a tree.
#pragma once

#include <map>
#include <set>
#include <string>
#include <vector>

#include "model/kinematic_tree.h"
#include "model/loop_plane.h"

namespace robcogen::model {

struct LoopContext {
  KinematicTree& tree;
  Diagnostics& diagnostics;
  std::vector<double> parameters;    // their defaults
  std::set<int> given;               // joints of couplings
  std::map<int, Place> independent;  // joints that are to be independent

  const std::string& name(int joint) const;
  std::string quoted(const std::vector<int>& joints) const;
  std::vector<double> zeros() const { return std::vector<double>(tree.joints.size()); }
  // Whether a joint may follow others.
  bool is_free(int joint) const;
  bool is_driven(int joint) const;
  // The hint to leave out of the list some of these joints that are to be independent; or empty.
  std::string hint_to_free(const std::vector<int>& joints) const;
  void report(const LoopJoint& loop, const PlaneFault& fault);
};

// The joints of both ends.
std::vector<int> joints_of(const LoopJoint& loop);

}  // namespace robcogen::model
