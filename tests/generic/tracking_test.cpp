// The experiment of robots/tracking: fast motions need a model of the robot.
#include "tracking.h"

#include <gtest/gtest.h>

#include <cmath>

#include "picture.h"

namespace tracking {
namespace {

constexpr double kDuration = 1.5;  // s

double rms(const Result& run) {
  return run.rms.norm();
}

TEST(Tracking, InverseDynamicsIsMarkedlyBetter) {
  for (const double rate : {250.0, 1000.0}) {
    const Result without = run(Law::proportional_derivative, rate, kDuration);
    const Result with = run(Law::inverse_dynamics, rate, kDuration);
    EXPECT_LT(5 * rms(with), rms(without)) << rate << " Hz";
    EXPECT_LT(5 * with.largest.norm(), without.largest.norm()) << rate << " Hz";
    // The amplitudes are 0.3 and 0.4 rad.
    EXPECT_LT(with.largest.maxCoeff(), 0.05) << rate << " Hz";
  }
}

TEST(Tracking, IsTheSameInEveryRun) {
  const Result a = run(Law::inverse_dynamics, 250, kDuration), b = run(Law::inverse_dynamics, 250, kDuration);
  ASSERT_EQ(a.instants.size(), b.instants.size());
  for (std::size_t i = 0; i < a.instants.size(); ++i) EXPECT_EQ(a.instants[i].found, b.instants[i].found);
}

TEST(Tracking, RunsAtItsRate) {
  const Result slow = run(Law::inverse_dynamics, 250, kDuration);
  EXPECT_EQ(slow.loop_times.size(), 376U);  // the first at 0
  EXPECT_EQ(slow.instants.size(), 1501U);
  // The desired motion has five periods per second about the centre.
  EXPECT_NEAR(slow.instants[200].wanted[0], slow.instants[0].wanted[0], 1e-12);
  EXPECT_NEAR(slow.instants[50].wanted[1] - slow.instants[0].wanted[1], 0.4, 1e-12);
}

TEST(Tracking, PictureShowsAllRuns) {
  const std::vector<Result> runs = {
      run(Law::proportional_derivative, 250, kDuration), run(Law::inverse_dynamics, 1000, kDuration)};
  const std::string text = picture(runs);
  EXPECT_EQ(text.rfind("</svg>\n"), text.size() - 7);
  for (const Result& r : runs) EXPECT_NE(text.find(">" + name_of(r) + "<"), std::string::npos) << name_of(r);
  EXPECT_EQ(text.find("nan"), std::string::npos);
  EXPECT_EQ(text.find("inf"), std::string::npos);
  std::size_t curves = 0;
  for (std::size_t at = text.find("<polyline"); at != std::string::npos; at = text.find("<polyline", at + 1)) ++curves;
  EXPECT_EQ(curves, 3 + 2 * 3 + 2U);  // legend; wanted and both runs in two panels; errors
}

}  // namespace
}  // namespace tracking
