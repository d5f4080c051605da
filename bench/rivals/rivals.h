// Code that other generators made for a robot, as peers in the benchmark of that robot.
#pragma once

#include <vector>

#include "peers/peer.h"

namespace robcogen::rivals {

struct Rival;

// The peer, or the reason why the code does not belong to this robot.
peers::Candidate candidate(const Rival& rival, const peers::Subject& subject);

}  // namespace robcogen::rivals
