#include "algorithm/search/trials.h"

#include <algorithm>

#include "symbolic/count.h"

namespace robcogen::algorithm {

Trial::Trial(const symbolic::Program& program)
    : work(symbolic::work(program)), statements(static_cast<long>(program.statements.size())) {
  for (const symbolic::Constant& n : program.constants) largest_constant = std::max(largest_constant, n.value());
}

Trial& Trials::in_frames(const LinkFrames& frames, const std::function<symbolic::Program()>& trace) {
  known_.resize(frames.size());
  std::vector<int> key;
  for (std::size_t i = 0; i < frames.size(); ++i) {
    const auto found = std::find(known_[i].begin(), known_[i].end(), frames[i]);
    key.push_back(static_cast<int>(found - known_[i].begin()));
    if (found == known_[i].end()) known_[i].push_back(frames[i]);
  }
  const auto done = done_.find(key);
  return done != done_.end() ? done->second : done_.emplace(std::move(key), Trial(trace())).first->second;
}

}  // namespace robcogen::algorithm
