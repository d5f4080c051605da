// Spheres, capsules and distances against kinematics and geometry that are written down here.
#include <algorithm>
#include <cmath>
#include <random>

#include "algorithm/catalogue/catalogue.h"
#include "algorithm/kinematics/collision.h"
#include "driver/find_function.h"
#include "files.h"
#include "model/collision.h"
#include "symbolic/derivative.h"
#include "symbolic/interpret.h"

namespace robcogen::test::collision_test {
namespace {

using Point = std::array<double, 3>;
using Numbers = std::vector<double>;

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

// A point of a link in the base.
Point in_base(std::size_t link, const Numbers& q, Point p) {
  const auto turn = [&](std::size_t a, std::size_t b, double angle) {
    const double c = std::cos(angle), s = std::sin(angle), x = p[a], y = p[b];
    p[a] = c * x - s * y;
    p[b] = s * x + c * y;
  };
  for (std::size_t k = link; k-- > 0;) {
    if (k == 0) turn(0, 1, q[0]);
    if (k == 1) turn(2, 0, q[1]);
    if (k == 2) turn(1, 2, q[2]);
    if (k == 3) p[2] += q[3];
    p[2] += 0.5;
  }
  return p;
}

double distance(const Point& a, const Point& b) {
  return std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
}

Point between(const Point& a, const Point& b, double t) {
  return {a[0] + t * (b[0] - a[0]), a[1] + t * (b[1] - a[1]), a[2] + t * (b[2] - a[2])};
}

// The distance of a point and a segment, by golden sections: no formula is shared with the code under test.
template <class F>
double least(F f) {
  const double ratio = (std::sqrt(5.0) - 1) / 2;
  double low = 0, high = 1;
  for (int k = 0; k < 45; ++k) {
    const double a = high - ratio * (high - low), b = low + ratio * (high - low);
    (f(a) < f(b) ? high : low) = f(a) < f(b) ? b : a;
  }
  return std::min({f(0.0), f(1.0), f((low + high) / 2)});
}

double distance_of_segments(const std::array<Point, 2>& a, const std::array<Point, 2>& b) {
  return least([&](double s) {
    const Point p = between(a[0], a[1], s);
    return least([&](double t) { return distance(p, between(b[0], b[1], t)); });
  });
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

Point along(const Point& p, double length, const Point& axis) {
  return {p[0] + length * axis[0], p[1] + length * axis[1], p[2] + length * axis[2]};
}

// The ends of their axes, in the frames of the URDF: Rz(0.4) Ry(1.2) and Rx(0.5) turn two of them.
const Point kTilted = {std::cos(0.4) * std::sin(1.2), std::sin(0.4) * std::sin(1.2), std::cos(1.2)};
const Point kTurned = {0, -std::sin(0.5), std::cos(0.5)};
const std::array<std::array<Point, 2>, 5> kEnds = {
    {{along({0.3, 0, 0}, -0.4, kTilted), along({0.3, 0, 0}, 0.4, kTilted)},
     {{{0.1, 0.2, 0.3}, {0.1, 0.2, 0.3}}},
     {{{0, 0, 0}, {0, 0, 0.4}}},
     {along({0, 0.1, 0.3}, -0.3, kTurned), along({0, 0.1, 0.3}, 0.3, kTurned)},
     {{{0, 0, 0.1}, {0, 0, 0.1}}}}};

std::vector<Numbers> states(std::size_t count) {
  std::mt19937 random(17);
  std::uniform_real_distribution<double> uniform(-2, 2);
  std::vector<Numbers> list = {{0, 0, 0, 0}};
  while (list.size() < count)
    list.push_back({uniform(random), uniform(random), uniform(random), 0.2 * uniform(random)});
  return list;
}

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
  // Those of links that a joint connects are left out.
  using Pairs = std::vector<std::array<std::size_t, 2>>;
  const Pairs pairs = {{0, 2}, {0, 3}, {0, 4}, {1, 3}, {1, 4}, {2, 4}};
  EXPECT_EQ(model::collision_pairs(robot.tree(), robot.capsules), pairs);
  const symbolic::Program program = algorithm::self_distance(robot.tree(), "d");
  for (const Numbers& q : states(40)) {
    double expected = 1e9;
    for (const auto& [i, k] : pairs) {
      std::array<std::array<Point, 2>, 2> segments;
      for (const auto& [side, index] : {std::pair<std::size_t, std::size_t>{0, i}, {1, k}})
        for (std::size_t e = 0; e < 2; ++e) segments[side][e] = in_base(index, q, kEnds[index][e]);
      expected = std::min(
          expected,
          distance_of_segments(segments[0], segments[1]) - robot.capsules[i].radius - robot.capsules[k].radius);
    }
    EXPECT_NEAR(run(program, q, "distance")[0], expected, 1e-6);
  }
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
      "unavailable-group: 'collision' of robot 'chain' is not available: it has no collision shapes, which only a URDF "
      "can "
      "have");
}

}  // namespace
}  // namespace robcogen::test::collision_test
