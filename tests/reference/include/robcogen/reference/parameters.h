// Values of a robot's parameters: random ones that are physically plausible, and the robot's tables for them.
#pragma once

#include <cmath>
#include <optional>
#include <random>

#include "robcogen/reference/algebra.h"
#include "robcogen/reference/samples.h"

namespace robcogen::reference {

// The tables of a robot for these parameter values, computed by the expressions of the document only.
class RobotOf {
 public:
  RobotOf(const Robot& robot, const std::vector<double>& values)
      : links_(robot.links.begin(), robot.links.end()),
        joints_(robot.joints.begin(), robot.joints.end()),
        frames_(robot.frames.begin(), robot.frames.end()),
        robot_(robot) {
    const std::size_t of_joint =
        kOfPlacement + (robot.numbers_of_drives ? kOfDrive : 0) + (robot.numbers_of_pitches ? 1 : 0);
    std::vector<double> links(kOfLink * links_.size()), joints(of_joint * joints_.size());
    std::vector<double> frames(kOfPlacement * frames_.size());
    robot.numbers(values.data(), links.data(), joints.data(), frames.data());
    const double* next = links.data();
    for (reflection::Link& link : links_) {
      link.mass = *next++;
      next = fill(fill(next, link.com), link.inertia);
    }
    next = joints.data();
    for (reflection::Joint& joint : joints_) {
      next = fill(fill(next, joint.translation), joint.rotation);
      if (robot.numbers_of_drives) next = fill(next, joint.drive);
      if (robot.numbers_of_pitches) joint.pitch = *next++;
    }
    next = frames.data();
    for (reflection::Frame& frame : frames_) next = fill(fill(next, frame.translation), frame.rotation);
    fill_couplings(robot, values);
    fill_tendons(robot, values);
    robot_.links.data = links_.data();
    robot_.joints.data = joints_.data();
    robot_.frames.data = frames_.data();
  }
  RobotOf(const RobotOf&) = delete;
  RobotOf& operator=(const RobotOf&) = delete;

  const Robot& robot() const { return robot_; }

 private:
  static constexpr std::size_t kOfLink = 10, kOfPlacement = 6, kOfDrive = 11;

  template <int n>
  static const double* fill(const double* from, double (&to)[n]) {
    std::copy(from, from + n, to);
    return from + n;
  }

  static const double* fill(const double* from, JointDrive& drive) {
    for (double* number :
         {&drive.damping, &drive.friction, &drive.friction_velocity, &drive.armature, &drive.stiffness, &drive.rest,
          &drive.rotor_inertia, &drive.rotor_ratio})
      *number = *from++;
    return fill(from, drive.rotor_axis);
  }

  void fill_couplings(const Robot& robot, const std::vector<double>& values) {
    if (robot.couplings.size == 0) return;
    const auto dof = static_cast<std::size_t>(robot.dof());
    coupling_numbers_.resize((dof + 1) * static_cast<std::size_t>(robot.couplings.size));
    robot.coupling_numbers(values.data(), coupling_numbers_.data());
    for (const double* next = coupling_numbers_.data();
         couplings_.size() < static_cast<std::size_t>(robot.couplings.size); next += dof + 1)
      couplings_.push_back({next, next[dof], robot.couplings[static_cast<int>(couplings_.size())].assembled});
    robot_.couplings.data = couplings_.data();
  }

  void fill_tendons(const Robot& robot, const std::vector<double>& values) {
    if (robot.tendons.size == 0) return;
    const std::size_t joints = joints_.size(), of_tendon = joints + 3;
    tendon_numbers_.resize(of_tendon * static_cast<std::size_t>(robot.tendons.size));
    robot.tendon_numbers(values.data(), tendon_numbers_.data());
    const double* next = tendon_numbers_.data();
    for (const reflection::Tendon& tendon : robot.tendons) {
      tendons_.push_back({tendon.name, next, next[joints], next[joints + 1], next[joints + 2]});
      next += of_tendon;
    }
    robot_.tendons.data = tendons_.data();
  }

  std::vector<reflection::Link> links_;
  std::vector<reflection::Joint> joints_;
  std::vector<reflection::Frame> frames_;
  std::vector<double> coupling_numbers_;
  std::vector<reflection::Coupling> couplings_;
  std::vector<double> tendon_numbers_;
  std::vector<reflection::Tendon> tendons_;
  Robot robot_;
};

// The declared defaults, or nullopt if a parameter has none.
inline std::optional<std::vector<double>> default_values(const Robot& robot) {
  std::vector<double> values;
  for (const reflection::Parameter& p : robot.parameters) values.push_back(p.default_value);
  for (const double value : values)
    if (std::isnan(value)) return std::nullopt;
  return values;
}

// True if a body can have these mass properties: a positive mass, and a positive definite inertia about the centre of
// mass whose smallest moment is larger than `share` of the sum of moments. Massless links are accepted.
inline bool is_body(const reflection::Link& link, double share) {
  const auto [xx, yy, zz, xy, xz, yz] = link.inertia;
  if (link.mass == 0) return xx == 0 && yy == 0 && zz == 0;
  const auto [x, y, z] = link.com;
  const double m = link.mass;
  // Sylvester's criterion for the inertia minus `least` times the identity.
  const double least = share * (std::abs(xx) + std::abs(yy) + std::abs(zz));
  const double a = xx - m * (y * y + z * z) - least, b = yy - m * (x * x + z * z) - least;
  const double c = zz - m * (x * x + y * y) - least;
  const double d = -(xy - m * x * y), e = -(xz - m * x * z), f = -(yz - m * y * z);
  const double minor = a * b - d * d;
  return m > 0 && a > 0 && minor > 0 && minor * c - a * f * f + 2 * d * e * f - b * e * e > 0;
}

// One random value: near the default, or else about the size of a limb. The sign and the size of a parameter without
// default are random, too, but the result must be a body.
inline double random_value(std::mt19937_64& engine, const reflection::Parameter& p) {
  if (!std::isnan(p.default_value)) return p.default_value * (1 + uniform(engine, 0.2)) + uniform(engine, 0.01);
  if (!p.dynamics) return uniform(engine, 1.5);
  const double size = std::exp(uniform(engine, 3));  // 0.05 to 20
  return uniform(engine, 1) < -0.5 ? -size : size;
}

// The mass properties of a link.
inline std::vector<double> numbers_of(const reflection::Link& link) {
  std::vector<double> numbers = {link.mass};
  numbers.insert(numbers.end(), std::begin(link.com), std::end(link.com));
  numbers.insert(numbers.end(), std::begin(link.inertia), std::end(link.inertia));
  return numbers;
}

// For each link, the parameters that change its mass properties.
inline std::vector<std::vector<int>> dependencies(const Robot& robot, const std::vector<double>& values) {
  std::vector<std::vector<int>> result(static_cast<std::size_t>(robot.links.size));
  const RobotOf here(robot, values);
  for (int k = 0; k < robot.parameters.size; ++k) {
    std::vector<double> others = values;
    others[static_cast<std::size_t>(k)] += 0.125;
    const RobotOf there(robot, others);
    for (int i = 0; i < robot.links.size; ++i) {
      if (numbers_of(here.robot().links[i]) != numbers_of(there.robot().links[i]))
        result[static_cast<std::size_t>(i)].push_back(k);
    }
  }
  return result;
}

// Random values for which all links that depend on them are bodies, or nullopt if none were found. While a link is not
// a body, the parameters that it depends on are drawn again.
inline std::optional<std::vector<double>> random_values(std::mt19937_64& engine, const Robot& robot) {
  constexpr int kTries = 20000;
  // The first attempt demands moderate condition numbers, but some documents can only express rods and point masses.
  for (const double share : {0.01, -1e-9}) {
    std::vector<double> values;
    for (const reflection::Parameter& p : robot.parameters) values.push_back(random_value(engine, p));
    const std::vector<std::vector<int>> redrawn = dependencies(robot, values);
    for (int i = 0; i < kTries; ++i) {
      const RobotOf made(robot, values);
      int wrong = 0;
      while (wrong < robot.links.size &&
             (redrawn[static_cast<std::size_t>(wrong)].empty() || is_body(made.robot().links[wrong], share)))
        ++wrong;
      if (wrong == robot.links.size) return values;
      for (const int k : redrawn[static_cast<std::size_t>(wrong)])
        values[static_cast<std::size_t>(k)] = random_value(engine, robot.parameters[k]);
    }
  }
  return std::nullopt;
}

}  // namespace robcogen::reference
