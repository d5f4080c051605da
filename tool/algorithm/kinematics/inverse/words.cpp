#include "algorithm/kinematics/inverse/words.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "algorithm/kinematics/inverse/swivel.h"
#include "support/number.h"

namespace robcogen::algorithm::inversion {
namespace {

using Kind = Feature::Kind;

constexpr const char* kAnyChain = "damped steps serve any chain: <robcogen/generic/inverse_kinematics.h>";

// `J4, J5 and J6`
std::string list(const std::vector<std::string>& names) {
  if (names.size() < 2) return names.empty() ? "" : names.front();
  return fmt::format("{} and {}", fmt::join(names.begin(), names.end() - 1, ", "), names.back());
}

std::vector<std::string> turning(const SerialChain& chain, const Feature& f) {
  std::vector<std::string> names;
  for (int k = f.begin; k < std::min(f.end, chain.joints); ++k)
    if (chain.axis(k).turns && !chain.is_parametric(k)) names.push_back(chain.axis(k).name);
  return names;
}

int coordinates(const model::InverseTask& task) {
  switch (task.kind) {
    case model::InverseTask::Kind::point:
      return 3;
    case model::InverseTask::Kind::axis:
      return 5;
    case model::InverseTask::Kind::orientation:
      return 3;
    default:
      return 6;
  }
}

// `0.3 mm`
std::string length(double metres) {
  return metres < 1e-3 ? fmt::format("{:.3g} um", metres * 1e6) : fmt::format("{:.3g} mm", metres * 1e3);
}

// Neighbours that almost meet or are almost parallel.
std::string near_misses(const SerialChain& chain) {
  constexpr double kNear = 1e-3;  // rad, or m for a chain that reaches one metre
  std::string text;
  for (int k = 1; k < chain.joints; ++k) {
    const ChainAxis &a = chain.axis(k - 1), &b = chain.axis(k);
    if (!a.turns || !b.turns || a.amount >= 0 || b.amount >= 0) continue;
    const double sine = norm(cross(a.direction, b.direction));
    if (sine >= kSameDirection && sine < kNear)
      text += fmt::format("; the axes of {} and {} are {:.3g} rad from being parallel", a.name, b.name, sine);
    if (sine < kNear) continue;
    const double distance = gap(a, b);
    if (distance > chain.same_point && distance < kNear / kSameDirection * chain.same_point)
      text += fmt::format("; the axis of {} misses that of {} by {}", b.name, a.name, length(distance));
  }
  return text;
}

// `3e-4 rad and 0.2 mm`
std::string difference(const Calibration& c) {
  const std::string angle = fmt::format("{:.2g} rad", c.angle);
  return c.distance > c.chain.same_point ? angle + " and " + length(c.distance) : angle;
}

}  // namespace

std::string describe(const Calibration& calibration) {
  return fmt::format(
      "then {} Newton steps on the chain itself, which find {:.1f} % of random positions to 1e-9", calibration.steps,
      100.0 * calibration.share);
}

std::string describe_axes(const SerialChain& chain) {
  std::vector<std::string> words;
  for (const Feature& f : features_of(chain).maximal) {
    const std::vector<std::string> names = turning(chain, f);
    if (names.size() < 2 || f.kind == Kind::plane) continue;
    const std::string text = fmt::format(
        "{} {}", list(names), f.kind == Kind::point ? (names.size() > 2 ? "meet in a point" : "meet") : "are parallel");
    if (std::find(words.begin(), words.end(), text) == words.end()) words.push_back(text);
  }
  return fmt::format("{}", fmt::join(words, ", "));
}

Explanation explain(
    const Search& search,
    const std::vector<std::string>& arguments,
    const Search* nominal,
    bool needs_values) {
  const SerialChain& chain = search.chain;
  if (search.plan || search.swivel) {
    const std::string axes = describe_axes(chain);
    const int count = search.plan ? search.plan->branches() : search.swivel->branches();
    std::string text = fmt::format("{} branch{}", count, count == 1 ? "" : "es");
    if (search.calibration)
      text += " of a nominal chain, from which axes differ by up to " + difference(*search.calibration);
    return {text + (axes.empty() ? "" : "; axes: " + axes), ""};
  }
  std::string nominal_hint;
  if (nominal && (nominal->plan || nominal->swivel))
    nominal_hint = fmt::format(
        "for a calibrated chain, add 'tolerance = {}': a nominal chain within {} has a closed form, and Newton steps "
        "follow; otherwise round the numbers of the model: --snap-angles for URDF",
        print_double(nominal->chain.task.tolerance), difference(*nominal->calibration));
  if (chain.task.by_swivel && chain.has_parameters())
    return {"a swivel angle needs a chain without parameters", "give a joint"};
  if (chain.task.by_swivel)
    return {
        "a swivel angle needs seven joints: the axes of the first three meet, those of the last three meet, and the "
        "fourth is across the line between both points",
        nominal_hint.empty() ? kAnyChain : nominal_hint};
  int free = 0;
  for (int k = 0; k < chain.joints; ++k) free += chain.is_known(k) ? 0 : 1;
  const int needed = coordinates(chain.task);
  if (free > needed)
    return {
        fmt::format("{} joints for {} coordinates", free, needed),
        arguments.empty() ? kAnyChain : fmt::format("closed forms exist with {}", list(arguments))};
  std::vector<std::string> found, others;
  for (int k = 0; k < chain.joints; ++k)
    if (!chain.is_known(k)) (search.found[at(k)] ? found : others).push_back(chain.axis(k).name);
  const std::string follow = found.empty() ? "" : list(found) + (found.size() == 1 ? " follows, " : " follow, ");
  const std::string misses = near_misses(chain);
  std::string hint = kAnyChain;
  if (!arguments.empty())
    hint = fmt::format(
        "closed forms exist with {}; a search over that joint finds all positions: <robcogen/generic/all_solutions.h>",
        list(arguments));
  if (needs_values)
    hint =
        "axes must meet and be parallel whatever the values of parameters: with their default values as numbers, the "
        "chain has a closed form";
  else if (!nominal_hint.empty())
    hint = nominal_hint;
  else if (!misses.empty())
    hint = "round the numbers of the model, if they are meant to be exact: --snap-angles for URDF";
  return {fmt::format("{}no equation finds one of {}{}", follow, fmt::join(others, ", "), misses), hint};
}

}  // namespace robcogen::algorithm::inversion
