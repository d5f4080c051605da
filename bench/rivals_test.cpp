// Code of other generators as a peer: its arguments, and how its results are read.
#include "rivals/rivals.h"

#include <gtest/gtest.h>

#include "rivals/rival.h"

namespace robcogen::rivals {
namespace {

using peers::Quantity;

// A robot with two joints on a floating base: its forces are its arguments, and its matrix numbers the elements by
// columns.
States given;
std::vector<double> last;

void prepare(const States& states) {
  given = states;
  last.assign(64, 0);
  const double *q = states.q + 2, *acceleration = states.base_acceleration + 6;  // of state 1
  last = {acceleration[0], acceleration[5], states.gravity[2], states.qd[2], states.qdd[3], states.tau[2], q[0], q[1]};
}
void run(Function, std::size_t) {}
void result(Function function, double* values) {
  for (int k = 0; k < (function == Function::inertia_matrix ? 64 : 8); ++k)
    values[k] = function == Function::inertia_matrix ? k : last[static_cast<std::size_t>(k)];
}

constexpr Rival kRival = {"Rival", 1e-3, 2, true, prepare, run, result};

peers::State state(double first) {
  peers::State s;
  const auto next = [&] { return first += 1; };
  for (Eigen::VectorXd* v : {&s.q, &s.qd, &s.qdd, &s.tau}) *v = Eigen::VectorXd::NullaryExpr(2, next);
  s.base_velocity = s.base_velocity.NullaryExpr(next);
  s.base_acceleration = s.base_acceleration.NullaryExpr(next);
  return s;
}

peers::Subject subject(std::vector<std::string> joints, bool floating) {
  peers::Subject s;
  s.joints = std::move(joints);
  s.floating_base = floating;
  return s;
}

TEST(Rivals, GetStatesOneAfterTheOther) {
  const peers::Candidate made = candidate(kRival, subject({"a", "b"}, true));
  ASSERT_NE(made.peer, nullptr);
  EXPECT_EQ(made.peer->name(), "Rival");
  EXPECT_TRUE(made.peer->has(Quantity::inertia_matrix));
  EXPECT_FALSE(made.peer->has(Quantity::jacobian));
  made.peer->prepare({state(0), state(100)});
  EXPECT_EQ(given.count, 2u);
  made.peer->run(Quantity::inverse_dynamics, 1);
  Eigen::VectorXd expected(8);
  expected << 115, 120, -9.81, 103, 106, 107, 101, 102;
  EXPECT_EQ(made.peer->result(Quantity::inverse_dynamics), expected);
  const Eigen::MatrixXd H = made.peer->result(Quantity::inertia_matrix);
  ASSERT_EQ(H.rows(), 8);
  ASSERT_EQ(H.cols(), 8);
  EXPECT_EQ(H(3, 2), 19);
}

TEST(Rivals, OfAnotherRobotAreLeftOut) {
  for (const auto& other : {subject({"a"}, true), subject({"a", "b"}, false)}) {
    const peers::Candidate made = candidate(kRival, other);
    EXPECT_EQ(made.peer, nullptr);
    EXPECT_EQ(made.reason, "was generated from another robot");
  }
}

}  // namespace
}  // namespace robcogen::rivals
