#include "algorithm/kinematics/inverse/steps.h"

#include <optional>
#include <utility>

namespace robcogen::algorithm::inversion {
namespace {

using Equation = Step::Equation;
using Kind = Feature::Kind;

std::optional<Equation> invariant_of(Kind a, Kind b) {
  if (a == Kind::point && b == Kind::point) return Equation::distance;
  if (a == Kind::direction && b == Kind::direction) return Equation::angle;
  if ((a == Kind::point && b == Kind::plane) || (a == Kind::plane && b == Kind::point)) return Equation::height;
  return std::nullopt;
}

// The unknown joints that an equation has.
class Unknowns {
 public:
  Unknowns(const SerialChain& chain, const Known& known) : chain_(chain), known_(known) {}

  // From begin to before end; directions do not depend on joints that slide.
  void add(int begin, int end, bool only_turns) {
    for (int k = begin; k < end; ++k)
      if (!known_[at(k)] && (!only_turns || chain_.axis(k).turns)) {
        ++count_;
        last_ = k;
      }
  }

  // The only unknown joint, unless it is a freedom of the task.
  std::optional<int> single() const {
    return count_ == 1 && last_ < chain_.joints ? std::optional<int>(last_) : std::nullopt;
  }

 private:
  const SerialChain& chain_;
  const Known& known_;
  int count_ = 0, last_ = -1;
};

void add_vector_step(const SerialChain& chain, const Feature& b, const Known& known, std::vector<Step>& steps) {
  if (b.kind == Kind::plane) return;
  const bool only_turns = b.kind == Kind::direction;
  Unknowns unknowns(chain, known);
  unknowns.add(0, b.begin, only_turns);
  unknowns.add(b.end, chain.size(), only_turns);
  if (const auto joint = unknowns.single()) steps.push_back({Equation::vector, *joint, {}, b});
}

// A plane that joint and path leave in place, so that both sides have the same height over it.
std::optional<Numbers3> plane_of_distance(const std::vector<Feature>& features, const Step& step) {
  if (step.joint < step.a.end || step.joint >= step.b.begin) return std::nullopt;
  for (const Feature& f : features)
    if (f.kind == Kind::plane && f.begin <= step.a.begin && step.b.begin <= f.end) return f.direction;
  return std::nullopt;
}

}  // namespace

std::vector<Step> possible_steps(const SerialChain& chain, const std::vector<Feature>& features, const Known& known) {
  std::vector<Step> steps;
  for (const Feature& b : features) add_vector_step(chain, b, known, steps);
  for (std::size_t i = 0; i < features.size(); ++i)
    for (std::size_t k = i + 1; k < features.size(); ++k) {
      const Feature *a = &features[i], *b = &features[k];
      if (a->begin > b->begin || (a->begin == b->begin && a->end > b->end)) std::swap(a, b);
      const auto equation = invariant_of(a->kind, b->kind);
      if (!equation || a->end > b->begin) continue;
      Unknowns unknowns(chain, known);
      const bool only_turns = equation == Equation::angle;
      unknowns.add(a->end, b->begin, only_turns);
      unknowns.add(0, a->begin, only_turns);
      unknowns.add(b->end, chain.size(), only_turns);
      const auto joint = unknowns.single();
      if (!joint) continue;
      Step step{*equation, *joint, *a, *b};
      steps.push_back(step);
      if (equation != Equation::distance || !chain.axis(*joint).turns) continue;
      if (const auto normal = plane_of_distance(features, step)) {
        step.equation = Equation::distance_in_plane;
        step.normal = *normal;
        steps.push_back(step);
      }
    }
  return steps;
}

std::string describe(const SerialChain& chain, const Feature& feature) {
  std::string joints;
  std::string amount;  // of a feature that only parameters leave in place
  for (int k = feature.begin; k < feature.end && k < chain.joints; ++k)
    if (chain.is_parametric(k))
      amount = "'" + chain.axis(k).name + "'";
    else
      joints += (joints.empty() ? "" : ", ") + chain.axis(k).name;
  if (joints.empty()) joints = amount;
  const bool is_of_target = feature.begin >= chain.joints;
  if (joints.empty()) joints = is_of_target ? "the target" : "the base";
  switch (feature.kind) {
    case Kind::point:
      return "the point of " + joints;
    case Kind::direction:
      return (is_of_target || feature.end == 0 ? "an axis of " : "the direction of ") + joints;
    case Kind::plane:
      break;
  }
  return "the plane of " + joints;
}

std::string describe(const SerialChain& chain, const Step& step) {
  const std::string joint = chain.axis(step.joint).name + ": ";
  const std::string roots = step.has_two_roots(chain) ? ", 2 roots" : ", 1 root";
  if (step.equation == Equation::vector) return joint + describe(chain, step.b) + roots;
  const std::string both = describe(chain, step.a) + " and " + describe(chain, step.b) + roots;
  switch (step.equation) {
    case Equation::angle:
      return joint + "angle of " + both;
    case Equation::height:
      return joint + "height of " + both;
    case Equation::distance_in_plane:
      return joint + "distance in a plane of " + both;
    default:
      return joint + "distance of " + both;
  }
}

}  // namespace robcogen::algorithm::inversion
