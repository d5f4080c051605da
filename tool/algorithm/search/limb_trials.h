// What a search for link frames has tried, limb by limb, so that it traces nothing twice.
#pragma once

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
  symbolic::Weight weight;
  std::optional<bool> keeps_digits = {};  // once it was asked for
};

// The trials of one limb.
class Trials {
 public:
  // That of these frames, one a joint of the limb; weighed when they are new.
  Trial& in_frames(const LinkFrames& frames, const std::function<symbolic::Weight()>& weigh);

 private:
  std::vector<LinkFrames> known_;           // by joint of the limb: the frames that it was seen in
  std::map<std::vector<int>, Trial> done_;  // by the index of each joint's frame in known_
};

// The trials of all limbs of a robot: of each joint, that which the joint moves or which carries it.
class LimbTrials {
 public:
  // `formulation` for all but the frames; `numbers` of a robot without parameters, else nullptr.
  LimbTrials(
      const model::KinematicTree& tree,
      const Formulation& formulation,
      const TraceOf& trace,
      const std::shared_ptr<const LinkNumbers>& numbers);

  // That of a joint's limb in these frames of all joints of the robot.
  Trial& of(int joint, const LinkFrames& frames);
  // Whether the limb's trace keeps the digits that it keeps in the frames of the model: with the same mass properties,
  // which other limbs may have a share in. `trial` is that of these frames.
  bool keeps_digits(int joint, const LinkFrames& frames, Trial& trial);

 private:
  struct Limb {
    LimbView view;
    std::shared_ptr<const LinkNumbers> numbers;
    std::shared_ptr<const symbolic::AccurateResults> results;  // once they were asked for
    Trials trials;
  };

  const Formulation& formulation_;
  const TraceOf& trace_;
  std::vector<Limb> limbs_;  // by joint

  Formulation draft(const Limb& limb, LinkFrames frames) const;
};

// The program of a formulation, and the results that it should have.
symbolic::Program program_of(const model::KinematicTree& tree, const TraceOf& trace, const Formulation& formulation);
std::shared_ptr<const symbolic::AccurateResults> results_of(
    const model::KinematicTree& tree,
    const TraceOf& trace,
    const Formulation& formulation);

}  // namespace robcogen::algorithm
