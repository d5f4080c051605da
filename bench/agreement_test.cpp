#include "agreement.h"

#include <gtest/gtest.h>

#include <limits>

namespace robcogen::bench {
namespace {

// Returns value(state) for the inertia matrix, and has no other quantity.
class Scripted : public peers::Peer {
 public:
  explicit Scripted(std::function<Eigen::MatrixXd(std::size_t)> value) : value_(std::move(value)) {}
  std::string name() const override { return "Scripted"; }
  bool has(peers::Quantity quantity) const override { return quantity == peers::Quantity::inertia_matrix; }
  void prepare(const std::vector<peers::State>&) override {}
  void run(peers::Quantity, std::size_t state) override { last_ = value_(state); }
  Eigen::MatrixXd result(peers::Quantity) const override { return last_; }

 private:
  std::function<Eigen::MatrixXd(std::size_t)> value_;
  Eigen::MatrixXd last_;
};

constexpr std::size_t kStates = 4;

Eigen::MatrixXd truth(std::size_t state) {
  Eigen::MatrixXd m(2, 2);
  m << 1000.0 + static_cast<double>(state), 2, 2, 1;
  return m;
}

// The peer's matrix is the truth, except for one element at state 2.
std::vector<std::string> messages(double error) {
  Scripted peer([error](std::size_t state) {
    Eigen::MatrixXd m = truth(state);
    if (state == 2) m(1, 0) += error;
    return m;
  });
  const std::vector<Computed> computed = {
      {peers::Quantity::forward_dynamics, "forward_dynamics", [](std::size_t) { return Eigen::MatrixXd(); }},
      {peers::Quantity::inertia_matrix, "joint_space_inertia", truth}};
  return disagreements(peer, computed, kStates);
}

TEST(Agreement, RoundingIsLeft) {
  EXPECT_TRUE(messages(0).empty());
  // Relative to the largest element, 1002.
  EXPECT_TRUE(messages(0.9e-6).empty());
  EXPECT_EQ(messages(1.1e-6).size(), 1);
}

TEST(Agreement, MessageNamesPeerQuantityAndState) {
  const std::vector<std::string> all = messages(0.5);
  ASSERT_EQ(all.size(), 1);
  for (const char* part :
       {"Scripted disagrees in inertia_matrix (joint_space_inertia) at state 2", "row 1 of column 0", "1002, 2\n",
        "1002, 2.5"}) {
    EXPECT_NE(all.front().find(part), std::string::npos) << all.front();
  }
}

TEST(Agreement, NotANumberDisagrees) {
  EXPECT_EQ(messages(std::numeric_limits<double>::quiet_NaN()).size(), 1);
  EXPECT_EQ(messages(std::numeric_limits<double>::infinity()).size(), 1);
}

TEST(Agreement, AnotherShapeDisagrees) {
  Scripted peer([](std::size_t) { return Eigen::MatrixXd::Ones(2, 1); });
  EXPECT_EQ(disagreements(peer, {{peers::Quantity::inertia_matrix, "joint_space_inertia", truth}}, kStates).size(), 1);
}

TEST(Agreement, ZeroAgreesWithZeroAlone) {
  const std::vector<Computed> zero = {{peers::Quantity::inertia_matrix, "joint_space_inertia", [](std::size_t) {
                                         return Eigen::MatrixXd::Zero(2, 2);
                                       }}};
  Scripted same([](std::size_t) { return Eigen::MatrixXd::Zero(2, 2); });
  EXPECT_TRUE(disagreements(same, zero, kStates).empty());
  Scripted other([](std::size_t) { return Eigen::MatrixXd::Constant(2, 2, 1e-3); });
  EXPECT_EQ(disagreements(other, zero, kStates).size(), 1);
}

}  // namespace
}  // namespace robcogen::bench
