// The state that the functions which resolve loops share.
#pragma once

#include <map>
#include <set>
#include <string>
#include <vector>

#include "model/description.h"
#include "model/kinematic_tree.h"
#include "model/loop_plane.h"

namespace robcogen::model {

struct LoopContext {
  KinematicTree& tree;
  Diagnostics& diagnostics;
  std::vector<double> parameters;    // default values
  std::set<int> given;               // joints that are part of couplings
  std::map<int, Place> independent;  // joints that are to be independent
  AssembledForm assembled_form = AssembledForm::none;
  std::set<int> driven = {};  // joints that the description names as such

  const std::string& name(int joint) const;
  std::string quoted(const std::vector<int>& joints) const;
  // Returns the positions (rad, m) of all joints where loops are assembled, approximate for dependent joints: as the
  // document gives them, or zero; coupled joints follow by their couplings.
  std::vector<double> start() const;
  // Whether the document gives any of these joints such a position other than zero.
  bool has_start(const std::vector<int>& joints) const;
  // Returns a phrase that says where loops are assembled, to follow a verb.
  std::string where(const std::vector<int>& joints) const;
  // The position of a joint as the document writes it: `assembled = 0.5`. The format must have such positions.
  std::string assembled_text(double position) const;
  // The hint for loops with these joints that do not close.
  std::string hint_to_close(const std::vector<int>& joints) const;
  // The hint to assemble loops with these joints in another position, such as one in which they are open.
  std::string hint_to_assemble(const std::vector<int>& joints, const std::string& how) const;
  // Whether a joint may be dependent.
  bool is_free(int joint) const;
  bool is_driven(int joint) const;
  // The hint to remove some of these joints from the list of independent joints, or empty.
  std::string hint_to_free(const std::vector<int>& joints) const;
  void report(const LoopJoint& loop, const PlaneFault& fault);
};

// The joints of both ends of a loop.
std::vector<int> joints_of(const LoopJoint& loop);

}  // namespace robcogen::model
