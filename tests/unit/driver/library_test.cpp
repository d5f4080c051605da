// What a library says about its model, and the functions that it contains.
#include "driver/library.h"

#include "documents.h"
#include "driver/declare.h"
#include "driver/optimise.h"
#include "symbolic/interpret.h"

namespace robcogen::driver::library_test {
namespace {

using namespace test;

backend::Library assembled(const Model& model, const std::vector<std::string>& groups, Primitives primitives = {}) {
  return library_of(model, {"arm", "a::b"}, groups, optimise(model, declare(model, groups), {}, {}), primitives);
}

const backend::Function& function(const backend::Library& library, const std::string& scope, const std::string& name) {
  for (const backend::Function& f : library.functions)
    if (f.scope == scope && f.name == name) return f;
  ADD_FAILURE() << scope << "::" << name << " is missing";
  return library.functions.front();
}

TEST(Library, SaysWhereItIsFrom) {
  const Folder folder;
  const Model model = loaded(folder.file("rods.kindsl", kRods));
  const backend::Library library = assembled(model, {"inverse_dynamics"});
  EXPECT_EQ(library.name, "arm");
  EXPECT_EQ(library.enclosing, "a::b");
  EXPECT_EQ(library.title(), "Rods");
  EXPECT_EQ(library.model_file, "rods.kindsl");  // without the folder on this machine
  EXPECT_EQ(library.generator_version, kVersion);
  EXPECT_EQ(library.groups, std::vector<std::string>{"inverse_dynamics"});
  EXPECT_FALSE(library.tree.floating_base);
  const Model other = loaded(folder.file("rods.kindsl", replaced(kRods, "mass = 2.0", "mass = 2.5")));
  EXPECT_NE(library.model_hash, assembled(other, {"inverse_dynamics"}).model_hash);
}

TEST(Library, FunctionsKnowTheirFrames) {
  const backend::Library library = assembled(rods(), {"transforms", "jacobians"});
  const backend::Function& f = function(library, "transforms::motion", "fr_base_X_tip");
  EXPECT_EQ(library.frames().at(static_cast<std::size_t>(f.left_frame)), "fr_base");
  EXPECT_EQ(library.frames().at(static_cast<std::size_t>(f.right_frame)), "tip");
  EXPECT_EQ(function(library, "jacobians", "fr_base_J_tip").columns, (std::vector<int>{0, 1}));
}

TEST(Library, HomogeneousTransformsCanBeProducts) {
  using model::MovedFramePosition;
  const Model model = rods();
  const backend::Library none = assembled(model, {"transforms"});
  EXPECT_EQ(none.primitives, backend::PrimitiveConvention::none);
  EXPECT_FALSE(function(none, "transforms::homogeneous", "fr_base_X_fr_lower").product);
  const backend::Library right = assembled(model, {"transforms"}, MovedFramePosition::right);
  EXPECT_EQ(right.primitives, backend::PrimitiveConvention::right);
  EXPECT_EQ(assembled(model, {"transforms"}, MovedFramePosition::left).primitives, backend::PrimitiveConvention::left);
  // Rx(PI/2) Rz(q0) Tx(0.75) Rz(q1)
  const std::vector<backend::PrimitiveData> primitives =
      function(right, "transforms::homogeneous", "fr_base_X_fr_lower").product.value().primitives;
  ASSERT_EQ(primitives.size(), 4U);
  EXPECT_TRUE(primitives[0].rotation && primitives[1].rotation && !primitives[2].rotation);
  EXPECT_EQ(primitives[0].axis, 0);
  EXPECT_EQ(primitives[1].axis, 2);
  EXPECT_FALSE(function(right, "transforms::motion", "fr_base_X_fr_lower").product);
}

TEST(Library, OfADocumentOfTransformsHasNoRobot) {
  const Folder folder;
  const backend::Library library = assembled(loaded(folder.file("arm.ctdsl", kTransforms)), {kTransformsGroup});
  EXPECT_FALSE(library.has_robot());
  EXPECT_EQ(library.title(), "Arm");
  EXPECT_EQ(library.document.variables, std::vector<std::string>{"a"});
  EXPECT_EQ(library.frames().size(), 2U);
  // The document's own product, for checks: Rx(a) Ty(0.5).
  const backend::Function& f = function(library, "transforms::homogeneous", "base_X_hand");
  ASSERT_EQ(f.factors.value().primitives.size(), 2U);
  EXPECT_TRUE(f.factors->primitives[0].rotation);
  EXPECT_EQ(
      symbolic::interpret(f.factors->amounts, symbolic::Arrays<double>{{"variables", {0.75}}}).at("amounts"),
      (std::vector<double>{0.75, 0.5}));
  EXPECT_EQ(library.frames()[static_cast<std::size_t>(f.left_frame)], "base");
}

}  // namespace
}  // namespace robcogen::driver::library_test
