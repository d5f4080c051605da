// The experiment of robots/identification: an arm is identified from its torques.
#include "identification.h"

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>

#include "picture.h"

namespace identification {
namespace {

struct Experiment {
  Motion motion = exciting_motion(10, 1);
  std::vector<Instant> instants = measure(motion, 2), others = measure(exciting_motion(1, 3), 4);
  InertialParameters guess = guessed_parameters(5);
  Unknowns identified = least_squares(instants);
};

const Experiment& experiment() {
  static const Experiment made;
  return made;
}

double least_moment(const InertialParameters& pi) {
  double least = HUGE_VAL;
  for (int link = 0; link < kLinks; ++link)
    least = std::min(least, pseudo_inertia(pi, link).selfadjointView<Eigen::Lower>().eigenvalues().minCoeff());
  return least;
}

Unknowns with(const InertialParameters& pi) {
  Unknowns unknowns = experiment().identified;
  unknowns.head<kBaseParameters>() = puma::base_parameters(pi);
  return unknowns;
}

TEST(Identification, MotionExcitesAllParameters) {
  const double best = condition_number(experiment().motion);
  EXPECT_LT(best, 500);
  EXPECT_LE(best, condition_number(exciting_motion(1, 1)));
  for (const Instant& i : experiment().instants) {
    EXPECT_LE(i.q.cwiseAbs().maxCoeff(), 1.5 + 1e-12);
    EXPECT_LE(i.qd.cwiseAbs().maxCoeff(), 3 + 1e-12);
  }
  // Velocities and accelerations are those of the positions.
  const double h = 1e-4;
  const Instant now = experiment().motion.at(2), before = experiment().motion.at(2 - h),
                after = experiment().motion.at(2 + h);
  EXPECT_LT(((after.q - before.q) / (2 * h) - now.qd).norm(), 1e-6);
  EXPECT_LT(((after.qd - before.qd) / (2 * h) - now.qdd).norm(), 1e-5);
}

TEST(Identification, NoiseIsWhatIsSaid) {
  JointState sum = JointState::Zero();
  for (const Instant& i : experiment().instants) sum += (i.measured - i.tau).cwiseAbs2();
  const JointState deviation = (sum / static_cast<double>(experiment().instants.size())).cwiseSqrt();
  for (int j = 0; j < kJoints; ++j) EXPECT_NEAR(deviation[j] / noise()[j], 1, 0.1);
}

// Errors for other motions are far below the noise of the measurements, and those of the guess are above it.
TEST(Identification, LeastSquaresPredictOtherMotions) {
  const JointState error = prediction_error(experiment().others, experiment().identified);
  const JointState of_guess = prediction_error(experiment().others, with(experiment().guess));
  for (int j = 0; j < kJoints; ++j) EXPECT_LT(error[j], 0.3 * noise()[j]) << j;
  EXPECT_GT(of_guess.cwiseQuotient(noise()).maxCoeff(), 1);
}

TEST(Identification, LinksAreRealBodies) {
  ASSERT_GT(least_moment(actual_parameters()), 0);
  ASSERT_GT(least_moment(experiment().guess), 0);
  const InertialParameters bodies = consistent_parameters(experiment().instants, experiment().guess);
  EXPECT_GT(least_moment(bodies), 0);
  const JointState error = prediction_error(experiment().others, with(bodies));
  for (int j = 0; j < kJoints; ++j) EXPECT_LT(error[j], 0.5 * noise()[j]) << j;
  // The identified parameters are closer to the actual ones than the guess is.
  const auto of = [](const InertialParameters& pi) { return puma::base_parameters(pi); };
  EXPECT_LT(
      (of(bodies) - of(actual_parameters())).norm(), 0.5 * (of(experiment().guess) - of(actual_parameters())).norm());
}

TEST(Identification, RegressorsAreThoseOfInverseDynamics) {
  const Instant& i = experiment().instants[123];
  const JointState tau = puma::inverse_dynamics(i.q, i.qd, i.qdd);
  EXPECT_LT((puma::regressor(i.q, i.qd, i.qdd) * actual_parameters() - tau).norm(), 1e-12 * (1 + tau.norm()));
  EXPECT_LT(
      (puma::base_regressor(i.q, i.qd, i.qdd) * puma::base_parameters(actual_parameters()) - tau).norm(),
      1e-12 * (1 + tau.norm()));
}

TEST(Identification, PictureShowsAllJoints) {
  const std::string text = picture(experiment().others, with(experiment().guess), experiment().identified);
  EXPECT_EQ(text.rfind("</svg>\n"), text.size() - 7);
  EXPECT_EQ(text.find("nan"), std::string::npos);
  EXPECT_EQ(text.find("inf"), std::string::npos);
  std::size_t curves = 0;
  for (std::size_t at = text.find("<polyline"); at != std::string::npos; at = text.find("<polyline", at + 1)) ++curves;
  EXPECT_EQ(curves, 3 + 3 * 6U);  // legend; each joint
}

}  // namespace
}  // namespace identification
