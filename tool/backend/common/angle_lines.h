// The lines that define sines and cosines: in pairs, alone, or those of several angles together.
#pragma once

#include <set>
#include <string>

#include "backend/common/kernel_lines.h"

namespace robcogen::backend {

class AngleLines {
 public:
  explicit AngleLines(KernelLines& lines) : lines_(lines) {}

  // Of elements of inputs, together where the plan says so.
  void add_those_of_inputs();
  // Of values of a block that is loaded: together, where most of its columns are angles. Two lanes leave room for
  // others in a register; four are as well computed where they are used.
  void add_those_of_load(std::size_t load);
  void add(const AngleKey& key, const Angle& angle);
  // Whether the sine and cosine of a statement stand with its block.
  bool are_done(int statement) const { return done_.contains(statement); }

 private:
  void define(const std::string& function, const symbolic::Operand& argument, const std::string& name);
  void compute_together(
      const std::string& all,
      const std::string& first,
      const std::string& array,
      std::size_t count,
      int width);
  void pick(const Angle& angle, const std::string& all, std::size_t k, int width);

  KernelLines& lines_;
  std::set<int> done_;
};

}  // namespace robcogen::backend
