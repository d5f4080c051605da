// Shapes of MJCF and SDF: which are read, where they are, and which pairs are checked. (tests/oracles compares geoms
// with MuJoCo.)
#include <algorithm>
#include <cmath>

#include "algorithm/kinematics/collision.h"
#include "files.h"
#include "model/collision.h"
#include "symbolic/interpret.h"

namespace robcogen::test::formats_test {
namespace {

using model::Shape;
using Use = Shape::Use;

driver::LoadOptions all_shapes() {
  driver::LoadOptions options;
  options.urdf.shapes = {.visuals = true, .collisions = true};
  return options;
}

struct Expected {
  Shape::Kind kind;
  Use use;
  std::array<double, 3> size;
  const char* body;
  int link;
};

void expect_shapes(const Loaded& read, const std::vector<Expected>& expected) {
  ASSERT_TRUE(read.model) << read.diagnostics.render();
  ASSERT_EQ(read.shapes().size(), expected.size());
  for (std::size_t k = 0; k < expected.size(); ++k) {
    const Shape& shape = read.shapes()[k];
    SCOPED_TRACE(k);
    EXPECT_EQ(shape.kind, expected[k].kind);
    EXPECT_EQ(shape.use, expected[k].use);
    for (std::size_t i = 0; i < 3; ++i) EXPECT_NEAR(shape.size[i], expected[k].size[i], 1e-15);
    EXPECT_EQ(shape.body, expected[k].body);
    EXPECT_EQ(shape.link, expected[k].link);
  }
}

// Both ends of the capsule of this number among those that are not spheres, lower z first.
std::array<std::array<double, 3>, 2> ends_of(const Loaded& read, const std::vector<double>& q, std::size_t capsule) {
  const symbolic::Program program = algorithm::collision_capsules(read.tree(), "capsules");
  const std::vector<double> ends = symbolic::interpret<double>(program, {{"q", q}}).at("ends");
  std::array<std::array<double, 3>, 2> result{};
  for (std::size_t e = 0; e < 2; ++e)
    for (std::size_t k = 0; k < 3; ++k) result[e][k] = ends[6 * capsule + 3 * e + k];
  if (result[0][2] > result[1][2]) std::swap(result[0], result[1]);
  return result;
}

void expect_near(const std::array<double, 3>& found, const std::array<double, 3>& expected) {
  for (std::size_t k = 0; k < 3; ++k) EXPECT_NEAR(found[k], expected[k], 1e-12) << k;
}

std::size_t pairs_of(const Loaded& read) {
  return model::collision_pairs(read.tree(), model::capsules(read.tree())).size();
}

const std::string kInertial = "<inertial pos='0 0 0' mass='1' diaginertia='1 1 1'/>";

std::string mjcf(const std::string& bodies, const std::string& rest = "") {
  return "<mujoco model='m'><default><default class='visual'><geom contype='0' conaffinity='0' group='2'/></default>"
         "<default class='hidden'><geom group='3' type='capsule'/></default></default>"
         "<asset><mesh name='t' vertex='0 0 0  1 0 0  0 1 0  0 0 1' face='0 2 1  0 1 3  0 3 2  1 2 3' scale='1 1 -2' "
         "refpos='0.5 0 0'/></asset><worldbody>" +
         bodies + "</worldbody>" + rest + "</mujoco>";
}

// A turning body `a` whose joint is off its origin, with a body `b` that is fixed to it, and a body `c` that slides.
const std::string kBodies =
    "<geom type='plane' size='1 1 1'/><geom type='box' size='0.5 0.25 0.125'/><body name='a' pos='0 0 1'>"
    "<joint name='turn' axis='0 0 1' pos='0.5 0 0'/>" +
    kInertial +
    "<geom class='visual' type='ellipsoid' size='0.3 0.1 0.2'/><geom class='hidden' fromto='0 0 0 0 0 -1' size='0.1'/>"
    "<body name='b' pos='0 0 0.5' euler='0 0 90'><geom class='hidden' type='cylinder' size='0.1 0.2' pos='1 0 0'/>"
    "<body name='c'><joint name='slide' type='slide' axis='0 0 1'/>" +
    kInertial + "<geom type='mesh' mesh='t' pos='0 0 3'/></body></body></body>";

TEST(MjcfShapes, AreGeoms) {
  const Folder folder;
  const auto file = folder.file("m.xml", mjcf(kBodies));
  using Kind = Shape::Kind;
  const Loaded read = loaded(file, all_shapes());
  expect_shapes(
      read, {{Kind::box, Use::visual, {1, 0.5, 0.25}, "world", 0},
             {Kind::box, Use::collision, {1, 0.5, 0.25}, "world", 0},
             {Kind::capsule, Use::visual, {0.2, 0.2, 0}, "a", 1},
             {Kind::capsule, Use::collision, {0.1, 1, 0}, "a", 1},
             {Kind::cylinder, Use::collision, {0.1, 0.4, 0}, "b", 1},
             {Kind::mesh, Use::visual, {1, 1, 1}, "c", 2},
             {Kind::mesh, Use::collision, {1, 1, 1}, "c", 2}});
  // Where the joint turns by q, points p of `a` are at (0.5, 0, 1) + Rz(q) (p - (0.5, 0, 0)).
  const double q = 0.3, c = std::cos(q), s = std::sin(q);
  const auto capsule = ends_of(read, {q, 0.25}, 1), cylinder = ends_of(read, {q, 0.25}, 2);
  expect_near(capsule[0], {0.5 - 0.5 * c, -0.5 * s, 0});
  expect_near(capsule[1], {0.5 - 0.5 * c, -0.5 * s, 1});
  // The x axis of `b` is the y axis of `a`.
  expect_near(cylinder[0], {0.5 - 0.5 * c - s, -0.5 * s + c, 1.3});
  expect_near(cylinder[1], {0.5 - 0.5 * c - s, -0.5 * s + c, 1.7});
  // First shifted by `refpos`, then scaled, as MuJoCo does: from z = 0 to -2, and outside in the mirror.
  const model::TriangleMesh& mesh = *read.shapes()[5].mesh;
  EXPECT_EQ(mesh.vertices[3], (std::array<float, 3>{-0.5F, 0, -2}));
  EXPECT_EQ(mesh.faces[0], (std::array<std::uint32_t, 3>{0, 1, 2}));
}

TEST(MjcfShapes, AreReadOnlyWhereTheyAreAskedFor) {
  const Folder folder;
  const auto file = folder.file("m.xml", mjcf(kBodies));
  const Loaded plain = loaded(file, {}), asked = loaded(file, checked());
  ASSERT_TRUE(plain.model && asked.model);
  EXPECT_TRUE(plain.shapes().empty());
  EXPECT_EQ(asked.shapes().size(), 4u);
  EXPECT_NE(plain.model->canonical, asked.model->canonical);
  EXPECT_EQ(
      asked.messages(),
      std::vector<std::string>{"unread-geom: this plane is not a shape of a link, and is not checked"});
}

TEST(MjcfShapes, PairsAreThoseOfTheDocument) {
  const Folder folder;
  const auto pairs = [&](const std::string& attributes, const std::string& contact, std::vector<std::string> messages) {
    std::string bodies = kBodies.substr(kBodies.find("<geom type='box'"));
    bodies.insert(bodies.find(" size='0.5 0.25"), attributes);
    const Loaded read = loaded(folder.file("m.xml", mjcf(bodies, contact)), checked());
    EXPECT_EQ(read.messages(), messages);
    return pairs_of(read);
  };
  // The world and `c`: links that a joint connects are left out.
  EXPECT_EQ(pairs("", "", {}), 1u);
  EXPECT_EQ(pairs(" contype='2'", "", {}), 1u) << "the affinity of the first and the type of the second suffice";
  EXPECT_EQ(pairs(" contype='2' conaffinity='2'", "", {}), 0u);
  EXPECT_EQ(pairs(" contype='-1' conaffinity='0'", "", {}), 1u) << "all bits";
  EXPECT_EQ(pairs("", "<contact><exclude body1='c' body2='world'/></contact>", {}), 0u);
  EXPECT_EQ(pairs("", "<contact><exclude body1='c' body2='a'/></contact>", {}), 1u);
  EXPECT_EQ(
      pairs(
          "", "<contact><exclude body1='d' body2='world'/><pair geom1='x' geom2='y'/></contact>",
          {"unknown-body: body 'd' is not declared: the pair is checked",
           "unread-pair: this pair of geoms is not read: its bodies are checked as all others are"}),
      1u);
}

// Links between the joints of a body do not count as bodies.
TEST(MjcfShapes, SeveralJointsConnectTwoBodies) {
  const Folder folder;
  const std::string joints = "<joint name='x' axis='1 0 0'/><joint name='y' axis='0 1 0'/>";
  for (const std::string& moved : {joints, std::string("<joint name='ball' type='ball'/>")}) {
    const Loaded read = loaded(
        folder.file(
            "m.xml", mjcf(
                         "<geom size='1'/><body name='a'><geom size='1'/>" + moved +
                         "<body name='b'><joint name='z'/><geom size='1'/></body></body>")),
        checked());
    ASSERT_TRUE(read.model) << read.diagnostics.render();
    EXPECT_EQ(pairs_of(read), 1u) << "the world and b";
  }
}

TEST(MjcfShapes, ThatAreWrongAreLeftOutOfPicturesOnly) {
  const Folder folder;
  folder.file("empty.obj", "");
  const auto body = [](const std::string& geom) {
    return "<body name='a'><joint name='j'/>" + kInertial + "<geom size='1'/>" + geom + "</body>";
  };
  const std::string meshes =
      "<asset><mesh name='none' file='none.stl'/><mesh name='empty' file='empty.obj'/><mesh name='made' "
      "builtin='sphere'/><mesh name='flat' vertex='0 0 0 1 1 1' scale='1 0 1'/><mesh name='huge' vertex='0 0 1e7'/>"
      "</asset>";
  for (const auto& [geom, message] : std::vector<std::pair<std::string, std::string>>{
           {"<geom/>", "missing-attribute: this 'geom' has no attribute 'size'"},
           {"<geom size='-1'/>", "geom-size: the size of this geom is not positive"},
           {"<geom size='1e7'/>", "geom-size: the size of this geom is more than 1e6 m"},
           {"<geom type='sdf'/>", "unread-geom: a signed distance field is not read as a shape"},
           {"<geom type='mesh'/>", "unread-geom: this 'geom' has no attribute 'mesh'"},
           {"<geom type='box' mesh='t'/>", "unread-geom: a shape that is fitted to a mesh is not read"},
           {"<geom type='mesh' mesh='u'/>", "unknown-mesh: mesh 'u' is not declared"},
           {"<geom type='mesh' mesh='empty'/>", "unread-mesh: mesh 'empty' cannot be read: it has no vertex"},
           {"<geom type='mesh' mesh='flat'/>", "unread-mesh: mesh 'flat' cannot be read: its scale is zero"},
           {"<geom type='mesh' mesh='huge'/>", "unread-mesh: mesh 'huge' cannot be read: it is larger than 1e6 m"},
           {"<geom type='mesh' mesh='made'/>", "unread-mesh: mesh 'made' cannot be read: MuJoCo generates it"},
           {"<geom size='1' contype='0.5'/>", "geom-bits: 'contype' is not an integer of 32 bits"}}) {
    SCOPED_TRACE(geom);
    const auto file = folder.file("m.xml", mjcf(body(geom), meshes));
    const Loaded picture = loaded(file, all_shapes());
    ASSERT_TRUE(picture.model) << picture.diagnostics.render();
    EXPECT_EQ(picture.shapes().size(), 2u);
    EXPECT_EQ(picture.messages(), std::vector<std::string>{message + ": the shape is left out"});
    const Loaded check = loaded(file, checked());
    EXPECT_FALSE(check.model);
    ASSERT_FALSE(check.messages().empty());
    EXPECT_EQ(check.messages().front(), message);
  }
  const Loaded unread = loaded(folder.file("m.xml", mjcf(body("<geom type='mesh' mesh='none'/>"), meshes)), checked());
  ASSERT_FALSE(unread.messages().empty());
  EXPECT_EQ(unread.messages().front().substr(0, 17), "unread-mesh: file");
}

TEST(MjcfShapes, AMeshOfSeveralGeomsIsReportedOnce) {
  const Folder folder;
  const std::string geom = "<geom type='mesh' mesh='none'/>";
  const auto file = folder.file(
      "m.xml", mjcf(
                   "<body name='a'><joint name='j'/>" + kInertial + geom + geom + "</body>",
                   "<asset><mesh name='none'/></asset>"));
  EXPECT_EQ(loaded(file, all_shapes()).messages().size(), 1u);
  EXPECT_FALSE(loaded(file, checked()).model);
}

TEST(MjcfShapes, HaveNamesOfTheirOwn) {
  const Folder folder;
  const Loaded read = loaded(
      folder.file(
          "m.xml", mjcf(
                       "<body name='a'><joint name='j'/>" + kInertial +
                       "<geom size='1'/><geom size='2'/><body name='a_1'><geom size='3'/></body></body>")),
      checked());
  ASSERT_TRUE(read.model) << read.diagnostics.render();
  std::vector<std::string> names;
  for (const model::Capsule& capsule : model::capsules(read.tree())) names.push_back(capsule.name);
  EXPECT_EQ(names, (std::vector<std::string>{"a_2", "a_3", "a_1"}));
}

const std::string kMass = "<inertial><mass>1</mass><inertia><ixx>1</ixx><iyy>1</iyy><izz>1</izz></inertia></inertial>";

std::string sdf(const std::string& shapes, const std::string& rest = "") {
  return "<sdf version='1.9'><model name='m'><joint name='fix' "
         "type='fixed'><parent>world</parent><child>base</child></joint>"
         "<link name='base'><pose>0 0 1 0 0 0</pose><collision name='c'><geometry><box><size>1 0.5 0.25</size></box>"
         "</geometry></collision></link><frame name='aside'><pose>0 3 0 0 0 0</pose></frame>"
         "<link name='arm'><pose>0.5 0 2 0 0 1.5707963267948966</pose>" +
         kMass + shapes +
         "</link><joint name='turn' type='revolute'><pose>0.25 0 0 0 0 0</pose><parent>base</parent><child>arm</child>"
         "<axis><xyz>0 0 1</xyz></axis></joint>" +
         rest + "</model></sdf>";
}

std::string collision(const std::string& geometry, const std::string& rest = "") {
  return "<collision name='c'>" + rest + "<geometry>" + geometry + "</geometry></collision>";
}

TEST(SdfShapes, AreReadWhereTheyAre) {
  const Folder folder;
  folder.file("t.obj", kTetrahedron);
  const std::string shapes =
      "<visual name='v'><geometry><ellipsoid><radii>1 2 3</radii></ellipsoid></geometry></visual>" +
      collision("<empty/>") +
      collision("<capsule><radius>0.1</radius><length>2</length></capsule>", "<pose>1 0 0 0 0 0</pose>") +
      collision(
          "<cylinder><radius>0.2</radius><length>4</length></cylinder>",
          "<pose relative_to='aside'>0 0 0.5 0 0 0</pose>") +
      collision("<sphere><radius>0.3</radius></sphere>") +
      collision("<mesh><uri>t.obj</uri><scale>2 2 -2</scale></mesh>");
  const Loaded read = loaded(folder.file("m.sdf", sdf(shapes)), all_shapes());
  using Kind = Shape::Kind;
  EXPECT_EQ(read.messages(), std::vector<std::string>());
  expect_shapes(
      read, {{Kind::box, Use::collision, {1, 0.5, 0.25}, "base", 0},
             {Kind::capsule, Use::visual, {2, 2, 0}, "arm", 1},
             {Kind::capsule, Use::collision, {0.1, 2, 0}, "arm", 1},
             {Kind::cylinder, Use::collision, {0.2, 4, 0}, "arm", 1},
             {Kind::sphere, Use::collision, {0.3, 0, 0}, "arm", 1},
             {Kind::mesh, Use::collision, {2, 2, -2}, "arm", 1}});
  EXPECT_EQ(read.model->read.size(), 2u);  // the document and the mesh
  // The joint is 0.25 m from the link, along the y axis of the model.
  const double q = 0.3, c = std::cos(q), s = std::sin(q);
  const auto at = [&](double x, double y, double z) -> std::array<double, 3> {
    const double dx = x - 0.5, dy = y - 0.25;
    return {0.5 + c * dx - s * dy, 0.25 + s * dx + c * dy, z};
  };
  const auto capsule = ends_of(read, {q}, 1), cylinder = ends_of(read, {q}, 2);
  expect_near(capsule[0], at(0.5, 1, 1));
  expect_near(capsule[1], at(0.5, 1, 3));
  expect_near(cylinder[0], at(0, 3, -1.5));
  expect_near(cylinder[1], at(0, 3, 2.5));
  EXPECT_TRUE(loaded(folder.path() / "m.sdf", {}).shapes().empty());
}

TEST(SdfShapes, PairsAreThoseOfTheDocument) {
  const Folder folder;
  const std::string ball = "<sphere><radius>0.3</radius></sphere>";
  const auto far = [&](const std::string& mask) {
    const std::string surface = "<surface><contact><collide_bitmask>" + mask + "</collide_bitmask></contact></surface>";
    return sdf(
        "", "<link name='far'>" + kMass + collision(ball, mask.empty() ? "" : surface) +
                "</link><joint name='go' type='prismatic'><parent>arm</parent><child>far</child><axis><xyz>0 0 1</xyz>"
                "</axis></joint>");
  };
  const auto read = [&](const std::string& mask) { return loaded(folder.file("m.sdf", far(mask)), checked()); };
  EXPECT_EQ(pairs_of(read("")), 1u);
  EXPECT_EQ(pairs_of(read("0")), 1u);
  EXPECT_EQ(
      read("0").messages(),
      std::vector<std::string>{
          "unread-mask: this 'collide_bitmask' is not read: the shape is checked with all others"});
  // A joint that closes a loop connects links, too.
  model::KinematicTree tree = read("").tree();
  model::LoopJoint loop;
  loop.ends[0].link = 2, loop.ends[1].link = 0;
  tree.loops.push_back(loop);
  EXPECT_TRUE(model::collision_pairs(tree, model::capsules(tree)).empty());
  tree.loops.back().type = model::LoopType::distance;
  EXPECT_EQ(model::collision_pairs(tree, model::capsules(tree)).size(), 1u);
}

TEST(SdfShapes, ThatAreWrongAreLeftOutOfPicturesOnly) {
  const Folder folder;
  for (const auto& [shape, message] : std::vector<std::pair<std::string, std::string>>{
           {"<collision name='c'/>", "missing-element: this 'collision' has no 'geometry'"},
           {collision("<plane/>"), "missing-element: this 'geometry' has no shape that is read"},
           {collision("<sphere/>"), "missing-element: this 'sphere' has no 'radius'"},
           {collision("<sphere><radius>0</radius></sphere>"),
            "shape-size: 'radius' of a shape of link 'arm' is not positive"},
           {collision("<box><size>1 1 -1</size></box>"), "shape-size: 'size' of a shape of link 'arm' is not positive"},
           {collision("<mesh><uri>none.stl</uri></mesh>"), "unread-mesh: mesh 'none.stl' of link 'arm' is not found"},
           {collision("<mesh><uri>none.stl</uri><scale>1 0 1</scale></mesh>"),
            "shape-size: 'scale' of a shape of link 'arm' is zero"}}) {
    SCOPED_TRACE(shape);
    const auto file = folder.file("m.sdf", sdf(shape));
    const Loaded picture = loaded(file, all_shapes());
    ASSERT_TRUE(picture.model);
    EXPECT_EQ(picture.shapes().size(), 1u);
    ASSERT_FALSE(picture.messages().empty());
    EXPECT_EQ(picture.messages().front(), message + ": the shape is left out");
    const Loaded check = loaded(file, checked());
    EXPECT_FALSE(check.model);
    ASSERT_FALSE(check.messages().empty());
    EXPECT_EQ(check.messages().front(), message);
  }
}

}  // namespace
}  // namespace robcogen::test::formats_test
