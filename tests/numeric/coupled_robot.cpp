#include "coupled_robot.h"

#include <algorithm>
#include <set>

#include "dice.h"

namespace robcogen::numeric {
namespace {

using model::Coupling;
using model::KinematicTree;
using model::Quantity;

// Returns a value as a quantity. For robots with parameters it is a parameter, or an expression of one.
Quantity quantity(CoupledRobot& made, double value, model::ParameterKind kind, bool parametric) {
  if (!parametric) return Quantity(value);
  const Quantity p = Quantity::parameter(static_cast<int>(made.parameters.size()));
  made.robot.parameters.push_back({"c" + std::to_string(made.parameters.size()), kind, {}, {}});
  made.parameters.push_back(value / 2);
  return Quantity(2.0) * p;
}

double factor(Dice& dice) {
  if (dice.chance(0.5)) return dice.sign();
  return dice.sign() * (dice.chance(0.3) ? 2.0 : dice.between(0.1, 1.5));
}

}  // namespace

CoupledRobot coupled(const KinematicTree& free, std::uint64_t seed, bool parametric) {
  CoupledRobot made = {free, {}};
  Dice dice(seed + 0x51ed270b);
  const int joints = static_cast<int>(free.joints.size());
  std::vector<int> independent;
  std::vector<bool> follows(free.joints.size());
  const int kept = dice.below(joints);
  for (int j = 0; j < joints; ++j) {
    follows[static_cast<std::size_t>(j)] = j != kept && dice.chance(0.35);
    if (!follows[static_cast<std::size_t>(j)]) independent.push_back(j);
  }
  for (int j = 0; j < joints; ++j) {
    if (!follows[static_cast<std::size_t>(j)]) continue;
    Coupling coupling;
    coupling.joint = j;
    const int terms = dice.chance(0.1) ? 0 : dice.chance(0.3) ? 2 : 1;
    std::set<int> followed;
    for (int t = 0; t < terms; ++t)
      followed.insert(independent[static_cast<std::size_t>(dice.below(static_cast<int>(independent.size())))]);
    for (const int k : followed)
      coupling.terms.push_back({k, quantity(made, factor(dice), model::ParameterKind::ratio, parametric)});
    if (dice.chance(0.5)) {
      const bool turns = model::turns(free.joints[static_cast<std::size_t>(j)].type);
      coupling.offset = quantity(
          made, dice.between(-1, 1), turns ? model::ParameterKind::angle : model::ParameterKind::length, parametric);
    }
    made.robot.couplings.push_back(std::move(coupling));
  }
  return made;
}

}  // namespace robcogen::numeric
