#include "import/snap_angles.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

namespace robcogen::import {

namespace {

constexpr double kNear = 1e-6;  // rad; covers angles with six or more decimals
constexpr int kStepsInHalfTurn = 12;

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

}  // namespace

void AngleSnapper::treat(Number& angle, const Place& place, const char* name, const std::string& owner) {
  const std::optional<Snap> snap = near_multiple(angle);
  if (!snap) return;
  if (++count_ == 1) first_ = place;
  largest_change_ = std::max(largest_change_, std::abs(snap->change));
  if (!snaps_) return;
  diagnostics_.note(
      "angle-snapped", place,
      fmt::format(
          "{} of {}: {} becomes {}, a change of {:.1e} rad", name, owner, print_double(angle.value()),
          print(snap->multiple), snap->change));
  angle = snap->multiple;
}

void AngleSnapper::note_count() const {
  if (count_ == 0) return;
  if (snaps_) {
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

}  // namespace robcogen::import
