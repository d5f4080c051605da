// The two studies as pictures in SVG, in the layout of the paper: curves, and legs of three lengths above them.
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

// Powers are drawn relative to that of legs whose parts are equally long.
struct TrotCurve {
  double speed;
  std::vector<Sample> samples;
};
std::string trot_picture(const std::vector<TrotCurve>& curves);

}  // namespace design
