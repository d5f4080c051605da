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
  bool may_say_assembled = false;    // as in Description

  const std::string& name(int joint) const;
  std::string quoted(const std::vector<int>& joints) const;
  // Positions of all joints where loops are assembled, of joints that follow near there: as the document gives them,
  // or zero; of coupled joints as those that they follow have it.
  std::vector<double> start() const;
  // Whether the document gives the position of any of these joints there.
  bool has_start(const std::vector<int>& joints) const;
  // Where that is, behind a verb.
  std::string where(const std::vector<int>& joints) const;
  // The hint where loops with these joints do not close.
  std::string hint_to_close(const std::vector<int>& joints) const;
  // The hint to assemble loops with these joints in another position: such that they are open, for example.
  std::string hint_to_assemble(const std::vector<int>& joints, const std::string& how) const;
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
