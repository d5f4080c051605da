#include "algorithm/kinematics/inverse/nominal.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

#include "algorithm/kinematics/inverse/features.h"

namespace robcogen::algorithm::inversion {
namespace {

constexpr double kExactlyAcross = 1e-12;

class Nominal {
 public:
  Nominal(const SerialChain& chain, double tolerance)
      : exact_(chain), tolerance_(tolerance), longest_(tolerance / kSameDirection * chain.same_point), result_{chain} {}

  NominalChain made() {
    // The axis that a task leaves free is that of the tool; other freedoms meet in its point exactly.
    const int end = exact_.task.kind == model::InverseTask::Kind::axis ? exact_.size() : exact_.joints;
    for (int k = 0; k < end; ++k) place(k);
    return std::move(result_);
  }

 private:
  const SerialChain& exact_;
  double tolerance_, longest_;
  NominalChain result_;
  Numbers3 anchor_{};                // the point where the last axis is held
  std::optional<Numbers3> meeting_;  // in which the last axes meet

  const ChainAxis& before(int k) const { return result_.chain.axis(k - 1); }

  void place(int k) {
    const ChainAxis& axis = exact_.axis(k);
    const Numbers3 direction = direction_of(k);
    anchor_ = anchor_of(k, direction);
    ChainAxis& placed = result_.chain.axes[at(k)];
    placed.direction = folded(direction);
    placed.point = without_rounding(exact_, anchor_ - dot(placed.direction, anchor_) * placed.direction);
    result_.angle = std::max(result_.angle, norm(cross(axis.direction, direction)));
    if (axis.turns) result_.distance = std::max(result_.distance, norm(cross(anchor_ - axis.point, axis.direction)));
  }

  // The direction of a candidate, or its opposite, if it is near.
  std::optional<Numbers3> near(const Numbers3& candidate, const Numbers3& direction) const {
    if (norm(cross(candidate, direction)) >= tolerance_) return std::nullopt;
    return dot(candidate, direction) < 0.0 ? -1.0 * candidate : candidate;
  }

  Numbers3 direction_of(int k) const {
    const Numbers3& direction = exact_.axis(k).direction;
    std::vector<Numbers3> candidates;
    for (int i = k; i-- > 0;) candidates.push_back(result_.chain.axis(i).direction);
    for (std::size_t i = 0; i < 3; ++i) candidates.emplace_back()[i] = 1.0;
    const Numbers3* last = k == 0 ? nullptr : &before(k).direction;
    if (last) {
      if (const auto parallel = near(*last, direction)) return *parallel;
      // An angle other than a right one is as it is.
      if (std::abs(dot(*last, direction)) >= tolerance_) return direction;
    }
    for (const Numbers3& candidate : candidates)
      if (!last || std::abs(dot(candidate, *last)) < kExactlyAcross)
        if (const auto same = near(candidate, direction)) return *same;
    if (!last) return direction;
    const Numbers3 across = direction - dot(*last, direction) * *last;
    return (1.0 / norm(across)) * across;
  }

  // Where the axis is held while it is turned and moved.
  Numbers3 anchor_of(int k, const Numbers3& direction) {
    const ChainAxis& axis = exact_.axis(k);
    const auto nearest = [&](const Numbers3& x) {
      return axis.point + dot(axis.direction, x - axis.point) * axis.direction;
    };
    const std::optional<Numbers3> last_meeting = std::exchange(meeting_, std::nullopt);
    if (k == 0) return axis.point;
    if (!axis.turns || !before(k).turns || are_parallel(direction, before(k).direction)) return nearest(anchor_);
    if (last_meeting && norm(*last_meeting - nearest(*last_meeting)) < longest_) return *(meeting_ = last_meeting);
    ChainAxis turned = axis;
    turned.direction = direction;
    turned.point = foot(axis, before(k));
    const Numbers3 here = foot(turned, before(k)), there = foot(before(k), turned);
    // Both neighbours of the axis before are at the same place of it, such as those of an elbow with an offset.
    const Numbers3 along = anchor_ - there;
    const bool is_level = k > 1 && norm(along) < longest_;
    if (norm(here - there) < longest_) return *(meeting_ = is_level ? anchor_ : there);
    return is_level ? here + along : here;
  }
};

}  // namespace

NominalChain nominal_chain(const SerialChain& chain, double tolerance) {
  return Nominal(chain, tolerance).made();
}

}  // namespace robcogen::algorithm::inversion
