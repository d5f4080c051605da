// Finds angles that are multiples of PI/12 up to the rounding of their decimals.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "import/urdf/document.h"

namespace robcogen::import::from_urdf {

namespace {

constexpr double kNear = 1e-6;  // rad; covers angles with six or more decimals
constexpr int kStepsInHalfTurn = 12;

constexpr std::array<const char*, 3> kAngleNames = {"roll", "pitch", "yaw"};

struct Snap {
  Number multiple;
  double change = 0.0;
};

// Returns the multiple of PI/12 near the angle, unless the angle is zero.
std::optional<Snap> near_multiple(const Number& angle) {
  if (angle.is_zero()) return std::nullopt;
  constexpr long double kStep = std::numbers::pi_v<long double> / kStepsInHalfTurn;
  const auto steps = std::llround(angle.value() / kStep);
  // Computed in long double, because the double nearest to PI/2 is not PI/2.
  const auto change = static_cast<double>(static_cast<long double>(steps) * kStep - angle.value());
  return std::abs(change) <= kNear ? std::optional<Snap>({Number::pi_multiple(steps, kStepsInHalfTurn), change})
                                   : std::nullopt;
}

class Snapper {
 public:
  Snapper(bool snap, Diagnostics& diagnostics) : snap_(snap), diagnostics_(diagnostics) {}

  void treat(Origin& origin, const std::string& owner) {
    for (std::size_t i = 0; i < 3; ++i) {
      Number& angle = origin.rpy[i];
      const std::optional<Snap> snap = near_multiple(angle);
      if (!snap) continue;
      if (++count_ == 1) first_ = origin.rpy_places[i];
      largest_change_ = std::max(largest_change_, std::abs(snap->change));
      if (!snap_) continue;
      diagnostics_.note(
          "angle-snapped", origin.rpy_places[i],
          fmt::format(
              "{} of {}: {} becomes {}, a change of {:.1e} rad", kAngleNames[i], owner, print_double(angle.value()),
              print(snap->multiple), snap->change));
      angle = snap->multiple;
    }
  }

  void note_count() const {
    if (count_ == 0) return;
    if (snap_) {
      diagnostics_.summarise_notes(
          "angle-snapped",
          fmt::format(
              "{} angles become the multiples of PI/12 next to them, the largest change is {:.1e} rad; "
              "--verbose lists them",
              count_, largest_change_));
      return;
    }
    diagnostics_
        .note(
            "angles-near-multiples", first_,
            fmt::format(
                "{} of this robot {} within 1e-6 of a multiple of PI/12: as exact multiples {} may save a quarter to "
                "a half of all operations",
                count_ == 1 ? "an angle" : fmt::format("{} angles", count_), count_ == 1 ? "is" : "are",
                count_ == 1 ? "it" : "they"))
        .hint = "--snap-angles (SNAP_ANGLES in CMake) makes them exact; the first one is shown";
  }

 private:
  bool snap_;
  Diagnostics& diagnostics_;
  int count_ = 0;
  double largest_change_ = 0.0;  // rad
  Place first_;
};

}  // namespace

void treat_near_multiples(Document& document, bool snap, Diagnostics& diagnostics) {
  Snapper snapper(snap, diagnostics);
  for (Link& link : document.links)
    if (link.inertial) snapper.treat(link.inertial->origin, fmt::format("the inertial of link '{}'", link.name.text));
  for (Joint& joint : document.joints)
    snapper.treat(joint.origin, fmt::format("the origin of joint '{}'", joint.name.text));
  snapper.note_count();
}

}  // namespace robcogen::import::from_urdf
