// One external wrench for each link of a robot.
#pragma once

#include <array>
#include <cstddef>

#include "robcogen/spatial.h"

namespace robcogen {

// Indexed by the robot's own enumeration of links, or by its values as integers. Each wrench acts on its link, in link
// coordinates about the origin of the link frame. Zero until set.
template <class Scalar, class Link, int kLinkCount>
class LinkWrenches {
 public:
  BasicWrench<Scalar>& operator[](int link) { return wrenches_[static_cast<std::size_t>(link)]; }
  const BasicWrench<Scalar>& operator[](int link) const { return wrenches_[static_cast<std::size_t>(link)]; }
  BasicWrench<Scalar>& operator[](Link link) { return wrenches_[static_cast<std::size_t>(link)]; }
  const BasicWrench<Scalar>& operator[](Link link) const { return wrenches_[static_cast<std::size_t>(link)]; }

  static constexpr int size() { return kLinkCount; }

  // 6 kLinkCount scalars, link by link.
  const Scalar* data() const noexcept {
    static_assert(sizeof(LinkWrenches) == 6 * kLinkCount * sizeof(Scalar), "wrenches are contiguous");
    return reinterpret_cast<const Scalar*>(this);
  }

 private:
  std::array<BasicWrench<Scalar>, static_cast<std::size_t>(kLinkCount)> wrenches_;
};

}  // namespace robcogen
