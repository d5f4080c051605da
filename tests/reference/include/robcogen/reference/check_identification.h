// Checks of regressors: multiplied by the parameters of the tables, they are the forces and energies of the reference.
// Each function records the errors of one sample.
#pragma once

#include "robcogen/reference/check_control.h"

namespace robcogen::reference {

inline constexpr Tolerance kParameter{"kParameter", 1e-14, "a product or a sum of few numbers of the document"};

// The robot of a case without its drives and tendons.
class Undriven {
 public:
  explicit Undriven(const Case& c) : joints_(c.robot.joints.begin(), c.robot.joints.end()), robot_(c.robot) {
    for (reflection::Joint& joint : joints_) joint.drive = {};
    robot_.joints = {joints_.data(), static_cast<int>(joints_.size())};
    robot_.tendons = {nullptr, 0};
  }
  Undriven(const Undriven&) = delete;
  Undriven& operator=(const Undriven&) = delete;

  const Robot& robot() const { return robot_; }

 private:
  std::vector<reflection::Joint> joints_;
  Robot robot_;
};

// Ten numbers per moving link: mass, first moment, moments and products of inertia about the link's origin.
inline Vector<Real> inertial_parameters_of(const Robot& robot) {
  std::vector<Real> numbers;
  for (int i = first_moving_link(robot); i < robot.links.size; ++i) {
    const reflection::Link& link = robot.links[i];
    numbers.push_back(link.mass);
    for (const double x : link.com) numbers.push_back(static_cast<Real>(link.mass) * static_cast<Real>(x));
    for (const double x : link.inertia) numbers.push_back(x);
  }
  Vector<Real> result(static_cast<int>(numbers.size()));
  std::copy(numbers.begin(), numbers.end(), result.data());
  return result;
}

// For each joint inertia, damping, friction, stiffness and constant force; for each tendon stiffness, damping and
// constant force; then, for rotors on moving links, their
// momentum per unit rate of the joint.
inline Vector<Real> drive_parameters_of(const Robot& robot, bool passive) {
  std::vector<Real> numbers;
  for (const reflection::Joint& joint : robot.joints) {
    const JointDrive& d = joint.drive;
    const Real resists = passive ? 1 : 0;
    numbers.push_back(inertia_of<Real>(d));
    for (const double x : {d.damping, d.friction, d.stiffness}) numbers.push_back(resists * static_cast<Real>(x));
    numbers.push_back(-resists * static_cast<Real>(d.stiffness) * static_cast<Real>(d.rest));
  }
  for (const reflection::Tendon& tendon : robot.tendons) {
    for (const double x : {tendon.stiffness, tendon.damping}) numbers.push_back(x);
    numbers.push_back(-static_cast<Real>(tendon.stiffness) * static_cast<Real>(tendon.rest));
  }
  for (const reflection::Joint& joint : robot.joints)
    if (joint.drive.rotor_carrier >= first_moving_link(robot)) numbers.push_back(momentum_of_rotor<Real>(joint.drive));
  Vector<Real> result(static_cast<int>(numbers.size()));
  std::copy(numbers.begin(), numbers.end(), result.data());
  return result;
}

// Checks that a matrix times parameters is the expected vector; errors are relative to the terms of both.
inline void check_product(
    const std::string& name,
    const Case& c,
    const Matrix<double>& Y,
    const Vector<Real>& parameters,
    const Expected& expected,
    Checks& checks) {
  if (Y.cols() != parameters.rows()) {
    checks.record(name, kForce, std::numeric_limits<Real>::infinity(), c.index);
    return;
  }
  const Matrix<Real> matrix = Y.cast<Real>();
  const Vector<Real> product = matrix * parameters, terms = expected.terms + magnitude(matrix) * magnitude(parameters);
  checks.record(name, kForce, relative_error(product, expected.value, terms), c.index);
}

template <class Subject>
void check_parameters_of_regressors(const Subject& subject, const Case& c, Checks& checks) {
  const auto compare = [&](const char* name, const Vector<double>& found, const Vector<Real>& expected) {
    const bool fits = found.rows() == expected.rows();
    const Vector<Real> error = fits ? found.cast<Real>() - expected : expected;
    const Real scale = std::max(largest(expected), std::numeric_limits<Real>::min());
    checks.record(name, kParameter, fits ? largest(error) / scale : std::numeric_limits<Real>::infinity(), c.index);
  };
  compare("inertial_parameters", subject.inertial_parameters(), inertial_parameters_of(c.robot));
  compare("drive_parameters", subject.drive_parameters(), drive_parameters_of(c.robot, true));
}

// Checks the regressors of inverse dynamics: that of the links, and that of the drives.
template <class Subject>
void check_regressor(const Subject& subject, const Case& c, Checks& checks) {
  const Undriven bare(c);
  const Vector<Real> parameters = inertial_parameters_of(c.robot);
  const Motion<double>& m = c.sample.motion;
  for (const Overload& o : overloads(c.sample)) {
    if (o.arguments.external != nullptr) continue;
    const Vector<Real> forces = cut(c.floating, generalized_forces(bare.robot(), c.motion, o.loads));
    const Vector<Real> terms = expected_forces(c, m, o.loads).terms;
    check_product("regressor" + o.suffix, c, subject.regressor(m, o.arguments), parameters, {forces, terms}, checks);
  }
  const Loads<Real> none = loads<Real>(Vector<double>(3));
  const Vector<Real> all = generalized_forces(c.robot, c.motion, none),
                     without = generalized_forces(bare.robot(), c.motion, none);
  const Expected drives{cut(c.floating, all - without), expected_forces(c, m, none).terms};
  check_product(
      "drive_regressor", c, subject.drive_regressor(m), drive_parameters_of(c.robot, c.robot.passive_forces), drives,
      checks);
}

template <class Subject>
void check_base_regressor(const Subject& subject, const Case& c, Checks& checks) {
  const Undriven bare(c);
  const Vector<double> all = inertial_parameters_of(c.robot).cast<double>();
  const Motion<double>& m = c.sample.motion;
  for (const Overload& o : overloads(c.sample)) {
    if (o.arguments.external != nullptr) continue;
    const Expected expected{
        cut(c.floating, generalized_forces(bare.robot(), c.motion, o.loads)), expected_forces(c, m, o.loads).terms};
    check_product(
        "base_regressor" + o.suffix, c, subject.base_regressor(m, o.arguments),
        subject.base_parameters(all, o.arguments).template cast<Real>(), expected, checks);
  }
}

template <class Subject>
void check_energy_regressor(const Subject& subject, const Case& c, Checks& checks) {
  const Undriven bare(c);
  const Vector<Real> speeds = magnitude(coordinates(c.floating, c.motion.base_velocity, c.motion.qd));
  const Real kinetic_terms = dot(speeds, magnitude(c.H) * speeds) / 2;
  for (const Overload& o : overloads(c.sample)) {
    if (o.arguments.external != nullptr) continue;
    const Expected energies{
        {kinetic_energy(bare.robot(), c.motion), potential_energy(bare.robot(), c.motion.q, o.loads.gravity)},
        {kinetic_terms, 3 * largest(o.loads.gravity) * center_length(c, 1)}};
    check_product(
        "energy_regressor" + o.suffix, c, subject.energy_regressor(c.sample.motion, o.arguments),
        inertial_parameters_of(c.robot), energies, checks);
  }
}

// The Coriolis matrix that a Slotine-Li regressor implies, computed column by column, as a subject of
// check_coriolis_matrix.
template <class Subject>
class ImpliedCoriolisMatrix {
 public:
  ImpliedCoriolisMatrix(const Subject& subject, const Case& c)
      : subject_(subject), c_(c), parameters_(inertial_parameters_of(c.robot)) {}

  // H qdd_r + C qd_r + gravity forces.
  Vector<Real> forces(const Motion<double>& reference, const Arguments& arguments) const {
    return subject_.slotine_li_regressor(c_.sample.motion, reference, arguments).template cast<Real>() * parameters_;
  }

  Matrix<double> coriolis_matrix(const Motion<double>&) const {
    const Vector<Real> rest = forces(at_rest(c_.robot, c_.sample.motion.q), {});
    Matrix<double> C(rest.rows(), rest.rows());
    for (int k = 0; k < C.cols(); ++k) {
      Motion<double> unit = at_rest(c_.robot, c_.sample.motion.q);
      const int first = c_.floating ? 6 : 0;
      (k < first ? unit.base_velocity(k) : unit.qd(k - first)) = 1;
      C.set_block(0, k, (forces(unit, {}) - rest).template cast<double>());
    }
    return C;
  }

 private:
  const Subject& subject_;
  const Case& c_;
  Vector<Real> parameters_;
};

template <class Subject>
void check_slotine_li_regressor(const Subject& subject, const Case& c, Checks& checks) {
  const Undriven bare(c);
  const Motion<double>& m = c.sample.motion;
  const Vector<Real> parameters = inertial_parameters_of(c.robot);
  for (const Overload& o : overloads(c.sample)) {
    if (o.arguments.external != nullptr) continue;
    const std::string name = "slotine_li_regressor" + o.suffix;
    // The reference motion is the motion itself.
    const Expected forces{
        cut(c.floating, generalized_forces(bare.robot(), c.motion, o.loads)), expected_forces(c, m, o.loads).terms};
    check_product(name, c, subject.slotine_li_regressor(m, m, o.arguments), parameters, forces, checks);
    // The reference motion has no velocity.
    Motion<double> at_once = m;
    at_once.qd = Vector<double>(m.qd.rows());
    at_once.base_velocity = Vector<double>(6);
    at_once.of_loops = {};
    const Motion<Real> still = cast<Real>(at_once);
    Expected inertial{
        cut(c.floating, generalized_forces(bare.robot(), still, o.loads)), expected_forces(c, at_once, o.loads).terms};
    check_product(
        name + " of accelerations", c, subject.slotine_li_regressor(m, at_once, o.arguments), parameters, inertial,
        checks);
  }
  const Case undriven(bare.robot(), c.sample, c.index, c.loops);
  check_coriolis_matrix(ImpliedCoriolisMatrix<Subject>(subject, c), undriven, checks, "slotine_li_regressor: ");
}

}  // namespace robcogen::reference
