// Messages about a document's parameters, and the growth of the run time with their number.
#include <gtest/gtest.h>

#include "run_tool.h"

namespace robcogen::test::parameters_test {
namespace {

namespace fs = std::filesystem;

const char* const kArm = R"(Robot Arm {
RobotBase base { children { upper via shoulder } }
link upper { id = 1
    inertia_params { mass = 2.0 + density*len  CoM = (0.5 len, 0.0, 0.0)
      Ix=0.1 Iy=0.2 Iz=0.2 Ixy=0.0 Ixz=0.0 Iyz=0.0 }
    children {}
    frames { tip { translation = (len[0.4], 0.0, 0.0) rotation = (tilt[-0.1], 0.0, 0.0) } } }
r_joint shoulder { ref_frame { translation = (height, 0.0, 0.0) rotation = (PI/2.0, 0.0, 0.0) } }
}
)";

TEST(Parameters, AreListedWithTheirPlaces) {
  const Scratch scratch("list");
  const fs::path model = scratch.path / "arm.kindsl";
  write_text(model, kArm);
  const std::string expected = model.string() +
                               ":4:35: note: 4 parameters: name[default] line:column [parameters]\n"
                               "    mass and drive properties: density 4:35\n"
                               "    lengths, in mass properties too: len[0.4] 4:43\n"
                               "    angles: tilt[-0.1] 7:67\n"
                               "    lengths: height 8:47\n";
  const Outcome check = run_tool("check " + quoted(model));
  EXPECT_EQ(check.status, 0);
  EXPECT_EQ(check.errors, expected);
  const Outcome generate = run_tool("generate " + quoted(model) + " -o " + quoted(scratch.path / "o") + " --name arm");
  EXPECT_EQ(generate.status, 0);
  EXPECT_EQ(generate.errors, expected);
  EXPECT_EQ(run_tool("print " + quoted(model)).errors, "");
}

TEST(Parameters, OfMotionsAndTransformsAreListed) {
  const Scratch scratch("list-frames");
  for (const std::string text :
       {"Model M\nParams p { a, b }\nConvention = local\nA -> B : trx(a) rotz(b)\n",
        "Model M\nParams p { a, b }\nMovedFramePos = right\n{A}_X_{B} = Tx(a) Rz(b)\n"}) {
    const fs::path model = scratch.path / (text.find("Convention") == std::string::npos ? "m.ctdsl" : "m.motdsl");
    write_text(model, text);
    EXPECT_EQ(
        run_tool("check " + quoted(model)).errors,
        model.string() + ":2:12: note: 2 parameters: name[default] line:column [parameters]\n" +
            "    lengths: a 2:12\n    angles: b 2:15\n");
  }
}

TEST(Parameters, ThatMayBeAccidentsAreErrorsInAStrictReading) {
  const Scratch scratch("accidents");
  const fs::path model = scratch.path / "arm.kindsl", out = scratch.path / "o";
  std::string text = kArm;
  text.replace(text.find("height"), 6, "400mm");
  write_text(model, text);
  const std::string generate = " " + quoted(model) + " -o " + quoted(out) + " --name arm";
  const Outcome strict = run_tool("generate --strict" + generate), check = run_tool("check --strict " + quoted(model));
  EXPECT_EQ(strict.status, 1);
  EXPECT_FALSE(fs::exists(out));
  EXPECT_EQ(check.status, 1);
  for (const std::string& errors : {strict.errors, check.errors})
    EXPECT_NE(errors.find(":8:50: error: 'mm' is a parameter here, not a unit [unit-as-name]"), std::string::npos)
        << errors;
  const Outcome lenient = run_tool("generate" + generate);
  EXPECT_EQ(lenient.status, 0);
  EXPECT_NE(lenient.errors.find("warning: 'mm' is a parameter"), std::string::npos) << lenient.errors;
}

int count(const std::string& text, const std::string& part) {
  int found = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++found;
  return found;
}

// `len` is a length that is also used in mass properties.
TEST(Parameters, OfBothInterfacesArePrintedOnce) {
  const Scratch scratch("shared");
  const fs::path model = scratch.path / "arm.kindsl", out = scratch.path / "o";
  write_text(model, kArm);
  const Outcome run = run_tool(
      "generate " + quoted(model) + " -o " + quoted(out) + " --name arm --effort 0 --language cpp matlab maxima");
  ASSERT_EQ(run.status, 0) << run.errors;
  const std::string matlab = read_text(out / "matlab" / "+arm" / "parameters.m");
  EXPECT_EQ(count(matlab, "parameters.len"), 1) << matlab;
  EXPECT_EQ(count(matlab, "parameters.len = 0.4;"), 1) << matlab;
  const std::string maxima = read_text(out / "maxima" / "arm.mac");
  const std::string list = maxima.substr(maxima.find("arm_parameters() :="));
  EXPECT_EQ(count(list.substr(0, list.find('$')), "0.4"), 1) << list;
  const std::string header = read_text(out / "arm" / "parameters.h");
  EXPECT_EQ(count(header, "virtual double get_len() const noexcept = 0;"), 2) << header;
  EXPECT_EQ(count(header, "double len = 0.4;"), 1) << header;
  EXPECT_EQ(count(header, "\"len\""), 1) << header;
}

// Five joints in which each number is a sum of `terms` parameters, 80 parameters for each term.
std::string arm_of(int terms) {
  int count = 0;
  const auto sum = [&](const std::string& value) {
    std::string text;
    for (int i = 0; i < terms; ++i)
      text += (i == 0 ? "p" : " + p") + std::to_string(++count) + "[" + (i == 0 ? value : "0.0") + "]";
    return text;
  };
  const auto vector = [&](const char* x, const char* y, const char* z) {
    const std::string a = sum(x), b = sum(y), c = sum(z);
    return "(" + a + ", " + b + ", " + c + ")";
  };
  std::string text = "Robot Arm { RobotBase base { children { l1 via j1 } }\n";
  for (int i = 1; i <= 5; ++i) {
    const std::string n = std::to_string(i), next = std::to_string(i + 1);
    text += "link l" + n + " { id = " + n + " inertia_params { mass = " + sum("1.0");
    text += " CoM = " + vector("0.01", "0.02", "0.03") + " Ix = " + sum("0.1") + " Iy = " + sum("0.11");
    text += " Iz = " + sum("0.12") + " Ixy = " + sum("0.001") + " Ixz = " + sum("0.002") + " Iyz = " + sum("0.003");
    text += " } children { " + (i < 5 ? "l" + next + " via j" + next : "") + " } }\n";
    text += "r_joint j" + n + " { ref_frame { translation = " + vector("0.1", "0.2", "0.3");
    text += " rotation = " + vector("0.1", "0.2", "0.3") + " } }\n";
  }
  return text + "}\n";
}

// The amount of printed text measures the work, because each statement is printed.
TEST(Parameters, CostTimeInProportionToTheirNumber) {
  const Scratch scratch("many");
  const auto bytes_of = [&](int terms) {
    const fs::path model = scratch.path / "arm.kindsl", out = scratch.path / std::to_string(terms);
    write_text(model, arm_of(terms));
    // Limits the address space, most of which is for threads; even 960 parameters need only a tenth of it. A generator
    // with sanitizers maps far more.
    const std::string command = "generate " + quoted(model) + " -o " + quoted(out) + " --name arm --batch --effort 0";
    Outcome run = run_tool(command, "", "ulimit -v 400000;");
    if (run.errors.find("Sanitizer failed to allocate") != std::string::npos) run = run_tool(command);
    EXPECT_EQ(run.status, 0) << run.errors;
    std::uintmax_t bytes = 0;
    for (const auto& entry : fs::recursive_directory_iterator(out))
      if (entry.is_regular_file()) bytes += entry.file_size();
    return static_cast<double>(bytes);
  };
  const double once = bytes_of(1), twice = bytes_of(2), twelvefold = bytes_of(12);
  EXPECT_GT(twice, once);
  // The cost of a parameter is constant; longer numbers in names and indices increase it slightly.
  EXPECT_LT(twelvefold - once, 11 * 1.25 * (twice - once));
}

}  // namespace
}  // namespace robcogen::test::parameters_test
