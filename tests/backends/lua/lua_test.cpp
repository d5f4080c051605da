// The language of the guide's example.
#include "lua.h"

#include <gtest/gtest.h>

#include "../../unit/backend/programs.h"

namespace robcogen::backend::lua_test {
namespace {

TEST(Lua, PrintsAFunctionOfALibrary) {
  Library library = test::leg_library();
  library.functions = {test::function(
      "inverse_dynamics", "inverse_dynamics",
      test::leg_program(
          "tmp s = sin q[0]\nlet hip_w = s * qd[0]\nin 1\nlet end = hip_w - 0.5\nlet square = end * end\nreturn tau "
          "square "
          "hip_w\n",
          2))};
  const std::vector<OutputFile> files = lua::print(library);
  ASSERT_EQ(files.size(), 1U);
  EXPECT_EQ(files[0].path, "leg.lua");
  EXPECT_EQ(
      files[0].text,
      "-- Leg\n"
      "local M = {}\n"
      "\n"
      "-- Summary of inverse_dynamics.\n"
      "function M.inverse_dynamics(q, qd)\n"
      "  local s_HFE = math.sin(q[1])\n"
      "\n"
      "  -- link hip: velocity\n"
      "  local hip_w = s_HFE * qd[1]\n"
      "\n"
      "  -- link knee: velocity\n"
      "  local end_ = hip_w - 0.5\n"
      "  local square = end_ * end_\n"
      "  return {square, hip_w}\n"
      "end\n"
      "\n"
      "return M\n");
}

}  // namespace
}  // namespace robcogen::backend::lua_test
