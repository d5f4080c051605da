// A new function of the API as an example for tool/README.md: its algorithm, its row, and what follows from them.
#include <gtest/gtest.h>

#include <string>

#include "algorithm/catalogue/arrays.h"
#include "algorithm/catalogue/catalogue.h"
#include "algorithm/dynamics/loads.h"
#include "model/descriptions.h"
#include "symbolic/interpret.h"

namespace robcogen::algorithm::example_function_test {
namespace {

// ---- algorithm/dynamics/mechanical_power.cpp

// The power (W) of the joint forces, those of a floating base excluded: qd, tau -> P.
symbolic::Program mechanical_power(const model::KinematicTree& tree, const std::string& name) {
  Trace trace(tree);
  const std::vector<Expression> qd = trace.coordinate_input("qd", symbolic::Role::joint_velocity);
  const std::vector<Expression> tau = trace.coordinate_input("tau", symbolic::Role::joint_force);
  Expression power;
  for (std::size_t k = 0; k < tau.size(); ++k) power += tau[k] * qd[k];
  trace.output("P", symbolic::Role::value, std::vector<Expression>{power});
  return trace.program(name);
}

// ---- a row of the group `energy` in algorithm/catalogue/dynamics_declarations.cpp

Declaration row() {
  using namespace catalogue;
  return {
      .name = "mechanical_power",
      .summary = {"Power (W) of the joint forces on {what moves}."},
      .signature = {{qd, tau}, {value("P", rows<1>)}},
      .program = {by<mechanical_power>}};
}

const ContactFrames kNoContacts;

model::KinematicTree robot() {
  Diagnostics diagnostics;
  return *model::build(model::test::two_links(), diagnostics);
}

TEST(ExampleFunction, IsDescribedWithoutBeingTraced) {
  const model::KinematicTree tree = robot();
  const Declaration declaration = row();
  const std::vector<Declared> functions = overloads(declaration, {tree, kNoContacts});
  ASSERT_EQ(functions.size(), 1U);
  EXPECT_EQ(functions[0].kernel, "mechanical_power");
  EXPECT_EQ(described(functions[0]).summary.front(), "Power (W) of the joint forces on the moving links.");
  const symbolic::Program outline = algorithm::outline(functions[0]);
  ASSERT_EQ(outline.inputs.size(), 2U);
  EXPECT_EQ(outline.inputs[1].name, "tau");
  EXPECT_EQ(outline.inputs[1].elements.size(), 2U);
  EXPECT_EQ(outline.outputs.at(0).rows, 1);
}

TEST(ExampleFunction, IsTraced) {
  const model::KinematicTree tree = robot();
  const Declaration declaration = row();
  FormulationChoices choices(tree, {});
  const symbolic::Function f = trace(overloads(declaration, {tree, kNoContacts}).front(), choices);
  const auto results = symbolic::interpret<double>(f.program, {{"qd", {2.0, -1.0}}, {"tau", {3.0, 4.0}}});
  EXPECT_EQ(results.at("P").at(0), 2.0);
}

}  // namespace
}  // namespace robcogen::algorithm::example_function_test
