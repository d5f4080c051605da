// How shapes of links, meshes and SRDFs are read.
#include <cstdlib>
#include <cstring>

#include "files.h"

namespace robcogen::test::reading_test {
namespace {

using model::Shape;

driver::LoadOptions all_shapes() {
  driver::LoadOptions options;
  options.urdf.shapes = {.visuals = true, .collisions = true};
  return options;
}

// A turning arm of two bodies, of which the second is fixed to the first.
std::string arm(const std::string& shapes) {
  return R"(<robot name='r'>
    <link name='base'/>
    <link name='upper'><visual><geometry><sphere radius='0.1'/></geometry></visual></link>
    <link name='lower'>)" +
         shapes + R"(</link>
    <joint name='turn' type='revolute'><parent link='base'/><child link='upper'/><axis xyz='0 0 1'/>
      <origin xyz='0 0 0.5'/><limit lower='-1' upper='1' effort='1' velocity='1'/></joint>
    <joint name='weld' type='fixed'><parent link='upper'/><child link='lower'/><origin xyz='0.25 0 0' rpy='0 0 1.5707963267948966'/></joint>
  </robot>)";
}

double number(const model::Quantity& q) {
  return model::evaluate(q);
}

TEST(Shapes, AreReadInTheFrameOfTheirLink) {
  const Folder folder;
  const Loaded read = loaded(
      folder.file("r.urdf", arm(R"(
        <visual name='v'><origin xyz='0.5 0 0.125'/><geometry><box size='1 2 3'/></geometry><material name='m'/></visual>
        <collision><geometry><capsule radius='0.25' length='2'/></geometry></collision>
        <collision><geometry><cylinder radius='0.5' length='4'/></geometry></collision>)")),
      all_shapes());
  ASSERT_TRUE(read.model) << read.diagnostics.render();
  EXPECT_EQ(read.messages(), std::vector<std::string>());
  ASSERT_EQ(read.shapes().size(), 4u);
  const auto expect = [&](std::size_t k, Shape::Kind kind, Shape::Use use, std::array<double, 3> size,
                          const char* body) {
    const Shape& shape = read.shapes()[k];
    EXPECT_EQ(shape.kind, kind) << k;
    EXPECT_EQ(shape.use, use) << k;
    EXPECT_EQ(shape.size, size) << k;
    EXPECT_EQ(shape.body, body) << k;
    EXPECT_EQ(read.tree().links[static_cast<std::size_t>(shape.link)].name, "upper") << k;
  };
  expect(0, Shape::Kind::sphere, Shape::Use::visual, {0.1, 0, 0}, "upper");
  expect(1, Shape::Kind::box, Shape::Use::visual, {1, 2, 3}, "lower");
  expect(2, Shape::Kind::capsule, Shape::Use::collision, {0.25, 2, 0}, "lower");
  expect(3, Shape::Kind::cylinder, Shape::Use::collision, {0.5, 4, 0}, "lower");
  // The box: 0.5 m along the x axis of `lower`, which is the y axis of `upper`.
  const auto& t = read.shapes()[1].placement.translation;
  EXPECT_DOUBLE_EQ(number(t[0]), 0.25);
  EXPECT_DOUBLE_EQ(number(t[1]), 0.5);
  EXPECT_DOUBLE_EQ(number(t[2]), 0.125);
  EXPECT_DOUBLE_EQ(number(read.shapes()[1].placement.rotation[2]), 1.5707963267948966);
}

TEST(Shapes, AreReadOnlyWhereTheyAreAskedFor) {
  const Folder folder;
  const auto file =
      folder.file("r.urdf", arm("<collision><geometry><mesh filename='none.stl'/></geometry></collision>"));
  const Loaded plain = loaded(file, {});
  ASSERT_TRUE(plain.model);
  EXPECT_TRUE(plain.shapes().empty());
  EXPECT_EQ(plain.messages(), std::vector<std::string>());
  driver::LoadOptions visuals;
  visuals.urdf.shapes.visuals = true;
  const Loaded pictures = loaded(file, visuals);
  ASSERT_TRUE(pictures.model);
  ASSERT_EQ(pictures.shapes().size(), 1u);
  EXPECT_EQ(pictures.model->canonical, plain.model->canonical);
  EXPECT_EQ(pictures.messages(), std::vector<std::string>());
}

// A picture lacks a shape that is wrong; a check would be unsafe without it.
TEST(Shapes, ThatAreWrongAreLeftOutOfPicturesOnly) {
  const Folder folder;
  folder.file("t.obj", kTetrahedron);
  folder.file("cut.stl", "solid s\n facet normal 0 0 1\n outer loop\n vertex 0 0 0\n vertex 1 0 0\n");
  for (const auto& [shape, message] : std::vector<std::pair<std::string, std::string>>{
           {"<collision/>", "missing-element: this 'collision' has no element 'geometry'"},
           {"<collision><geometry/></collision>", "missing-element: this 'geometry' has no shape"},
           {"<collision><geometry><sphere radius='-1'/></geometry></collision>",
            "shape-size: 'radius' of a shape of link 'lower' is not positive"},
           {"<collision><geometry><box size='1 0 1'/></geometry></collision>",
            "shape-size: 'size' of a shape of link 'lower' is not positive"},
           {"<collision><geometry><cylinder radius='1'/></geometry></collision>",
            "missing-attribute: this 'cylinder' has no attribute 'length'"},
           {"<collision><geometry><capsule radius='1' length='2e6'/></geometry></collision>",
            "shape-size: 'length' of a shape of link 'lower' is more than 1e6 m"},
           {"<collision><geometry><box size='1 2e6 1'/></geometry></collision>",
            "shape-size: 'size' of a shape of link 'lower' is more than 1e6 m"},
           {"<collision><geometry><mesh filename='t.obj' scale='1 0 1'/></geometry></collision>",
            "shape-size: 'scale' of a shape of link 'lower' is zero"},
           {"<collision><geometry><mesh filename='t.obj' scale='2e6 1 1'/></geometry></collision>",
            "unread-mesh: mesh 't.obj' of link 'lower' is larger than 1e6 m"},
           {"<collision><geometry><mesh filename=''/></geometry></collision>",
            "unread-mesh: mesh '' of link 'lower' is not found"},
           {"<collision><geometry><mesh filename='package://'/></geometry></collision>",
            "unread-mesh: mesh 'package://' of link 'lower' is not found"},
           {"<collision><geometry><mesh filename='cut.stl'/></geometry></collision>",
            "unread-mesh: mesh 'cut.stl' of link 'lower' cannot be read: it ends within a solid"},
           {"<collision><geometry><mesh filename='package://none/a.stl'/></geometry></collision>",
            "unread-mesh: mesh 'package://none/a.stl' of link 'lower' is not found"}}) {
    SCOPED_TRACE(shape);
    const auto file = folder.file("r.urdf", arm(shape));
    const Loaded picture = loaded(file, all_shapes());
    ASSERT_TRUE(picture.model);
    EXPECT_EQ(picture.shapes().size(), 1u);
    EXPECT_EQ(picture.messages(), std::vector<std::string>{message + ": the shape is left out"});
    const Loaded check = loaded(file, checked());
    EXPECT_FALSE(check.model);
    ASSERT_FALSE(check.messages().empty());
    EXPECT_EQ(check.messages().front(), message);
  }
}

TEST(Shapes, WarnOfWhatIsNotRead) {
  const Folder folder;
  const Loaded read = loaded(
      folder.file("r.urdf", arm("<visual><geometry><sphere radius='1' color='red'/><cone/></geometry></visual>")),
      all_shapes());
  EXPECT_EQ(
      read.messages(), (std::vector<std::string>{
                           "unknown-attribute: attribute 'color' of this 'sphere' is unknown and ignored",
                           "unknown-element: element 'cone' of this 'geometry' is unknown and ignored"}));
}

// Sets a variable of the environment for as long as it lives.
class Variable {
 public:
  Variable(const char* name, const std::string& value) : name_(name) { setenv(name, value.c_str(), 1); }
  ~Variable() { unsetenv(name_); }
  Variable(const Variable&) = delete;
  Variable& operator=(const Variable&) = delete;

 private:
  const char* name_;
};

TEST(Shapes, FindMeshesOfPackages) {
  const Folder folder;
  folder.file("clone-main/package.xml", "<package><name> arm_description </name></package>");
  folder.file("clone-main/meshes/t.obj", kTetrahedron);
  const auto mesh = [](const std::string& file) {
    return arm("<visual><geometry><mesh filename='" + file + "' scale='2 2 -2'/></geometry></visual>");
  };
  const auto finds = [&](const std::filesystem::path& file, const driver::LoadOptions& options) {
    const Loaded read = loaded(file, options);
    const bool is_found = read.model && read.shapes().size() == 2;
    if (is_found) {
      EXPECT_EQ(read.shapes()[1].mesh->faces.size(), 4u);
      EXPECT_EQ(read.shapes()[1].size, (std::array<double, 3>{2, 2, -2}));
      EXPECT_EQ(read.model->read.size(), 2u);
    }
    return is_found;
  };
  const std::string in_package = mesh("package://arm_description/meshes/t.obj");
  EXPECT_TRUE(finds(folder.file("clone-main/urdf/r.urdf", in_package), all_shapes()));
  EXPECT_TRUE(finds(folder.file("clone-main/urdf/r.urdf", mesh("../meshes/t.obj")), all_shapes()));
  const auto elsewhere = folder.file("elsewhere/r.urdf", in_package);
  EXPECT_FALSE(finds(elsewhere, all_shapes()));
  driver::LoadOptions with_folder = all_shapes();
  with_folder.import_folders = {folder.path() / "clone-main"};
  EXPECT_TRUE(finds(elsewhere, with_folder));
  // A copy of the document, such as that which an editor makes of a text that is not saved.
  with_folder.import_folders = {folder.path() / "clone-main" / "urdf"};
  EXPECT_TRUE(finds(elsewhere, with_folder));
  const auto copy = folder.file("elsewhere/r.urdf", mesh("../meshes/t.obj"));
  EXPECT_FALSE(finds(copy, all_shapes()));
  EXPECT_TRUE(finds(copy, with_folder));
  folder.file("elsewhere/r.urdf", in_package);
  folder.file("ws/arm_description/meshes/t.obj", kTetrahedron);
  folder.file("install/share/arm_description/meshes/t.obj", kTetrahedron);
  {
    const Variable path("ROS_PACKAGE_PATH", "/nowhere:" + (folder.path() / "ws").string());
    EXPECT_TRUE(finds(elsewhere, all_shapes()));
  }
  const Variable prefix("AMENT_PREFIX_PATH", (folder.path() / "install").string());
  EXPECT_TRUE(finds(elsewhere, all_shapes()));
}

TEST(Shapes, MoveWithLockedJoints) {
  const Folder folder;
  const auto file = folder.file(
      "r.urdf", arm("<collision><origin xyz='1 0 0'/><geometry><sphere radius='1'/></geometry></collision>"));
  driver::LoadOptions options = all_shapes();
  options.changes.locks = {"turn=0"};
  const Loaded read = loaded(file, options);
  ASSERT_TRUE(read.model) << read.diagnostics.render();
  ASSERT_EQ(read.shapes().size(), 2u);
  const Shape& sphere = read.shapes()[1];
  EXPECT_EQ(sphere.link, 0);
  EXPECT_EQ(sphere.body, "lower");
  const std::array<double, 3> expected = {0.25, 1, 0.5};
  for (std::size_t k = 0; k < 3; ++k) EXPECT_NEAR(number(sphere.placement.translation[k]), expected[k], 1e-15);
}

TEST(Srdf, DisablesPairsByTheNamesOfLinks) {
  const Folder folder;
  const auto file = folder.file("r.urdf", arm("<collision><geometry><sphere radius='1'/></geometry></collision>"));
  driver::LoadOptions options = checked();
  options.srdf = folder.file(
      "r.srdf",
      "<robot name='r'><group name='g'/><disable_collisions link1='base' link2='lower' reason='Adjacent'/>"
      "<disable_collisions link1='base' link2='lowr'/><enable_collisions link1='base' link2='upper'/></robot>");
  const Loaded read = loaded(file, options);
  ASSERT_TRUE(read.model) << read.diagnostics.render();
  EXPECT_TRUE(read.tree().geometry.has_srdf);
  ASSERT_EQ(read.tree().geometry.may_touch.size(), 1u);
  EXPECT_EQ(read.tree().geometry.may_touch[0], (std::array<std::string, 2>{"base", "lower"}));
  EXPECT_EQ(
      read.messages(), (std::vector<std::string>{
                           "unknown-link: robot 'r' has no link 'lowr': the pair is ignored",
                           "unknown-element: element 'enable_collisions' of this SRDF is not read"}));
  EXPECT_EQ(read.model->read.back(), *options.srdf);
  options.srdf = folder.file("other.srdf", "<sdf/>");
  EXPECT_EQ(
      loaded(file, options).messages(),
      std::vector<std::string>{"other-format: this XML is not an SRDF: its root element is 'sdf', not 'robot'"});
  options.srdf = folder.file("short.srdf", "<robot><disable_collisions link1='base'/></robot>");
  EXPECT_EQ(
      loaded(file, options).messages(),
      std::vector<std::string>{"missing-attribute: this 'disable_collisions' has no attribute 'link2'"});
}

}  // namespace
}  // namespace robcogen::test::reading_test
