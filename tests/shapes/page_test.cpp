// Shapes in pages.
#include "view/page.h"

#include <nlohmann/json.hpp>

#include "files.h"
#include "view/page_shapes.h"

namespace robcogen::test::page_test {
namespace {

using Json = nlohmann::json;

constexpr const char* kRobot = R"(<robot name='r'>
  <link name='base'><visual><geometry><box size='1 1 0.25'/></geometry></visual></link>
  <link name='arm'>
    <visual><origin xyz='0.5 0 0' rpy='0 1.5707963267948966 0'/><geometry><cylinder radius='0.125' length='1'/></geometry></visual>
    <visual><geometry><mesh filename='t.obj' scale='2 2 2'/></geometry></visual>
    <visual><geometry><mesh filename='t.obj'/></geometry></visual>
    <collision><geometry><sphere radius='0.25'/></geometry></collision>
  </link>
  <joint name='turn' type='continuous'><parent link='base'/><child link='arm'/><axis xyz='0 0 1'/></joint>
</robot>)";

Json data_of(const std::string& page) {
  const std::string begin = "<script type=\"application/json\" id=\"data\">";
  const std::size_t at = page.find(begin) + begin.size();
  return Json::parse(page.substr(at, page.find("</script>", at) - at));
}

Json page_of(const std::filesystem::path& file, bool has_shapes) {
  driver::LoadOptions options;
  options.urdf.shapes = {.visuals = has_shapes, .collisions = has_shapes};
  const Loaded read = loaded(file, options);
  const view::ViewedRobot robot = view::viewed(*read.model, view::Purpose::page);
  return data_of(view::page(*read.model, robot, read.diagnostics, {{0.0}, {}}));
}

TEST(ShapesOnAPage, AreThoseOfTheRobot) {
  const Folder folder;
  folder.file("t.obj", kTetrahedron);
  const auto file = folder.file("r.urdf", kRobot);
  const Json data = page_of(file, true), &shapes = data.at("shapes");
  ASSERT_EQ(shapes.size(), 5u);
  EXPECT_EQ(data.at("meshes").size(), 1u) << "one mesh with two scales";
  const auto kind = [&](std::size_t k) { return shapes[k].at("kind").get<std::string>(); };
  EXPECT_EQ(kind(0) + kind(1) + kind(2) + kind(3) + kind(4), "boxcylindermeshmeshsphere");
  EXPECT_EQ(shapes[0].at("link"), 0);
  EXPECT_EQ(shapes[1].at("link"), 1);
  EXPECT_EQ(shapes[2].at("size"), Json({2, 2, 2}));
  EXPECT_TRUE(shapes[3].at("isVisual"));
  EXPECT_FALSE(shapes[4].at("isVisual"));
  // The axis of the cylinder is the x axis of the link.
  const Json& pose = shapes[1].at("pose");
  EXPECT_EQ(pose[0][2], 1.0);
  EXPECT_EQ(pose[0][3], 0.5);
  EXPECT_FALSE(page_of(file, false).contains("shapes"));
}

TEST(ShapesOnAPage, HaveFewTriangles) {
  model::TriangleMesh wave;
  constexpr std::uint32_t kRow = 300;
  for (std::uint32_t i = 0; i < kRow; ++i)
    for (std::uint32_t k = 0; k < kRow; ++k)
      wave.vertices.push_back({static_cast<float>(i), static_cast<float>(k), static_cast<float>((i * k) % 7)});
  for (std::uint32_t i = 0; i + 1 < kRow; ++i)
    for (std::uint32_t k = 0; k + 1 < kRow; ++k) {
      wave.faces.push_back({i * kRow + k, i * kRow + k + 1, (i + 1) * kRow + k});
      wave.faces.push_back({i * kRow + k + 1, (i + 1) * kRow + k + 1, (i + 1) * kRow + k});
    }
  model::Shape shape;
  shape.kind = model::Shape::Kind::mesh;
  shape.size = {1, 1, 1};
  shape.mesh = std::make_shared<const model::TriangleMesh>(wave);
  const view::PageShapes shapes = view::page_shapes({shape, shape});
  EXPECT_EQ(shapes.triangles, 2 * wave.faces.size());
  EXPECT_LE(shapes.shown_triangles, 9000u);
  EXPECT_GT(shapes.shown_triangles, 2000u);
  EXPECT_LT(shapes.meshes.dump().size(), 100'000u);
}

}  // namespace
}  // namespace robcogen::test::page_test
