// Numbers the angles whose sines and cosines programs read: the position of each joint, then the sums that are read as
// well.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "pass/angle_sums.h"
#include "support/unique_names.h"
#include "symbolic/program.h"

namespace robcogen::pass {

class AngleTable {
 public:
  // `parameters` may have no elements.
  AngleTable(symbolic::InputArray parameters, const std::vector<Position>& positions);

  AngleSums& sums() { return sums_; }
  int count() const { return static_cast<int>(all_.size()); }

  // The number of an angle; a new angle gets the next one. nullopt if the addition theorems do not give its sine and
  // cosine.
  std::optional<int> number(const symbolic::Expression& angle);

  // The inputs that replace the angles: the sines and the cosines of all of them.
  symbolic::InputArray sines() const { return array("sin_q", symbolic::Role::joint_sine, "s_"); }
  symbolic::InputArray cosines() const { return array("cos_q", symbolic::Role::joint_cosine, "c_"); }

  // The program that computes these angles from parameters and joint positions.
  symbolic::Program program(const std::string& name, const std::vector<int>& which) const;
  // The program that computes the sines and cosines of all angles from those of the joints.
  symbolic::Program addition(const std::string& name) const;

 private:
  std::vector<symbolic::InputArray> inputs(std::vector<symbolic::InputArray> arrays) const;
  symbolic::InputArray array(const std::string& name, symbolic::Role role, const std::string& prefix) const;

  symbolic::InputArray q_, parameters_;
  AngleSums sums_;
  std::vector<symbolic::Expression> all_;
  std::vector<std::string> labels_;
  UniqueNames taken_;
  std::map<int, int> numbers_;  // by node
};

}  // namespace robcogen::pass
