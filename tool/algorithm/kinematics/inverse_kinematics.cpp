#include "algorithm/kinematics/inverse_kinematics.h"

#include <algorithm>
#include <optional>
#include <utility>

#include "algorithm/kinematics/inverse/calibration.h"
#include "algorithm/kinematics/inverse/swivel.h"
#include "algorithm/kinematics/inverse/words.h"
#include "algorithm/spatial/trace.h"
#include "support/number.h"

namespace robcogen::algorithm {
namespace {

using inversion::Branch;
using inversion::JointValue;
using inversion::Plan;
using model::InverseTask;
using symbolic::Program;
using symbolic::Role;

// The joints to which signs belong.
std::vector<std::string> sign_names(const inversion::Search& found) {
  if (found.swivel) return found.swivel->sign_names();
  std::vector<std::string> names;
  for (const inversion::Step& step : found.plan->steps)
    if (step.has_two_roots(found.chain)) names.push_back(found.chain.axis(step.joint).name);
  return names;
}

// A solver in the trace of a function, with its inputs.
class Inversion {
 public:
  Inversion(const model::KinematicTree& tree, const model::FramePair& frames, const InverseTask& task)
      : trace(tree), found(inversion::search(tree, frames, task)), chain(found.chain) {
    for (const model::Quantity& amount : inversion::parametric_amounts(tree, frames))
      amounts_.push_back(trace.lift(amount));
  }

  Trace trace;
  const inversion::Search& found;
  const inversion::SerialChain& chain;
  Expression swivel;
  std::vector<Expression> reference;  // by joint of the robot
  inversion::Target target;
  inversion::JointValues known;

  void target_input() {
    if (chain.task.kind == InverseTask::Kind::point) {
      for (std::size_t k = 0; k < 3; ++k) target.rotation[k][k] = trace.graph.one();
      target.position = trace.vector_input("p", Role::position);
      return;
    }
    std::vector<std::string> elements;
    for (const char column : {'x', 'y', 'z', 'p'})
      for (const char row : {'x', 'y', 'z', 'w'}) elements.push_back({row, column});
    const std::vector<Expression> X = trace.input("X", Role::homogeneous, elements);
    for (std::size_t row = 0; row < 3; ++row) {
      for (std::size_t column = 0; column < 3; ++column) target.rotation[row][column] = X[4 * column + row];
      target.position[row] = X[12 + row];
    }
    for (const inversion::ToolSlide& slide : chain.tool_slides)
      tool_length_ += slide.sign < 0.0 ? -amounts_[at(slide.amount)] : amounts_[at(slide.amount)];
    if (chain.tool_slides.empty()) return;
    for (std::size_t row = 0; row < 3; ++row) target.position[row] -= tool_length_ * target.rotation[row][2];
  }

  void swivel_input() {
    if (chain.task.by_swivel) swivel = trace.input("swivel", Role::value, {"swivel"}).front();
  }

  void reference_input() {
    reference = trace.joint_input("reference", Role::joint_reference);
    known.resize(chain.axes.size());
    for (int k = 0; k < chain.joints; ++k)
      if (chain.is_known(k)) known[at(k)] = value_of(k, reference);
  }

  // `q` by joint of the robot.
  JointValue value_of(int k, const std::vector<Expression>& q) {
    const Expression position = position_of(k, q);
    if (!chain.axis(k).turns) return {position, trace.graph.one()};
    return {sin(position), cos(position)};
  }

  inversion::JointValues values_at(const std::vector<Expression>& q) {
    inversion::JointValues values(chain.axes.size());
    for (int k = 0; k < chain.joints; ++k) values[at(k)] = value_of(k, q);
    return values;
  }

  std::vector<Branch> branches(const std::vector<Expression>* signs) {
    if (found.swivel)
      return inversion::swivel_branches(trace.graph, *found.swivel, target, references(), swivel, signs, margin());
    inversion::StepSolver s = solver();
    return inversion::branches(trace.graph, s, chain, found.plan->steps, known, signs);
  }

  // Completes a branch: returns its misfit, after Newton steps if the chain is calibrated.
  Expression finish(Branch& branch) {
    const Expression missed = misfit(branch);
    if (chain.tool_slides.empty()) return missed;
    // Where the axis is off by an angle, its end is off by this times the length (Cauchy).
    return sqrt(trace.graph.one() + tool_length_ * tool_length_) * missed;
  }

  Expression determinant(const Branch& branch) {
    const double factor = found.plan ? found.plan->determinant_per_root : 0.0;
    return factor == 0.0 ? branch.product : trace.graph.constant(factor) * branch.product;
  }

  // The roots at known positions.
  std::vector<Expression> roots(const inversion::JointValues& values) {
    if (found.swivel) return inversion::swivel_roots(trace.graph, *found.swivel, references(), values);
    std::vector<Expression> result;
    const inversion::StepSolver s = solver();
    for (const inversion::Step& step : found.plan->steps) {
      if (!step.has_two_roots(chain)) continue;
      trace.section(chain.axis(step.joint).name, "joint " + describe(chain, step));
      result.push_back(s.root(step, values));
    }
    return result;
  }

 private:
  std::vector<Expression> amounts_;  // that depend on parameters
  Expression tool_length_;           // by which the target is moved along its axis

  Expression misfit(Branch& branch) {
    if (found.calibration) {
      const inversion::NewtonSteps newton =
          inversion::newton_steps(trace.graph, *found.calibration, found, target, swivel);
      inversion::RefinedBranch refined = inversion::refined(*found.calibration, newton, branch.values);
      branch.values = std::move(refined.values);
      return refined.misfit;
    }
    trace.graph.begin_section("pose of the branch", "end");
    const inversion::Closure& closure = found.swivel ? found.swivel->closure : found.plan->closure;
    return inversion::misfit(trace.graph, {trace.graph, chain, target}, closure, branch.values);
  }

  Expression position_of(int k, const std::vector<Expression>& q) const {
    return chain.is_parametric(k) ? amounts_[at(chain.axis(k).amount)] : q[at(chain.axis(k).joint)];
  }

  std::vector<Expression> references() {
    std::vector<Expression> of_chain;
    for (int k = 0; k < chain.joints; ++k) of_chain.push_back(position_of(k, reference));
    return of_chain;
  }

  inversion::StepSolver solver() {
    return {trace.graph, chain, target, references(), found.plan ? found.plan->lengths_agree : std::vector<bool>(),
            margin()};
  }

  double margin() const { return found.calibration ? found.calibration->margin : 0.0; }
};

// Of calibrated arms (rad, m).
constexpr double kUsualTolerance = 1e-3;

// Words for the joints with which the chain has a closed form, if their positions are arguments.
std::vector<std::string> given_joints(
    const model::KinematicTree& tree,
    const model::FramePair& frames,
    InverseTask task,
    const inversion::SerialChain& chain) {
  std::vector<std::string> words;
  for (int k = 0; k < chain.joints; ++k) {
    if (chain.is_parametric(k)) continue;
    task.given = chain.axis(k).joint;
    const inversion::Search& found = inversion::search(tree, frames, task);
    if (!found.plan) continue;
    const std::string tolerance = found.calibration ? ", tolerance = " + print_double(task.tolerance) : "";
    words.push_back("'given " + chain.axis(k).name + tolerance + "'");
  }
  return words;
}

// Whether a chain without a closed form has one with the default values of its parameters.
bool needs_values(const model::KinematicTree& tree, const model::FramePair& frames, const inversion::Search& search) {
  const auto has_default = [](const model::Parameter& p) { return p.default_value.has_value(); };
  if (search.plan || !search.chain.has_parameters()) return false;
  if (!std::all_of(tree.parameters.begin(), tree.parameters.end(), has_default)) return false;
  const inversion::SerialChain chain = inversion::serial_chain(tree, frames, search.chain.task, parameter_values(tree));
  return inversion::search(chain).plan.has_value();
}

}  // namespace

InverseKinematicsSize inverse_kinematics_size(
    const model::KinematicTree& tree,
    const model::FramePair& frames,
    const InverseTask& task) {
  if (!inversion::obstacle(tree, frames).empty()) return {};
  const inversion::Search& found = inversion::search(tree, frames, task);
  int joints = 0;
  for (int k = 0; k < found.chain.joints; ++k) joints += found.chain.is_parametric(k) ? 0 : 1;
  const int steps = found.calibration ? found.calibration->steps : 0;
  if (found.swivel) return {joints, found.swivel->branches(), found.swivel->roots(), false, steps};
  const std::optional<Plan>& plan = found.plan;
  if (!plan) return {};
  return {joints, plan->branches(), plan->roots(), plan->determinant_per_root != 0.0, steps};
}

Program inverse_kinematics(
    const model::KinematicTree& tree,
    const model::FramePair& frames,
    const InverseTask& task,
    const std::string& name) {
  Inversion inversion(tree, frames, task);
  Trace& trace = inversion.trace;
  inversion.target_input();
  inversion.swivel_input();
  inversion.reference_input();
  std::vector<Expression> misfit, determinant;
  Columns sines, cosines;
  for (Branch& branch : inversion.branches(nullptr)) {
    const Expression of_branch = inversion.finish(branch);
    std::vector<Expression>&s = sines.emplace_back(), &c = cosines.emplace_back();
    for (int k = 0; k < inversion.chain.joints; ++k) {
      if (inversion.chain.is_parametric(k)) continue;
      s.push_back(branch.values[at(k)]->sine);
      c.push_back(inversion.chain.axis(k).turns ? branch.values[at(k)]->cosine : Expression());
    }
    misfit.push_back(of_branch);
    determinant.push_back(inversion.determinant(branch));
  }
  const auto rows = static_cast<int>(sines.front().size());
  trace.output("sin_q", Role::matrix, rows, sines);
  trace.output("cos_q", Role::matrix, rows, cosines);
  trace.output("misfit", Role::residual, misfit);
  trace.output("determinant", Role::residual, determinant);
  return trace.program(name);
}

Program inverse_kinematics_branch(
    const model::KinematicTree& tree,
    const model::FramePair& frames,
    const InverseTask& task,
    const std::string& name) {
  Inversion inversion(tree, frames, task);
  Trace& trace = inversion.trace;
  inversion.target_input();
  inversion.swivel_input();
  const std::vector<Expression> signs = trace.input("signs", Role::value, sign_names(inversion.found));
  inversion.reference_input();
  Branch branch = inversion.branches(&signs).front();
  const bool is_calibrated = inversion.found.calibration != nullptr;
  Expression misfit;
  if (is_calibrated) misfit = inversion.finish(branch);
  trace.section("q", "positions");
  std::vector<Expression> q = inversion.reference;
  for (int k = 0; k < inversion.chain.joints; ++k) {
    const JointValue& value = *branch.values[at(k)];
    if (inversion.chain.is_known(k)) continue;
    q[at(inversion.chain.axis(k).joint)] = inversion.chain.axis(k).turns ? atan2(value.sine, value.cosine) : value.sine;
  }
  trace.output("q", Role::joint_position, trace.positions(q));
  if (!is_calibrated) misfit = inversion.finish(branch);
  trace.output("misfit", Role::residual, std::vector<Expression>{misfit});
  trace.output("determinant", Role::residual, std::vector<Expression>{inversion.determinant(branch)});
  return trace.program(name);
}

Program inverse_kinematics_configuration(
    const model::KinematicTree& tree,
    const model::FramePair& frames,
    const InverseTask& task,
    const std::string& name) {
  Inversion inversion(tree, frames, task);
  Trace& trace = inversion.trace;
  inversion.reference = trace.joint_input("q", Role::joint_position);
  const inversion::JointValues values = inversion.values_at(inversion.reference);
  std::vector<Expression> signs;
  for (const Expression& root : inversion.roots(values)) {
    // The sign, as a number: positive where the roots meet.
    const Expression shifted = root + trace.graph.constant(0x1p-100);
    signs.push_back(shifted / sqrt(shifted * shifted));
  }
  trace.output("signs", Role::value, signs);
  return trace.program(name);
}

Program inverse_kinematics_redundancy(
    const model::KinematicTree& tree,
    const model::FramePair& frames,
    const InverseTask& task,
    const std::string& name) {
  Inversion inversion(tree, frames, task);
  Trace& trace = inversion.trace;
  const std::vector<Expression> q = trace.joint_input("q", Role::joint_position);
  const inversion::JointValues values = inversion.values_at(q);
  trace.section("swivel", "swivel angle");
  trace.output(
      "swivel", Role::value,
      std::vector<Expression>{inversion::swivel_of(trace.graph, *inversion.found.swivel, values)});
  return trace.program(name);
}

std::vector<std::string> inverse_kinematics_steps(
    const model::KinematicTree& tree,
    const model::FramePair& frames,
    const InverseTask& task) {
  const inversion::Search& found = inversion::search(tree, frames, task);
  std::vector<std::string> lines;
  if (found.swivel) lines = found.swivel->lines();
  if (found.plan)
    for (const inversion::Step& step : found.plan->steps) lines.push_back(describe(found.chain, step));
  if (found.calibration) lines.push_back(describe(*found.calibration));
  return lines;
}

InverseKinematicsReport report_inverse_kinematics(
    const model::KinematicTree& tree,
    const model::FramePair& frames,
    const InverseTask& task) {
  const std::string obstacle = inversion::obstacle(tree, frames);
  if (!obstacle.empty()) return {false, obstacle, ""};
  const inversion::Search& search = inversion::search(tree, frames, task);
  if (task.given >= 0 && search.chain.given < 0)
    return {false, "joint '" + tree.joints[at(task.given)].name + "' is not between these frames", ""};
  const inversion::Search* nominal = nullptr;
  for (const double tolerance : {kUsualTolerance, 10.0 * kUsualTolerance}) {
    if (search.plan || search.swivel || (nominal && nominal->calibration) || tolerance <= task.tolerance) continue;
    InverseTask other = task;
    other.tolerance = tolerance;
    nominal = &inversion::search(tree, frames, other);
  }
  std::vector<std::string> arguments;
  if (!search.plan && !task.by_swivel && task.given < 0) {
    arguments = given_joints(tree, frames, task, search.chain);
    InverseTask other = task;
    other.by_swivel = true;
    if (inversion::search(tree, frames, other).swivel) arguments.emplace_back("'swivel'");
    other = task;
    other.tolerance = std::max(task.tolerance, kUsualTolerance);
    constexpr int kCoordinates = 6;
    if (arguments.empty() && search.chain.joints > kCoordinates) {
      arguments = given_joints(tree, frames, other, search.chain);
      other.by_swivel = true;
      if (inversion::search(tree, frames, other).swivel)
        arguments.push_back("'swivel, tolerance = " + print_double(other.tolerance) + "'");
    }
  }
  inversion::Explanation explanation = explain(search, arguments, nominal, needs_values(tree, frames, search));
  return {search.plan || search.swivel, std::move(explanation.reason), std::move(explanation.hint)};
}

}  // namespace robcogen::algorithm
