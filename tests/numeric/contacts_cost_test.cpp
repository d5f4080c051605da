// Operation counts of the contact functions: they must stay sparse.
#include <gtest/gtest.h>

#include <filesystem>
#include <map>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "driver/driver.h"
#include "symbolic/cost.h"

namespace robcogen::numeric::contacts_cost_test {
namespace {

// Returns the number of multiplications and additions of each function.
std::map<std::string, int> costs(const std::string& robot, const std::vector<std::string>& contacts) {
  Diagnostics diagnostics;
  const std::filesystem::path file = std::filesystem::path(ROBCOGEN_ROBOTS_DIR) / robot / (robot + ".kindsl");
  driver::LoadOptions options;
  options.contacts = contacts;
  const std::optional<driver::Model> model = driver::load(file, options, diagnostics);
  if (!model) throw std::runtime_error(diagnostics.render());
  std::map<std::string, int> result;
  for (const driver::Function& f : driver::programs(*model, {"contacts"}, {}).list) {
    const symbolic::Cost count = symbolic::cost(f.program);
    result.insert({f.program.name, count.mul + count.add});
  }
  return result;
}

// The limits are the counts of a textbook implementation that uses the sparsity of the factor.
TEST(ContactsCost, IsThatOfTheSparseFactor) {
  const auto quadruped = costs("quadruped", {"fr_LF_foot", "fr_RF_foot", "fr_LH_foot", "fr_RH_foot"});
  EXPECT_LE(quadruped.at("inverse_contact_inertia"), 3307);
  EXPECT_LE(quadruped.at("constrained_forward_dynamics"), 6258);
  const auto arm = costs("iiwa14", {"fr_ee"});
  EXPECT_LE(arm.at("inverse_contact_inertia"), 625);
  EXPECT_LE(arm.at("constrained_forward_dynamics"), 1222);
}

// The blocks of legs on a fixed base are not coupled.
TEST(ContactsCost, GrowsWithTheContacts) {
  const auto one = costs("quadruped_fixed", {"fr_LF_foot"});
  const auto all = costs("quadruped_fixed", {"fr_LF_foot", "fr_RF_foot", "fr_LH_foot", "fr_RH_foot"});
  EXPECT_LE(all.at("inverse_contact_inertia"), 4 * one.at("inverse_contact_inertia"));
}

}  // namespace
}  // namespace robcogen::numeric::contacts_cost_test
