// The programs of a robot, run in the interpreter, as the subject of checks (robcogen/reference/subject.h).
#pragma once

#include <map>
#include <string>
#include <vector>

#include "algorithm/catalogue/catalogue.h"
#include "pass/passes.h"
#include "reference_tables.h"
#include "robcogen/reference/check_derivatives.h"
#include "robcogen/reference/check_functions.h"
#include "robcogen/reference/check_identification.h"
#include "robcogen/reference/loops.h"
#include "symbolic/interpret.h"

namespace robcogen::numeric {

// The names of the formulation choices, followed by those of the passes.
const std::vector<std::string>& all_steps();

class InterpretedRobot {
 public:
  using State = reference::Motion<double>;
  template <class Scalar>
  using Vector = reference::Vector<Scalar>;

  // The functions of these groups, traced in these link frames and optimised by `steps`. Without groups, all of them,
  // except the regressors of robots with many joints: their matrices are the largest. A function is traced when it
  // first runs.
  InterpretedRobot(
      const model::KinematicTree& robot,
      const model::DesiredTransforms& desired,
      const std::vector<std::string>& steps = all_steps(),
      std::vector<double> parameters = {},
      const algorithm::LinkFrames& frames = {},
      const std::vector<std::string>& groups = {});
  // Declared functions refer to members of this object.
  InterpretedRobot(const InterpretedRobot&) = delete;
  InterpretedRobot& operator=(const InterpretedRobot&) = delete;

  // The robot and its desired transforms and Jacobians; valid as long as this object.
  reflection::Robot tables() const { return tables_.robot(); }
  // All programs, by their unique names.
  const std::map<std::string, symbolic::Program>& programs() const;
  bool has(const std::string& name) const { return declared_.contains(name); }
  const symbolic::Program& program(const std::string& name) const;

  // Replaces the program of that name by another form of the same function.
  void replace(symbolic::Program program);

  // The members that checks call: see CompiledRobot.
  Vector<double> inverse_dynamics(const State& m, const reference::Arguments& arguments) const;
  Vector<double> inverse_dynamics_fully_actuated(const State& m, const reference::Arguments& arguments) const;
  Vector<double> forward_dynamics(const State& m, const Vector<double>& tau, const reference::Arguments& arguments)
      const;
  Vector<double> bias_forces(const State& m, const reference::Arguments& arguments) const;
  Vector<double> gravity_forces(const Vector<double>& q, const reference::Arguments& arguments) const;
  Vector<double> coriolis_forces(const State& m) const;
  Vector<double> passive_forces(const State& m) const;
  reference::Matrix<double> joint_space_inertia(const Vector<double>& q) const;
  reference::FactorResults inertia_factor(const reference::Vector<double>& q, const reference::Vector<double>& x) const;
  reference::Matrix<double> coriolis_matrix(const State& m) const;
  reference::MomentumAndRate generalized_momentum(const State& m, const reference::Arguments& arguments) const;
  reference::PathTerms path_dynamics(const State& m, const reference::Arguments& arguments) const;
  reference::Derivatives inverse_dynamics_fully_actuated_derivatives(
      const State& m,
      const reference::Arguments& arguments) const;
  reference::Derivatives inverse_dynamics_derivatives(const State& m, const reference::Arguments& arguments) const;
  reference::Derivatives forward_dynamics_derivatives(
      const State& m,
      const Vector<double>& tau,
      const reference::Arguments& arguments) const;
  reference::Derivatives inverse_dynamics_gradient(
      const State& m,
      const Vector<double>& weights,
      const reference::Arguments& arguments) const;
  reference::Derivatives gravity_forces_derivative(const Vector<double>& q, const reference::Arguments& arguments)
      const;
  reference::Matrix<double> regressor(const State& m, const reference::Arguments& arguments) const;
  reference::Matrix<double> drive_regressor(const State& m) const;
  Vector<double> inertial_parameters() const;
  Vector<double> drive_parameters() const;
  reference::Matrix<double> base_regressor(const State& m, const reference::Arguments& arguments) const;
  Vector<double> base_parameters(const Vector<double>& inertial_parameters, const reference::Arguments& arguments)
      const;
  reference::Matrix<double> energy_regressor(const State& m, const reference::Arguments& arguments) const;
  reference::Matrix<double> slotine_li_regressor(const State& m, const State& r, const reference::Arguments& arguments)
      const;
  Vector<double> center_of_mass(const Vector<double>& q) const;
  reference::Matrix<double> center_of_mass_jacobian(const Vector<double>& q) const;
  reference::Matrix<double> centroidal_momentum_matrix(const Vector<double>& q) const;
  double kinetic_energy(const State& m) const;
  double potential_energy(const Vector<double>& q, const reference::Arguments& arguments) const;
  reference::TransformForms transform(int index, const Vector<double>& q) const;
  reference::Matrix<double> jacobian(int index, const Vector<double>& q) const;
  reference::Matrix<double> frame_function(int index, const State& m) const;

  // Runs the overload that takes these optional arguments; ignores `inputs` that the program does not have.
  symbolic::Arrays<double> run(
      const std::string& function,
      const reference::Arguments& arguments,
      symbolic::Arrays<double> inputs) const;

 private:
  symbolic::Arrays<double> inputs_of(const State& m) const;
  // Combines the derivatives of the result of the base and of the result of the joints.
  reference::Derivatives derivatives(
      const symbolic::Arrays<double>& results,
      const std::string& base,
      const std::string& joints) const;

  int rows() const { return floating_ ? 6 + dof_ : dof_; }

  model::KinematicTree tree_;
  model::DesiredTransforms desired_;
  std::vector<std::string> passes_;
  mutable algorithm::FormulationChoices choices_;
  bool floating_;
  int dof_;
  std::vector<double> parameters_;
  reference::Tables tables_;
  std::map<std::string, algorithm::Declared> declared_;        // by their unique names
  mutable std::map<std::string, symbolic::Program> programs_;  // those that were traced

  void add_to_tables(const algorithm::Declared& function);
};

// Runs all checks on all samples: P1 to P5 of the dynamics and kinematics, and all results against the reference.
reference::Checks check_all(const InterpretedRobot& robot, std::uint64_t seed, int samples);

}  // namespace robcogen::numeric
