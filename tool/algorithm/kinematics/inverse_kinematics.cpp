#include "algorithm/kinematics/inverse_kinematics.h"

#include <utility>

#include "algorithm/kinematics/inverse/plan.h"
#include "algorithm/spatial/trace.h"

namespace robcogen::algorithm {
namespace {

using inversion::Branch;
using inversion::JointValue;
using inversion::Plan;
using model::InverseTask;
using symbolic::Program;
using symbolic::Role;

// A solver in the trace of a function, with its inputs.
class Inversion {
 public:
  Inversion(const model::KinematicTree& tree, const model::FramePair& frames, const InverseTask& task)
      : trace(tree), plan(*inversion::search(tree, frames, task).plan), chain(plan.chain) {}

  Trace trace;
  const Plan& plan;
  const inversion::SerialChain& chain;
  std::vector<Expression> reference;  // by joint of the robot
  inversion::Target target;
  inversion::JointValues given;

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
  }

  void reference_input() {
    reference = trace.joint_input("reference", Role::joint_position);
    given.resize(chain.axes.size());
    if (chain.given >= 0) given[at(chain.given)] = value_of(chain.given, reference);
  }

  // `q` by joint of the robot.
  JointValue value_of(int k, const std::vector<Expression>& q) {
    const Expression& position = q[at(chain.axis(k).joint)];
    if (!chain.axis(k).turns) return {position, trace.graph.one()};
    return {sin(position), cos(position)};
  }

  inversion::StepSolver solver() {
    std::vector<Expression> of_chain;
    for (int k = 0; k < chain.joints; ++k) of_chain.push_back(reference[at(chain.axis(k).joint)]);
    return {trace.graph, chain, target, std::move(of_chain), plan.lengths_agree};
  }

  std::vector<Branch> branches(const std::vector<Expression>* signs) {
    inversion::StepSolver s = solver();
    std::vector<Branch> list = inversion::branches(trace.graph, s, chain, plan.steps, given, signs);
    for (Branch& branch : list) branch.misfit += remaining_misfit(branch);
    return list;
  }

  Expression determinant(const Branch& branch) {
    return plan.determinant_per_root == 0.0 ? branch.product
                                            : trace.graph.constant(plan.determinant_per_root) * branch.product;
  }

 private:
  // A chain with fewer joints than the task has coordinates misses some targets though every equation has a solution:
  // the difference of the poses tells which.
  Expression remaining_misfit(const Branch& branch) {
    const int coordinates = chain.task.kind == InverseTask::Kind::pose    ? 6
                            : chain.task.kind == InverseTask::Kind::point ? 3
                                                                          : 5;
    if (chain.joints >= coordinates) return {};
    trace.graph.begin_section("pose of the branch", "end");
    const auto constant = [&](const inversion::Numbers3& v) {
      return Vector3{trace.graph.constant(v[0]), trace.graph.constant(v[1]), trace.graph.constant(v[2])};
    };
    Expression squares;
    const inversion::StepSolver s = solver();
    const Vector3 end = s.moved(constant(chain.position), false, branch.values) - target.position;
    squares += dot(end, end);
    for (std::size_t k = 0; k < 3; ++k) {
      if (chain.task.kind == InverseTask::Kind::point || (chain.task.kind == InverseTask::Kind::axis && k < 2))
        continue;
      const Vector3 column = {target.rotation[0][k], target.rotation[1][k], target.rotation[2][k]};
      const Vector3 difference = s.moved(constant(chain.rotation[k]), true, branch.values) - column;
      squares += dot(difference, difference);
    }
    return sqrt(squares);
  }
};

}  // namespace

InverseKinematicsSize inverse_kinematics_size(
    const model::KinematicTree& tree,
    const model::FramePair& frames,
    const InverseTask& task) {
  if (!inversion::obstacle(tree, frames).empty()) return {};
  const auto& plan = inversion::search(tree, frames, task).plan;
  if (!plan) return {};
  return {plan->chain.joints, plan->branches(), plan->roots()};
}

Program inverse_kinematics(
    const model::KinematicTree& tree,
    const model::FramePair& frames,
    const InverseTask& task,
    const std::string& name) {
  Inversion inversion(tree, frames, task);
  Trace& trace = inversion.trace;
  inversion.target_input();
  inversion.reference_input();
  std::vector<Expression> misfit, determinant;
  Columns sines, cosines;
  for (const Branch& branch : inversion.branches(nullptr)) {
    std::vector<Expression>&s = sines.emplace_back(), &c = cosines.emplace_back();
    for (int k = 0; k < inversion.chain.joints; ++k) {
      s.push_back(branch.values[at(k)]->sine);
      c.push_back(inversion.chain.axis(k).turns ? branch.values[at(k)]->cosine : Expression());
    }
    misfit.push_back(branch.misfit);
    determinant.push_back(inversion.determinant(branch));
  }
  trace.output("sin_q", Role::matrix, inversion.chain.joints, sines);
  trace.output("cos_q", Role::matrix, inversion.chain.joints, cosines);
  trace.output("misfit", Role::value, misfit);
  trace.output("determinant", Role::value, determinant);
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
  std::vector<std::string> elements;
  for (const inversion::Step& step : inversion.plan.steps)
    if (step.has_two_roots(inversion.chain)) elements.push_back(inversion.chain.axis(step.joint).name);
  const std::vector<Expression> signs = trace.input("signs", Role::value, elements);
  inversion.reference_input();
  const Branch branch = inversion.branches(&signs).front();
  trace.section("q", "positions");
  std::vector<Expression> q = inversion.reference;
  for (int k = 0; k < inversion.chain.joints; ++k) {
    const JointValue& value = *branch.values[at(k)];
    if (k == inversion.chain.given) continue;
    q[at(inversion.chain.axis(k).joint)] = inversion.chain.axis(k).turns ? atan2(value.sine, value.cosine) : value.sine;
  }
  trace.output("q", Role::joint_position, trace.positions(q));
  trace.output("misfit", Role::value, std::vector<Expression>{branch.misfit});
  trace.output("determinant", Role::value, std::vector<Expression>{inversion.determinant(branch)});
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
  inversion::JointValues values(inversion.chain.axes.size());
  for (int k = 0; k < inversion.chain.joints; ++k) values[at(k)] = inversion.value_of(k, inversion.reference);
  const inversion::StepSolver solver = inversion.solver();
  std::vector<Expression> signs;
  for (const inversion::Step& step : inversion.plan.steps) {
    if (!step.has_two_roots(inversion.chain)) continue;
    trace.section(inversion.chain.axis(step.joint).name, "joint " + describe(inversion.chain, step));
    // The sign, as a number: positive where the roots meet.
    const Expression root = solver.root(step, values) + trace.graph.constant(0x1p-100);
    signs.push_back(root / sqrt(root * root));
  }
  trace.output("signs", Role::value, signs);
  return trace.program(name);
}

std::vector<std::string> inverse_kinematics_steps(
    const model::KinematicTree& tree,
    const model::FramePair& frames,
    const InverseTask& task) {
  std::vector<std::string> lines;
  const Plan& plan = *inversion::search(tree, frames, task).plan;
  for (const inversion::Step& step : plan.steps) lines.push_back(describe(plan.chain, step));
  return lines;
}

}  // namespace robcogen::algorithm
