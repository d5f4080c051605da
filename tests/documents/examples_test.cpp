// The examples of the guides compile.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <sstream>

#include "markdown.h"

namespace robcogen::test::examples_test {
namespace {

namespace fs = std::filesystem;

// Returns a program with a function for each section. The other functions repeat the declarations of the first section;
// templates and includes come before all functions.
std::string program(const std::vector<CodeBlock>& blocks) {
  std::string includes, templates, functions, first, section, body;
  int count = 0;
  const auto finish = [&] {
    if (body.empty()) return;
    functions += "void section_" + std::to_string(++count) + "() {\n" + first + "{\n" + body + "}\n}\n";
    if (first.empty()) first = body;
    body.clear();
  };
  for (const CodeBlock& block : blocks) {
    if (block.language != "cpp") continue;
    if (block.section != section) finish();
    section = block.section;
    std::istringstream lines(block.text);
    std::string& rest = block.text.find("template <") == std::string::npos ? body : templates;
    for (std::string line; std::getline(lines, line);) (line.starts_with("#include") ? includes : rest) += line + "\n";
  }
  finish();
  return includes + templates + functions;
}

const std::string robots = ROBCOGEN_SOURCE_DIR "/robots/";

// Generates code into a new folder.
void generate(const fs::path& folder, const std::string& arguments) {
  int status = 0;
  const std::string output =
      output_of("'" ROBCOGEN_TOOL "' generate -o '" + folder.string() + "' " + arguments, status);
  ASSERT_EQ(status, 0) << output;
}

void expect_to_compile(const fs::path& folder, const std::string& text, const std::string& options = "") {
  std::ofstream(folder / "examples.cpp") << text;
  int status = 0;
  const std::string output = output_of(
      "'" ROBCOGEN_CXX "' -std=c++20 -fsyntax-only -I '" + folder.string() +
          "' -I '" ROBCOGEN_SOURCE_DIR "/runtime/include' -isystem '" ROBCOGEN_EIGEN "' " + options + " '" +
          (folder / "examples.cpp").string() + "'",
      status);
  EXPECT_EQ(status, 0) << output;
}

#if ROBCOGEN_TEST_EVERYTHING
TEST(Examples, OfTheGeneratedCodeCompile) {
  const fs::path folder = scratch("examples");
  fs::remove_all(folder);
  fs::create_directories(folder);
  for (const CodeBlock& block : code_blocks(read_text(source_folder() / "tool/language/README.md")))
    if (block.language == "motdsl") std::ofstream(folder / "crane.motdsl") << block.text;
  for (const std::string& arguments :
       {robots + "hyl/hyl.kindsl --name hyl --batch --algorithms all --contacts fr_foot --desired " + robots +
            "hyl/hyl.dtdsl",
        robots + "hyl_parametric/hyl_parametric.kindsl --name hyl_parametric",
        robots + "quadruped/quadruped.kindsl --name quadruped --algorithms all --desired " + robots +
            "quadruped/quadruped.dtdsl",
        robots + "hyl/hyl.kindsl --name arm --algorithms inverse_dynamics --parameters fr_foot.inertia",
        robots + "ball_leg/ball_leg.kindsl --name ball_leg", (folder / "crane.motdsl").string() + " --name crane"})
    generate(folder, arguments);
  std::vector<CodeBlock> blocks = code_blocks(read_text(source_folder() / "runtime/README.md"));
  for (const char* page : {"NOTATION.md", "WORLD.md", "CONTACTS.md", "JOINTS.md", "BATCH.md"})
    for (CodeBlock block : code_blocks(read_text(source_folder() / "runtime" / page))) {
      block.section = page;  // its examples build on each other
      blocks.push_back(block);
    }
  const std::string text = program(blocks);
  expect_to_compile(folder, text);
  // The calls on the front page. Its listing is part of a function, and another test compares it.
  std::string front =
      "#include <hyl/hyl.h>\nvoid calls(hyl::JointState q, hyl::JointState qd, hyl::JointState qdd) {\n";
  for (const CodeBlock& block : code_blocks(read_text(source_folder() / "README.md")))
    if (block.language == "cpp" && block.text.find("hyl::") != std::string::npos) front += block.text;
  EXPECT_NE(front.find("hyl::forward_dynamics"), std::string::npos) << front;
  expect_to_compile(folder, front + "}\n");
  EXPECT_NE(text.find("section_9"), std::string::npos) << "too few sections have examples";
  if (!testing::Test::HasFailure()) fs::remove_all(folder);
}
#endif

TEST(Examples, OfDerivativesCompile) {
  const fs::path folder = scratch("derivatives_examples");
  fs::remove_all(folder);
  generate(
      folder, robots +
                  "hyl_parametric/hyl_parametric.kindsl --name leg --effort 0 --algorithms inverse_dynamics "
                  "--derivatives inverse_dynamics:q,parameters --gradients forward_dynamics:q,qd,tau --tangents "
                  "inverse_dynamics:q,qd forward_dynamics_gradient_q_qd_tau:q");
  std::string text =
      "#include <leg/leg.h>\nvoid calls(const leg::Parameters<double>& parameters, leg::JointState q) {\n"
      "const leg::JointState qd = q, qdd = q, tau = q, weights = q, q_tangent = q, qd_tangent = q;\n";
  for (const CodeBlock& block : code_blocks(read_text(source_folder() / "cmake/README.md")))
    if (block.language == "cpp" && block.section == "Derivatives")
      text += block.text + "static_cast<void>(d.tau), d.d_q, d.d_parameters;\n";
  text += "static_cast<void>(g.qdd), g.d_q, g.d_qd, g.d_tau, t.tau, t.tau_tangent;\n";
  EXPECT_NE(text.find("d.tau"), std::string::npos) << text;
  expect_to_compile(folder, text + "}\n", "-Wno-unused-value");
  if (!testing::Test::HasFailure()) fs::remove_all(folder);
}

TEST(Examples, OfFusedFunctionsCompile) {
  const fs::path folder = scratch("fused_examples");
  fs::remove_all(folder);
  generate(
      folder, robots +
                  "hyl/hyl.kindsl --name leg --effort 0 --algorithms jacobian_derivatives --frames fr_foot --function "
                  "'control = joint_space_inertia + bias_forces + jacobians.fr_base_J_fr_foot + "
                  "jacobians.fr_base_Jd_qd_fr_foot'");
  std::string text = "#include <leg/leg.h>\nvoid calls(leg::JointState q, leg::JointState qd) {\n";
  for (const CodeBlock& block : code_blocks(read_text(source_folder() / "cmake/README.md")))
    if (block.language == "cpp" && block.section == "Fused functions") text += block.text;
  expect_to_compile(
      folder, text + "static_cast<void>(r.joint_space_inertia), r.fr_base_Jd_qd_fr_foot;\n}\n", "-Wno-unused-value");
  if (!testing::Test::HasFailure()) fs::remove_all(folder);
}

TEST(Examples, OfDesignStudiesCompile) {
  const fs::path folder = scratch("design_examples");
  fs::remove_all(folder);
  const std::string design = robots + "design/", name = design + "quadruped_parametric";
  generate(
      folder, name + ".kindsl --name quadruped_parametric --effort 0 --desired " + name +
                  ".dtdsl --algorithms forward_dynamics transforms contacts");
  const std::string text = program(code_blocks(read_text(source_folder() / "robots/design/README.md")));
  // The functions contain namespace aliases, too.
  expect_to_compile(folder, text, "-I '" + design + "'");
  EXPECT_NE(text.find("section_4"), std::string::npos) << "too few sections have examples";
  if (!testing::Test::HasFailure()) fs::remove_all(folder);
}

}  // namespace
}  // namespace robcogen::test::examples_test
