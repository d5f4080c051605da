// What a search for link frames has tried, so that it traces nothing twice.
#pragma once

#include <functional>
#include <map>
#include <optional>
#include <vector>

#include "algorithm/formulation/link_frames.h"
#include "symbolic/program.h"

namespace robcogen::algorithm {

// What the search asks of a traced program.
struct Trial {
  explicit Trial(const symbolic::Program& program);

  int work = 0;
  long statements = 0;
  double largest_constant = 0.0;
  std::optional<bool> keeps_digits = {};  // once it was asked for
};

// The trials of one limb.
class Trials {
 public:
  // That of these frames, one a joint of the limb; traced when they are new.
  Trial& in_frames(const LinkFrames& frames, const std::function<symbolic::Program()>& trace);

 private:
  std::vector<LinkFrames> known_;           // by joint of the limb: the frames that it was seen in
  std::map<std::vector<int>, Trial> done_;  // by the index of each joint's frame in known_
};

}  // namespace robcogen::algorithm
