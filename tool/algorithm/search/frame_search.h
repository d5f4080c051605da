// The search for link frames in which a program costs least.
#pragma once

#include "algorithm/search/limb_trials.h"

namespace robcogen::algorithm {

// Coordinate descent, link by link from the base: directions of common normals, of first moments and principal axes for
// the turn; feet of common normals and points where products of inertia vanish for the slide; turning with the joint or
// not. The cost of a choice is that of the whole trace of the links between the base and the leaves beyond the link.
// Limbs that correspond to each other (model/limbs.h) get corresponding frames.
//
// A choice that costs less is taken only if it keeps the digits of the plain formulation (symbolic/accuracy.h), and if
// its constants are not much larger.
//
// The search is bounded by the number of traced statements, not by time, so that the same robot has the same frames on
// every machine. `formulation.effort` scales that bound; `formulation.frames` are where the search starts, and the
// result if there is nothing to choose.
LinkFrames cheap_frames(const model::KinematicTree& tree, const Formulation& formulation, const TraceOf& trace);

}  // namespace robcogen::algorithm
