// Choices between forms of the same dynamics. Any of them can be switched off: results differ by rounding only.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "algorithm/formulation/link_frames.h"
#include "symbolic/derivative.h"

namespace robcogen::algorithm {

struct Formulation {
  bool regroup = true;  // mass properties that a joint does not feel move to the parent (base_parameters.h)
  bool choose_forward_dynamics = true;  // by inertia matrix where that is quicker; else always by articulated bodies
  bool choose_frames = true;            // turned and slid along joint axes, where that is cheaper (link_frames.h)
  bool turn_inertia = true;             // of links, instead of the vectors of the recursion, where that is cheaper
  bool choose_reverse_mode = true;      // for derivatives of programs, where that is cheaper; else always forward mode
  int effort = 0;                       // of the search for such frames (frame_search.h); 0: none
  LinkFrames frames = {};               // those that were found; empty: the model's

  // For traces that are only compared: without names, and with the numbers of the model computed before (together with
  // `frames` only).
  bool is_draft = false;
  std::shared_ptr<const LinkNumbers> numbers = nullptr;

  // For programs whose congruent limbs are to share lanes: their representative numbers; not for drafts.
  RepresentativeLinks representative = {};
};

// Chooses nothing: the algorithms of the textbook in the frames of the model, the reference for all others.
Formulation plain_formulation();

symbolic::DerivativeMode derivative_mode(const Formulation& formulation);

// Names of the choices, in the order of the fields.
const std::vector<std::string>& choices();

// Removes the choices from a list of names: those found are on, the others off. The remaining names are not checked.
Formulation take_formulation(std::vector<std::string>& names);

}  // namespace robcogen::algorithm
