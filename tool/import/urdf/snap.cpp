// Angles that were meant as multiples of PI/12, and lost that to decimals.
#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "import/urdf/document.h"

namespace robcogen::import::from_urdf {

namespace {

constexpr double kNear = 1e-6;  // rad; decimals of six digits and more
constexpr int kStepsInHalfTurn = 12;

constexpr std::array<const char*, 3> kAngleNames = {"roll", "pitch", "yaw"};

// The multiple of PI/12 that is near, unless the angle is one already.
std::optional<Number> near_multiple(const Number& angle) {
  if (angle.is_zero() || angle.is_pi_multiple()) return std::nullopt;
  const auto steps = std::llround(angle.value() / (std::numbers::pi / kStepsInHalfTurn));
  const Number multiple = Number::pi_multiple(steps, kStepsInHalfTurn);
  return std::abs(multiple.value() - angle.value()) <= kNear ? std::optional(multiple) : std::nullopt;
}

class Snapper {
 public:
  Snapper(bool snap, Diagnostics& diagnostics) : snap_(snap), diagnostics_(diagnostics) {}

  void treat(Origin& origin, const std::string& owner) {
    for (std::size_t i = 0; i < 3; ++i) {
      Number& angle = origin.rpy[i];
      const std::optional<Number> multiple = near_multiple(angle);
      if (!multiple) continue;
      if (++count_ == 1) first_ = origin.rpy_places[i];
      if (!snap_) continue;
      diagnostics_.note(
          "angle-snapped", origin.rpy_places[i],
          fmt::format(
              "{} of {}: {} becomes {}, a change of {:.1e} rad", kAngleNames[i], owner, print_double(angle.value()),
              print(*multiple), multiple->value() - angle.value()));
      angle = *multiple;
    }
  }

  void note_count() const {
    if (snap_ || count_ == 0) return;
    diagnostics_
        .note(
            "angles-near-multiples", first_,
            fmt::format(
                "{} of this robot {} within 1e-6 of a multiple of PI/12: as exact multiples {} may save a quarter to "
                "a half of all operations",
                count_ == 1 ? "an angle" : fmt::format("{} angles", count_), count_ == 1 ? "is" : "are",
                count_ == 1 ? "it" : "they"))
        .hint = "--snap-angles (SNAP_ANGLES in CMake) makes them exact; this is the first";
  }

 private:
  bool snap_;
  Diagnostics& diagnostics_;
  int count_ = 0;
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
