// Programs of random robots as text. P10: literals read back as the same numbers. P11: the text is the same in every
// run and in every locale. P13: the operations that are counted are those of the C++ text.
#include <gtest/gtest.h>

#include <bit>
#include <cctype>
#include <charconv>
#include <clocale>
#include <locale>
#include <set>

#include "../unit/backend/kernel_evaluator.h"
#include "backend/cpp/lower.h"
#include "interpreted_robot.h"
#include "random_robot.h"
#include "symbolic/cost.h"
#include "symbolic/text.h"
#include "symbolic/verify.h"
#include "volume.h"

namespace robcogen::numeric::text_test {
namespace {

using model::KinematicTree;
using symbolic::Program;

constexpr std::uint64_t kFirstSeed = 50000;

int robots() {
  return volume("ROBCOGEN_TEST_ROBOTS", 12);
}

std::map<std::string, Program> programs_of(std::uint64_t seed, const std::vector<std::string>& passes = pass::names()) {
  const KinematicTree robot = random_robot(seed, {.max_joints = 12});
  return InterpretedRobot(robot, random_desired(seed, robot), passes).programs();
}

std::string cpp_text(const Program& program) {
  std::string text;
  for (const backend::cpp::Line& line : backend::cpp::lower(program, program.name).lines)
    text += backend::cpp::text(line) + "\n";
  return text;
}

bool same_bits(double a, double b) {
  return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b);
}

TEST(Text, LiteralsReadBackAsTheSameNumber) {
  for (int i = 0; i < robots(); ++i) {
    const std::uint64_t seed = kFirstSeed + static_cast<std::uint64_t>(i);
    for (const auto& [name, program] : programs_of(seed)) {
      for (const symbolic::Constant& constant : program.constants) {
        const std::string text = print_double(constant.value());
        double value = 0;
        const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
        ASSERT_TRUE(error == std::errc() && end == text.data() + text.size()) << text;
        ASSERT_TRUE(same_bits(value, constant.value())) << "seed " << seed << " " << name << " " << text;
      }
    }
  }
}

TEST(Text, ProgramsReadBackAsTheyWere) {
  for (int i = 0; i < robots(); ++i) {
    const std::uint64_t seed = kFirstSeed + static_cast<std::uint64_t>(i);
    for (const auto& [name, program] : programs_of(seed)) {
      ASSERT_EQ(symbolic::verify(program), "") << "seed " << seed << " " << name;
      std::string error;
      const std::string text = symbolic::print(program);
      const std::optional<Program> again = symbolic::parse(text, error);
      ASSERT_TRUE(again) << "seed " << seed << " " << name << " " << error;
      ASSERT_EQ(symbolic::print(*again), text) << "seed " << seed << " " << name;
    }
  }
}

// A locale with a decimal comma and points between thousands, for streams and, if the system has such a locale, for the
// C library.
class GermanNumbers {
 public:
  GermanNumbers() : c_(std::setlocale(LC_ALL, nullptr)), cpp_(std::locale::global({std::locale(), new Comma})) {
    std::setlocale(LC_NUMERIC, "de_DE.UTF-8");
  }
  ~GermanNumbers() {
    std::locale::global(cpp_);
    std::setlocale(LC_ALL, c_.c_str());
  }
  GermanNumbers(const GermanNumbers&) = delete;
  GermanNumbers& operator=(const GermanNumbers&) = delete;

 private:
  struct Comma : std::numpunct<char> {
    char do_decimal_point() const override { return ','; }
    char do_thousands_sep() const override { return '.'; }
    std::string do_grouping() const override { return "\3"; }
  };
  std::string c_;
  std::locale cpp_;
};

TEST(Text, IsTheSameAtEveryRunAndInEveryLocale) {
  for (std::uint64_t seed = kFirstSeed; seed < kFirstSeed + 20; ++seed) {
    const std::map<std::string, Program> first = programs_of(seed);
    std::map<std::string, std::string> texts;
    for (const auto& [name, program] : first) texts[name] = symbolic::print(program) + cpp_text(program);
    const GermanNumbers locale;
    for (const auto& [name, program] : programs_of(seed))
      EXPECT_EQ(symbolic::print(program) + cpp_text(program), texts.at(name)) << "seed " << seed << " " << name;
  }
}

bool branches(const std::string& line) {
  const std::set<std::string> keywords{"?", "if", "for", "while", "switch", "goto"};
  std::string word;
  for (const char c : line + " ") {
    if (std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_') {
      word += c;
    } else {
      if (keywords.contains(word) || keywords.contains(std::string(1, c))) return true;
      word.clear();
    }
  }
  return false;
}

TEST(Text, BranchesAreSeen) {
  EXPECT_TRUE(branches("if (q[0] < 0) x = 1;"));
  EXPECT_TRUE(branches("const Scalar x = q[0] < 0 ? a : b;"));
  EXPECT_FALSE(branches("const Scalar iffy = for_ce * q[0];"));
}

// The C++ text, run by a separate evaluator, gives the results of the interpreter to the last bit, with the operations
// that are reported and without a branch.
TEST(Text, OfKernelsComputesAndCountsAsTheProgram) {
  for (int i = 0; i < robots(); ++i) {
    const std::uint64_t seed = kFirstSeed + static_cast<std::uint64_t>(i);
    for (const auto& [name, program] : programs_of(seed)) {
      SCOPED_TRACE("seed " + std::to_string(seed) + " " + name);
      symbolic::Arrays<double> inputs;
      test::KernelEvaluator::Values elements;
      std::mt19937_64 engine(seed);
      for (const symbolic::InputArray& array : program.inputs) {
        for (std::size_t k = 0; k < array.elements.size(); ++k) {
          inputs[array.name].push_back(reference::uniform(engine, 2));
          elements[array.name + "[" + std::to_string(k) + "]"] = inputs[array.name].back();
        }
      }
      test::KernelEvaluator evaluator(elements);
      for (const backend::cpp::Line& line : backend::cpp::lower(program, name).lines) {
        const std::string text = backend::cpp::text(line);
        ASSERT_NO_THROW(evaluator.run(text)) << text;
        if (line.kind != backend::cpp::Line::Kind::section) {
          ASSERT_FALSE(branches(text)) << text;
        }
      }
      for (const auto& [array, values] : symbolic::interpret(program, inputs)) {
        for (std::size_t k = 0; k < values.size(); ++k) {
          const auto found = evaluator.values().find(array + "[" + std::to_string(k) + "]");
          ASSERT_NE(found, evaluator.values().end()) << array << " " << k;
          ASSERT_EQ(found->second, values[k]) << array << " " << k;
        }
      }
      const symbolic::Cost reported = symbolic::cost(program), &found = evaluator.count();
      EXPECT_EQ(found.mul, reported.mul);
      EXPECT_EQ(found.add, reported.add);
      EXPECT_EQ(found.div, reported.div);
      EXPECT_EQ(found.sqrt, reported.sqrt);
      EXPECT_EQ(found.sincos, reported.sincos);
    }
  }
}

}  // namespace
}  // namespace robcogen::numeric::text_test
