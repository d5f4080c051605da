// The lanes that are tested: all sizes (by default, the sizes of AVX2), with scalars for which processors have vectors, and with one for which they
// have none.
#pragma once

#include <gtest/gtest.h>

namespace robcogen {

template <class Scalar_, int kSize_>
struct LaneShape {
  using Scalar = Scalar_;
  static constexpr int kSize = kSize_;
};

using LaneShapes = testing::Types<
#if ROBCOGEN_TEST_EVERYTHING
    LaneShape<double, 1>,
    LaneShape<double, 8>,
    LaneShape<double, 16>,
    LaneShape<float, 1>,
    LaneShape<float, 2>,
    LaneShape<float, 4>,
    LaneShape<float, 16>,
#endif
    LaneShape<double, 2>,
    LaneShape<double, 4>,
    LaneShape<float, 8>,
    LaneShape<long double, 4>>;

}  // namespace robcogen
