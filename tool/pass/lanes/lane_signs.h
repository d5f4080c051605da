// Signs of lanes, chosen so that few have to be changed.
//
// Mirrored limbs differ in signs: a + b in one is a - b in another. A value of lanes may be kept with some of its lanes
// negated as long as all that read it know; this is the algebra of that choice, linear over the field of two elements.
#pragma once

#include <optional>
#include <vector>

namespace robcogen::pass {

// Which lanes are negated, up to a sign of the whole: bits, of which that of lane 0 is zero, plus variables.
struct Sign {
  unsigned lanes = 0;
  std::vector<int> variables = {};  // ascending
};

class Signs {
 public:
  explicit Signs(int width) : all_((1U << width) - 1U) {}

  unsigned all() const { return all_; }
  // A sign that is free to be chosen. Choosing it costs nothing (constants take it), or an instruction.
  Sign variable(bool costs);
  Sign fixed(unsigned lanes) const { return {lanes & 1U ? lanes ^ all_ : lanes, {}}; }
  Sign product(const Sign& a, const Sign& b) const;
  // Chooses a variable such that this sign vanishes, where that is possible.
  void make_plain(const Sign& sign);
  // The lanes that are negated, where variables that nobody chose are plain.
  unsigned value(const Sign& sign);

 private:
  struct Variable {
    bool costs = false;
    std::optional<Sign> value = {};
  };
  // By variables that nobody chose; those on the way are remembered by these too.
  Sign resolved(const Sign& sign);

  unsigned all_;
  std::vector<Variable> variables_;
};

}  // namespace robcogen::pass
