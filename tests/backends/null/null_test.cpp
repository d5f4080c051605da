// The input of every back end, listed by the null back end.
#include "null.h"

#include <gtest/gtest.h>

#include "../../unit/backend/programs.h"
#include "backend/languages.h"

namespace robcogen::backend::null_test {
namespace {

const Language kNull = {.name = "null", .takes_transforms = true, .print = null::print};

TEST(NullBackEnd, ListsTheFunctionsOfALibrary) {
  Library library = test::leg_library();
  library.functions = {
      test::function("energy", "energy", test::leg_program("tmp t = q[0] * qd[1]\nreturn tau t\n")),
      test::function(
          "inertia", "inertia_of_all",
          test::described_program("program inertia\n"
                                  "input q joint_position HFE KFE\n"
                                  "output H inertia_matrix 2 2\n"
                                  "return H 1 0 0 1\n"))};
  const std::vector<OutputFile> files = kNull.print(library);
  ASSERT_EQ(files.size(), 1U);
  EXPECT_EQ(files[0].path, "leg.txt");
  EXPECT_EQ(
      files[0].text,
      "energy: q 2 qd 2 -> tau 1 x 1; 1 statements\n"
      "inertia_of_all: q 2 -> H 2 x 2; 0 statements\n");
}

TEST(NullBackEnd, HasNothingToSayOfALibraryWithoutFunctions) {
  EXPECT_EQ(kNull.print(test::leg_library())[0].text, "");
}

}  // namespace
}  // namespace robcogen::backend::null_test
