// Signs of lanes, chosen so that few of them have to be changed.
//
// Mirrored limbs differ in signs: a + b in one is a - b in another. A packed value may be kept with some of its lanes
// negated as long as all its readers take that into account. Choosing such signs is linear algebra over the field of
// two elements.
#pragma once

#include <optional>
#include <vector>

namespace robcogen::pass {

// Which lanes are negated, up to a common sign of all lanes: a bit for each lane (zero for lane 0), plus variables.
struct Sign {
  unsigned lanes = 0;
  std::vector<int> variables = {};  // ascending
};

class Signs {
 public:
  explicit Signs(int width) : all_((1U << width) - 1U) {}

  unsigned all() const { return all_; }
  // A sign that can be chosen freely. That costs nothing (constants absorb it) or one instruction.
  Sign variable(bool costs);
  Sign fixed(unsigned lanes) const { return {lanes & 1U ? lanes ^ all_ : lanes, {}}; }
  Sign product(const Sign& a, const Sign& b) const;
  // Chooses a variable such that this sign vanishes, if that is possible.
  void make_plain(const Sign& sign);
  // The lanes that are negated; variables that were not chosen count as zero.
  unsigned value(const Sign& sign);

 private:
  struct Variable {
    bool costs = false;
    std::optional<Sign> value = {};
  };
  // Expresses the sign by variables that were not chosen, and shortens chains of chosen ones on the way.
  Sign resolved(const Sign& sign);

  unsigned all_;
  std::vector<Variable> variables_;
};

}  // namespace robcogen::pass
