#include "algorithm/kinematics/inverse/probes.h"

#include <cmath>

#include "symbolic/apply.h"

namespace robcogen::algorithm::inversion {
namespace {

using symbolic::Node;
using symbolic::Op;

constexpr double kPi = 3.14159265358979323846;

template <class F>
void in_each_state(ProbeValues& result, F f) {
  for (std::size_t k = 0; k < kProbes; ++k) result[k] = f(k);
}

}  // namespace

ProbeValues Probes::operator()(const symbolic::Expression& e) {
  for (std::size_t i = values_.size(); i < graph_.nodes().size(); ++i) {
    const Node& n = graph_.nodes()[i];
    ProbeValues& here = values_.emplace_back();
    if (n.kind == Node::Kind::constant) {
      here.fill(graph_.constant_of(n).value());
    } else if (n.kind == Node::Kind::input) {
      here = inputs_.at(at(n.a));
    } else {
      const ProbeValues &a = values_[at(n.a)], &b = values_[at(n.b < 0 ? n.a : n.b)];
      switch (n.op) {
        case Op::add:
          in_each_state(here, [&](std::size_t k) { return a[k] + b[k]; });
          break;
        case Op::subtract:
          in_each_state(here, [&](std::size_t k) { return a[k] - b[k]; });
          break;
        case Op::multiply:
          in_each_state(here, [&](std::size_t k) { return a[k] * b[k]; });
          break;
        default:
          in_each_state(here, [&](std::size_t k) {
            return symbolic::apply(n.op, n.a_negative ? -a[k] : a[k], n.b_negative ? -b[k] : b[k]);
          });
      }
    }
  }
  ProbeValues result = values_[at(e.node())];
  if (e.negative())
    for (double& value : result) value = -value;
  return result;
}

std::uint64_t Random::next() {
  std::uint64_t z = state_ += 0x9e3779b97f4a7c15ULL;
  z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9ULL;
  z = (z ^ (z >> 27)) * 0x94d049bb133111ebULL;
  return z ^ (z >> 31);
}

double Random::uniform(double low, double high) {
  return low + (high - low) * (static_cast<double>(next() >> 11) * 0x1p-53);
}

int Random::integer(int low, int high) {
  return low + static_cast<int>(next() % static_cast<std::uint64_t>(high - low + 1));
}

std::vector<double> random_positions(const SerialChain& chain, Random& random, bool special) {
  constexpr double kSpecialShare = 0.35, kSlide = 0.5;
  std::vector<double> q;
  for (int k = 0; k < chain.joints; ++k) {
    if (!chain.axis(k).turns) {
      q.push_back(random.uniform(-kSlide, kSlide));
      continue;
    }
    q.push_back(random.uniform(-kPi, kPi));
    if (!special || chain.is_parametric(k) || random.uniform(0.0, 1.0) > kSpecialShare) continue;
    const double distance = std::pow(10.0, random.integer(-16, -2));
    q.back() = random.integer(-2, 2) * (kPi / 2.0) + random.integer(-1, 1) * distance;
  }
  return q;
}

std::vector<SineCosine> sines_cosines(const SerialChain& chain, const std::vector<double>& q) {
  std::vector<SineCosine> result;
  for (int k = 0; k < chain.joints; ++k)
    result.push_back(
        chain.axis(k).turns ? SineCosine{std::sin(q[at(k)]), std::cos(q[at(k)])} : SineCosine{q[at(k)], 1.0});
  return result;
}

}  // namespace robcogen::algorithm::inversion
