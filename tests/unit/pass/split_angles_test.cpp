// Programs that read sines and cosines of joint angles take them as inputs; sines and cosines of sums are computed from
// those of joints.
#include "pass/split_angles.h"

#include <cmath>

#include "symbolic/cost.h"
#include "symbolic/programs.h"

namespace robcogen::pass::split_angles_test {
namespace {

using symbolic::Arrays;
using symbolic::Program;

const std::vector<Position> kJoints = {{"slide"}, {"hip"}, {"knee"}};
const std::vector<double> kPositions = {0.3, 1.1, -0.7};
const std::vector<double> kSpeeds = {0.5, 2.0, -1.5};

// p: an angle and a length; q: three joint positions; v: joint velocities.
Program with(const std::string& statements, const std::string& returns) {
  return test::program(
      "program test\n"
      "input p parameters angle length\n"
      "input q joint_position slide hip knee\n"
      "input v joint_velocity slide hip knee\n"
      "output out value 2 1\n"
      "section leg link leg\n"
      "in 0\n" +
      statements + "return out " + returns + "\n");
}

const std::vector<double> kParameters = {0.4, 1.5};

std::vector<double> run(const Program& program, const Arrays<double>& inputs, const std::string& output) {
  return symbolic::interpret<double>(program, inputs).at(output);
}

// Sines and cosines of all angles: computed from the angles, or by addition theorems from those of joints.
struct Trigonometry {
  std::vector<double> sine, cosine;
};
Trigonometry computed(const SplitAngles& split) {
  Trigonometry all;
  for (const double angle : run(split.angles, {{"p", kParameters}, {"q", kPositions}}, "angles")) {
    all.sine.push_back(std::sin(angle));
    all.cosine.push_back(std::cos(angle));
  }
  return all;
}
Trigonometry added(const SplitAngles& split) {
  Arrays<double> inputs = {{"p", kParameters}, {"sin_joint", {}}, {"cos_joint", {}}};
  for (const double q : kPositions) {
    inputs["sin_joint"].push_back(std::sin(q));
    inputs["cos_joint"].push_back(std::cos(q));
  }
  return {run(split.addition, inputs, "sin_q"), run(split.addition, inputs, "cos_q")};
}

std::vector<double> run_core(const SplitAngles& split, const Trigonometry& all) {
  return run(
      split.cores[0]->program,
      {{"p", kParameters}, {"q", kPositions}, {"v", kSpeeds}, {"sin_q", all.sine}, {"cos_q", all.cosine}}, "out");
}

std::vector<double> run_whole(const Program& program) {
  return run(program, {{"p", kParameters}, {"q", kPositions}, {"v", kSpeeds}}, "out");
}

// With the sines and cosines that the program computes, the core gives the same result to the last bit; with those from
// addition theorems, nearly the same.
void expect_same(const Program& program, const SplitAngles& split) {
  const std::vector<double> expected = run_whole(program);
  EXPECT_EQ(run_core(split, computed(split)), expected);
  const std::vector<double> found = run_core(split, added(split));
  for (std::size_t i = 0; i < expected.size(); ++i) EXPECT_NEAR(found[i], expected[i], 1e-15) << i;
}

TEST(SplitAngles, TakesSinesOfJoints) {
  const Program program =
      with("tmp s = sin q[2]\ntmp c = cos -q[1]\ntmp x = s * v[1]\ntmp y = x + c\ntmp z = q[0] * c\n", "y -z");
  const SplitAngles split = split_angles({{program}}, kJoints);
  ASSERT_TRUE(split.cores[0]);
  EXPECT_EQ(split.angle_count, 3);
  EXPECT_EQ(split.cores[0]->read, (std::vector<int>{1, 2}));
  const Program& core = split.cores[0]->program;
  EXPECT_EQ(symbolic::cost(core).sincos, 0);
  ASSERT_EQ(core.inputs.size(), 5u);
  EXPECT_EQ(core.inputs[1].name, "q");
  EXPECT_EQ(core.inputs[2].role, symbolic::Role::joint_sine);
  EXPECT_EQ(core.inputs[3].elements, (std::vector<std::string>{"c_slide", "c_hip", "c_knee"}));
  expect_same(program, split);
}

// The sign of an angle changes the sign of its sine; sums of joints and constants are angles of their own.
TEST(SplitAngles, AddsTheoremsForSums) {
  const Program program = with(
      "tmp sum = q[1] - q[2]\ntmp turned = sum + 0.25\ntmp right = q[2] + pi:1:2\n"
      "tmp s = sin -turned\ntmp c = cos right\ntmp d = cos sum\n"
      "tmp x = s * v[1]\ntmp y = x + c\ntmp z = d * s\n",
      "y z");
  const SplitAngles split = split_angles({{program}}, kJoints);
  EXPECT_EQ(split.angle_count, 6);
  EXPECT_EQ(split.cores[0]->read, (std::vector<int>{3, 4, 5}));
  const std::vector<std::string> labels = split.cores[0]->program.inputs[2].elements;
  EXPECT_EQ(labels[3], "s_hip_knee_turned");
  EXPECT_EQ(labels[4], "s_knee_turned");
  EXPECT_EQ(labels[5], "s_hip_knee");
  expect_same(program, split);
}

// A right angle costs nothing; two joints, or a joint and any other constant, cost four products and two sums.
TEST(SplitAngles, CountsOfTheorems) {
  const auto count_of = [](const std::string& sum) {
    const Program program = with("tmp a = " + sum + "\ntmp s = sin a\n", "s s");
    const symbolic::Cost c = symbolic::cost(split_angles({{program}}, kJoints).addition);
    return std::pair(c.mul, c.add);
  };
  EXPECT_EQ(count_of("q[1] + pi:1:2"), std::pair(0, 0));
  EXPECT_EQ(count_of("q[1] + q[2]"), std::pair(4, 2));
  EXPECT_EQ(count_of("q[1] - q[2]"), std::pair(4, 2));
  EXPECT_EQ(count_of("q[1] + 0.25"), std::pair(4, 2));
}

TEST(SplitAngles, SumsMayHoldParameters) {
  const Program program =
      with("tmp turned = q[1] + p[0]\ntmp s = sin turned\ntmp c = cos q[1]\ntmp x = c * p[1]\n", "s x");
  const SplitAngles split = split_angles({{program}}, kJoints);
  EXPECT_EQ(split.cores[0]->read, (std::vector<int>{1, 3}));
  expect_same(program, split);
}

// An angle that two programs share has one number.
TEST(SplitAngles, ProgramsShareAngles) {
  const Program first = with("tmp a = q[1] + q[2]\ntmp s = sin a\n", "s s");
  const Program second = with("tmp a = q[2] + q[1]\ntmp b = q[0] + q[1]\ntmp s = cos a\ntmp t = sin b\n", "s t");
  const SplitAngles split = split_angles({{first}, {second}}, kJoints);
  EXPECT_EQ(split.cores[0]->read, (std::vector<int>{3}));
  EXPECT_EQ(split.cores[1]->read, (std::vector<int>{3, 4}));
  EXPECT_EQ(split.cores[0]->program.inputs[2].elements.size(), 5u);
}

// Angles that no theorem covers stay: angles of other inputs, products of positions, sines of parameters alone.
TEST(SplitAngles, LeavesTheRest) {
  const Program others = with("tmp s = sin v[1]\ntmp c = cos p[0]\n", "s c");
  EXPECT_FALSE(split_angles({{others}}, kJoints).cores[0]);
  const Program twice = with("tmp d = q[1] * 3\ntmp s = sin d\ntmp c = cos q[1]\n", "s c");
  const SplitAngles split = split_angles({{twice}}, kJoints);
  EXPECT_EQ(split.cores[0]->read, (std::vector<int>{1}));
  EXPECT_EQ(symbolic::cost(split.cores[0]->program).sincos, 1);
  expect_same(twice, split);
}

// A coupled joint may turn with the position of a sliding joint, whose sine is not given.
TEST(SplitAngles, LeavesWhatTurnsByASlide) {
  const Program turns = with("tmp s = sin q[0]\ntmp c = cos q[1]\n", "s c");
  const SplitAngles split = split_angles({{turns}}, {{"slide", false}, {"hip"}, {"knee"}});
  EXPECT_EQ(split.cores[0]->read, (std::vector<int>{1}));
  expect_same(turns, split);
}

// In lanes, a vector of sines is gathered from the given ones, and one of its lanes is one of them.
TEST(SplitAngles, LanesAreGathered) {
  const Program program =
      with("tmp s1 = sin q[1]\ntmp s2 = sin q[2]\ntmp x = s1 * v[1]\ntmp y = s2 * v[2]\ntmp z = x + s2\n", "z y");
  const Program in_lanes = with(
      "tmp angle = gather q[1] q[2]\ntmp s = sin angle\ntmp speed = gather v[1] v[2]\ntmp x = s * speed\n"
      "tmp z = x@0 + s@1\n",
      "z x@1");
  const SplitAngles split = split_angles({{program, &in_lanes}}, kJoints);
  ASSERT_TRUE(split.cores[0]->in_lanes);
  const Program& core = *split.cores[0]->in_lanes;
  EXPECT_EQ(symbolic::verify(core), "");
  EXPECT_EQ(
      symbolic::print(core),
      symbolic::print(
          test::program("program test\ninput p parameters angle length\ninput q joint_position slide hip knee\n"
                        "input sin_q joint_sine s_slide s_hip s_knee\ninput cos_q joint_cosine c_slide c_hip c_knee\n"
                        "input v joint_velocity slide hip knee\noutput out value 2 1\nsection leg link leg\nin 0\n"
                        "tmp leg_t0 = gather sin_q[1] sin_q[2]\ntmp speed = gather v[1] v[2]\ntmp x = leg_t0 * speed\n"
                        "tmp z = x@0 + sin_q[2]\nreturn out z x@1\n")));
  expect_same(program, split);
}

// Sums are resolved lane by lane: each lane is an angle as elsewhere, with a sign if it is negated.
TEST(SplitAngles, LanesOfSumsAreAnglesOfTheirOwn) {
  const Program program = with(
      "tmp a = q[1] + 0.25\ntmp b = q[2] - 0.25\ntmp s = sin a\ntmp t = sin b\ntmp c = cos b\ntmp x = t + c\n", "s x");
  const Program in_lanes = with(
      "tmp ones = gather 1 -1\ntmp q12 = gather q[1] q[2]\ntmp turned = q12 * ones\ntmp a = turned + 0.25\n"
      "tmp s = sin a\ntmp c = cos a\ntmp x = c@1 - s@1\n",
      "s@0 x");
  const SplitAngles split = split_angles({{program, &in_lanes}}, kJoints);
  EXPECT_EQ(split.cores[0]->read, (std::vector<int>{3, 4}));
  EXPECT_EQ(split.angle_count, 5);
  const Program& core = *split.cores[0]->in_lanes;
  EXPECT_EQ(symbolic::cost(core).sincos, 0);
  const Trigonometry all = computed(split);
  const std::vector<double> found = run(
      core, {{"p", kParameters}, {"q", kPositions}, {"v", kSpeeds}, {"sin_q", all.sine}, {"cos_q", all.cosine}}, "out");
  EXPECT_EQ(found, run_whole(in_lanes));
  EXPECT_EQ(found, run_core(split, all));
}

// If no theorem covers one lane, all lanes stay.
TEST(SplitAngles, LanesStayTogether) {
  const Program program = with("tmp s = sin v[1]\ntmp t = sin q[1]\n", "s t");
  const Program in_lanes = with("tmp a = gather v[1] q[1]\ntmp s = sin a\n", "s@0 s@1");
  const SplitAngles split = split_angles({{program, &in_lanes}}, kJoints);
  EXPECT_EQ(symbolic::cost(*split.cores[0]->in_lanes).sincos, 1);
  EXPECT_EQ(split.cores[0]->read, std::vector<int>{1});
}

TEST(SplitAngles, NoProgramsNoSums) {
  const SplitAngles split = split_angles({}, kJoints);
  EXPECT_EQ(split.angle_count, 3);
  EXPECT_EQ(split.addition.outputs[0].rows, 3);
}

}  // namespace
}  // namespace robcogen::pass::split_angles_test
