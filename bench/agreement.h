// Whether other libraries agree with the generated code.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "peers/peer.h"

namespace robcogen::bench {

// Largest element of the difference, relative to that of the generated code's result: the effect of rounding, with a
// margin for forward dynamics of light links on heavy ones. An error of the model is millions of times larger.
constexpr double kAgreement = 1e-9;

// One quantity as the generated code computes it.
struct Computed {
  peers::Quantity quantity;
  std::string function;  // the benchmark that times it
  std::function<Eigen::MatrixXd(std::size_t state)> result;
};

// "inverse_dynamics", …
const char* name(peers::Quantity quantity);

// A message for each quantity in which the peer disagrees with the generated code by more than `agreement`, with the
// worst of the first `states` states, with which the peer was prepared. A result that is not finite, or has another
// shape, disagrees.
std::vector<std::string> disagreements(
    peers::Peer& peer,
    const std::vector<Computed>& computed,
    std::size_t states,
    double agreement = kAgreement);

}  // namespace robcogen::bench
