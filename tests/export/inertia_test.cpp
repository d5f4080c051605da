// Mass properties at the limit of what a body can have, with as many digits as documents have. Converted from URDF to a
// robot document and back to URDF, they are accepted by readers and do not change. Impossible ones are refused.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <random>

#include "export/kinematics.h"
#include "export/urdf.h"
#include "import/kinematics.h"
#include "import/urdf.h"
#include "robots.h"
#include "same_physics.h"

namespace robcogen::inertia_test {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;
using model::KinematicTree;

struct Body {
  double mass = 1.0;
  Vector3d com = Vector3d::Zero();
  Matrix3d tensor = Matrix3d::Zero();  // about the centre of mass
};

class RandomBodies {
 public:
  explicit RandomBodies(std::uint64_t seed) : engine_(seed) {}

  // Returns a solid, a plate, a rod, a point mass, or a body whose moments are rounding noise; of any size, mass and
  // orientation.
  Body next() {
    const double mass = std::pow(10.0, uniform(-3, 2)), size = std::pow(10.0, uniform(-3, 1));
    Body body{mass, Vector3d::Zero(), Matrix3d::Zero()};
    const std::uint64_t flat = engine_() % 4;
    if (flat == 3 || engine_() % 3 != 0) body.com = size * uniform(0.1, 3) * direction();
    Vector3d second = {uniform(0, 1), uniform(0, 1), uniform(0, 1)};  // second moments of mass
    second.head(static_cast<Eigen::Index>(flat)).setZero();
    const Matrix3d R = rotation();
    body.tensor = mass * size * size * (second.sum() * Matrix3d::Identity() - R * second.asDiagonal() * R.transpose());
    if (flat == 3) add_noise(body, size);
    return body;
  }

  double uniform(double low, double high) { return std::uniform_real_distribution<double>(low, high)(engine_); }
  Matrix3d rotation() {
    return Eigen::Quaterniond(uniform(-1, 1), uniform(-1, 1), uniform(-1, 1), uniform(-1, 1))
        .normalized()
        .toRotationMatrix();
  }
  Vector3d direction() { return Vector3d(uniform(-1, 1), uniform(-1, 1), uniform(-1, 1)).normalized(); }

 private:
  // Adds the rounding error of a difference between moments of the body's size, computed in doubles.
  void add_noise(Body& body, double size) {
    const double reach = std::max(size, body.com.norm());
    for (Eigen::Index i = 0; i < 3; ++i)
      for (Eigen::Index j = 0; j <= i; ++j)
        body.tensor(i, j) = body.tensor(j, i) = uniform(-1e-16, 1e-16) * body.mass * reach * reach;
  }

  std::mt19937_64 engine_;
};

std::string inertial(const Body& b, int digits) {
  const auto text = [&](double x) { return fmt::format("{:.{}g}", x, digits); };
  return fmt::format(
      "<inertial><origin xyz=\"{} {} {}\"/><mass value=\"{}\"/>"
      "<inertia ixx=\"{}\" ixy=\"{}\" ixz=\"{}\" iyy=\"{}\" iyz=\"{}\" izz=\"{}\"/></inertial>",
      text(b.com[0]), text(b.com[1]), text(b.com[2]), text(b.mass), text(b.tensor(0, 0)), text(b.tensor(0, 1)),
      text(b.tensor(0, 2)), text(b.tensor(1, 1)), text(b.tensor(1, 2)), text(b.tensor(2, 2)));
}

// The body at the end of an arm whose other link has inertia about all axes.
std::string arm(const std::string& tip, const Vector3d& axis, double length) {
  const auto joint = [](const char* parent, const char* child, const Vector3d& a, double x) {
    return fmt::format(
        "<joint name=\"{1}_joint\" type=\"continuous\"><parent link=\"{0}\"/><child link=\"{1}\"/>"
        "<origin xyz=\"{5} 0 0\"/><axis xyz=\"{2} {3} {4}\"/></joint>",
        parent, child, a[0], a[1], a[2], x);
  };
  const Body upper{1.0, {0.1, 0.2, 0.3}, Matrix3d::Identity()};
  return fmt::format(
      "<robot name=\"arm\"><link name=\"base\"/><link name=\"upper\">{}</link><link name=\"tip\">{}</link>{}{}</robot>",
      inertial(upper, 17), tip, joint("base", "upper", {0, 0, 1}, 0.0), joint("upper", "tip", axis, length));
}

std::optional<KinematicTree> read(const std::string& urdf, Diagnostics& diagnostics) {
  return import::urdf(std::make_shared<Source>("arm.urdf", urdf), {}, diagnostics);
}

bool reports(const Diagnostics& diagnostics, const std::string& code) {
  const auto& all = diagnostics.all();
  return std::any_of(all.begin(), all.end(), [&](const Diagnostic& d) { return d.code == code; });
}

TEST(BorderlineInertia, IsNeverRefused) {
  constexpr int kBodies = 450;
  RandomBodies random(7);
  for (int i = 0; i < kBodies; ++i) {
    const Body body = random.next();
    const int digits = 3 + i % 15;
    const std::string text = arm(inertial(body, digits), random.direction(), 0.3);
    SCOPED_TRACE(text);
    Diagnostics diagnostics;
    const auto first = read(text, diagnostics);
    ASSERT_TRUE(first.has_value()) << diagnostics.render();

    const std::string document =
        language::kinematics::print(exporting::numbered_parents_first(*first, exporting::kinematics_document(*first)));
    const auto second = import::kinematic_tree(
        language::kinematics::parse(std::make_shared<Source>("arm.kindsl", document), diagnostics), diagnostics);
    ASSERT_TRUE(second.has_value()) << diagnostics.render() << document;
    const std::string urdf = exporting::urdf(*second);
    const auto third = read(urdf, diagnostics);
    ASSERT_TRUE(third.has_value()) << diagnostics.render() << urdf;
    EXPECT_LT(test::differences(*third, *first, 3, 1).inertia_matrix, 1e-12);
    if (digits == 17 && !reports(diagnostics, "zero-mass")) {
      EXPECT_FALSE(reports(diagnostics, "inertia-not-positive")) << diagnostics.render();
      EXPECT_FALSE(reports(diagnostics, "triangle-inequality")) << diagnostics.render();
    }
  }
}

TEST(BorderlineInertia, OfNoBodyIsStillRefusedOrWarnedOf) {
  constexpr int kBodies = 200;
  RandomBodies random(8);
  for (int i = 0; i < kBodies; ++i) {
    const double mass = random.uniform(0.1, 10), a = random.uniform(0.1, 1) * mass, b = random.uniform(0.1, 1) * mass;
    const Matrix3d R = random.rotation();
    const auto text = [&](const Vector3d& moments) {
      const Matrix3d tensor = R * moments.asDiagonal() * R.transpose();
      return arm(inertial({mass, 0.3 * random.direction(), tensor}, 17), random.direction(), 0.3);
    };
    Diagnostics of_triangle, of_negative;
    EXPECT_TRUE(read(text({a, b, 1.5 * (a + b)}), of_triangle).has_value());
    EXPECT_TRUE(reports(of_triangle, "triangle-inequality")) << of_triangle.render();
    EXPECT_FALSE(read(text({a, b, -0.2 * (a + b)}), of_negative).has_value());
    EXPECT_TRUE(reports(of_negative, "inertia-not-positive")) << of_negative.render();
  }
}

}  // namespace
}  // namespace robcogen::inertia_test
