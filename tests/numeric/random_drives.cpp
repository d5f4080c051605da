#include "random_drives.h"

#include "dice.h"

namespace robcogen::numeric {

using model::Drive;
using model::KinematicTree;
using model::Quantity;

KinematicTree with_random_drives(KinematicTree robot, std::uint64_t seed) {
  Dice dice(seed + 0x2545f4914f6cdd1d);
  const auto maybe = [&](double low, double high) {
    return dice.chance(0.5) ? Quantity(dice.between(low, high)) : Quantity();
  };
  for (model::Joint& joint : robot.joints) {
    Drive& drive = joint.drive;
    drive.damping = maybe(0.01, 2);
    drive.armature = maybe(0.01, 1);
  }
  return robot;
}

}  // namespace robcogen::numeric
