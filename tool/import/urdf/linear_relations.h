// Joints that follow others, from sums over joints that are zero.
#pragma once

#include <functional>
#include <map>
#include <vector>

#include "support/number.h"

namespace robcogen::import::from_urdf {

// The sum of factor times position over these joints is zero. No factor is zero.
using LinearRelation = std::map<int, Number>;  // factors by joint

struct SolvedRelations {
  struct Follower {
    std::size_t relation = 0;  // that determines the joint
    LinearRelation sum;        // with factor 1 of the joint; of no other joint that follows
  };
  struct Unsolved {
    std::size_t relation = 0;
    bool is_redundant = false;  // it follows from those before it
  };

  std::map<int, Follower> followers;  // by joint
  std::vector<Unsolved> unsolved;     // relations by which no joint follows
};

// Gauss-Jordan elimination, with exact numbers as long as they are rational. Each relation in turn makes one joint
// follow: of those that may, and do not follow yet, the last.
SolvedRelations solve(const std::vector<LinearRelation>& relations, const std::function<bool(int)>& may_follow);

}  // namespace robcogen::import::from_urdf
