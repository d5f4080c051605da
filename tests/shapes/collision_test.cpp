// Spheres, capsules and distances against kinematics and geometry that are written down here.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "algorithm/catalogue/catalogue.h"
#include "algorithm/kinematics/collision.h"
#include "chain.h"
#include "driver/find_function.h"
#include "files.h"
#include "import/body_shape.h"
#include "model/collision.h"
#include "symbolic/cost.h"
#include "symbolic/derivative.h"
#include "symbolic/interpret.h"

namespace robcogen::test::collision_test {
namespace {

Numbers run(const symbolic::Program& program, const Numbers& q, const std::string& output) {
  return symbolic::interpret<double>(program, {{"q", q}}).at(output);
}

// A joint about z, one about y and one about x, each 0.5 m above the last one in its own link, with a prismatic joint
// along z at the end. Link k has the shape `shapes[k]`; that of the base is the first.
std::string chain(const std::array<std::string, 5>& shapes) {
  std::string text = "<robot name='chain'>";
  for (std::size_t k = 0; k < 5; ++k)
    text += "<link name='l" + std::to_string(k) + "'>" +
            (shapes[k].empty() ? "" : "<collision>" + shapes[k] + "</collision>") + "</link>";
  const char* const axes[] = {"0 0 1", "0 1 0", "1 0 0", "0 0 1"};
  for (std::size_t k = 0; k < 4; ++k)
    text += "<joint name='j" + std::to_string(k) + "' type='" + (k == 3 ? "prismatic" : "revolute") +
            "'><parent link='l" + std::to_string(k) + "'/><child link='l" + std::to_string(k + 1) +
            "'/><origin xyz='0 0 0.5'/><axis xyz='" + axes[k] +
            "'/><limit lower='-3' upper='3' effort='1' velocity='1'/></joint>";
  return text + "</robot>";
}

std::string placed(const std::string& shape, const std::string& xyz, const std::string& rpy = "0 0 0") {
  return "<origin xyz='" + xyz + "' rpy='" + rpy + "'/><geometry>" + shape + "</geometry>";
}

struct Robot {
  Loaded loaded;
  std::vector<model::Capsule> capsules;

  const model::KinematicTree& tree() const { return loaded.tree(); }
};

Robot robot_of(const Folder& folder, const std::string& text, const driver::LoadOptions& options = checked()) {
  Robot robot{loaded(folder.file("robot.urdf", text), options), {}};
  if (!robot.loaded.model) throw std::runtime_error(robot.loaded.diagnostics.render());
  robot.capsules = model::capsules(robot.tree());
  return robot;
}

const std::array<std::string, 5> kShapes = {
    placed("<capsule radius='0.1' length='0.8'/>", "0.3 0 0", "0 1.2 0.4"),
    placed("<sphere radius='0.05'/>", "0.1 0.2 0.3"), placed("<capsule radius='0.07' length='0.4'/>", "0 0 0.2"),
    placed("<cylinder radius='0.08' length='0.6'/>", "0 0.1 0.3", "0.5 0 0"),
    placed("<sphere radius='0.125'/>", "0 0 0.1")};

TEST(Collision, SpheresAndCapsulesAreWhereTheirLinksAre) {
  const Folder folder;
  const Robot robot = robot_of(folder, chain(kShapes));
  const symbolic::Program spheres = algorithm::collision_spheres(robot.tree(), "spheres");
  const symbolic::Program capsules = algorithm::collision_capsules(robot.tree(), "capsules");
  for (const Numbers& q : states(20)) {
    const Numbers centers = run(spheres, q, "centers"), ends = run(capsules, q, "ends");
    ASSERT_EQ(centers.size(), 6u);
    ASSERT_EQ(ends.size(), 18u);
    const Point first = in_base(1, q, {0.1, 0.2, 0.3}), second = in_base(4, q, {0, 0, 0.1});
    const Point low = in_base(2, q, {0, 0, 0}), high = in_base(2, q, {0, 0, 0.4});
    for (std::size_t k = 0; k < 3; ++k) {
      EXPECT_NEAR(centers[k], first[k], 1e-14);
      EXPECT_NEAR(centers[3 + k], second[k], 1e-14);
      EXPECT_NEAR(ends[6 + k], low[k], 1e-14);
      EXPECT_NEAR(ends[9 + k], high[k], 1e-14);
    }
    EXPECT_EQ(run(spheres, q, "radii"), (Numbers{0.05, 0.125}));
    EXPECT_EQ(run(capsules, q, "radii"), (Numbers{0.1, 0.07, 0.08}));
  }
}

TEST(Collision, DistanceIsThatOfTheNearestPair) {
  const Folder folder;
  const Robot robot = robot_of(folder, chain(kShapes));
  EXPECT_EQ(model::collision_pairs(robot.tree(), robot.capsules), kPairs);
  const symbolic::Program program = algorithm::self_distance(robot.tree(), "d");
  for (const Numbers& q : states(40)) EXPECT_NEAR(run(program, q, "distance")[0], least_distance(q), 1e-6);
}

// Two spheres of radius 0.25 m, 2 m apart at zero, on a rail towards each other.
TEST(Collision, DistanceByHand) {
  const Folder folder;
  const Robot robot = robot_of(
      folder,
      chain({placed("<sphere radius='0.25'/>", "0 0 0"), "", "", "", placed("<sphere radius='0.25'/>", "0 0 0")}));
  const symbolic::Program program = algorithm::self_distance(robot.tree(), "d");
  EXPECT_DOUBLE_EQ(run(program, {0, 0, 0, 0}, "distance")[0], 1.5);
  EXPECT_DOUBLE_EQ(run(program, {1, 0, 0, -0.5}, "distance")[0], 1.0);
  EXPECT_DOUBLE_EQ(run(program, {1, 0, 0, -1.75}, "distance")[0], -0.25);
  const symbolic::Program derived = symbolic::with_derivatives(program, {"q"});
  const Numbers gradient = run(derived, {0, 0, 0, 0}, "d_q");
  ASSERT_EQ(gradient.size(), 4u);
  for (std::size_t k = 0; k < 4; ++k) EXPECT_DOUBLE_EQ(gradient[k], k == 3 ? 1.0 : 0.0);
  // Where the centres meet, the distance has no direction, and the derivative is zero instead of undefined.
  for (const double d : run(derived, {0, 0, 0, -2}, "d_q")) EXPECT_EQ(d, 0.0);
}

TEST(Collision, GradientAgreesWithDifferences) {
  const Folder folder;
  const Robot robot = robot_of(folder, chain(kShapes));
  const symbolic::Program program = algorithm::self_distance(robot.tree(), "d");
  const symbolic::Program derived = symbolic::with_derivatives(program, {"q"});
  constexpr double kStep = 1e-6;
  int compared = 0;
  for (const Numbers& q : states(60)) {
    const Numbers gradient = run(derived, q, "d_q");
    for (std::size_t k = 0; k < q.size(); ++k) {
      EXPECT_TRUE(std::isfinite(gradient[k]));
      Numbers more = q, less = q;
      more[k] += kStep, less[k] -= kStep;
      const double here = run(program, q, "distance")[0], up = run(program, more, "distance")[0] - here,
                   down = here - run(program, less, "distance")[0];
      if (std::abs(up - down) > 1e-9) continue;  // at a corner: another pair, or another side
      EXPECT_NEAR(gradient[k], (up + down) / 2 / kStep, 1e-5);
      ++compared;
    }
  }
  EXPECT_GT(compared, 200);
}

// Symmetric arms have pairs of equal distance in every symmetric position.
TEST(Collision, GradientIsDefinedWherePairsTie) {
  const Folder folder;
  const std::string sphere = "<geometry><sphere radius='0.1'/></geometry>";
  std::string text =
      chain({placed("<sphere radius='0.1'/>", "0.3 0 0"), "", "", "", placed("<sphere radius='0.1'/>", "0 0 0")});
  text.insert(text.find("</link>"), "<collision><origin xyz='-0.3 0 0'/>" + sphere + "</collision>");
  const Robot robot = robot_of(folder, text);
  ASSERT_EQ(robot.capsules.size(), 3u);
  EXPECT_EQ(robot.capsules[0].name, "l0_1");
  EXPECT_EQ(robot.capsules[2].name, "l4");
  const symbolic::Program derived = symbolic::with_derivatives(algorithm::self_distance(robot.tree(), "d"), {"q"});
  const Numbers gradient = run(derived, {0, 0, 0, 0}, "d_q");
  const double slope = 2.0 / std::hypot(2.0, 0.3);
  EXPECT_NEAR(gradient[3], slope, 1e-12);
  EXPECT_NEAR(gradient[1], 0.0, 1e-12);  // the mean of both sides
}

TEST(Collision, PairsOfAnSrdf) {
  const Folder folder;
  driver::LoadOptions options = checked();
  options.srdf = folder.file(
      "r.srdf",
      "<robot><disable_collisions link1='l4' link2='l0'/><disable_collisions link1='l0' link2='l1'/></robot>");
  const Robot robot = robot_of(folder, chain({kShapes[0], kShapes[1], "", "", kShapes[4]}), options);
  using Pairs = std::vector<std::array<std::size_t, 2>>;
  EXPECT_EQ(model::collision_pairs(robot.tree(), robot.capsules), (Pairs{{1, 2}}));
}

// Every point of a shape is inside its capsule.
TEST(Collision, CapsulesContainBoxesAndMeshes) {
  const Folder folder;
  folder.file("t.obj", kTetrahedron);
  folder.file("flat.obj", "v 0 0 0\nv 1 0 0\nv 0 0.5 0\nf 1 2 3\n");
  const Robot robot = robot_of(
      folder,
      chain(
          {placed("<box size='0.2 0.3 1'/>", "0 0 0"), placed("<mesh filename='t.obj' scale='1 2 0.5'/>", "0 0 0"), "",
           placed("<box size='1 1 1'/>", "0 0 0"), placed("<mesh filename='flat.obj'/>", "0 0 0")}));
  const std::vector<std::vector<Point>> points = {
      {{0.1, 0.15, 0.5}, {-0.1, 0.15, -0.5}, {0.1, -0.15, 0.5}},
      {{0, 0, 0}, {1, 0, 0}, {0, 2, 0}, {0, 0, 0.5}},
      {{0.5, 0.5, 0.5}, {-0.5, -0.5, 0.5}, {-0.5, 0.5, -0.5}},
      {{0, 0, 0}, {1, 0, 0}, {0, 0.5, 0}}};
  ASSERT_EQ(robot.capsules.size(), 4u);
  for (std::size_t c = 0; c < 4; ++c) {
    const model::Capsule& capsule = robot.capsules[c];
    for (const Point& p : points[c])
      EXPECT_LE(
          least([&](double t) { return distance(p, between(capsule.ends[0], capsule.ends[1], t)); }),
          capsule.radius + 1e-9)
          << capsule.name;
  }
  // Along the long edge of the box, with the diagonal of the others.
  EXPECT_EQ(robot.capsules[0].ends[0][2], -robot.capsules[0].ends[1][2]);
  EXPECT_NEAR(robot.capsules[0].radius, std::hypot(0.1, 0.15), 1e-15);
  EXPECT_LT(robot.capsules[1].radius, 0.6);
}

// Capsules of 0.1 m around axes of 1 m, of which the second is on a rail.
Robot two_capsules(const Folder& folder, const std::string& xyz, const std::string& rpy) {
  const std::string shape = "<capsule radius='0.1' length='1'/>";
  return robot_of(folder, chain({placed(shape, "0 0 0"), "", "", "", placed(shape, xyz, rpy)}));
}

TEST(Collision, AxesMayBeParallelOrMeet) {
  const Folder folder;
  struct Case {
    const char *xyz, *rpy;
    double rail, expected;
  };
  const double right = std::hypot(0.5, 1.0);
  for (const auto& [xyz, rpy, rail, expected] :
       {Case{"0.5 0 0", "0 0 0", 0, right - 0.2},       // parallel, one above the other
        {"0.5 0 0", "0 0 0", -1.75, 0.5 - 0.2},         // parallel, side by side
        {"0.5 0 0", "3.141592653589793 0 0", -2, 0.3},  // antiparallel, ends at the same heights
        {"0 0 0", "0 0 0", 0, 1 - 0.2},                 // on one line
        {"0 0 0", "0 0 0", -1.75, -0.2},                // on one line, overlapping
        {"0 0 0", "0 0 0", -2, -0.2},                   // the same
        {"0 0 0", "1.5707963267948966 0 0", -2, -0.2},  // crossed
        {"0 0.25 0.4", "0 1.5707963267948966 0", -2, 0.05}}) {
    SCOPED_TRACE(testing::Message() << xyz << ", " << rpy << " at " << rail);
    const Robot robot = two_capsules(folder, xyz, rpy);
    const symbolic::Program program = algorithm::self_distance(robot.tree(), "d");
    const symbolic::Program derived = symbolic::with_derivatives(program, {"q"});
    EXPECT_NEAR(run(program, {0, 0, 0, rail}, "distance")[0], expected, 1e-9);
    const auto single = symbolic::interpret<float>(derived, {{"q", {0, 0, 0, static_cast<float>(rail)}}});
    EXPECT_NEAR(single.at("distance")[0], expected, 1e-6);
    for (const float d : single.at("d_q")) EXPECT_LE(std::abs(d), 3);  // the rail is 2.5 m from the base at most
    for (const double d : run(derived, {0, 0, 0, rail}, "d_q")) EXPECT_LE(std::abs(d), 3);
  }
}

model::Capsule capsule_of(model::Shape::Kind kind, const std::array<double, 3>& size) {
  model::KinematicTree tree;
  model::Shape shape;
  shape.kind = kind;
  shape.use = model::Shape::Use::collision;
  shape.size = size;
  tree.geometry.shapes = {shape};
  return model::capsules(tree).at(0);
}

TEST(Collision, AnEllipsoidTouchesItsCapsuleFromInside) {
  for (const std::array<double, 3>& a :
       {std::array{0.3, 0.1, 0.2}, {0.1, 0.1, 0.4}, {0.2, 0.2, 0.2}, {1.0, 3.0, 2.9}}) {
    import::BodyShape shape;
    import::set_ellipsoid(shape, a);
    model::KinematicTree tree;
    tree.geometry.shapes = {import::placed(shape, "body", {})};
    tree.geometry.shapes[0].use = model::Shape::Use::collision;
    const model::Capsule capsule = model::capsules(tree).at(0);
    double farthest = 0;
    for (int i = 0; i <= 20; ++i)
      for (int k = 0; k < 20; ++k) {
        const double polar = std::numbers::pi * i / 20, around = std::numbers::pi * k / 10;
        const Point p = {
            a[0] * std::sin(polar) * std::cos(around), a[1] * std::sin(polar) * std::sin(around),
            a[2] * std::cos(polar)};
        farthest = std::max(
            farthest, least([&](double t) { return distance(p, between(capsule.ends[0], capsule.ends[1], t)); }));
      }
    EXPECT_NEAR(farthest, capsule.radius, 1e-6);
    EXPECT_NEAR(capsule.radius + distance(capsule.ends[0], capsule.ends[1]) / 2, std::max({a[0], a[1], a[2]}), 1e-12);
  }
}

// The square of their length would be zero in single precision.
TEST(Collision, ShortAxesArePoints) {
  const model::Capsule capsule = capsule_of(model::Shape::Kind::capsule, {0.1, 1e-9, 0});
  EXPECT_TRUE(capsule.is_sphere());
  EXPECT_DOUBLE_EQ(capsule.radius, 0.1 + 5e-10);
  EXPECT_FALSE(capsule_of(model::Shape::Kind::capsule, {0.1, 1e-5, 0}).is_sphere());
}

// Spheres on both ends of the chain, each of which makes a pair with each.
Robot many_pairs(const Folder& folder, int count) {
  std::string spheres;
  for (int k = 0; k < count; ++k)
    spheres += (k > 0 ? "</collision><collision>" : "") +
               placed("<sphere radius='0.05'/>", std::to_string(0.01 * k * k) + " " + std::to_string(0.2 * k) + " 0");
  return robot_of(folder, chain({spheres, "", "", "", spheres}));
}

TEST(Collision, PairsAreComparedInRounds) {
  const Folder folder;
  const auto path = [&](int count) {
    return symbolic::cost(algorithm::self_distance(many_pairs(folder, count).tree(), "d")).critical_path;
  };
  // One pair, 64 pairs: six rounds.
  EXPECT_LE(path(8), path(1) + 7 * (path(2) - path(1)) / 2);
  const Robot robot = many_pairs(folder, 5);
  const symbolic::Program program = algorithm::self_distance(robot.tree(), "d");
  for (const Numbers& q : states(10)) {
    double expected = 1e9;
    for (std::size_t i = 0; i < 5; ++i)
      for (std::size_t k = 5; k < 10; ++k)
        expected = std::min(
            expected,
            distance(in_base(0, q, robot.capsules[i].ends[0]), in_base(4, q, robot.capsules[k].ends[0])) - 0.1);
    EXPECT_NEAR(run(program, q, "distance")[0], expected, 1e-12);
  }
}

TEST(Collision, TooManyPairsAreMentioned) {
  const Folder folder;
  const Robot robot = many_pairs(folder, 64);
  ASSERT_FALSE(robot.loaded.messages().empty());
  EXPECT_EQ(
      robot.loaded.messages().back(),
      "too-many-pairs: self_distance is left out: 4096 pairs of shapes would be checked, and at most 4000 can be");
  EXPECT_TRUE(driver::find_functions(*robot.loaded.model->robot(), "self_distance").empty());
  EXPECT_FALSE(driver::find_functions(*robot.loaded.model->robot(), "collision_spheres").empty());
}

std::vector<std::string> names_of(const driver::Model& model) {
  std::vector<std::string> names;
  for (const algorithm::Declared& f : driver::find_functions(*model.robot(), "self_distance")) names.push_back(f.name);
  return names;
}

TEST(Collision, FunctionsExistWhereTheyAreAskedFor) {
  const Folder folder;
  const auto file = folder.file("robot.urdf", chain(kShapes));
  const Loaded plain = loaded(file, {}), asked = loaded(file, checked());
  ASSERT_TRUE(plain.model && asked.model);
  EXPECT_FALSE(algorithm::is_available(plain.tree(), "collision"));
  EXPECT_TRUE(algorithm::is_available(asked.tree(), "collision"));
  EXPECT_TRUE(names_of(*plain.model).empty());
  EXPECT_EQ(names_of(*asked.model), std::vector<std::string>{"self_distance"});
  // The hash of the model tells whether the shapes changed.
  EXPECT_NE(plain.model->canonical, asked.model->canonical);
  driver::LoadOptions derivative;
  derivative.derivatives = {{"self_distance", {"q"}}};
  EXPECT_TRUE(algorithm::is_available(loaded(file, derivative).tree(), "collision"));
  const Loaded without = loaded(folder.file("bare.urdf", chain({})), checked());
  EXPECT_EQ(
      without.messages().back(),
      "unavailable-group: 'collision' of robot 'chain' is not available: it has no collision shapes, which a URDF, "
      "MJCF or SDF can have");
}

}  // namespace
}  // namespace robcogen::test::collision_test
