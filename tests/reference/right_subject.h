// A correct subject of checks, which tests of the checks make wrong.
#pragma once

#include "sample_robots.h"

#include "robcogen/reference/subject.h"

namespace robcogen::reference {

// The reference in double precision, as the subject of checks.
class Right {
 public:
  explicit Right(const Robot& robot) : robot_(robot) {}
  virtual ~Right() = default;

  virtual Vector<double> inverse_dynamics(const Motion<double>& m, const Arguments& arguments) const;
  virtual Vector<double> inverse_dynamics_fully_actuated(const Motion<double>& m, const Arguments& arguments) const;
  virtual Vector<double> forward_dynamics(
      const Motion<double>& m,
      const Vector<double>& tau,
      const Arguments& arguments) const;
  virtual Vector<double> bias_forces(const Motion<double>& m, const Arguments& arguments) const;
  virtual Vector<double> gravity_forces(const Vector<double>& q, const Arguments& arguments) const;
  virtual Vector<double> coriolis_forces(const Motion<double>& m) const;
  virtual Matrix<double> joint_space_inertia(const Vector<double>& q) const;
  virtual FactorResults inertia_factor(const Vector<double>& q, const Vector<double>& x) const;
  virtual Matrix<double> centroidal_momentum_matrix(const Vector<double>& q) const;
  virtual Vector<double> center_of_mass(const Vector<double>& q) const;
  virtual Matrix<double> center_of_mass_jacobian(const Vector<double>& q) const;
  virtual double kinetic_energy(const Motion<double>& m) const;
  virtual double potential_energy(const Vector<double>& q, const Arguments& arguments) const;
  virtual Matrix<double> coriolis_matrix(const Motion<double>& m) const;
  virtual MomentumAndRate generalized_momentum(const Motion<double>& m, const Arguments& arguments) const;
  virtual PathTerms path_dynamics(const Motion<double>& m, const Arguments& arguments) const;
  virtual TransformForms transform(int index, const Vector<double>& q) const;
  virtual Matrix<double> jacobian(int index, const Vector<double>& q) const;
  virtual Matrix<double> frame_function(int index, const Motion<double>& m) const;

 protected:
  static Loads<double> loads(const Arguments& arguments);
  Vector<double> joined(const Forces<double>& forces) const;

  Motion<double> unit_motion(const Vector<double>& q, int coordinate) const;

  Robot robot_;
};

// The same subject with derivatives: differences, column by column, which take time.
class RightDerivatives : public Right {
 public:
  using Right::Right;

  virtual Derivatives inverse_dynamics_fully_actuated_derivatives(const Motion<double>& m, const Arguments& arguments)
      const;
  virtual Derivatives inverse_dynamics_derivatives(const Motion<double>& m, const Arguments& arguments) const;
  virtual Derivatives forward_dynamics_derivatives(
      const Motion<double>& m,
      const Vector<double>& tau,
      const Arguments& arguments) const;
  virtual Derivatives inverse_dynamics_gradient(
      const Motion<double>& m,
      const Vector<double>& weights,
      const Arguments& arguments) const;
  virtual Derivatives gravity_forces_derivative(const Vector<double>& q, const Arguments& arguments) const;
};

// The robot of these tests, a crooked tree with transforms, Jacobians and functions of frames.
Tables sample(bool floating);

// The report of the checks that fail for a subject. A RightDerivatives is checked for its derivatives, too.
std::string failures(const Right& subject, const Robot& robot);

// The report for a subject made from the tables.
template <class Subject>
std::string failures(bool floating) {
  const Tables tables = sample(floating);
  const Robot robot = tables.robot();
  return failures(Subject(robot), robot);
}

// Expects that all of the named checks fail, for these bases.
template <class Wrong>
void expect_found(const std::vector<std::string>& names, const std::vector<bool>& bases = {false, true}) {
  for (const bool floating : bases) {
    expect_failures(failures<Wrong>(floating), names);
  }
}

}  // namespace robcogen::reference
