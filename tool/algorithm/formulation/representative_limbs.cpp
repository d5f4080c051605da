#include "algorithm/formulation/representative_limbs.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "algorithm/formulation/congruent_limbs.h"
#include "support/index.h"

namespace robcogen::algorithm {
namespace {

constexpr double kNothing = std::numeric_limits<double>::quiet_NaN();  // is typical: a number stays what it is

template <class AnyPose>
auto elements_of_pose(AnyPose& pose) {
  return std::array{&pose.offset[0], &pose.offset[1], &pose.offset[2], &pose.slide};
}

template <class AnyMass>
auto elements_of_mass(AnyMass& mass) {
  auto& h = mass.first_moment;
  auto& S = mass.pseudo_inertia;
  return std::array{&mass.mass, &h[0],    &h[1],    &h[2],    &S[0][0], &S[0][1], &S[0][2],
                    &S[1][0],   &S[1][1], &S[1][2], &S[2][0], &S[2][1], &S[2][2]};
}

// The number in one place of each limb; nullopt where that is not a number.
using Numbers = std::vector<std::optional<double>>;

std::optional<double> number_of(const Expression& e) {
  return e.is_constant() ? std::optional(e.number().value()) : std::nullopt;
}

bool are_numbers(const Numbers& numbers) {
  return std::all_of(numbers.begin(), numbers.end(), [](const auto& n) { return n.has_value(); });
}

// Whether one of them folds where another does not.
bool fold_differently(const Numbers& numbers) {
  if (!are_numbers(numbers)) return false;
  const auto some_but_not_all = [&](double magnitude) {
    const auto count =
        std::count_if(numbers.begin(), numbers.end(), [&](const auto& n) { return std::abs(*n) == magnitude; });
    return count > 0 && count < static_cast<std::ptrdiff_t>(numbers.size());
  };
  return some_but_not_all(0.0) || some_but_not_all(1.0);
}

// A mean of magnitudes, in which no two limbs weigh the same: what is equal in all limbs stays equal, and hardly
// anything else becomes so.
double typical_magnitude(const Numbers& numbers) {
  double sum = 0.0, weights = 0.0, weight = 1.0;
  for (const auto& n : numbers) {
    sum += weight * std::abs(*n);
    weights += weight;
    weight += 1.0;
  }
  return sum / weights;
}

// Of each limb.
std::vector<double> typical_numbers(const Numbers& numbers) {
  std::vector<double> result(numbers.size(), kNothing);
  if (!are_numbers(numbers)) return result;
  const double magnitude = typical_magnitude(numbers), first = std::abs(*numbers.front());
  if (std::all_of(numbers.begin(), numbers.end(), [&](const auto& n) { return std::abs(*n) == first; })) return result;
  for (std::size_t i = 0; i < numbers.size(); ++i) result[i] = *numbers[i] < 0.0 ? -magnitude : magnitude;
  return result;
}

// Of all places of corresponding links; the first index is that of the place.
std::vector<Numbers> numbers_of(
    const model::KinematicTree& tree,
    const std::vector<int>& joints,
    const std::vector<Pose>& poses,
    const std::vector<MassProperties>& masses) {
  std::vector<Numbers> places;
  const auto add = [&](std::size_t place, const Expression& e) {
    if (place == places.size()) places.emplace_back();
    places[place].push_back(number_of(e));
  };
  for (const int joint : joints) {
    std::size_t place = 0;
    for (const Expression* e : elements_of_pose(poses[at(joint)])) add(place++, *e);
    for (const Expression* e : elements_of_mass(masses[at(tree.joints[at(joint)].child)])) add(place++, *e);
  }
  return places;
}

template <std::size_t n>
void fold_like(Trace& trace, const std::array<double, n>& typical, const std::array<Expression*, n>& elements) {
  for (std::size_t i = 0; i < n; ++i)
    if (std::isfinite(typical[i])) *elements[i] = trace.graph.constant(elements[i]->constant().folded_as(typical[i]));
}

}  // namespace

RepresentativeLinks representative_links(
    const model::KinematicTree& tree,
    const std::vector<Pose>& poses,
    const std::vector<MassProperties>& masses) {
  RepresentativeLinks result(tree.joints.size());
  for (RepresentativeLink& link : result) {
    link.pose.fill(kNothing);
    link.mass.fill(kNothing);
  }
  bool some_differ = false;
  for (const LimbsInLanes& limbs : limbs_in_lanes(tree)) {
    std::vector<std::vector<Numbers>> links;
    for (const std::vector<int>& joints : limbs.joints) links.push_back(numbers_of(tree, joints, poses, masses));
    const bool differ = std::any_of(links.begin(), links.end(), [](const std::vector<Numbers>& places) {
      return std::any_of(places.begin(), places.end(), fold_differently);
    });
    if (!differ) continue;
    some_differ = true;
    for (std::size_t k = 0; k < links.size(); ++k) {
      for (std::size_t place = 0; place < links[k].size(); ++place) {
        const std::vector<double> typical = typical_numbers(links[k][place]);
        for (std::size_t i = 0; i < typical.size(); ++i) {
          RepresentativeLink& link = result[at(limbs.joints[k][i])];
          (place < link.pose.size() ? link.pose[place] : link.mass[place - link.pose.size()]) = typical[i];
        }
      }
    }
  }
  return some_differ ? result : RepresentativeLinks();
}

void fold_like(Trace& trace, const RepresentativeLink& representative, Pose& pose) {
  fold_like(trace, representative.pose, elements_of_pose(pose));
}

void fold_like(Trace& trace, const RepresentativeLink& representative, MassProperties& mass) {
  fold_like(trace, representative.mass, elements_of_mass(mass));
}

}  // namespace robcogen::algorithm
