// The programs that are generated lose no more digits than the plain recursions do in the same precision.
//
// ROBCOGEN_TEST_ILL_ROBOTS raises the volume.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "command/pipeline.h"
#include "ill_robot.h"
#include "packed_programs.h"
#include "random_robot.h"
#include "symbolic/interpret.h"
#include "volume.h"

namespace robcogen::numeric {
namespace {

using model::KinematicTree;
using symbolic::Arrays;
using symbolic::Program;

// A program may lose this many times as much as the plain one does …
constexpr double kShare = 4.0;
// … or this many roundings: sums of other order differ by that.
constexpr double kFloor = 32.0;
// Where the plain program keeps fewer than this share of the result there is nothing to compare.
constexpr double kLost = 1e-2;

// Places far apart, and states close to each of them: near a singular position all errors are as large as that is near,
// and one state alone tells of luck.
constexpr int kPlaces = 8, kNearby = 4;
constexpr double kNear = 1e-3;

const std::vector<std::string>& groups() {
  static const std::vector<std::string> list = {
      "inverse_dynamics",           "bias_forces",     "forward_dynamics", "joint_space_inertia",
      "joint_space_inertia_factor", "coriolis_matrix", "centroidal",       "energy"};
  return list;
}

double uniform(std::mt19937_64& engine) {
  return static_cast<double>(engine() >> 11) * 0x1p-52 - 1.0;
}

// Numbers that a float holds.
Arrays<double> inputs_of(const Program& program, int place, int nearby) {
  std::mt19937_64 far(static_cast<std::uint64_t>(place) * 1000),
      near(static_cast<std::uint64_t>(place * 1000 + nearby));
  Arrays<double> inputs;
  for (const symbolic::InputArray& array : program.inputs) {
    const double limit = array.role == symbolic::Role::joint_position ? 3.0
                         : array.role == symbolic::Role::gravity      ? 10.0
                                                                      : 2.0;
    for (std::size_t k = 0; k < array.elements.size(); ++k) {
      const double x = limit * uniform(far) + kNear * uniform(near);
      inputs[array.name].push_back(static_cast<double>(static_cast<float>(x)));
    }
  }
  return inputs;
}

template <class To>
Arrays<To> cast(const Arrays<double>& arrays) {
  Arrays<To> result;
  for (const auto& [name, values] : arrays)
    for (const double x : values) result[name].push_back(static_cast<To>(x));
  return result;
}

// What a program is compared with, state by state.
struct State {
  Arrays<double> inputs;
  Arrays<long double> results;
};

std::vector<State> states_of(const Program& plain) {
  std::vector<State> states;
  for (int place = 0; place < kPlaces; ++place) {
    for (int nearby = 0; nearby < kNearby; ++nearby) {
      State state;
      state.inputs = inputs_of(plain, place, nearby);
      state.results = symbolic::interpret<long double>(plain, cast<long double>(state.inputs));
      states.push_back(std::move(state));
    }
  }
  return states;
}

// By output array: the root of the mean square of the largest errors, relative to the largest results.
template <class Real>
std::map<std::string, double> errors_of(const Program& program, const std::vector<State>& states) {
  // A state where results cancel is judged by a share of what they are otherwise.
  constexpr double kLeastScale = 0.25;
  std::map<std::string, double> squares, usual;
  for (const State& state : states) {
    for (const auto& [name, expected] : state.results) {
      long double largest = 0;
      for (const long double x : expected) largest = std::max(largest, std::abs(x));
      if (std::isfinite(largest)) usual[name] += static_cast<double>(largest * largest);
    }
  }
  for (auto& [name, sum] : usual) sum = kLeastScale * std::sqrt(sum / static_cast<double>(states.size()));
  for (const State& state : states) {
    const Arrays<Real> found = symbolic::interpret<Real>(program, cast<Real>(state.inputs));
    for (const auto& [name, expected] : state.results) {
      long double scale = usual[name], error = 0;
      for (std::size_t k = 0; k < expected.size(); ++k) {
        const long double difference = std::abs(static_cast<long double>(found.at(name)[k]) - expected[k]);
        scale = std::max(scale, std::abs(expected[k]));
        error = std::isnan(difference) ? std::numeric_limits<long double>::infinity() : std::max(error, difference);
      }
      if (scale > 0 && std::isfinite(scale)) squares[name] += static_cast<double>(error / scale * (error / scale));
    }
  }
  for (auto& [name, sum] : squares) sum = std::sqrt(sum / static_cast<double>(states.size()));
  return squares;
}

// Empty, or what the program loses.
template <class Real>
std::string loss(
    const Program& program,
    const Program& plain,
    const std::vector<State>& states,
    const char* precision) {
  const double rounding = static_cast<double>(std::numeric_limits<Real>::epsilon()) / 2;
  const auto own = errors_of<Real>(program, states), allowed = errors_of<Real>(plain, states);
  for (const auto& [name, error] : own) {
    const double of_plain = allowed.at(name);
    if (!(of_plain < kLost) || error <= std::max(kShare * of_plain, kFloor * rounding)) continue;
    return program.name + ": error of " + name + " in " + precision + " is " + std::to_string(error / rounding) +
           " roundings, of the plain recursion " + std::to_string(of_plain / rounding) + "\n";
  }
  return "";
}

std::string loss(const Program& program, const Program& plain, const std::vector<State>& states) {
  return loss<double>(program, plain, states, "double") + loss<float>(program, plain, states, "float");
}

// Of all that is generated for the robot.
std::string losses(const KinematicTree& tree) {
  command::Robot robot;
  robot.tree = tree;
  std::string text;
  const backend::Library library = command::library_for_vectors(robot, {"robot", ""}, groups(), {});
  std::map<std::string, Program> plain;
  for (const std::string& group : groups())
    for (Program& program : algorithm::plain_programs(tree, group)) plain.emplace(program.name, program);
  for (const backend::Function& f : library.functions) {
    // What reads a factor has no formulation.
    if (f.scope == "inertia_factor") continue;
    const Program& reference = plain.at(f.kernel);
    const std::vector<State> states = states_of(reference);
    text += loss(f.program, reference, states);
    const std::string in_lanes = f.in_lanes ? loss(*f.in_lanes, reference, states) : "";
    if (!in_lanes.empty()) text += "in lanes: " + in_lanes;
  }
  return text;
}

void expect_digits(const KinematicTree& tree, std::uint64_t seed) {
  const std::string text = losses(tree);
  if (text.empty()) return;
  const KinematicTree small = shrink(tree, [](const KinematicTree& t) { return !losses(t).empty(); });
  ADD_FAILURE() << "seed " << seed << "\n" << text << "shrunk to\n" << describe(small) << losses(small);
}

// Small robots with what makes exporters' documents ill.
class IllDocuments : public testing::TestWithParam<const char*> {};

TEST_P(IllDocuments, LoseNoMoreDigitsThanThePlainRecursions) {
  EXPECT_EQ(losses(document_of(std::string(TEST_SOURCE_DIR) + "/ill/" + GetParam() + ".kindsl")), "");
}

INSTANTIATE_TEST_SUITE_P(All, IllDocuments, testing::Values("near_parallel", "crumbs", "nearly_planar"));

// Shards, so that a test runner can share them out.
constexpr int kShards = 10;

class IllRobots : public testing::TestWithParam<int> {};

TEST_P(IllRobots, LoseNoMoreDigitsThanThePlainRecursions) {
  const int count = volume("ROBCOGEN_TEST_ILL_ROBOTS", 40);
  for (int i = GetParam(); i < count; i += kShards)
    expect_digits(ill_robot(static_cast<std::uint64_t>(i)), static_cast<std::uint64_t>(i));
}

INSTANTIATE_TEST_SUITE_P(Shard, IllRobots, testing::Range(0, kShards));

}  // namespace
}  // namespace robcogen::numeric
