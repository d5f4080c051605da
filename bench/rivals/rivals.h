// Code that other generators made, as peers of the benchmark of the robot that it was made for.
#pragma once

#include <vector>

#include "peers/peer.h"

namespace robcogen::rivals {

struct Rival;

// The peer, or the reason why the code is not of this robot.
peers::Candidate candidate(const Rival& rival, const peers::Subject& subject);

}  // namespace robcogen::rivals
