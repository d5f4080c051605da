// The trials of a search for link frames, limb by limb, so that nothing is traced twice.
#pragma once

#include <cstddef>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <vector>

#include "algorithm/formulation/formulation.h"
#include "algorithm/search/limb_view.h"
#include "algorithm/spatial/trace.h"
#include "symbolic/accuracy.h"

namespace robcogen::algorithm {

// Traces the function for which frames are searched, of the whole robot or of a part of it.
using TraceOf = std::function<void(Trace&, const Formulation&)>;

struct Trial {
  symbolic::TracedCost cost;
  std::optional<bool> keeps_digits = {};  // set when it is first requested
  bool is_counted = false;                // among the statements of the search
};

// The trials of one limb.
class Trials {
 public:
  // The trial with these frames, one per joint of the limb. `trace` is called if they are new.
  Trial& in_frames(const LinkFrames& frames, const std::function<symbolic::TracedCost()>& trace);

 private:
  std::vector<LinkFrames> known_;           // by joint of the limb: the frames that it was seen in
  std::map<std::vector<int>, Trial> done_;  // by the index of each joint's frame in known_
};

// The trials of all limbs of a robot. The limb of a joint is made of the links that the joint moves and those that
// carry it, except limbs that are left out because the program computes them in the lanes of others.
class LimbTrials {
 public:
  // `formulation`: for everything but the frames. `numbers`: of a robot without parameters, otherwise nullptr.
  // `left_out`: by joint.
  LimbTrials(
      const model::KinematicTree& tree,
      const Formulation& formulation,
      const TraceOf& trace,
      const std::shared_ptr<const LinkNumbers>& numbers,
      const std::vector<bool>& left_out = {});

  // The trial of the limb of a joint that is not left out; `frames` are those of all joints of the robot.
  Trial& of(int joint, const LinkFrames& frames);
  // Whether the limb's trace keeps the digits that it keeps in the frames of the model, with the same mass properties,
  // which may include shares of other limbs. `trial` is the trial of these frames.
  bool keeps_digits(int joint, const LinkFrames& frames, Trial& trial);

 private:
  struct Limb {
    LimbView view;
    std::shared_ptr<const LinkNumbers> numbers;
    std::shared_ptr<const symbolic::AccurateResults> results;  // set when they are first requested
    Trials trials;
    std::size_t nodes = 0;  // the most that a trial had
  };

  const Formulation& formulation_;
  const TraceOf& trace_;
  std::vector<Limb> limbs_;  // by joint

  Formulation draft(const Limb& limb, LinkFrames frames) const;
};

// The program of a formulation, and its reference results.
symbolic::Program program_of(const model::KinematicTree& tree, const TraceOf& trace, const Formulation& formulation);
std::shared_ptr<const symbolic::AccurateResults> results_of(
    const model::KinematicTree& tree,
    const TraceOf& trace,
    const Formulation& formulation);

}  // namespace robcogen::algorithm
