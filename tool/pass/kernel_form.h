// Chooses the kernels of a function from the costs of its programs.
#pragma once

#include "symbolic/function.h"

namespace robcogen::pass {

// The group of a function.
struct GroupTraits {
  bool is_kinematics = false;  // functions of frames: a robot has dozens of small ones
  // Generated if no groups are named. Compiled for several processors, all other functions of frames would take as long
  // to compile as everything else.
  bool is_default = false;
};

symbolic::KernelForm kernel_form(const symbolic::Function& function, const GroupTraits& group);

}  // namespace robcogen::pass
