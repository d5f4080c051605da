// Whether other libraries compute what the generated code computes.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "peers/peer.h"

namespace robcogen::bench {

// Norm of the difference relative to that of the generated code's result (largest elements): what rounding leaves, with
// room for forward dynamics of light links on heavy ones. An error of the model is millions of times larger.
constexpr double kAgreement = 1e-9;

// One quantity as the generated code computes it.
struct Computed {
  peers::Quantity quantity;
  std::string function;  // the benchmark that times it
  std::function<Eigen::MatrixXd(std::size_t state)> result;
};

// "inverse_dynamics", …
const char* name(peers::Quantity quantity);

// A message for each quantity of the peer that is not what the generated code computes, with the worst of the first
// `states` states; the peer was prepared with them. A result that is not finite, or of another shape, disagrees.
std::vector<std::string> disagreements(peers::Peer& peer, const std::vector<Computed>& computed, std::size_t states);

}  // namespace robcogen::bench
