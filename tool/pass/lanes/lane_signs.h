// Signs of lanes, chosen so that few of them have to be changed.
//
// Mirrored limbs differ in signs: a + b in one is a - b in another. A packed value may be kept with some of its lanes
// negated as long as all its readers take that into account. Choosing such signs is linear algebra over the field of
// two elements.
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
  // The lanes that are negated, with zero for variables that were not chosen.
  unsigned value(const Sign& sign);

 private:
  struct Variable {
    bool costs = false;
    std::optional<Sign> value = {};
  };
  // Expresses the sign by variables that were not chosen, and shortens the chains on the way.
  Sign resolved(const Sign& sign);

  unsigned all_;
  std::vector<Variable> variables_;
};

}  // namespace robcogen::pass
