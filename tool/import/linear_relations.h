// Determines joints that follow others from linear relations between joint positions.
#pragma once

#include <functional>
#include <map>
#include <vector>

#include "support/number.h"

namespace robcogen::import {

// The sum of factor times position over these joints is zero. No factor is zero.
using LinearRelation = std::map<int, Number>;  // factors by joint

struct SolvedRelations {
  struct Follower {
    std::size_t relation = 0;  // index of the relation that determines the joint
    LinearRelation sum;        // with factor 1 for the joint; contains no other follower
  };
  struct Unsolved {
    std::size_t relation = 0;
    bool is_redundant = false;  // it follows from the relations before it
  };

  std::map<int, Follower> followers;  // by joint
  std::vector<Unsolved> unsolved;     // relations that determine no joint
};

// Solves the relations by Gauss-Jordan elimination, with exact numbers as long as they are rational. Each relation in
// turn determines one joint: the last of those that may follow and do not follow yet.
SolvedRelations solve(const std::vector<LinearRelation>& relations, const std::function<bool(int)>& may_follow);

}  // namespace robcogen::import
