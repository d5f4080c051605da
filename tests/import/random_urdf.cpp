#include "random_urdf.h"

#include <Eigen/Geometry>
#include <numbers>
#include <random>

#include "support/number.h"

namespace robcogen::test {

namespace {

class Writer {
 public:
  Writer(std::uint64_t seed, const UrdfOptions& options) : engine_(seed), options_(options) {}

  std::string write() {
    const int links = 2 + below(11);
    std::string text = "<robot name=\"random robot\">\n";
    bool has_mass = true;
    for (int i = 0; i < links; ++i) {
      if (i == 0) {
        text += link(i, true);
        continue;
      }
      const bool is_fixed = below(3) == 0;
      has_mass = !is_fixed || below(3) != 0;
      text += link(i, has_mass) + joint(i, below(3) == 0 ? below(i) : i - 1, is_fixed);
    }
    return text + "</robot>\n";
  }

 private:
  int below(int count) { return static_cast<int>(engine_() % static_cast<std::uint64_t>(count)); }
  double between(double low, double high) {
    return low + (high - low) * static_cast<double>(engine_() >> 11) * 0x1p-53;
  }

  static std::string words(const Eigen::Vector3d& v) {
    return print_double(v[0]) + " " + print_double(v[1]) + " " + print_double(v[2]);
  }

  double angle() {
    if (!options_.exact_angles) {
      const int kind = below(5);
      if (kind == 0) return 0.0;
      if (kind == 1) return (below(5) - 2) * std::numbers::pi / 2;  // the nearest double
      if (kind == 2) return (below(2) == 0 ? 1.5708 : -3.14159);    // as people write them
      return between(-3.5, 3.5);
    }
    const double error = options_.angle_error * (below(2) == 0 ? 1 : -1);
    const int steps = below(25) - 12;
    return steps * std::numbers::pi / 12 + (steps == 0 ? 0.0 : error);
  }

  Eigen::Vector3d position() {
    Eigen::Vector3d p(between(-1, 1), between(-1, 1), between(-1, 1));
    for (int k = 0; k < 3; ++k)
      if (below(3) == 0) p[k] = 0.0;
    return p;
  }

  std::string origin() {
    const Eigen::Vector3d p = position(), a(angle(), angle(), angle());
    return "<origin xyz=\"" + words(p) + "\" rpy=\"" + words(a) + "\"/>";
  }

  static std::string name(char kind, int index) { return std::string(1, kind) + "-" + std::to_string(index); }

  std::string link(int index, bool has_mass) {
    const std::string begin = "<link name=\"" + name('l', index) + "\">";
    if (!has_mass) return begin + "</link>\n";
    // The inertia of a solid body, from second moments along its principal axes.
    const double a = between(0.001, 0.1), b = between(0.001, 0.1), c = between(0.001, 0.1);
    const Eigen::Matrix3d R = Eigen::Quaterniond(between(-1, 1), between(-1, 1), between(-1, 1), between(0.1, 1))
                                  .normalized()
                                  .toRotationMatrix();
    const Eigen::Matrix3d I = R * Eigen::Vector3d(b + c, a + c, a + b).asDiagonal() * R.transpose();
    const auto element = [&](const char* key, int i, int j) {
      return " " + std::string(key) + "=\"" + print_double(I(i, j)) + "\"";
    };
    const std::string where = origin();
    return begin + "<inertial>" + where + "<mass value=\"" + print_double(between(0.1, 5)) + "\"/><inertia" +
           element("ixx", 0, 0) + element("ixy", 0, 1) + element("ixz", 0, 2) + element("iyy", 1, 1) +
           element("iyz", 1, 2) + element("izz", 2, 2) + "/></inertial></link>\n";
  }

  Eigen::Vector3d axis() {
    if (below(2) == 0) return (below(2) == 0 ? 1.0 : -1.0) * Eigen::Vector3d::Unit(below(3));
    if (below(3) == 0) return {between(-1, 1), 0.5, -0.5};
    return {between(-2, 2), between(-2, 2), between(0.1, 2)};
  }

  std::string joint(int index, int parent, bool is_fixed) {
    const char* type =
        is_fixed ? "fixed" : std::array{"revolute", "continuous", "prismatic"}[static_cast<std::size_t>(below(3))];
    std::string text = "<joint name=\"" + name('j', index) + "\" type=\"" + type + "\">" + origin() +
                       "<parent link=\"" + name('l', parent) + "\"/><child link=\"" + name('l', index) + "\"/>";
    if (!is_fixed)
      text += "<axis xyz=\"" + words(axis()) + "\"/><limit lower=\"-1\" upper=\"1\" effort=\"1\" velocity=\"1\"/>";
    return text + "</joint>\n";
  }

  std::mt19937_64 engine_;
  UrdfOptions options_;
};

}  // namespace

std::string random_urdf(std::uint64_t seed, const UrdfOptions& options) {
  return Writer(seed, options).write();
}

}  // namespace robcogen::test
