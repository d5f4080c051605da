// The formulation of a robot's dynamics: link frames, inertias and algorithms. All formulations give the same results
// up to rounding.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "algorithm/formulation/link_frames.h"
#include "symbolic/derivative.h"

namespace robcogen::algorithm {

struct Formulation {
  // Choices that can be switched off.
  bool base_parameters = true;          // base inertial parameters instead of those of the links (base_parameters.h)
  bool choose_forward_dynamics = true;  // by the inertia matrix where that is faster; off: always articulated bodies
  bool choose_frames = true;            // link frames that cost less than the model's (link_frames.h)
  bool turn_inertia = true;             // link inertias in the axes of the parent link, where that costs less
  bool choose_reverse_mode = true;      // reverse mode for derivatives, where that costs less; off: forward mode
  int effort = 0;                       // of the search for link frames (frame_search.h); 0: no search
  LinkFrames frames = {};               // the frames that the search found; empty: the model's

  // For programs that are only counted: their values have no names, and the numbers of the model are precomputed in
  // `numbers` (only together with `frames`).
  bool is_draft = false;
  std::shared_ptr<const LinkNumbers> numbers = nullptr;

  // For programs that compute congruent limbs in lanes: the representative numbers of the limbs. Not for drafts.
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
