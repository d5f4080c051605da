// Numbers in some states at once for the nodes of a graph that is still growing.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "algorithm/kinematics/inverse/serial_chain.h"
#include "symbolic/expression.h"

namespace robcogen::algorithm::inversion {

inline constexpr std::size_t kProbes = 12;
using ProbeValues = std::array<double, kProbes>;

class Probes {
 public:
  // By element of the graph's inputs.
  Probes(const symbolic::Graph& graph, std::vector<ProbeValues> inputs) : graph_(graph), inputs_(std::move(inputs)) {}

  // The values of an expression.
  ProbeValues operator()(const symbolic::Expression& e);
  // After the graph returned to a mark.
  void forget(std::size_t mark) {
    if (values_.size() > mark) values_.resize(mark);
  }

 private:
  const symbolic::Graph& graph_;
  std::vector<ProbeValues> inputs_;
  std::vector<ProbeValues> values_;  // by node
};

// Random numbers that are the same on all machines (SplitMix64: Steele, Lea, Flood 2014).
class Random {
 public:
  explicit Random(std::uint64_t seed) : state_(seed) {}
  double uniform(double low, double high);
  int integer(int low, int high);  // inclusive

 private:
  std::uint64_t state_;
  std::uint64_t next();
};

// Random positions of the joints of a chain (rad, m), or special ones: joints at and next to multiples of a quarter
// turn, where chains are singular.
std::vector<double> random_positions(const SerialChain& chain, Random& random, bool special);
std::vector<SineCosine> sines_cosines(const SerialChain& chain, const std::vector<double>& q);

}  // namespace robcogen::algorithm::inversion
