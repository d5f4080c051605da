// Long kernels are split into parts: each reads only its arguments, and together they give the results of the whole.
#include "backend/common/split_kernel.h"

#include <gtest/gtest.h>

#include <cctype>
#include <cmath>
#include <set>
#include <utility>

#include "backend/cpp/lower.h"
#include "kernel_evaluator.h"
#include "programs.h"
#include "random_program.h"
#include "symbolic/interpret.h"

namespace robcogen::backend::cpp::split_kernel_test {
namespace {

using symbolic::Program;

SplitKernel split(const Program& program, std::size_t longest) {
  return split_kernel(lower(program, "leg"), longest, dialect());
}

std::vector<std::string> texts(const Kernel& kernel) {
  std::vector<std::string> result;
  for (const Line& line : kernel.lines) result.push_back(text(line));
  return result;
}

std::vector<std::string> names(const std::vector<KernelArray>& parameters) {
  std::vector<std::string> result;
  for (const KernelArray& p : parameters) result.push_back(p.name);
  return result;
}

using Texts = std::vector<std::string>;

const char* const kTwoLinks =
    "let hip_a = q[0] + qd[0]\n"
    "let hip_b = hip_a * hip_a\n"
    "in 1\n"
    "let knee_a = hip_b * q[1]\n"
    "let knee_b = knee_a * knee_a\n"
    "tmp t0 = knee_a + knee_b\n"
    "return tau t0\n";

TEST(SplitKernel, IsCutBetweenSectionsAndKeepsWhatIsReadLater) {
  const SplitKernel kernel = split(test::leg_program(kTwoLinks), 4);
  ASSERT_EQ(kernel.parts.size(), 2u);
  EXPECT_EQ(kernel.parts[0].name, "leg_1");
  EXPECT_EQ(names(kernel.parts[0].parameters), (Texts{"q", "qd", "kept"}));
  EXPECT_EQ(
      texts(kernel.parts[0]), (Texts{
                                  "// link hip: velocity",
                                  "const Scalar hip_a = q[0] + qd[0];",
                                  "const Scalar hip_b = hip_a * hip_a;",
                                  "kept[0] = hip_b;",
                              }));
  EXPECT_EQ(kernel.parts[1].name, "leg_2");
  EXPECT_EQ(names(kernel.parts[1].parameters), (Texts{"q", "tau", "kept"}));
  EXPECT_EQ(
      texts(kernel.parts[1]), (Texts{
                                  "const Scalar& hip_b = kept[0];",
                                  "// link knee: velocity",
                                  "const Scalar knee_a = hip_b * q[1];",
                                  "const Scalar knee_b = knee_a * knee_a;",
                                  "tau[0] = knee_a + knee_b;",
                              }));
  ASSERT_EQ(kernel.live.size(), 1u);
  EXPECT_EQ(kernel.live[0].size, 1u);
}

TEST(SplitKernel, IsOnePartWhereAllLinesFit) {
  const SplitKernel kernel = split(test::leg_program(kTwoLinks), 100);
  ASSERT_EQ(kernel.parts.size(), 1u);
  EXPECT_TRUE(kernel.live.empty());
  EXPECT_EQ(texts(kernel.parts[0]), texts(lower(test::leg_program(kTwoLinks), "leg")));
}

// Of three sections, the second joins the first or the third; the first hands more values to the second than the second
// to the third.
TEST(SplitKernel, IsCutWhereFewValuesAreLive) {
  const Program program = test::described_program(
      "program leg\n"
      "input q value a b c\n"
      "output tau value 1 1\n"
      "section hip hip\n"
      "section knee knee\n"
      "section foot foot\n"
      "in 0\n"
      "let x = q[0] * q[1]\n"
      "let y = q[0] * q[2]\n"
      "let z = q[1] * q[2]\n"
      "in 1\n"
      "let u = x + y\n"
      "let v = u * z\n"
      "let w = v * x\n"
      "in 2\n"
      "let a = w * q[0]\n"
      "let b = a * a\n"
      "let c = b * a\n"
      "return tau c\n");
  const SplitKernel kernel = split(program, 8);
  ASSERT_EQ(kernel.parts.size(), 2u);
  EXPECT_EQ(texts(kernel.parts[1]).front(), "const Scalar& w = kept[0];");
}

TEST(SplitKernel, NamesParametersWhereTheyAreRead) {
  const Program program = test::described_program(
      "program leg\n"
      "input parameters parameters length mass\n"
      "input q value a\n"
      "output tau value 1 1\n"
      "section hip hip\n"
      "section knee knee\n"
      "in 0\n"
      "let x = parameters[0] * q[0]\n"
      "in 1\n"
      "let y = parameters[1] * x\n"
      "tmp t0 = y * y\n"
      "return tau t0\n");
  const SplitKernel kernel = split(program, 2);
  ASSERT_EQ(kernel.parts.size(), 2u);
  EXPECT_EQ(texts(kernel.parts[0])[0], "const Scalar& length = parameters[0];");
  EXPECT_EQ(texts(kernel.parts[1])[0], "const Scalar& mass = parameters[1];");
  EXPECT_EQ(texts(kernel.parts[1])[1], "const Scalar& x = kept[0];");
  EXPECT_EQ(names(kernel.parts[1].parameters), (Texts{"parameters", "tau", "kept"}));
}

TEST(SplitKernel, KeepsLanesInArraysOfTheirOwn) {
  const Program program = test::described_program(
      "program leg\n"
      "input q value a b\n"
      "output tau value 1 1\n"
      "section hip hip\n"
      "section knee knee\n"
      "in 0\n"
      "let x = gather q[0] q[1]\n"
      "let y = q[0] * q[1]\n"
      "in 1\n"
      "let z = x * x\n"
      "let s = sum_lanes z\n"
      "let t = s * y\n"
      "return tau t\n");
  const SplitKernel kernel = split(program, 3);
  ASSERT_EQ(kernel.parts.size(), 2u);
  EXPECT_EQ(names(kernel.parts[1].parameters), (Texts{"tau", "kept", "kept_2"}));
  EXPECT_EQ(texts(kernel.parts[1])[0], "const Lanes2& x = kept_2[0];");
  EXPECT_EQ(kernel.parts[1].widths, std::vector<int>{2});
  ASSERT_EQ(kernel.live.size(), 2u);
  EXPECT_EQ(kernel.live[1].array.width, 2);
}

TEST(SplitKernel, LoadsBlocksWhereTheyAreReadAndStoresThem) {
  const Program program = test::described_program(
      "program limbs\n"
      "input q joint_position a0 a1 b0 b1\n"
      "output out value 4 1\n"
      "section first first\n"
      "section second second\n"
      "in 0\n"
      "tmp s = gather q[0] q[2]\n"
      "tmp t = gather q[1] q[3]\n"
      "let x = s * t\n"
      "in 1\n"
      "let y = x + s\n"
      "return out x@0 y@0 x@1 y@1\n");
  const SplitKernel kernel = split(program, 3);
  ASSERT_EQ(kernel.parts.size(), 2u);
  EXPECT_EQ(
      texts(kernel.parts[0]), (Texts{
                                  "// first",
                                  "const auto q_lanes = robcogen::load_lanes<2, 2, 2>(&q[0]);",
                                  "const Lanes2 x = q_lanes[0] * q_lanes[1];",
                                  "kept_2[0] = x;",
                              }));
  EXPECT_EQ(
      texts(kernel.parts[1]), (Texts{
                                  "const Lanes2& x = kept_2[0];",
                                  "// second",
                                  "const auto q_lanes = robcogen::load_lanes<2, 2, 2>(&q[0]);",
                                  "const Lanes2 y = x + q_lanes[0];",
                                  "robcogen::store_lanes<2>(&out[0], x, y);",
                              }));
  EXPECT_EQ(names(kernel.parts[1].parameters), (Texts{"q", "out", "kept_2"}));
}

// Returns the words of a text.
std::set<std::string> words(const std::string& text) {
  std::set<std::string> result;
  std::string word;
  for (const char c : text + ' ') {
    if (std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_') {
      word += c;
    } else if (!word.empty()) {
      result.insert(std::exchange(word, ""));
    }
  }
  return result;
}

// The texts decide: a line lists exactly those values, parameters and functions whose names are words of its text.
TEST(SplitKernelProperty, FollowsTheNamesThatTheTextOfALineRefersTo) {
  for (unsigned seed = 0; seed < 300; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    const Kernel kernel = lower(test::RandomProgram(seed).make(), "leg");
    std::set<std::string> known(kernel.functions.begin(), kernel.functions.end());
    for (const KernelArray& p : kernel.parameters) known.insert(p.name);
    for (const Line& line : kernel.lines)
      for (const std::string& target : line.targets)
        if (target.find('[') == std::string::npos) known.insert(target);
    for (const Line& line : kernel.lines) {
      if (line.kind == Line::Kind::section) continue;
      std::set<std::string> in_text;
      for (const std::string& word : words(text(line)))
        if (known.count(word) > 0) in_text.insert(word);
      for (const std::string& target : line.targets) in_text.erase(target);
      if (line.kind == Line::Kind::sincos) in_text.erase("sincos");
      EXPECT_EQ(std::set(line.names.begin(), line.names.end()), in_text) << text(line);
    }
  }
}

TEST(SplitKernelProperty, ComputesWhatTheProgramComputes) {
  for (unsigned seed = 0; seed < 1000; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    test::RandomProgram source(seed);
    const Program program = source.make();
    symbolic::Arrays<double> inputs;
    test::KernelEvaluator::Values known;  // computed by the parts so far
    for (const symbolic::InputArray& array : program.inputs) {
      for (std::size_t k = 0; k < array.elements.size(); ++k) {
        inputs[array.name].push_back(source.value());
        known[array.name + "[" + std::to_string(k) + "]"] = inputs[array.name].back();
      }
    }
    const SplitKernel kernel = split(program, 1 + seed % 12);
    for (const Kernel& part : kernel.parts) {
      // Elements that the part stores are not given, so each is undefined before.
      test::KernelEvaluator::Values given;
      for (const KernelArray& p : part.parameters)
        for (const auto& [element, value] : known)
          if (element.rfind(p.name + "[", 0) == 0 && p.name != "kept") given.emplace(element, value);
      for (const Line& line : part.lines)
        if (line.kind == Line::Kind::binding) given.emplace(line.expression, known.at(line.expression));
      test::KernelEvaluator evaluator(given);
      for (const Line& line : part.lines) ASSERT_NO_THROW(evaluator.run(text(line))) << text(line);
      for (const auto& [element, value] : evaluator.values())
        if (element.find('[') != std::string::npos) known[element] = value;
    }
    for (const auto& [name, values] : symbolic::interpret(program, inputs)) {
      for (std::size_t k = 0; k < values.size(); ++k) {
        const double found = known.at(name + "[" + std::to_string(k) + "]");
        EXPECT_TRUE(found == values[k] || (std::isnan(found) && std::isnan(values[k]))) << name << k;
      }
    }
  }
}

// Kernels with lanes, and those that exceed the instruction cache, have short parts.
TEST(SplitKernel, HasPartsOfTheLengthsOfTheLanguage) {
  Kernel kernel;
  const auto parts_of = [&](std::size_t lines) {
    kernel.lines.assign(lines, {Line::Kind::section, {}, "one"});
    return is_long(kernel, dialect()) ? split_kernel(kernel, dialect()).parts.size() : 1;
  };
  EXPECT_EQ(parts_of(2000), 1U);
  EXPECT_EQ(parts_of(2100), 3U);   // of 700 lines
  EXPECT_EQ(parts_of(3200), 16U);  // of 200 lines
  kernel.widths = {4};
  EXPECT_EQ(parts_of(1000), 1U);
  EXPECT_EQ(parts_of(1200), 6U);
}

}  // namespace
}  // namespace robcogen::backend::cpp::split_kernel_test
