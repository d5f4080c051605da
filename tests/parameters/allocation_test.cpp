// Parameter values may change in a loop that must not allocate.
#include <everywhere_fixed/everywhere_fixed.h>
#include <gtest/gtest.h>

#include <utility>

#include "allocation_hook.h"
#include "values.h"

namespace robcogen::test::allocation_test {
namespace {

using namespace everywhere_fixed;

TEST(Allocation, UpdatesAndCopiesDoWithout) {
  const ParameterValues others = other_values<ParameterValues>();
  const JointState q(0.3, -0.7, 0.2, 1.1);
  double sum = 0;
  {
    const NoAllocation guard("an update of parameters");
    Parameters<> p;
    Parameters<> copy = p;
    copy.update(others);
    copy.update(static_cast<const KinematicsParameters&>(ParameterValues()));
    copy.update(static_cast<const DynamicsParameters&>(ParameterValues()));
    copy.update(p.array());
    copy.update(p.values());
    std::swap(p, copy);
    sum = gravity_forces(p, q).sum();
  }
  EXPECT_EQ(sum, gravity_forces(Parameters<>(), q).sum());
}

}  // namespace
}  // namespace robcogen::test::allocation_test
