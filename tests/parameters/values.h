// Values for the parameters of everywhere.kindsl.in: `others` in this folder's CMakeLists.txt.
#pragma once

namespace robcogen::test {

template <class ParameterValues>
ParameterValues other_values() {
  ParameterValues v;
  v.trunk_mass = 7.5;
  v.trunk_x = -0.03;
  v.trunk_xy = 0.05;
  v.camera_x = 0.15;
  v.camera_tilt = -0.7;
  v.size = 1.1;
  v.shoulder_y = -0.02;
  v.shoulder_zz = 0.11;
  v.shoulder_xz = -0.003;
  v.upper = 0.5;
  v.offset = -0.1;
  v.twist = -0.9;
  v.lean = 0.35;
  v.arm_x = 0.22;
  v.fore = 0.41;
  v.slider_load = 1.7;
  return v;
}

}  // namespace robcogen::test
