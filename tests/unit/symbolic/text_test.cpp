// Programs as text: printed programs read back, and invalid text is refused at the place of the error.
#include "symbolic/text.h"

#include <gtest/gtest.h>

#include "programs.h"
#include "symbolic/verify.h"

namespace robcogen::symbolic::text_test {
namespace {

const std::string kEverything =
    "program inverse_dynamics\n"
    "input q joint_position SLIDE HFE\n"
    "input gravity gravity x y z\n"
    "output tau joint_force 2 1\n"
    "output X homogeneous 1 2\n"
    "output J jacobian 6 0\n"
    "section hip link hip: velocity, and more\n"
    "section knee \n"
    "in 1\n"
    "let knee_s = sin q[1]\n"
    "in 0\n"
    "tmp hip_t0 = -q[0] * 0.35\n"
    "tmp hip_t1 = hip_t0 + pi:2:3\n"
    "tmp hip_t2 = gravity[2] / -hip_t1\n"
    "in 1\n"
    "tmp knee_t0 = sqrt -hip_t2\n"
    "tmp knee_t1 = cos knee_t0\n"
    "tmp knee_t2 = 1e-09 - knee_t1\n"
    "return tau knee_t2 -knee_s\n"
    "return X q[0] -0.5\n"
    "return J\n";

TEST(ProgramText, PrintsWhatItRead) {
  EXPECT_EQ(print(test::program(kEverything)), kEverything);
}

TEST(ProgramText, MeansWhatItSays) {
  const Program p = test::program(kEverything);
  EXPECT_EQ(p.name, "inverse_dynamics");
  EXPECT_EQ(p.input_count(), 5);
  EXPECT_EQ(p.inputs[1].role, Role::gravity);
  EXPECT_EQ(p.inputs[1].elements, (std::vector<std::string>{"x", "y", "z"}));
  EXPECT_EQ(p.outputs[0].role, Role::joint_force);
  EXPECT_EQ(p.outputs[2].rows, 6);
  EXPECT_EQ(p.outputs[2].columns, 0);
  EXPECT_EQ(p.sections[0].title, "link hip: velocity, and more");
  EXPECT_EQ(p.sections[1].title, "");
  ASSERT_EQ(p.statements.size(), 7u);
  EXPECT_TRUE(p.statements[0].named);
  EXPECT_EQ(p.statements[0].section, 1);
  EXPECT_FALSE(p.statements[1].named);
  EXPECT_EQ(p.statements[1].a, (Operand{Operand::Kind::input, 0, true}));
  EXPECT_EQ(p.statements[3].a, (Operand{Operand::Kind::input, 4, false}));
  EXPECT_EQ(p.statements[3].b, (Operand{Operand::Kind::statement, 2, true}));
  EXPECT_EQ(p.statements[6].op, Op::subtract);
  EXPECT_EQ(p.constants[1], Number::pi_multiple(2, 3));
}

TEST(ProgramText, BlankLinesAndBlanksDoNotMatter) {
  std::string airy;
  for (char c : kEverything) airy += c == '\n' ? "\n \n  " : std::string(1, c);
  airy.replace(airy.find(" = sin "), 7, "  =   sin     ");
  EXPECT_EQ(print(test::program(airy)), kEverything);
}

TEST(ProgramText, RandomProgramsReadBack) {
  for (unsigned seed = 0; seed < 500; ++seed) {
    test::RandomPrograms random(seed);
    const Program p = random.make();
    const std::string text = print(p);
    std::string error;
    const std::optional<Program> back = parse(text, error);
    ASSERT_TRUE(back) << "seed " << seed << ": " << error << "\n" << text;
    EXPECT_EQ(print(*back), text) << "seed " << seed;
    EXPECT_EQ(test::difference(p, *back, random.inputs()), "") << "seed " << seed;
  }
}

TEST(ProgramText, EveryRoleReadsBack) {
  const int last = static_cast<int>(Role::value);
  for (int k = 0; k <= last; ++k) {
    Program p;
    p.name = "roles";
    p.inputs.push_back({"in", static_cast<Role>(k), {"x"}});
    EXPECT_EQ(test::program(print(p)).inputs[0].role, static_cast<Role>(k)) << k;
  }
}

struct Refused {
  std::string text;
  std::string error;
  friend std::ostream& operator<<(std::ostream& out, const Refused& refused) { return out << refused.error; }
};

class RefusedText : public testing::TestWithParam<Refused> {};

TEST_P(RefusedText, SaysWhereAndWhy) {
  std::string error;
  EXPECT_FALSE(parse(GetParam().text, error)) << GetParam().text;
  EXPECT_EQ(error, GetParam().error) << GetParam().text;
}

const std::string kHead = test::head();

INSTANTIATE_TEST_SUITE_P(
    ,
    RefusedText,
    testing::Values(
        Refused{"", "the program has no valid name"},
        Refused{"program\n", "line 1: a program needs a name"},
        Refused{"program 1st\n", "the program has no valid name"},
        Refused{"program p extra\n", "line 1: 'extra' is too much"},
        Refused{"program p\nprogramme q\n", "line 2: 'programme' is not a statement"},
        Refused{"program p\ninput q\n", "line 2: an input needs a name and a role"},
        Refused{"program p\ninput q altitude\n", "line 2: an input needs a name and a role"},
        Refused{"program p\noutput tau value 2\n", "line 2: an output needs a name, a role, rows and columns"},
        Refused{"program p\noutput tau value 2 1 1\n", "line 2: '1' is too much"},
        Refused{"program p\nsection\n", "line 2: a section needs a prefix"},
        Refused{"program p\nin x\n", "line 2: 'in' needs the number of a section"},
        Refused{"program p\nin 99999999999\n", "line 2: 'in' needs the number of a section"},
        Refused{kHead + "in 0 1\n", "line 6: '1' is too much"},
        Refused{kHead + "let x q[0]\n", "line 6: expected `name = …`"},
        Refused{kHead + "let x = a[0]\n", "line 6: expected `a op b`"},
        Refused{kHead + "let x = a[0] % a[1]\n", "line 6: '%' is not an operation"},
        Refused{kHead + "let x = a[0] + a[1] a[2]\n", "line 6: 'a[2]' is too much"},
        Refused{kHead + "let x = sin\n", "line 6: the function needs an operand"},
        Refused{kHead + "let x = sin a[0] a[1]\n", "line 6: 'a[1]' is too much"},
        Refused{kHead + "let x = a[4] + 1\n", "line 6: 'a[4]' is not an element of an input"},
        Refused{kHead + "let x = a[-1] + 1\n", "line 6: 'a[-1]' is not an element of an input"},
        Refused{kHead + "let x = a[1x] + 1\n", "line 6: 'a[1x]' is not an element of an input"},
        Refused{kHead + "let x = a[] + 1\n", "line 6: 'a[]' is not an element of an input"},
        Refused{kHead + "let x = b[0] + 1\n", "line 6: 'b[0]' is not an element of an input"},
        Refused{kHead + "let x = ] + 1\n", "line 6: ']' is not an element of an input"},
        Refused{kHead + "let x = y + 1\n", "line 6: 'y' is neither a number nor assigned before"},
        Refused{kHead + "let x = x + 1\n", "line 6: 'x' is neither a number nor assigned before"},
        Refused{kHead + "let x = --a[0] + 1\n", "line 6: '-a[0]' is not an element of an input"},
        Refused{kHead + "let x = a[0] + --1\n", "line 6: '-1' is neither a number nor assigned before"},
        Refused{kHead + "let x = a[0] + nan\n", "line 6: 'nan' is neither a number nor assigned before"},
        Refused{kHead + "let x = a[0] + 1e999\n", "line 6: '1e999' is neither a number nor assigned before"},
        Refused{kHead + "let x = a[0] + 1,5\n", "line 6: '1,5' is neither a number nor assigned before"},
        Refused{kHead + "let x = a[0] + pi:1:0\n", "line 6: 'pi:1:0' is neither a number nor assigned before"},
        Refused{kHead + "let x = a[0] + pi:1\n", "line 6: 'pi:1' is neither a number nor assigned before"},
        Refused{kHead + "let x = a[0] + pi:1:2:3\n", "line 6: 'pi:1:2:3' is neither a number nor assigned before"},
        Refused{kHead + "let x = a[0] + pi:-1:2\n", "line 6: 'pi:-1:2' is neither a number nor assigned before"},
        Refused{kHead + "let x = a[0] + 1\nlet x = a[0] + 2\n", "line 7: 'x' is assigned twice"},
        Refused{kHead + "let a-b = a[0] + 1\n", "'a-b' is not a valid identifier"},
        Refused{kHead + "let sin = a[0] + 1\nreturn out sin\n", "'sin' is an operation"},
        Refused{kHead + "in 2\nlet x = a[0] + 1\nreturn out x\n", "statement 'x' is in no section"},
        Refused{kHead + "in -1\nlet x = a[0] + 1\nreturn out x\n", "statement 'x' is in no section"},
        Refused{kHead + "return aus a[0]\n", "line 6: 'aus' is not an output"},
        Refused{kHead + "return out x\n", "line 6: 'x' is neither a number nor assigned before"},
        Refused{kHead + "return out a[0] a[1]\n", "output 'out' has the wrong number of values"},
        Refused{kHead, "output 'out' has the wrong number of values"}));

TEST(ProgramText, ErrorIsEmptyAfterSuccess) {
  std::string error = "old";
  EXPECT_TRUE(parse(kEverything, error));
  EXPECT_EQ(error, "");
}

// A program that was not read from text can have faults that text cannot express.
class Verify : public testing::Test {
 protected:
  Program p = test::small_program("let x = a[0] + 0.5\nlet y = x * a[1]\nreturn out y\n");
};

TEST_F(Verify, ASoundProgramIsSound) {
  EXPECT_EQ(verify(p), "");
}

TEST_F(Verify, StatementsThatReadWhatComesLater) {
  p.statements[0].a = {Operand::Kind::statement, 1, false};
  EXPECT_EQ(verify(p), "statement 'x' reads an undefined value");
}

TEST_F(Verify, StatementsThatReadThemselves) {
  p.statements[1].b = {Operand::Kind::statement, 1, false};
  EXPECT_EQ(verify(p), "statement 'y' reads an undefined value");
}

TEST_F(Verify, InputsAndConstantsThatAreNotThere) {
  p.statements[0].a = {Operand::Kind::input, 4, false};
  EXPECT_EQ(verify(p), "statement 'x' reads an undefined value");
  p.statements[0].a = {Operand::Kind::input, -1, false};
  EXPECT_EQ(verify(p), "statement 'x' reads an undefined value");
  p.statements[0].a = {Operand::Kind::constant, 1, false};
  EXPECT_EQ(verify(p), "statement 'x' reads an undefined value");
}

TEST_F(Verify, TheSecondOperandOfAUnaryOperationIsNotLookedAt) {
  p.statements[1].op = Op::sine;
  p.statements[1].b = {Operand::Kind::statement, 99, false};
  EXPECT_EQ(verify(p), "");
}

TEST_F(Verify, OutputsThatReadWhatIsNotThere) {
  p.outputs[0].values[0] = {Operand::Kind::statement, 2, false};
  EXPECT_EQ(verify(p), "output 'out' reads an undefined value");
}

TEST_F(Verify, OutputsOfNegativeSize) {
  p.outputs[0].rows = -1;
  p.outputs[0].columns = -1;
  EXPECT_EQ(verify(p), "output 'out' has the wrong number of values");
}

TEST_F(Verify, NamesThatRepeat) {
  p.statements[1].name = "x";
  EXPECT_EQ(verify(p), "'x' is assigned twice");
}

TEST_F(Verify, ArraysThatShareAName) {
  p.inputs.push_back(p.inputs[0]);
  EXPECT_EQ(verify(p), "'a' names two arrays");
  p.inputs.pop_back();
  p.outputs.push_back(p.outputs[0]);
  EXPECT_EQ(verify(p), "'out' names two arrays");
}

TEST_F(Verify, ArraysWithoutAProperName) {
  p.inputs[0].name = "a b";
  EXPECT_EQ(verify(p), "'a b' is not a valid identifier");
}

TEST_F(Verify, ConstantsThatAreNegativeOrNotFinite) {
  for (double value : {-0.5, std::nan(""), HUGE_VAL}) {
    p.constants[0] = Number(value);
    EXPECT_EQ(verify(p), "a constant is negative or not a number") << value;
  }
}

}  // namespace
}  // namespace robcogen::symbolic::text_test
