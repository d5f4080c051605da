#include "interpreted_robot.h"

#include <algorithm>
#include <optional>

namespace robcogen::numeric {
namespace {

using reference::Arguments;
using reference::Matrix;
using reference::Vector;

Matrix<double> matrix(const std::vector<double>& values, int rows) {
  Matrix<double> m(rows, rows == 0 ? 0 : static_cast<int>(values.size()) / rows);
  std::copy(values.begin(), values.end(), m.data());
  return m;
}

Vector<double> vector(const std::vector<double>& values) {
  Vector<double> v(static_cast<int>(values.size()));
  std::copy(values.begin(), values.end(), v.data());
  return v;
}

// Returns the frame quantity of a role, or nullopt if the reference has no check of it.
std::optional<reflection::FrameQuantity> frame_quantity(symbolic::Role role) {
  using reflection::FrameQuantity;
  switch (role) {
    case symbolic::Role::jacobian_in_target:
      return FrameQuantity::jacobian_in_target;
    case symbolic::Role::spatial_jacobian:
      return FrameQuantity::spatial_jacobian;
    case symbolic::Role::jacobian_derivative:
      return FrameQuantity::jacobian_derivative;
    case symbolic::Role::frame_bias_acceleration:
      return FrameQuantity::frame_bias_acceleration;
    case symbolic::Role::frame_velocity:
      return FrameQuantity::frame_velocity;
    case symbolic::Role::frame_acceleration:
      return FrameQuantity::frame_acceleration;
    default:
      return std::nullopt;
  }
}

constexpr std::size_t kFewJoints = 6;

// The formulation of these steps in these link frames. Leaves the passes in `steps`.
algorithm::Formulation formulation_of(std::vector<std::string>& steps, const algorithm::LinkFrames& frames) {
  algorithm::Formulation formulation = algorithm::take_formulation(steps);
  formulation.frames = frames;
  return formulation;
}

std::string pair_name(const std::string& left, const std::string& letter, const std::string& right) {
  return left + "_" + letter + "_" + right;
}

}  // namespace

const std::vector<std::string>& all_steps() {
  static const std::vector<std::string> all = [] {
    std::vector<std::string> list = algorithm::choices();
    list.insert(list.end(), pass::names().begin(), pass::names().end());
    return list;
  }();
  return all;
}

InterpretedRobot::InterpretedRobot(
    const model::KinematicTree& robot,
    const model::DesiredTransforms& desired,
    const std::vector<std::string>& steps,
    std::vector<double> parameters,
    const algorithm::LinkFrames& frames,
    const std::vector<std::string>& groups)
    : tree_(robot),
      desired_(desired),
      passes_(steps),
      choices_(tree_, formulation_of(passes_, frames)),
      floating_(robot.floating_base),
      dof_(robot.dof()),
      parameters_(std::move(parameters)),
      tables_(reference_tables(robot, parameters_)) {
  for (const model::FramePair& pair : desired.transforms)
    tables_.add_transform(
        pair_name(pair.left.name, "X", pair.right.name), frame_index(robot, pair.left), frame_index(robot, pair.right));
  const bool is_small = robot.joints.size() - 2 * robot.spherical_joints().size() <= kFewJoints;
  for (const std::string& group : groups.empty() ? algorithm::groups() : groups) {
    if (groups.empty() && !is_small && group.find("regressor") != std::string::npos) continue;
    for (const algorithm::Declared& function : algorithm::declared(tree_, desired_, group)) {
      add_to_tables(function);
      declared_.emplace(function.kernel, function);
    }
  }
}

void InterpretedRobot::add_to_tables(const algorithm::Declared& function) {
  const symbolic::Role role = algorithm::outline(function).outputs.front().role;
  const bool is_jacobian = function.is->group == std::string("jacobians") && symbolic::is_jacobian(role);
  const auto quantity = frame_quantity(role);
  if (!is_jacobian && !quantity) return;
  const std::vector<int> columns = algorithm::described(function).columns;
  const model::FramePair& frames = function.subject.frames;
  const int left = frame_index(tree_, frames.left), right = frame_index(tree_, frames.right);
  if (is_jacobian) tables_.add_jacobian(function.kernel, left, right, columns);
  if (quantity) tables_.add_frame_function(function.kernel, *quantity, left, right, columns);
}

const symbolic::Program& InterpretedRobot::program(const std::string& name) const {
  const auto found = programs_.find(name);
  if (found != programs_.end()) return found->second;
  symbolic::Program traced = algorithm::trace(declared_.at(name), choices_).program;
  return programs_.emplace(name, pass::run(std::move(traced), passes_)).first->second;
}

const std::map<std::string, symbolic::Program>& InterpretedRobot::programs() const {
  for (const auto& [name, function] : declared_) program(name);
  return programs_;
}

void InterpretedRobot::replace(symbolic::Program program) {
  const std::string name = declared_.at(program.name).kernel;
  programs_.insert_or_assign(name, std::move(program));
}

symbolic::Arrays<double> InterpretedRobot::run(
    const std::string& function,
    const Arguments& arguments,
    symbolic::Arrays<double> inputs) const {
  // The overloads: standard gravity folded (fixed base only), gravity, gravity and external wrenches.
  const std::string gravity_only = floating_ ? "" : "_gravity";
  std::string name = function;
  if (arguments.gravity != nullptr) name = function + gravity_only;
  // With gravity as an argument the base parameters are different ones.
  if (arguments.gravity != nullptr && has(function + "_any_gravity")) name = function + "_any_gravity";
  if (arguments.external != nullptr) name = function + "_external";
  inputs["gravity"] = arguments.gravity != nullptr ? arguments.gravity->values() : std::vector<double>{0, 0, -9.81};
  if (arguments.external != nullptr) {
    std::vector<double>& flat = inputs["external"];
    for (const Vector<double>& wrench : *arguments.external) {
      for (int k = 0; k < 6; ++k) flat.push_back(wrench(k));
    }
  }
  inputs["parameters"] = parameters_;
  const symbolic::Program& program = this->program(name);
  std::erase_if(inputs, [&](const auto& given) {
    return std::none_of(program.inputs.begin(), program.inputs.end(), [&](const symbolic::InputArray& array) {
      return array.name == given.first;
    });
  });
  return symbolic::interpret(program, inputs);
}

symbolic::Arrays<double> InterpretedRobot::inputs_of(const State& m) const {
  return {
      {"q", m.q.values()},
      {"qd", m.qd.values()},
      {"qdd", m.qdd.values()},
      {"base_velocity", m.base_velocity.values()},
      {"base_acceleration", m.base_acceleration.values()}};
}

namespace {

Vector<double> base_and_joints(
    bool floating,
    const symbolic::Arrays<double>& results,
    const std::string& base,
    const std::string& joints) {
  const Vector<double> found = vector(results.at(joints));
  return floating ? stacked(vector(results.at(base)), found) : found;
}

}  // namespace

Vector<double> InterpretedRobot::inverse_dynamics(const State& m, const Arguments& arguments) const {
  return base_and_joints(floating_, run("inverse_dynamics", arguments, inputs_of(m)), "base_acceleration", "tau");
}

Vector<double> InterpretedRobot::inverse_dynamics_fully_actuated(const State& m, const Arguments& arguments) const {
  if (!floating_) return inverse_dynamics(m, arguments);
  return base_and_joints(
      floating_, run("inverse_dynamics_fully_actuated", arguments, inputs_of(m)), "base_wrench", "tau");
}

Vector<double> InterpretedRobot::forward_dynamics(const State& m, const Vector<double>& tau, const Arguments& arguments)
    const {
  symbolic::Arrays<double> inputs = inputs_of(m);
  inputs["tau"] = tau.values();
  return base_and_joints(floating_, run("forward_dynamics", arguments, inputs), "base_acceleration", "qdd");
}

Vector<double> InterpretedRobot::bias_forces(const State& m, const Arguments& arguments) const {
  return base_and_joints(floating_, run("bias_forces", arguments, inputs_of(m)), "base_wrench", "tau");
}

Vector<double> InterpretedRobot::gravity_forces(const Vector<double>& q, const Arguments& arguments) const {
  const Arguments gravity{arguments.gravity, nullptr};
  return base_and_joints(floating_, run("gravity_forces", gravity, {{"q", q.values()}}), "base_wrench", "tau");
}

Vector<double> InterpretedRobot::coriolis_forces(const State& m) const {
  return base_and_joints(floating_, run("coriolis_forces", {}, inputs_of(m)), "base_wrench", "tau");
}

Vector<double> InterpretedRobot::passive_forces(const State& m) const {
  return vector(run("passive_forces", {}, inputs_of(m)).at("tau"));
}

Matrix<double> InterpretedRobot::joint_space_inertia(const Vector<double>& q) const {
  return matrix(run("joint_space_inertia", {}, {{"q", q.values()}}).at("H"), floating_ ? 6 + dof_ : dof_);
}

reference::FactorResults InterpretedRobot::inertia_factor(const Vector<double>& q, const Vector<double>& x) const {
  symbolic::Arrays<double> inputs = run("joint_space_inertia_factor", {}, {{"q", q.values()}});
  const int n = x.rows();
  const std::vector<double> L = inputs.at("L");
  const auto result = [&](const std::string& function, const char* output) {
    return run("inertia_factor_" + function, {}, inputs).at(output);
  };
  inputs["x"] = x.values();
  return {
      matrix(L, n), matrix(result("inverse_L", "inverse"), n), matrix(result("inverse", "inverse"), n),
      vector(result("solve", "y"))};
}

Matrix<double> InterpretedRobot::coriolis_matrix(const State& m) const {
  return matrix(run("coriolis_matrix", {}, inputs_of(m)).at("C"), floating_ ? 6 + dof_ : dof_);
}

reference::MomentumAndRate InterpretedRobot::generalized_momentum(const State& m, const Arguments& arguments) const {
  const auto results = run("generalized_momentum", {arguments.gravity, nullptr}, inputs_of(m));
  return {vector(results.at("p")), vector(results.at("rate"))};
}

reference::PathTerms InterpretedRobot::path_dynamics(const State& m, const Arguments& arguments) const {
  const auto results = run("path_dynamics", {arguments.gravity, nullptr}, inputs_of(m));
  return {vector(results.at("a")), vector(results.at("b")), vector(results.at("c"))};
}

reference::Derivatives InterpretedRobot::derivatives(
    const symbolic::Arrays<double>& results,
    const std::string& base,
    const std::string& joints) const {
  const int rows = floating_ ? 6 + dof_ : dof_;
  // A block that the function lacks has no columns.
  const auto block = [&](const std::string& array) {
    const auto found = results.find(array);
    return found == results.end() ? Matrix<double>(rows, 0) : matrix(found->second, rows);
  };
  return {
      results.contains(joints) ? base_and_joints(floating_, results, base, joints) : Vector<double>(),
      block("d_q"),
      block("d_qd"),
      block(joints == "qdd" ? "d_tau" : "d_qdd"),
      block("d_base_rotation"),
      block("d_base_velocity"),
      block("d_base_acceleration")};
}

reference::Derivatives InterpretedRobot::inverse_dynamics_fully_actuated_derivatives(
    const State& m,
    const Arguments& arguments) const {
  const std::string name = floating_ ? "inverse_dynamics_fully_actuated_derivatives" : "inverse_dynamics_derivatives";
  return derivatives(run(name, arguments, inputs_of(m)), "base_wrench", "tau");
}

reference::Derivatives InterpretedRobot::inverse_dynamics_derivatives(const State& m, const Arguments& arguments)
    const {
  return derivatives(run("inverse_dynamics_derivatives", arguments, inputs_of(m)), "base_acceleration", "tau");
}

reference::Derivatives InterpretedRobot::forward_dynamics_derivatives(
    const State& m,
    const Vector<double>& tau,
    const Arguments& arguments) const {
  symbolic::Arrays<double> inputs = inputs_of(m);
  inputs["tau"] = tau.values();
  return derivatives(run("forward_dynamics_derivatives", arguments, inputs), "base_acceleration", "qdd");
}

reference::Derivatives InterpretedRobot::inverse_dynamics_gradient(
    const State& m,
    const Vector<double>& weights,
    const Arguments& arguments) const {
  symbolic::Arrays<double> inputs = inputs_of(m);
  inputs["weights"] = weights.values();
  const symbolic::Arrays<double> results = run("inverse_dynamics_gradient", arguments, inputs);
  const auto column = [&](const std::string& array) {
    return results.contains(array) ? vector(results.at(array)) : Vector<double>();
  };
  return {
      base_and_joints(floating_, results, "base_wrench", "tau"),
      column("d_q"),
      column("d_qd"),
      column("d_qdd"),
      {},
      column("d_base_velocity"),
      column("d_base_acceleration")};
}

reference::Derivatives InterpretedRobot::gravity_forces_derivative(const Vector<double>& q, const Arguments& arguments)
    const {
  const Arguments gravity{arguments.gravity, nullptr};
  return derivatives(run("gravity_forces_derivative", gravity, {{"q", q.values()}}), "base_wrench", "tau");
}

Matrix<double> InterpretedRobot::regressor(const State& m, const Arguments& arguments) const {
  return matrix(run("regressor", arguments, inputs_of(m)).at("Y"), rows());
}

Matrix<double> InterpretedRobot::drive_regressor(const State& m) const {
  return matrix(run("drive_regressor", {}, inputs_of(m)).at("Y"), rows());
}

Vector<double> InterpretedRobot::inertial_parameters() const {
  return vector(run("inertial_parameters", {}, {}).at("pi"));
}

Vector<double> InterpretedRobot::drive_parameters() const {
  return vector(run("drive_parameters", {}, {}).at("pi"));
}

Matrix<double> InterpretedRobot::base_regressor(const State& m, const Arguments& arguments) const {
  return matrix(run("base_regressor", arguments, inputs_of(m)).at("Y"), rows());
}

Vector<double> InterpretedRobot::base_parameters(const Vector<double>& inertial_parameters, const Arguments& arguments)
    const {
  const symbolic::Arrays<double> inputs = {{"inertial_parameters", inertial_parameters.values()}};
  return vector(run("base_parameters", arguments, inputs).at("beta"));
}

Matrix<double> InterpretedRobot::energy_regressor(const State& m, const Arguments& arguments) const {
  return matrix(run("energy_regressor", arguments, inputs_of(m)).at("Y"), 2);
}

Matrix<double> InterpretedRobot::slotine_li_regressor(const State& m, const State& r, const Arguments& arguments)
    const {
  symbolic::Arrays<double> inputs = inputs_of(m);
  inputs["qd_r"] = r.qd.values();
  inputs["qdd_r"] = r.qdd.values();
  inputs["base_velocity_r"] = r.base_velocity.values();
  inputs["base_acceleration_r"] = r.base_acceleration.values();
  return matrix(run("slotine_li_regressor", arguments, inputs).at("Y"), rows());
}

Vector<double> InterpretedRobot::center_of_mass(const Vector<double>& q) const {
  return vector(run("center_of_mass", {}, {{"q", q.values()}}).at("com"));
}

Matrix<double> InterpretedRobot::center_of_mass_jacobian(const Vector<double>& q) const {
  return matrix(run("center_of_mass_jacobian", {}, {{"q", q.values()}}).at("J"), 3);
}

Matrix<double> InterpretedRobot::centroidal_momentum_matrix(const Vector<double>& q) const {
  return matrix(run("centroidal_momentum_matrix", {}, {{"q", q.values()}}).at("A"), 6);
}

double InterpretedRobot::kinetic_energy(const State& m) const {
  return run("kinetic_energy", {}, inputs_of(m)).at("T").front();
}

double InterpretedRobot::potential_energy(const Vector<double>& q, const Arguments& arguments) const {
  return run("potential_energy", {arguments.gravity, nullptr}, {{"q", q.values()}}).at("V").front();
}

reference::TransformForms InterpretedRobot::transform(int index, const Vector<double>& q) const {
  const std::string name = tables_.robot().transforms[index].name;
  const auto form = [&](const std::string& prefix, int rows) {
    return matrix(run(prefix + name, {}, {{"q", q.values()}}).at("X"), rows);
  };
  return {form("homogeneous_", 4), form("motion_", 6), form("force_", 6)};
}

Matrix<double> InterpretedRobot::jacobian(int index, const Vector<double>& q) const {
  return matrix(run(tables_.robot().jacobians[index].name, {}, {{"q", q.values()}}).at("J"), 6);
}

Matrix<double> InterpretedRobot::frame_function(int index, const State& m) const {
  return matrix(run(tables_.robot().frame_functions[index].name, {}, inputs_of(m)).begin()->second, 6);
}

reference::Checks check_all(const InterpretedRobot& robot, std::uint64_t seed, int samples) {
  const reflection::Robot tables = robot.tables();
  reference::Checks checks;
  std::mt19937_64 engine(seed);
  for (int i = 0; i < samples; ++i) {
    reference::Sample sample;
    const reference::AtLoops closed = draw(engine, tables, sample);
    const reference::Case c(closed.robot(), sample, i, &closed);
    check_functions(robot, c, checks);
    check_passive_forces(robot, c, checks);
    check_inverse_dynamics_gradient(robot, c, checks);
    if (robot.has("regressor")) {
      check_parameters_of_regressors(robot, c, checks);
      check_regressor(robot, c, checks);
      check_base_regressor(robot, c, checks);
      check_energy_regressor(robot, c, checks);
      check_slotine_li_regressor(robot, c, checks);
    }
    check_inverse_dynamics_derivatives(robot, c, checks);
    check_free_inverse_dynamics_derivatives(robot, c, checks);
    check_gravity_forces_derivative(robot, c, checks);
    // Large robots lack these derivatives.
    if (robot.has("forward_dynamics_derivatives")) check_forward_dynamics_derivatives(robot, c, checks);
  }
  return checks;
}

}  // namespace robcogen::numeric
