// Compares every function of a library over many states with single calls, state by state. Compiled once per robot,
// with CALLS, a header that write_calls makes.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <random>

#include "allocation_hook.h"
#include "calls.h"
#include CALLS
#include "robcogen/reference/levels.h"

namespace robcogen::batch_test {
namespace {

using batch::Level;
using reference::available_levels;

// Relative to the largest number of a state's results: products fuse with other sums, and solutions of equations
// accumulate errors of a few hundred roundings.
template <class Scalar>
constexpr double kTolerance = 450 * static_cast<double>(std::numeric_limits<Scalar>::epsilon());  // 1e-13 in double

constexpr int kGap = 3;  // numbers beyond the states, or beyond the elements of a state
constexpr int kGuard = 16;

// Numbers of n states in one layout, with gaps, between guards.
template <class Scalar>
class Array {
 public:
  static constexpr Scalar kUntouched = Scalar(-12345.5);

  Array(std::ptrdiff_t n, int elements, bool by_state) : n_(n), elements_(elements), by_state_(by_state) {
    const std::ptrdiff_t lines = by_state ? n : elements;
    numbers_.assign(static_cast<std::size_t>(lines * stride() + 2 * kGuard), kUntouched);
  }

  std::ptrdiff_t stride() const { return (by_state_ ? elements_ : n_) + kGap; }
  Scalar* data() { return numbers_.data() + kGuard; }
  Scalar& at(std::ptrdiff_t state, int element) {
    return data()[by_state_ ? state * stride() + element : element * stride() + state];
  }

  // True if nothing was written outside the elements of states.
  bool is_clean() {
    Array other(n_, elements_, by_state_);
    for (std::ptrdiff_t i = 0; i < n_; ++i)
      for (int k = 0; k < elements_; ++k) other.at(i, k) = at(i, k);
    return std::memcmp(numbers_.data(), other.numbers_.data(), numbers_.size() * sizeof(Scalar)) == 0;
  }

 private:
  std::ptrdiff_t n_;
  int elements_;
  bool by_state_;
  std::vector<Scalar> numbers_;
};

// The arguments of n states, state by state.
template <class Scalar>
using States = std::vector<std::vector<std::vector<Scalar>>>;

template <class Scalar>
States<Scalar> random_states(const Call<Scalar>& call, std::ptrdiff_t n) {
  std::mt19937_64 generator(static_cast<std::uint64_t>(n));
  std::uniform_real_distribution<double> unit(-2, 2);
  States<Scalar> states(static_cast<std::size_t>(n));
  for (auto& state : states) {
    for (std::size_t i = 0; i < call.input_sizes.size(); ++i) {
      std::vector<Scalar> values(static_cast<std::size_t>(call.input_sizes[i]));
      for (Scalar& x : values) x = static_cast<Scalar>(unit(generator));
      if (call.is_standard_gravity[i]) values = {0, 0, Scalar(-9.81)};
      state.push_back(std::move(values));
    }
  }
  return states;
}

// The results of one state, one after another.
template <class Scalar>
std::vector<Scalar> single(const Call<Scalar>& call, const std::vector<std::vector<Scalar>>& state) {
  std::vector<const Scalar*> in;
  for (const std::vector<Scalar>& values : state) in.push_back(values.data());
  std::vector<std::size_t> begins;
  std::size_t size = 0;
  for (const int elements : call.output_sizes) {
    begins.push_back(size);
    size += static_cast<std::size_t>(elements);
  }
  std::vector<Scalar> results(size);
  std::vector<Scalar*> out;
  for (const std::size_t begin : begins) out.push_back(results.data() + begin);
  call.single(in.data(), out.data());
  return results;
}

// For a function that computes only the lower triangle: returns the whole matrix, after checking that nothing was
// written above the diagonal.
template <class Scalar>
std::vector<Scalar> whole(const Call<Scalar>& call, std::vector<Scalar> matrix) {
  const auto rows = static_cast<std::size_t>(call.lower_rows);
  for (std::size_t column = 1; column < rows; ++column)
    for (std::size_t row = 0; row < column; ++row) {
      Scalar& above = matrix[column * rows + row];
      EXPECT_EQ(above, Array<Scalar>::kUntouched) << call.name << ": row " << row << ", column " << column;
      above = matrix[row * rows + column];
    }
  return matrix;
}

// The results of all states, by one call over them.
template <class Scalar>
std::vector<std::vector<Scalar>> many(
    const Call<Scalar>& call,
    const States<Scalar>& states,
    bool by_state,
    Level level) {
  const auto n = static_cast<std::ptrdiff_t>(states.size());
  Arguments<Scalar> arguments;
  arguments.n = n;
  arguments.level = level;
  std::vector<Array<Scalar>> inputs, outputs;
  for (const int elements : call.input_sizes) inputs.emplace_back(n, elements, by_state);
  for (const int elements : call.output_sizes) outputs.emplace_back(n, elements, by_state);
  for (std::size_t i = 0; i < inputs.size(); ++i) {
    for (std::ptrdiff_t s = 0; s < n; ++s)
      for (int k = 0; k < call.input_sizes[i]; ++k)
        inputs[i].at(s, k) = states[static_cast<std::size_t>(s)][i][static_cast<std::size_t>(k)];
    arguments.inputs.push_back(inputs[i].data());
    arguments.input_strides.push_back(inputs[i].stride());
  }
  for (Array<Scalar>& output : outputs) {
    arguments.outputs.push_back(output.data());
    arguments.output_strides.push_back(output.stride());
  }
  {
    const NoAllocation none(call.name.c_str());
    (by_state ? call.by_state : call.by_element)(arguments);
  }
  std::vector<std::vector<Scalar>> results(states.size());
  for (std::size_t i = 0; i < outputs.size(); ++i) {
    EXPECT_TRUE(outputs[i].is_clean()) << call.name << ": wrote beyond " << n << " states";
    for (std::ptrdiff_t s = 0; s < n; ++s)
      for (int k = 0; k < call.output_sizes[i]; ++k)
        results[static_cast<std::size_t>(s)].push_back(outputs[i].at(s, k));
  }
  for (std::vector<Scalar>& result : results) result = whole(call, std::move(result));
  return results;
}

// The largest difference, relative to the largest expected number.
template <class Scalar>
double error(const std::vector<Scalar>& found, const std::vector<Scalar>& expected) {
  double largest = 1, difference = 0;
  for (std::size_t i = 0; i < expected.size(); ++i) {
    if (std::isfinite(expected[i])) largest = std::max(largest, std::abs(static_cast<double>(expected[i])));
    if (found[i] == expected[i] || (std::isnan(found[i]) && std::isnan(expected[i]))) continue;
    const double d = std::abs(static_cast<double>(found[i]) - static_cast<double>(expected[i]));
    difference = std::max(difference, std::isnan(d) ? std::numeric_limits<double>::infinity() : d);
  }
  return difference / largest;
}

template <class Scalar>
class Batch : public testing::Test {};
using Precisions = testing::Types<double, float>;
TYPED_TEST_SUITE(Batch, Precisions);

TYPED_TEST(Batch, IsSingleCalls) {
  for (const Call<TypeParam>& call : calls<TypeParam>()) {
    for (const std::ptrdiff_t n : {0, 1, 3, 4, 7, 8, 9, 33}) {
      const States<TypeParam> states = random_states(call, n);
      for (const Level level : available_levels()) {
        for (const bool by_state : {false, true}) {
          const auto found = many(call, states, by_state, level);
          for (std::size_t i = 0; i < states.size(); ++i) {
            const std::vector<TypeParam> expected = single(call, states[i]);
            ASSERT_TRUE(std::all_of(expected.begin(), expected.end(), [](TypeParam x) { return std::isfinite(x); }));
            ASSERT_LE(error(found[i], expected), kTolerance<TypeParam>)
                << call.name << ", state " << i << " of " << n << ", level " << static_cast<int>(level)
                << (by_state ? ", by state" : ", by element");
          }
        }
      }
    }
  }
}

bool same_bits(double a, double b) {
  return std::memcmp(&a, &b, sizeof(a)) == 0;
}

// A NaN, or an angle too large for the polynomials of sines, affects only its own state.
TYPED_TEST(Batch, StatesDoNotTouchEachOther) {
  constexpr std::size_t kCount = 19, kOdd = 4, kLarge = 11;
  constexpr double kScale = 3e5, kCancelled = 1000;  // lengths are scaled, too, and cancel
  for (const Call<TypeParam>& call : calls<TypeParam>()) {
    const States<TypeParam> usual = random_states(call, kCount);
    States<TypeParam> states = usual;
    for (std::size_t i = 0; i < call.input_sizes.size(); ++i) {
      if (call.is_standard_gravity[i]) continue;
      for (TypeParam& x : states[kOdd][i]) x = std::numeric_limits<TypeParam>::quiet_NaN();
      if (i == 0)
        for (TypeParam& x : states[kLarge][i]) x = static_cast<TypeParam>(kScale * static_cast<double>(x));
    }
    for (const Level level : available_levels()) {
      const auto found = many(call, states, false, level), expected = many(call, usual, false, level);
      for (std::size_t i = 0; i < kCount; ++i) {
        if (i == kOdd) continue;
        if (i == kLarge) {
          EXPECT_LE(error(found[i], single(call, states[i])), kCancelled * kTolerance<TypeParam>) << call.name;
          continue;
        }
        for (std::size_t k = 0; k < found[i].size(); ++k)
          ASSERT_TRUE(same_bits(static_cast<double>(found[i][k]), static_cast<double>(expected[i][k])))
              << call.name << ", state " << i << ", level " << static_cast<int>(level);
      }
    }
  }
}

TEST(BatchLevel, IsNeverMoreThanThereIs) {
  EXPECT_EQ(batch::available(Level::baseline), Level::baseline);
  EXPECT_EQ(batch::available(Level::avx512), batch::best_level());
  EXPECT_LE(batch::available(Level::avx2), Level::avx2);
}

}  // namespace
}  // namespace robcogen::batch_test
