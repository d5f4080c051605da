// The benchmarks of other libraries on the states of one robot.
#pragma once

#include <vector>

#include "agreement.h"

namespace robcogen::bench {

// Adds `<peer>/<quantity>` for each quantity that the generated code computes and a peer has; the label is the name of
// the benchmark that it is compared with. All peers were prepared with `states` states. The context entry `peers` lists
// the peers, `absent` the libraries that do not take part with the reasons, one per line.
void add_peer_benchmarks(
    const std::vector<peers::Candidate>& candidates,
    const std::vector<Computed>& computed,
    std::size_t states);

}  // namespace robcogen::bench
