// The two studies as SVG pictures in the layout of the paper: curves, and above them legs of three lengths.
#pragma once

#include <string>
#include <vector>

#include "studies.h"

namespace design {

struct JumpCurve {
  double start, torque_limit;
  std::vector<Sample> samples;
};
std::string jump_picture(const std::vector<JumpCurve>& curves);

// Powers are drawn relative to the power for upper and lower legs of equal length.
struct TrotCurve {
  double speed;
  std::vector<Sample> samples;
};
std::string trot_picture(const std::vector<TrotCurve>& curves);

}  // namespace design
