// The base of a robot that is attached to a link can be lumped into the link, or kept as a link on a placement: the
// dynamics are the same.
#include "physics.h"

namespace robcogen::lump_test {
namespace {

using namespace test;
using numeric::Dice;

constexpr int kRobots = 150;

std::string carrier(Dice& dice, const std::string& attached) {
  const auto triple = [&](double most) {
    const auto number = [&] { return print_double(dice.between(-most, most)); };
    return "(" + number() + ", " + number() + ", " + number() + ")";
  };
  const std::string inertia = dice.chance(0.2) ? ""
                                               : "inertia_params { mass = 3.0 CoM = " + triple(0.1) +
                                                     " Ix = 1.0 Iy = 1.2 Iz = 1.3 Ixy = 0.1 Ixz = 0.05 Iyz = -0.1 " +
                                                     (dice.chance(0.5) ? "ref_frame = spot" : "") + " }";
  return "import \"other\" as Other Robot R { RobotBase base { children { arm via shoulder } } link arm { id = 1 " +
         inertia + " children { Other tool at { translation = " + triple(1.0) +
         " rotation = " + (dice.chance(0.3) ? "(0.0, PI/2.0, 0.0)" : triple(2.0)) + " }" + attached +
         " } frames { spot { translation = " + triple(0.3) + " rotation = " + triple(2.0) +
         " } } } r_joint shoulder { ref_frame { translation = " + triple(1.0) + " rotation = " + triple(1.0) + " } } }";
}

kinematics::Document robot(std::uint64_t seed, const kinematics::Document& tool, const std::string& attached) {
  Dice dice(seed);
  return expanded(parsed(carrier(dice, attached)), tool);
}

TEST(AttachedRobots, MoveTheSameWithTheirBaseLumpedOrKept) {
  for (std::uint64_t seed = 0; seed < kRobots; ++seed) {
    const kinematics::Document tool = random_document(seed);
    const std::string mirrored = seed % 2 == 0 ? "" : " mirrored z";
    const model::KinematicTree lumped = tree_of(robot(seed, tool, mirrored));
    const model::KinematicTree kept = tree_of(robot(seed, tool, mirrored + " keep base"));
    ASSERT_EQ(lumped.dof(), kept.dof());
    ASSERT_EQ(lumped.links.size() + 1, kept.links.size());
    Dice dice(seed);
    const State s = {random_vector(dice, kept.dof()), random_vector(dice, kept.dof()), {}, random_vector(dice, 3)};
    expect_equal(inertia_matrix(lumped, s), inertia_matrix(kept, s), "H");
    expect_equal(bias_forces(lumped, s), bias_forces(kept, s), "bias forces");
    ASSERT_FALSE(testing::Test::HasFailure()) << "seed " << seed << "\n" << kinematics::print(tool);
  }
}

}  // namespace
}  // namespace robcogen::lump_test
