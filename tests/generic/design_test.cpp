// The design studies of robots/design: the shapes of their curves, and derivatives with respect to parameters compared
// with differences.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <ctime>
#include <limits>
#include <stdexcept>

#include "picture.h"
#include "studies.h"

namespace design {
namespace {

constexpr double kNoLimit = std::numeric_limits<double>::infinity();

std::size_t place_of_most(const std::vector<Sample>& curve) {
  const auto less = [](const Sample& a, const Sample& b) { return a.value < b.value; };
  return static_cast<std::size_t>(std::max_element(curve.begin(), curve.end(), less) - curve.begin());
}

double with(double speed, double upper_by_lower) {
  const double lower = kTotalLength / (1 + upper_by_lower);
  return mechanical_power_value(with_lengths(kTotalLength - lower, lower), Trot{speed});
}

ParameterArray with_motors() {
  ParameterArray values = with_lengths(0.37, 0.31);
  values[index_of("gear_ratio")] = 21;
  values[index_of("rotor_inertia")] = 1.3e-4;
  return values;
}

TEST(SquatJump, HasAnOptimumWithLimitedTorquesOnly) {
  for (const double start : kStarts) {
    const std::vector<Sample> limited = jump_curve(start, kTorqueLimit), free = jump_curve(start, kNoLimit);
    const std::size_t best = place_of_most(limited);
    EXPECT_GT(limited[best].x, 0.299) << start;
    EXPECT_LT(limited[best].x, 0.401) << start;
    // The curve is lower at both ends, by more than the noise of the contacts.
    EXPECT_LT(limited.front().value, limited[best].value - 0.02) << start;
    EXPECT_LT(limited.back().value, limited[best].value - 0.02) << start;
    for (std::size_t i = 1; i < free.size(); ++i) EXPECT_GT(free[i].value, free[i - 1].value) << start << ", " << i;
  }
}

TEST(SquatJump, RisesByTheEnergyOfLiftOff) {
  // The legs are light, so that the trunk flies nearly like a point mass.
  const Jump jump = squat_jump(Parameters(with_lengths(0.35, 0.33)), kStarts[0], constant_limit(kTorqueLimit));
  const double ballistic = jump.lift_off_speed * jump.lift_off_speed / (2 * 9.81);
  EXPECT_GT(jump.rise, 0.5 * ballistic);
  EXPECT_LT(jump.rise, ballistic);
  // The trunk rises and stays level: all feet move away from it by the same distance.
  const Feet moved = jump.feet.back() - jump.feet.front();
  for (int foot = 0; foot < 4; ++foot) {
    EXPECT_LT(moved[3 * foot + 2], -0.05);
    EXPECT_NEAR(moved[3 * foot + 2], moved[2], 0.02);
    EXPECT_LT(moved.segment<2>(3 * foot).norm(), 0.02);  // friction holds them
  }
}

// CPU time of one core.
TEST(SquatJump, SeventyTwoTakeLessThanOneAndAHalfSeconds) {
  const std::clock_t before = std::clock();
  for (const double start : kStarts)
    for (const double limit : {kTorqueLimit, 200.0, kNoLimit}) EXPECT_EQ(jump_curve(start, limit).size(), 12U);
  EXPECT_LT(static_cast<double>(std::clock() - before) / CLOCKS_PER_SEC, 1.5);
}

TEST(SquatJump, RefusesWhatCannotBe) {
  const Parameters parameters(with_lengths(0.35, 0.33));
  EXPECT_THROW(squat_jump(parameters, 0.80, constant_limit(kTorqueLimit)), std::domain_error);
  EXPECT_THROW(squat_jump(parameters, kStarts[0], constant_limit(10)), std::domain_error);
}

TEST(TrotPower, BestKneeChangesSidesWithSpeed) {
  const double slow = with(0.3, 1.4) / with(0.3, 0.7), fast = with(1.0, 1.4) / with(1.0, 0.7);
  EXPECT_LT(slow, 0.95);  // long upper legs
  EXPECT_GT(fast, 1.02);  // long lower legs
  const double equal = with(0.6, 1);
  for (const double ratio : {0.7, 0.8, 1.25, 1.4}) EXPECT_NEAR(with(0.6, ratio) / equal, 1, 0.01) << ratio;
  EXPECT_GT(with(0.6, 0.5), equal);
  EXPECT_GT(with(0.6, 1.9), equal);
}

TEST(TrotPower, FeetMoveAsTheirDerivativesSay) {
  const Trot trot{0.6};
  constexpr double kStep = 1e-5;  // of the period
  for (const double phase : {0.1, 0.3, 0.47, 0.6, 0.9}) {
    const FeetMotion now = trotting_feet(trot, phase), before = trotting_feet(trot, phase - kStep),
                     after = trotting_feet(trot, phase + kStep);
    const double time = 2 * kStep * trot.period;
    EXPECT_LT(((after.positions - before.positions) / time - now.velocities).norm(), 1e-6);
    EXPECT_LT(((after.velocities - before.velocities) / time - now.accelerations).norm(), 1e-6);
    EXPECT_EQ(now.on_ground.sum(), 2);
    // These feet motions follow from the motion of the joints.
    const Parameters parameters(with_lengths(0.37, 0.31));
    const Motion m = motion(parameters, now.positions, now.velocities, now.accelerations, bent_knees());
    EXPECT_LT((feet_positions(parameters, m.q) - now.positions).norm(), 1e-12);
    const double h = 1e-6;
    const Feet ahead = feet_positions(parameters, m.q + h * m.qd + h * h / 2 * m.qdd),
               behind = feet_positions(parameters, m.q - h * m.qd + h * h / 2 * m.qdd);
    EXPECT_LT(((ahead - behind) / (2 * h) - now.velocities).norm(), 1e-7);
  }
  // The motion is continuous from stance to swing.
  const FeetMotion end = trotting_feet(trot, 0.5 - 1e-9), start = trotting_feet(trot, 0.5 + 1e-9);
  EXPECT_LT((end.positions - start.positions).norm(), 1e-7);
  EXPECT_LT((end.velocities - start.velocities).norm(), 1e-6);
  EXPECT_LT((end.accelerations - start.accelerations).norm(), 1e-5);
}

TEST(TrotPower, FeetOnTheGroundCarryTheWeight) {
  const FeetMotion feet = trotting_feet(Trot{0}, 0.25);
  const Parameters parameters;
  const Motion m = motion(parameters, feet.positions, Feet::Zero(), Feet::Zero(), bent_knees());
  Feet weights = Feet::Zero();
  for (int foot = 0; foot < 4; ++foot) weights[3 * foot + 2] = feet.on_ground[foot];
  const auto forces = constrained_inverse_dynamics(
      parameters, m.q, m.qd, m.qdd, quadruped::Twist(), quadruped::SpatialAcceleration(), weights,
      Eigen::Matrix<double, 1, 1>(1e-6), quadruped::Gravity(0, 0, -9.81));
  constexpr double kMass = 60.96 + 4 * (2.93 + 2.638 + 0.881);
  double sum = 0;
  for (int foot = 0; foot < 4; ++foot) sum += forces.contact_wrenches[3 * foot + 2];
  EXPECT_NEAR(sum, kMass * 9.81, 0.02 * kMass * 9.81);  // the moment about the feet takes the rest
}

// Each column changes one parameter alone, including its effect on the motion of the legs.
TEST(TrotPower, GradientsAreThoseOfDifferences) {
  for (const double speed : kSpeeds) {
    for (const bool is_electric : {false, true}) {
      const Trot trot{speed};
      const ParameterArray at = with_motors();
      const auto value = [&](const ParameterArray& p) {
        return is_electric ? electric_power_value(p, trot) : mechanical_power_value(p, trot);
      };
      const Power power = is_electric ? electric_power(at, trot) : mechanical_power(at, trot);
      EXPECT_NEAR(power.value, value(at), 1e-12 * power.value);
      for (std::size_t k = 0; k < at.size(); ++k) {
        const double h = 1e-5 * at[k];
        ParameterArray after = at, before = at;
        after[k] += h;
        before[k] -= h;
        const double difference = (value(after) - value(before)) / (2 * h);
        EXPECT_NEAR(power.gradient[static_cast<int>(k)], difference, 1e-6 * std::abs(difference))
            << quadruped::kParameterNames[k] << ", " << speed << " m/s";
      }
    }
  }
}

TEST(Search, GoldenSectionFindsTheBestJump) {
  for (const double start : kStarts) {
    const Optimum best = best_jump(start, kTorqueLimit);
    EXPECT_GT(best.x[0], 0.30);
    EXPECT_LT(best.x[0], 0.40);
    for (const Sample& sample : jump_curve(start, kTorqueLimit)) EXPECT_LT(sample.value, -best.value + 1e-3);
    EXPECT_LT(best.evaluations, 20);
  }
  const Optimum parabola = golden_section([](double x) { return (x - 0.7) * (x - 0.7); }, 0, 1, 1e-4);
  EXPECT_NEAR(parabola.x[0], 0.7, 1e-4);
}

TEST(Search, GradientsSaveEvaluations) {
  if (!can_minimise()) {
    EXPECT_THROW(minimise(trot_of_lengths(0.6), Method::slsqp), std::runtime_error);
    GTEST_SKIP() << "without NLopt";
  }
  const Optimum with = minimise(trot_of_lengths(0.6), Method::slsqp),
                without = minimise(trot_of_lengths(0.6), Method::cobyla);
  EXPECT_TRUE(with.is_complete);
  EXPECT_LT(with.evaluations, without.evaluations);
  EXPECT_NEAR(with.value, without.value, 1e-4 * with.value);
  EXPECT_NEAR(with.x[0], without.x[0], 0.005);
  // The legs are as short as they may be, and their two parts are nearly equal.
  EXPECT_NEAR(with.x[0] + with.x[1], 0.66, 1e-6);
  EXPECT_NEAR(with.x[0], 0.33, 0.05);

  // With four variables, no small change of the two motor variables is better.
  const Problem problem = trot_of_lengths_and_motors(1.0);
  const Optimum best = minimise(problem, Method::slsqp);
  ASSERT_EQ(best.x.size(), 4U);
  EXPECT_LT(best.evaluations, 150);
  for (std::size_t k = 2; k < 4; ++k) {
    for (const double factor : {0.95, 1.05}) {
      std::vector<double> x = best.x;
      x[k] *= factor;
      EXPECT_GT(problem.function(x, nullptr), best.value) << k;
    }
  }
}

TEST(DesignPictures, ShowCurvesAndLegs) {
  const std::string jump = jump_picture({{0.5, 150, jump_curve(0.5, 150)}, {0.5, kNoLimit, jump_curve(0.5, kNoLimit)}});
  const std::string trot = trot_picture({{0.6, trot_curve(0.6)}});
  for (const std::string& text : {jump, trot}) {
    EXPECT_EQ(text.rfind("</svg>\n"), text.size() - 7);
    EXPECT_EQ(text.find("nan"), std::string::npos);
    EXPECT_EQ(text.find("inf"), std::string::npos);
  }
  const auto curves = [](const std::string& text) {
    std::size_t count = 0;
    for (std::size_t at = text.find("<polyline"); at != std::string::npos; at = text.find("<polyline", at + 1)) ++count;
    return count;
  };
  EXPECT_EQ(curves(jump), 3 + 2U);  // legs, curves
  EXPECT_EQ(curves(trot), 3 + 1U);
}

}  // namespace
}  // namespace design
