// The search for link frames in which a program costs least.
#pragma once

#include "algorithm/search/limb_trials.h"

namespace robcogen::algorithm {

// Coordinate descent, link by link from the base: directions of common normals, of first moments and principal axes
// for the turn; feet of common normals and points where products of inertia vanish for the slide; with and without the
// joint. The cost of a choice is that of the whole trace of the links between the base and the leaves beyond the link.
// Limbs that correspond to each other (model/limbs.h) get corresponding frames.
//
// A choice that costs less is taken only if it keeps the digits of the plain formulation (symbolic/accuracy.h), and if
// its constants are not much larger.
//
// Bounded by the number of statements that are traced, not by time: the same robot has the same frames everywhere.
// `formulation.effort` scales that bound; its frames are where the search starts, and the result where there is nothing
// to choose.
LinkFrames cheap_frames(const model::KinematicTree& tree, const Formulation& formulation, const TraceOf& trace);

}  // namespace robcogen::algorithm
