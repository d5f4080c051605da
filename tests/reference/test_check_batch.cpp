// The check of functions over many states: it passes for correct code and finds the mistakes that loops over blocks of
// states are prone to.
#include <gtest/gtest.h>

#include "robcogen/reference/check_batch.h"

namespace robcogen::reference::check_batch_test {
namespace {

using batch::Level;
using Numbers = batch::Strided<const double>;
using Results = batch::Strided<double>;

// The function of a robot with one parameter p, for a state of two numbers x and y: x + p y, and y.
void single(const double* in, double* out) noexcept {
  out[0] = in[1] + in[0] * in[2];
  out[1] = in[2];
}

void state(double p, const Numbers& in, std::ptrdiff_t from, const Results& out, std::ptrdiff_t to) {
  const auto input = [&](std::ptrdiff_t k) { return in.data[k * in.element + from * in.state]; };
  const auto output = [&](std::ptrdiff_t k) -> double& { return out.data[k * out.element + to * out.state]; };
  output(0) = input(0) + p * input(1);
  output(1) = input(1);
}

void right(const double* p, std::ptrdiff_t n, const Numbers& in, const Results& out, Level) noexcept {
  for (std::ptrdiff_t i = 0; i < n; ++i) state(*p, in, i, out, i);
}

void without_tail(const double* p, std::ptrdiff_t n, const Numbers& in, const Results& out, Level most) noexcept {
  right(p, n / 8 * 8, in, out, most);
}

void of_a_neighbour(const double* p, std::ptrdiff_t n, const Numbers& in, const Results& out, Level most) noexcept {
  right(p, n, in, out, most);
  state(*p, in, n - 2, out, n - 1);
}

void of_one_layout(const double* p, std::ptrdiff_t n, const Numbers& in, const Results& out, Level most) noexcept {
  right(p, n, in, {out.data, n, 1}, most);
}

void of_another_parameter(const double*, std::ptrdiff_t n, const Numbers& in, const Results& out, Level most) noexcept {
  const double other = 2;
  right(&other, n, in, out, most);
}

void on_no_baseline(const double* p, std::ptrdiff_t n, const Numbers& in, const Results& out, Level most) noexcept {
  if (most != Level::baseline) right(p, n, in, out, most);
}

using Call = decltype(reflection::BatchFunction::call);

Checks checks_of(const char* name, Call call) {
  static constexpr reflection::Function kSingle[] = {{"f", {1, 1, 0, 0, 0, 1, 4}, 3, 2, &single}};
  Robot robot = {};
  robot.functions = {kSingle, 1};
  const reflection::BatchFunction function = {name, 2, 2, call};
  std::mt19937_64 engine(7);
  Checks checks;
  check_batches(robot, {&function, 1}, {0.5}, engine, checks);
  return checks;
}

TEST(BatchChecks, PassForWhatIsRight) {
  const Checks checks = checks_of("f", &right);
  EXPECT_EQ(checks.size(), 2);  // one per layout
  EXPECT_EQ(checks.failures(), 0) << checks.failure_report();
}

TEST(BatchChecks, FindMistakes) {
  EXPECT_EQ(checks_of("f", &without_tail).failures(), 2);
  EXPECT_EQ(checks_of("f", &of_a_neighbour).failures(), 2);
  EXPECT_EQ(checks_of("f", &of_one_layout).failures(), 1);
  EXPECT_EQ(checks_of("f", &of_another_parameter).failures(), 2);
  EXPECT_EQ(checks_of("f", &on_no_baseline).failures(), 2);
}

TEST(BatchChecks, FindWhatHasNoFunctionOfOneState) {
  EXPECT_EQ(checks_of("g", &right).failures(), 1);
}

// The positions follow a parameter, and the quaternion another joint: functions say where their positions are.
TEST(RandomInputs, HaveQuaternionsOfUnitLength) {
  reflection::Joint joints[4] = {};
  for (int j = 1; j < 4; ++j) {
    joints[j].type = JointType::spherical;
    joints[j].child = 2;
  }
  Robot robot = {};
  robot.joints = {joints, 4};
  reflection::Function f = {"f", {}, 9, 1, nullptr};
  std::mt19937_64 engine(3);
  const auto norm = [&] {
    const std::vector<double> in = random_inputs(engine, robot, f, {0.5});
    EXPECT_EQ(in[0], 0.5);
    return in[2] * in[2] + in[3] * in[3] + in[4] * in[4] + in[5] * in[5];
  };
  EXPECT_GT(std::abs(norm() - 1), 1e-3);
  f.positions = 1;
  EXPECT_NEAR(norm(), 1, 1e-15);
}

}  // namespace
}  // namespace robcogen::reference::check_batch_test
