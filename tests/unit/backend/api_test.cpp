#include "backend/cpp/api.h"

#include <gtest/gtest.h>

#include "programs.h"

namespace robcogen::backend::cpp::api_test {
namespace {

using Names = std::vector<std::string>;

// A function `name` with these inputs and outputs.
Function dynamics(const std::string& name, const std::string& kernel, const Names& inputs, const Names& outputs) {
  const std::map<std::string, std::string> roles = {
      {"parameters", "parameters"},
      {"q", "joint_position"},
      {"qd", "joint_velocity"},
      {"qdd", "joint_acceleration"},
      {"tau", "joint_force"},
      {"gravity", "gravity"},
      {"external", "link_wrenches"},
      {"base_velocity", "base_velocity"},
      {"base_acceleration", "base_acceleration"},
      {"base_wrench", "base_wrench"}};
  std::string text = "program " + kernel + "\n";
  for (const std::string& input : inputs) text += "input " + input + " " + roles.at(input) + " HFE KFE\n";
  for (const std::string& output : outputs) text += "output " + output + " " + roles.at(output) + " 2 1\n";
  for (const std::string& output : outputs) text += "return " + output + " 0 0\n";
  return test::function(name, kernel, test::described_program(text));
}

// `result kernel(type name, …) + standard gravity`, one string for each overload.
Names signatures(const Library& library, const std::string& group) {
  Names result;
  const Api names = api(library);
  for (const Overload& o : overloads(names, group, "")) {
    std::string text = o.result + " " + o.callable->kernel + "(";
    for (const Argument& a : o.arguments) text += (text.back() == '(' ? "" : ", ") + a.type + " " + a.name;
    result.push_back(text + ")" + (o.adds_standard_gravity ? " + standard gravity" : ""));
  }
  return result;
}

TEST(Overloads, GravityIsOptionalBesideExternalWrenchesWhenNoFunctionDoesWithout) {
  Library library = test::leg_library();
  library.functions = {
      dynamics("bias_forces", "bias", {"q", "qd"}, {"tau"}),
      dynamics("bias_forces", "bias_gravity", {"q", "qd", "gravity"}, {"tau"}),
      dynamics("bias_forces", "bias_external", {"q", "qd", "gravity", "external"}, {"tau"})};
  EXPECT_EQ(
      signatures(library, "bias_forces"),
      (Names{
          "JointState bias(JointState q, JointState qd)",
          "JointState bias_gravity(JointState q, JointState qd, Gravity gravity)",
          "JointState bias_external(JointState q, JointState qd, Gravity gravity, LinkWrenches external)",
          "JointState bias_external(JointState q, JointState qd, LinkWrenches external) + standard gravity"}));
}

TEST(Overloads, GravityIsOptionalAtTheEndWhenNoFunctionDoesWithout) {
  Library library = test::leg_library();
  library.functions = {dynamics("gravity_forces", "gravity_forces", {"q", "gravity"}, {"tau", "base_wrench"})};
  EXPECT_EQ(
      signatures(library, "gravity_forces"), (Names{
                                                 "GeneralizedForce gravity_forces(JointState q, Gravity gravity)",
                                                 "GeneralizedForce gravity_forces(JointState q) + standard gravity"}));
}

TEST(Overloads, FunctionsWithoutGravityStayAsTheyAre) {
  Library library = test::leg_library();
  library.functions = {
      dynamics("forward_dynamics", "f", {"q", "tau", "base_velocity", "external"}, {"qdd", "base_acceleration"})};
  EXPECT_EQ(
      signatures(library, "forward_dynamics"),
      (Names{"GeneralizedAcceleration f(JointState q, JointState tau, Twist base_velocity, LinkWrenches external)"}));
}

TEST(Api, ResultTypesFollowTheRolesOfTheOutputs) {
  EXPECT_EQ(result_type(dynamics("f", "f", {"q"}, {"tau", "base_acceleration"})), "InverseDynamics");
  EXPECT_EQ(result_type(dynamics("f", "f", {"q"}, {"base_wrench"})), "Wrench");
  EXPECT_EQ(
      result_type(test::function(
          "J", "J", test::described_program("program J\ninput q joint_position a\noutput J jacobian 6 0\nreturn J\n"))),
      "Matrix<6, 0>");
  EXPECT_EQ(
      result_type(
          test::function("H", "H", test::described_program("program H\noutput H inertia_matrix 1 1\nreturn H 1\n"))),
      "InertiaMatrix");
}

// One structure serves all overloads of a function, and no other function.
TEST(Api, ResultsOfSeveralArraysHaveAStructureNamedAfterTheFunction) {
  Library library = test::leg_library();
  library.functions = {
      dynamics("two_of_a_kind", "two", {"q"}, {"qdd", "base_wrench"}),
      dynamics("two_of_a_kind", "two_gravity", {"q", "gravity"}, {"qdd", "base_wrench"}),
      dynamics("held", "held", {"q"}, {"tau", "base_wrench"})};
  const Api names = api(library);
  EXPECT_EQ(result_type(library.functions[0]), "TwoOfAKind");
  EXPECT_EQ(result_type(library.functions[1]), "TwoOfAKind");
  ASSERT_EQ(callables_with_structures(names).size(), 1U);
  EXPECT_EQ(callables_with_structures(names).front()->kernel, "two");
}

// A factor is kept in an object; functions that read it are members of its type, not free functions.
TEST(Api, FunctionsOfAFactorAreMembersOfItsType) {
  Library library = test::leg_library();
  const auto add = [&](const std::string& name, const std::string& text) {
    library.functions.push_back(test::function(name, name, test::described_program("program " + name + "\n" + text)));
  };
  library.functions.clear();
  add("factor",
      "input q joint_position a\noutput L inertia_factor 1 1\noutput inverse_diagonal inverse_diagonal 1 1\n"
      "return L q[0]\nreturn inverse_diagonal q[0]\n");
  add("solve", "input L inertia_factor a\ninput x value a\noutput y value 1 1\nreturn y x[0]\n");
  library.functions[1].scope = "inertia_factor";
  for (Function& f : library.functions) f.group = "factor";
  const Api names = api(library);
  EXPECT_TRUE(returns_object(library.functions[0].program));
  EXPECT_FALSE(returns_object(library.functions[1].program));
  EXPECT_EQ(result_type(library.functions[0]), "InertiaFactor");
  EXPECT_EQ(scopes(names, "factor"), Names{""});
  EXPECT_TRUE(overloads(names, "factor", "inertia_factor").empty());
  const std::vector<Overload> found = members(names, "InertiaFactor");
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found[0].callable->name, "solve");
  ASSERT_EQ(found[0].arguments.size(), 1U);
  EXPECT_EQ(found[0].arguments[0].name, "x");
  EXPECT_EQ(found[0].inputs, (Names{"L_.data()", "x.data()"}));
}

TEST(Api, ParametersAreMembersOfOneTypeWithAGetterEach) {
  Library library = test::leg_library();
  for (const char* name : {"size", "class", "get_mass", "mass"}) {
    library.tree.parameters.emplace_back();
    library.tree.parameters.back().name = name;
  }
  for (const char* name : {"update_kinematics", "update_dynamics", "update_both"})
    library.updates.push_back(test::function("parameters", name, test::leg_program("return tau 0\n")));
  const Api names = api(library);
  EXPECT_TRUE(names.is_parametric());
  EXPECT_EQ(names.fields, (Names{"size", "class_", "get_mass", "mass"}));
  EXPECT_EQ(names.getters, (Names{"get_size", "get_class_", "get_get_mass", "get_mass_2"}));
}

TEST(Overloads, ParametersComeFirst) {
  Library library = test::leg_library();
  library.functions = {dynamics("bias_forces", "bias_gravity", {"parameters", "q", "gravity"}, {"tau"})};
  EXPECT_EQ(
      signatures(library, "bias_forces"),
      (Names{
          "JointState bias_gravity(Parameters<Scalar> parameters, JointState q, Gravity gravity)",
          "JointState bias_gravity(Parameters<Scalar> parameters, JointState q) + standard gravity"}));
}

TEST(Api, NamespacesThatWouldHideOthersAreRenamed) {
  Library library = test::leg_library();
  library.name = "Eigen";
  library.enclosing = "my::robcogen::class";
  EXPECT_EQ(api(library).space, "my::robcogen_::class_::Eigen_");
}

TEST(Api, EnumeratorsAreLegalAndDistinct) {
  Library library = test::leg_library();
  library.tree.joints[0].name = "class";
  library.tree.joints[1].name = "__x";
  model::test::add_frame(library.tree, "a-b", 0);
  model::test::add_frame(library.tree, "a_b", 0);
  const Api names = api(library);
  EXPECT_EQ(names.joints, (Names{"class_", "x"}));
  EXPECT_EQ(names.frames, (Names{"fr_trunk", "fr_thigh", "fr_shank", "fr_class", "fr_x", "fr_foot", "a_b_2", "a_b"}));
}

TEST(Api, DifferentFunctionsNeverShareAName) {
  Library library = test::leg_library();
  const auto transform = [](const std::string& name) {
    Function f = dynamics(name, name, {"q"}, {"tau"});
    f.scope = "transforms::motion";
    return f;
  };
  library.functions = {transform("a__X_b"), transform("a_X_b"), transform("a_X_b_2")};
  const Api names = api(library);
  EXPECT_EQ(names.callables[0].name, "a_X_b_3");
  EXPECT_EQ(names.callables[1].name, "a_X_b");
  EXPECT_EQ(names.callables[2].name, "a_X_b_2");
  EXPECT_EQ(names.callables[0].kernel, "a_X_b_3");
}

TEST(Api, TheColumnsOfAJacobianStandBesideIt) {
  Library library = test::leg_library();
  Function f = test::function(
      "a_J_b", "a_J_b",
      test::described_program("program J\ninput q joint_position a\noutput J jacobian 6 0\nreturn J\n"));
  f.scope = "jacobians";
  library.functions = {f, f};
  library.functions[1].name = library.functions[1].kernel = "a_J_b_columns";
  const Api names = api(library);
  EXPECT_EQ(names.callables[1].name, "a_J_b_columns");
  EXPECT_EQ(names.callables[0].columns, "a_J_b_columns_2");
}

}  // namespace
}  // namespace robcogen::backend::cpp::api_test
