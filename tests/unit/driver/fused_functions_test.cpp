// Functions that are fused of others: which a robot can have, and what they compute.
#include "driver/fused_functions.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <string>
#include <vector>

#include "algorithm/catalogue/fused.h"
#include "documents.h"
#include "driver/driver.h"
#include "driver/find_function.h"
#include "symbolic/cost.h"
#include "symbolic/interpret.h"

namespace robcogen::driver::fused_functions_test {
namespace {

using namespace test;

fs::path robot_file(const std::string& robot, const char* extension = ".kindsl") {
  return fs::path(ROBCOGEN_ROBOTS_DIR) / robot / (robot + extension);
}

Model loaded_with(const std::string& robot, const std::string& function, std::vector<std::string> contacts = {}) {
  return loaded(robot_file(robot), {.contacts = std::move(contacts), .functions = {function}});
}

// The messages of the rods with these functions, without the line that the last one stands in.
std::string messages(const std::vector<std::string>& functions, const std::vector<std::string>& groups = {}) {
  const Folder folder;
  Diagnostics diagnostics;
  load(folder.file("rods.kindsl", kRods), {.groups = groups, .functions = functions}, diagnostics);
  return diagnostics.render();
}

void expect_message(const std::string& function, const std::string& text) {
  const std::string all = messages({function});
  EXPECT_NE(all.find(text), std::string::npos) << "wanted: " << text << "\nfound: " << all;
}

TEST(FusedFunctions, RefusePartsThatTheRobotLacks) {
  expect_message(
      "control = joint_space_inertia + bias_force",
      "--function:1:33: error: robot 'Rods' has no function 'bias_force' [unknown-function]");
  expect_message("control = joint_space_inertia + bias_force", "hint: did you mean 'bias_forces'?");
  expect_message(
      "c = bias_forces + jacobians.base_J_lowr", "error: robot 'Rods' has no function 'jacobians.base_J_lowr'");
  expect_message(
      "c = bias_forces + contact_jacobian",
      "--function:1:19: error: 'contact_jacobian' cannot be a part of 'c': no contact frames are named "
      "[unavailable-part]");
  expect_message(
      "c = bias_forces + inertia_factor.solve",
      "--function:1:19: error: 'inertia_factor.solve' is a function of an inertia factor, which is an object "
      "[factor-part]");
  expect_message(
      "c = bias_forces + energy_of_all d = c + bias_forces",
      "error: 'c' cannot be a part of 'd': it is a fused function");
}

TEST(FusedFunctions, GiveTheReasonWhyAGroupIsMissing) {
  const Folder folder;
  Diagnostics diagnostics;
  const std::string massless =
      "Robot M {\nRobotBase base { children { arm via shoulder } }\nlink arm { id = 1 children {} }\n"
      "r_joint shoulder { ref_frame { translation = (0,0,0) rotation = (0,0,0) } }\n}\n";
  load(
      folder.file("m.kindsl", massless), {.functions = {"c = bias_forces + transforms.homogeneous.base_X_arm"}},
      diagnostics);
  EXPECT_NE(
      diagnostics.render().find(
          "'bias_forces' cannot be a part of 'c': no link that moves has mass properties [unavailable-part]"),
      std::string::npos)
      << diagnostics.render();
}

TEST(FusedFunctions, RefuseNamesThatAreTaken) {
  const char* const kHint = "hint: give the fused function another name";
  expect_message(
      "bias_forces = joint_space_inertia + gravity_forces",
      "--function:1:1: error: robot 'Rods' has 'bias_forces' already [name-taken]");
  expect_message("biasForces = joint_space_inertia + gravity_forces", "robot 'Rods' has 'bias_forces' already");
  expect_message(
      "bias_forces_gravity = joint_space_inertia + gravity_forces", "robot 'Rods' has 'bias_forces' already");
  for (const char* name :
       {"jacobians", "world", "double", "robot", "gravity", "joint_state", "kDof", "f32", "link", "kernel_energy",
        "batch_energy", "in_lanes_energy"}) {
    const std::string all = messages({std::string(name) + " = joint_space_inertia + gravity_forces"});
    EXPECT_NE(all.find("[name-taken]"), std::string::npos) << name << ": " << all;
    EXPECT_NE(all.find(kHint), std::string::npos) << name << ": " << all;
  }
}

TEST(FusedFunctions, RefuseRepetitionsAndSingleParts) {
  const std::string twice =
      messages({"control = joint_space_inertia + bias_forces", "control = bias_forces + gravity_forces"});
  EXPECT_NE(
      twice.find("--function:1:1: error: function 'control' is defined twice [duplicate-function]"), std::string::npos)
      << twice;
  EXPECT_NE(twice.find("note: first defined here"), std::string::npos) << twice;
  expect_message(
      "c = bias_forces + bias_forces", "--function:1:19: error: 'bias_forces' is given twice [duplicate-part]");
  expect_message("c = bias_forces", "--function:1:1: error: 'c' has the results of one function only [single-part]");
}

TEST(FusedFunctions, RefuseTextThatIsNoDefinition) {
  expect_message(
      "joint_space_inertia + bias_forces", "--function:1:21: error: expected '=' after 'joint_space_inertia'");
  expect_message(
      "c = bias_forces +",
      "--function:1:18: error: the file ends where the name of a function is expected [unexpected-end]");
  expect_message("c = bias_forces + 3", "--function:1:19: error: expected the name of a function, found number '3'");
  expect_message("c = jacobians. + bias_forces", "--function:1:14: error: unexpected character '.' [stray-character]");
}

// Both errors of a text are reported.
TEST(FusedFunctions, AreReadBeyondAnError) {
  const std::string all = messages({"c bias_forces d = bias_forces + nothing"});
  EXPECT_NE(all.find("expected '=' after 'c'"), std::string::npos) << all;
  EXPECT_EQ(all.find("[unknown-function]"), std::string::npos) << "robots are not searched after an error of syntax";
}

TEST(FusedFunctions, AreNeededByTheirGroup) {
  const std::string all = messages({}, {algorithm::kFusedGroup});
  EXPECT_NE(all.find("error: 'fused' of robot 'Rods' needs functions to fuse [no-functions]"), std::string::npos)
      << all;
}

// In a list, places are those of the document.
TEST(FusedFunctions, OfAListHavePlaces) {
  const Folder folder;
  Diagnostics diagnostics;
  const fs::path list = folder.file(
      "rods.dtdsl",
      "Robot Rods\nFrames { }\nTransforms { }\nFunctions {\n  control = joint_space_inertia\n          + "
      "bias_force\n}\n");
  load(folder.file("rods.kindsl", kRods), {.desired = list}, diagnostics);
  EXPECT_NE(
      diagnostics.render().find("rods.dtdsl:6:13: error: robot 'Rods' has no function 'bias_force' [unknown-function]"),
      std::string::npos)
      << diagnostics.render();
}

TEST(FusedFunctions, HaveTheOverloadsOfTheirParts) {
  const Model model = loaded_with("hyl", "control = joint_space_inertia + gravity_forces + bias_forces");
  const std::vector<algorithm::Declared> list = find_functions(*model.robot(), "control");
  ASSERT_EQ(list.size(), 3U);
  EXPECT_EQ(list[0].kernel, "control");
  EXPECT_EQ(list[1].kernel, "control_gravity");
  EXPECT_EQ(list[2].kernel, "control_external");
  std::vector<std::string> inputs, outputs;
  const symbolic::Program outline = algorithm::outline(list[2]);
  for (const symbolic::InputArray& array : outline.inputs) inputs.push_back(array.name);
  for (const symbolic::OutputArray& array : outline.outputs) outputs.push_back(array.name);
  EXPECT_EQ(inputs, (std::vector<std::string>{"q", "qd", "gravity", "external"}));
  EXPECT_EQ(outputs, (std::vector<std::string>{"joint_space_inertia", "gravity_forces", "bias_forces"}));
}

// Results of parts with several have two names, and parts of one name are told apart by their scopes.
TEST(FusedFunctions, NameTheirResults) {
  const Model model = loaded_with(
      "quadruped",
      "control = bias_forces + center_of_mass + world.center_of_mass + world.J_fr_LF_foot + "
      "joint_space_inertia_factor");
  std::vector<std::string> outputs;
  for (const symbolic::OutputArray& a : algorithm::outline(find_functions(*model.robot(), "control").front()).outputs)
    outputs.push_back(a.name);
  EXPECT_EQ(
      outputs, (std::vector<std::string>{
                   "bias_forces_tau", "bias_forces_base_wrench", "center_of_mass", "in_world_center_of_mass",
                   "J_fr_LF_foot", "joint_space_inertia_factor_L", "joint_space_inertia_factor_inverse_diagonal"}));
}

// Values of one array for all functions.
std::vector<double> values_of(const symbolic::InputArray& array) {
  std::vector<double> values;
  for (std::size_t k = 0; k < array.elements.size(); ++k)
    values.push_back(0.1 + 0.37 * std::sin(static_cast<double>(3 * k + 7 * array.name.size())));
  for (const int first : array.quaternions) {
    double square = 0;
    for (int k = 0; k < 4; ++k) square += std::pow(values[static_cast<std::size_t>(first + k)], 2);
    for (int k = 0; k < 4; ++k) values[static_cast<std::size_t>(first + k)] /= std::sqrt(square);
  }
  return values;
}

std::vector<std::vector<double>> results_of(const symbolic::Program& program) {
  symbolic::Arrays<double> inputs;
  for (const symbolic::InputArray& array : program.inputs) inputs[array.name] = values_of(array);
  const symbolic::Arrays<double> results = symbolic::interpret<double>(program, inputs);
  std::vector<std::vector<double>> list;
  for (const symbolic::OutputArray& array : program.outputs) list.push_back(results.at(array.name));
  return list;
}

const symbolic::Program& program_of(const Functions& functions, const std::string& kernel) {
  for (const Function& f : functions.list)
    if (f.kernel == kernel) return f.program;
  throw std::runtime_error("no " + kernel);
}

struct Whole {
  const char *robot, *function;
  int most_of_work;  // per cent of that of the parts
};

class FusedRobots : public testing::TestWithParam<Whole> {};

// All overloads, as they are generated, against the parts in the textbook formulation; and less work.
TEST_P(FusedRobots, HaveTheResultsOfTheirParts) {
  const Model model = loaded_with(GetParam().robot, std::string("control = ") + GetParam().function);
  const Functions plain = programs(model, algorithm::groups(), Steps{.names = {}});
  const Functions fused = programs(model, {algorithm::kFusedGroup}, Steps());
  ASSERT_FALSE(fused.list.empty());
  for (const Function& f : fused.list) {
    const std::vector<std::vector<double>> found = results_of(f.program);
    std::size_t place = 0;
    int work = 0;
    for (const algorithm::Declared& part : f.declared->parts) {
      const symbolic::Program& own = program_of(plain, part.kernel);
      work += symbolic::work(own);
      for (const std::vector<double>& expected : results_of(own)) {
        ASSERT_EQ(found.at(place).size(), expected.size());
        for (std::size_t k = 0; k < expected.size(); ++k)
          EXPECT_NEAR(found[place][k], expected[k], 1e-9 * (1 + std::abs(expected[k])))
              << f.kernel << ' ' << f.program.outputs[place].name << '[' << k << ']';
        ++place;
      }
    }
    EXPECT_EQ(place, found.size());
    EXPECT_LT(100 * symbolic::work(f.program), GetParam().most_of_work * work) << f.kernel;
  }
}

INSTANTIATE_TEST_SUITE_P(
    ,
    FusedRobots,
    testing::Values(
        Whole{
            "hyl", "joint_space_inertia + bias_forces + jacobians.fr_base_J_fr_foot + jacobians.fr_base_Jd_qd_fr_foot",
            80},
        Whole{"hyl_parametric", "joint_space_inertia + forward_dynamics + center_of_mass", 90},
        Whole{"scara", "inverse_dynamics + all_frames + kinetic_energy", 90},
        Whole{"ball_leg", "bias_forces + joint_space_inertia + center_of_mass + world.bias_toe + world.J_toe", 90},
        Whole{"five_bar", "bias_forces + joint_positions + jacobians.fr_base_Jd_qd_tool", 90},
        Whole{
            "quadruped",
            "joint_space_inertia + bias_forces + world.center_of_mass + world.centroidal_momentum + "
            "world.J_fr_LF_foot + world.bias_fr_LF_foot + world.in_target.bias_fr_RF_foot + "
            "jacobians.with_base.fr_trunk_bias_fr_LH_foot + center_of_mass_jacobian + centroidal_momentum_bias",
            80}),
    [](const auto& test) { return std::string(test.param.robot); });

TEST(AllFrames, AreThePosesOfFrames) {
  const Model model = loaded(robot_file("hyl"), {.frames = {"*"}});
  const Functions functions = programs(model, {"all_frames", "transforms"}, Steps());
  const symbolic::Program& all = program_of(functions, "all_frames");
  const std::vector<std::vector<double>> found = results_of(all);
  ASSERT_EQ(all.outputs.size(), 6U);
  for (std::size_t k = 0; k < found.size(); ++k) {
    const std::vector<double> expected =
        results_of(program_of(functions, "homogeneous_" + all.outputs[k].name)).front();
    for (std::size_t i = 0; i < expected.size(); ++i)
      EXPECT_NEAR(found[k][i], expected[i], 1e-12) << all.outputs[k].name;
  }
}

}  // namespace
}  // namespace robcogen::driver::fused_functions_test
