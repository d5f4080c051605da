// The lines that define sines and cosines: in pairs, singly, or of several angles together.
#pragma once

#include <set>
#include <string>

#include "backend/common/kernel_lines.h"

namespace robcogen::backend {

class AngleLines {
 public:
  explicit AngleLines(KernelLines& lines) : lines_(lines) {}

  // Adds the sines and cosines of input elements, together where the plan says so.
  void add_those_of_inputs();
  // Adds the sines and cosines of the values of a loaded block together, if most of its columns are angles. With two
  // lanes, a register has room for further angles; with four, computing them where they are used is as fast.
  void add_those_of_load(std::size_t load);
  void add(const AngleKey& key, const Angle& angle);
  // Whether the sine and cosine of a statement were defined together with its block.
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
