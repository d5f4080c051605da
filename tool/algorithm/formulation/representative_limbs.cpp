#include "algorithm/formulation/representative_limbs.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "algorithm/formulation/congruent_limbs.h"
#include "support/index.h"

namespace robcogen::algorithm {
namespace {

// In place of a representative number: the number of the limb decides what folds.
constexpr double kNothing = std::numeric_limits<double>::quiet_NaN();

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

// One number of a pose or of mass properties in all limbs of a class, by limb; nullopt where it is not constant.
using Numbers = std::vector<std::optional<double>>;

std::optional<double> number_of(const Expression& e) {
  return e.is_constant() ? std::optional(e.number().value()) : std::nullopt;
}

bool are_numbers(const Numbers& numbers) {
  return std::all_of(numbers.begin(), numbers.end(), [](const auto& n) { return n.has_value(); });
}

// Whether some of the numbers fold and others do not.
bool fold_differently(const Numbers& numbers) {
  if (!are_numbers(numbers)) return false;
  const auto some_but_not_all = [&](double magnitude) {
    const auto count =
        std::count_if(numbers.begin(), numbers.end(), [&](const auto& n) { return std::abs(*n) == magnitude; });
    return count > 0 && count < static_cast<std::ptrdiff_t>(numbers.size());
  };
  return some_but_not_all(0.0) || some_but_not_all(1.0);
}

// The representative of magnitudes: their mean, weighted by 1, 2, 3, … by limb. Two numbers that are equal in each limb
// have equal representatives; other numbers hardly ever have.
double representative_magnitude(const Numbers& numbers) {
  double sum = 0.0, weights = 0.0, weight = 1.0;
  for (const auto& n : numbers) {
    sum += weight * std::abs(*n);
    weights += weight;
    weight += 1.0;
  }
  return sum / weights;
}

// The representative number of each limb; kNothing if all have the same magnitude or some are not constant.
std::vector<double> representative_numbers(const Numbers& numbers) {
  std::vector<double> result(numbers.size(), kNothing);
  if (!are_numbers(numbers)) return result;
  const double magnitude = representative_magnitude(numbers), first = std::abs(*numbers.front());
  if (std::all_of(numbers.begin(), numbers.end(), [&](const auto& n) { return std::abs(*n) == first; })) return result;
  for (std::size_t i = 0; i < numbers.size(); ++i) result[i] = *numbers[i] < 0.0 ? -magnitude : magnitude;
  return result;
}

// The numbers at all places of corresponding links, by place.
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

// The plane rotations of corresponding joints, aligned: for each rotation its index in each limb, or -1 if the limb
// lacks it.
using AlignedPlanes = std::vector<std::vector<int>>;

bool are_corresponding(const PlaneRotation& a, const PlaneRotation& b) {
  if (a.axis != b.axis || a.c.is_constant() != b.c.is_constant()) return false;
  if (a.c.is_constant() || a.matrix || b.matrix) return true;
  return (parts_of_angle(a.angle).constant == 0.0) == (parts_of_angle(b.angle).constant == 0.0);
}

bool is_constant(const PlaneRotation& plane) {
  return !plane.matrix && plane.c.is_constant() && plane.s.is_constant();
}

// Reduces the angle of the first plane rotation: if it is nearly a multiple of 90 degrees, that multiple becomes
// quarter turns, which are free, and the small rest remains.
Rotation with_small_turn(const Rotation& r) {
  constexpr double kSmall = 1e-5;  // rad
  if (r.planes.empty() || !is_constant(r.planes.front())) return r;
  Rotation result = r;
  PlaneRotation& plane = result.planes.front();
  const double c = plane.c.number().value(), s = plane.s.number().value();
  const int turns = std::abs(s) < kSmall ? (c < 0.0 ? 2 : 0) : std::abs(c) < kSmall ? (s > 0.0 ? 1 : 3) : 0;
  for (int k = 0; k < turns; ++k) plane = {plane.axis, plane.s, -plane.c};
  if (turns > 0) result.quarter = result.quarter * quarter_turn(plane.axis, turns);
  return result;
}

// Aligns these rotations if each is the longest one without some of its constant planes; otherwise nullopt.
std::optional<AlignedPlanes> aligned(const std::vector<Rotation>& rotations) {
  const auto longest = std::max_element(rotations.begin(), rotations.end(), [](const Rotation& a, const Rotation& b) {
    return a.planes.size() < b.planes.size();
  });
  const std::vector<PlaneRotation>& all = longest->planes;
  AlignedPlanes result(all.size());
  for (const Rotation& rotation : rotations) {
    const std::vector<PlaneRotation>& own = rotation.planes;
    std::size_t next = 0;
    for (std::size_t k = 0; k < all.size(); ++k) {
      const bool is_there = next < own.size() && are_corresponding(own[next], all[k]);
      if (!is_there && !is_constant(all[k])) return std::nullopt;
      result[k].push_back(is_there ? static_cast<int>(next++) : -1);
    }
    if (next < own.size() || rotation.quarter.image != longest->quarter.image) return std::nullopt;
  }
  return result;
}

// The representative plane rotations of each limb; empty if all limbs fold in the same way.
std::vector<std::vector<RepresentativePlane>> representative_planes(
    const std::vector<Rotation>& rotations,
    const AlignedPlanes& planes) {
  const auto is_missing = [](const std::vector<int>& of_limbs) {
    return std::find(of_limbs.begin(), of_limbs.end(), -1) != of_limbs.end();
  };
  std::vector<std::vector<RepresentativePlane>> result(rotations.size());
  bool differ = false;
  for (const std::vector<int>& of_limbs : planes) {
    Numbers c, s;
    RepresentativePlane common;
    for (std::size_t i = 0; i < of_limbs.size(); ++i) {
      const PlaneRotation* plane = of_limbs[i] < 0 ? nullptr : &rotations[i].planes[at(of_limbs[i])];
      c.push_back(plane ? number_of(plane->c) : 1.0);
      s.push_back(plane ? number_of(plane->s) : 0.0);
      if (plane) common = {plane->axis, is_constant(*plane)};
    }
    differ = differ || is_missing(of_limbs) || fold_differently(c) || fold_differently(s);
    const std::vector<double> typical_c = representative_numbers(c), typical_s = representative_numbers(s);
    for (std::size_t i = 0; i < of_limbs.size(); ++i)
      result[i].push_back({common.axis, common.is_constant, of_limbs[i] < 0, typical_c[i], typical_s[i]});
  }
  if (!differ) return {};
  return result;
}

// The rotations of the limbs in the form that all rotations have in common; empty if one does not turn about z last.
std::vector<EulerRotation> euler_rotations(const std::vector<Rotation>& rotations) {
  std::vector<EulerRotation> result(rotations.size());
  std::array<Numbers, 3> angles;
  for (const Rotation& rotation : rotations) {
    const std::optional<std::array<double, 3>> own = euler_angles(rotation);
    if (!own) return {};
    for (std::size_t k = 0; k < own->size(); ++k) angles[k].push_back((*own)[k]);
  }
  for (std::size_t k = 0; k < angles.size(); ++k) {
    // Odd and even numbers of quarter turns exchange axes and keep them.
    const auto is_odd = [](double angle) { return std::abs(std::cos(angle)) < 0.5; };
    const bool are_quarters = std::all_of(angles[k].begin(), angles[k].end(), [&](const auto& angle) {
      return is_multiple_of_quarter(*angle) && is_odd(*angle) == is_odd(*angles[k].front());
    });
    Numbers c, s;
    for (const auto& angle : angles[k]) {
      c.emplace_back(std::cos(*angle));
      s.emplace_back(std::sin(*angle));
    }
    const std::vector<double> angle = representative_numbers(angles[k]), typical_c = representative_numbers(c),
                              typical_s = representative_numbers(s);
    for (std::size_t i = 0; i < result.size(); ++i)
      result[i][k] = {k == 1 ? 0 : 2, are_quarters, *angles[k][i], typical_c[i], typical_s[i], angle[i]};
  }
  return result;
}

void fold_like(Trace& trace, double typical, Expression& e) {
  if (std::isfinite(typical)) e = trace.graph.constant(e.constant().folded_as(typical));
}

// Makes a rotation fold as the representative one. It stays unchanged if its plane rotations are not those of the limb:
// a joint at zero, for example, has none.
void fold_like(Trace& trace, const std::vector<RepresentativePlane>& representative, Rotation& rotation) {
  if (representative.empty()) return;
  const Rotation own = with_small_turn(rotation);
  std::vector<PlaneRotation> planes;
  auto next = own.planes.begin();
  for (const RepresentativePlane& r : representative) {
    const bool is_there = next != own.planes.end() && next->axis == r.axis && is_constant(*next) == r.is_constant;
    if (!r.is_missing && !is_there && r.is_constant) return;
    if (!r.is_missing && !is_there) continue;
    planes.push_back(r.is_missing ? PlaneRotation{r.axis, trace.graph.one(), trace.graph.constant(Number())} : *next++);
    fold_like(trace, r.c, planes.back().c);
    fold_like(trace, r.s, planes.back().s);
  }
  if (next != own.planes.end()) return;
  rotation = {own.quarter, std::move(planes)};
}

template <std::size_t n>
void fold_like(Trace& trace, const std::array<double, n>& typical, const std::array<Expression*, n>& elements) {
  for (std::size_t i = 0; i < n; ++i) fold_like(trace, typical[i], *elements[i]);
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
    std::vector<std::vector<std::vector<RepresentativePlane>>> planes;  // by joint, then by limb
    std::vector<std::vector<EulerRotation>> euler;
    for (const std::vector<int>& joints : limbs.joints) {
      std::vector<Rotation> rotations;
      for (const int joint : joints) rotations.push_back(with_small_turn(poses[at(joint)].rotation));
      const std::optional<AlignedPlanes> alignment = aligned(rotations);
      planes.emplace_back();
      euler.emplace_back();
      if (alignment)
        planes.back() = representative_planes(rotations, *alignment);
      else
        euler.back() = euler_rotations(rotations);
    }
    const bool differ =
        std::any_of(
            links.begin(), links.end(),
            [](const std::vector<Numbers>& places) {
              return std::any_of(places.begin(), places.end(), fold_differently);
            }) ||
        std::any_of(planes.begin(), planes.end(), [](const auto& of_limbs) { return !of_limbs.empty(); }) ||
        std::any_of(euler.begin(), euler.end(), [](const auto& of_limbs) { return !of_limbs.empty(); });
    if (!differ) continue;
    some_differ = true;
    for (std::size_t k = 0; k < links.size(); ++k) {
      for (std::size_t i = 0; i < planes[k].size(); ++i)
        result[at(limbs.joints[k][i])].planes = std::move(planes[k][i]);
      for (std::size_t i = 0; i < euler[k].size(); ++i) result[at(limbs.joints[k][i])].euler = euler[k][i];
      for (std::size_t place = 0; place < links[k].size(); ++place) {
        const std::vector<double> typical = representative_numbers(links[k][place]);
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
  if (representative.euler)
    pose.rotation = as_euler_rotation(trace, *representative.euler, pose.rotation);
  else
    fold_like(trace, representative.planes, pose.rotation);
}

void fold_like(Trace& trace, const RepresentativeLink& representative, MassProperties& mass) {
  fold_like(trace, representative.mass, elements_of_mass(mass));
}

}  // namespace robcogen::algorithm
