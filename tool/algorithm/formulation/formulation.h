// Choices between forms of the same dynamics. Any of them can be switched off: results differ by rounding only.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "algorithm/formulation/link_frames.h"
#include "symbolic/derivative.h"

namespace robcogen::algorithm {

struct Formulation {
  bool base_parameters = true;  // mass properties that a joint does not feel move to the parent (base_parameters.h)
  bool choose_forward_dynamics = true;  // by inertia matrix where that is faster; off: always articulated bodies
  bool choose_frames = true;            // moved about and along joint axes, where that is cheaper (link_frames.h)
  bool turn_inertia = true;             // rotate link inertias instead of motion vectors, where that is cheaper
  bool choose_reverse_mode = true;      // for derivatives of programs, where that is cheaper; off: forward mode only
  int effort = 0;                       // of the search for link frames (frame_search.h); 0: no search
  LinkFrames frames = {};               // the frames that were found; empty: the model's

  // For traces that are only compared: names are left out, and the numbers of the model are precomputed (only together
  // with `frames`).
  bool is_draft = false;
  std::shared_ptr<const LinkNumbers> numbers = nullptr;

  // For programs whose congruent limbs are to share lanes: the representative numbers of the limbs. Not for drafts.
  RepresentativeLinks representative = {};
};

// All choices off: the textbook algorithms in the frames of the model, the reference for all other formulations.
Formulation plain_formulation();

symbolic::DerivativeMode derivative_mode(const Formulation& formulation);

// Names of the choices, in the order of the fields.
const std::vector<std::string>& choices();

// Removes the choices from a list of names: those found are on, the others off. The remaining names are not checked.
Formulation take_formulation(std::vector<std::string>& names);

}  // namespace robcogen::algorithm
