#include "algorithm/kinematics/inverse/swivel.h"

#include <algorithm>
#include <cmath>

#include "algorithm/kinematics/inverse/laboratory.h"

namespace robcogen::algorithm::inversion {
namespace {

constexpr int kJoints = 7, kElbow = 3;

Vector3 constant(Graph& graph, const Numbers3& v) {
  return {graph.constant(v[0]), graph.constant(v[1]), graph.constant(v[2])};
}

// Finite, also of a vector without length.
Expression inverse_length(Graph& graph, const Vector3& v) {
  constexpr double kSquare = 0x1p-126;
  return graph.one() / sqrt(dot(v, v) + graph.constant(kSquare));
}

Vector3 unit(Graph& graph, const Vector3& v) {
  return inverse_length(graph, v) * v;
}

// The directions across the line from shoulder to wrist from which the swivel angle is measured.
struct Line {
  Vector3 u, n, across;  // u x n
};

Line line(Graph& graph, const SwivelPlan& plan, const Vector3& from_shoulder_to_wrist) {
  // Where the line is parallel to the first axis, some angle counts as zero. Near there, the cross product is not quite
  // across the line; then the angle is off, but not the pose.
  constexpr double kTie = 0x1p-50;
  const Numbers3 axis = plan.chain.axis(0).direction;
  std::size_t least = 0;
  for (std::size_t k = 1; k < 3; ++k)
    if (std::abs(axis[k]) < std::abs(axis[least])) least = k;
  Numbers3 other{};
  other[least] = 1.0;
  const Numbers3 tie = cross(axis, other);
  Line l;
  l.u = unit(graph, from_shoulder_to_wrist);
  l.across = unit(
      graph, cross(l.u, unit(graph, cross(constant(graph, axis), l.u) + constant(graph, (kTie / norm(tie)) * tie))));
  l.n = cross(l.across, l.u);
  return l;
}

// The solver of three joints, for the orientation that they have together.
StepSolver part_solver(
    Graph& graph,
    const Plan& part,
    const Matrix3& rotation,
    const std::vector<Expression>& references,
    int first,
    double margin) {
  return {
      graph,
      part.chain,
      {rotation, {}},
      {references.begin() + first, references.begin() + first + part.chain.joints},
      part.lengths_agree,
      margin};
}

std::vector<Expression> part_of(const std::vector<Expression>& signs, int first, int count) {
  return {signs.begin() + first, signs.begin() + first + count};
}

JointValues part_of(const JointValues& values, const Plan& part, int first) {
  JointValues result(part.chain.axes.size());
  for (int k = 0; k < part.chain.joints; ++k) result[at(k)] = values[at(first + k)];
  return result;
}

// a b' + …
void add_product(Matrix3& m, const Vector3& a, const Vector3& b) {
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t k = 0; k < 3; ++k) m[i][k] += a[i] * b[k];
}

Matrix3 of_columns(const std::array<Vector3, 3>& columns) {
  Matrix3 m;
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t k = 0; k < 3; ++k) m[i][k] = columns[k][i];
  return m;
}

}  // namespace

std::vector<std::string> SwivelPlan::lines() const {
  std::vector<std::string> all = {describe(chain, elbow)};
  for (const Plan* part : {&shoulder, &wrist})
    for (const Step& step : part->steps) all.push_back(describe(part->chain, step) + ", behind the swivel");
  return all;
}

std::vector<std::string> SwivelPlan::sign_names() const {
  std::vector<std::string> names = {chain.axis(kElbow).name};
  for (const Plan* part : {&shoulder, &wrist})
    for (const Step& step : part->steps)
      if (step.has_two_roots(part->chain)) names.push_back(part->chain.axis(step.joint).name);
  return names;
}

std::optional<SwivelPlan> swivel_plan(const SerialChain& chain) {
  if (chain.joints != kJoints || chain.has_parameters() || chain.task.kind != model::InverseTask::Kind::pose)
    return std::nullopt;
  if (!std::all_of(chain.axes.begin(), chain.axes.end(), [](const ChainAxis& axis) { return axis.turns; }))
    return std::nullopt;
  const auto shoulder = common_point(chain, 0, kElbow), wrist = common_point(chain, kElbow + 1, kJoints);
  if (!shoulder || !wrist) return std::nullopt;
  SwivelPlan plan;
  plan.chain = chain;
  plan.shoulder_point = without_rounding(chain, *shoulder);
  plan.wrist_point = without_rounding(chain, *wrist);
  const Numbers3 axis = chain.axis(kElbow).direction;
  // The axis of the elbow is across the line in every position.
  if (std::abs(dot(axis, plan.wrist_point - plan.shoulder_point)) > chain.same_point) return std::nullopt;
  const Feature a{Feature::Kind::point, 0, kElbow, plan.shoulder_point, {}};
  const Feature b{Feature::Kind::point, kElbow + 1, kJoints, plan.wrist_point, {}};
  plan.elbow = {Step::Equation::distance, kElbow, a, b, {}};
  Search of_shoulder = search(orientation_chain(chain, 0, kElbow));
  Search of_wrist = search(orientation_chain(chain, kElbow + 1, kJoints));
  if (!of_shoulder.plan || !of_wrist.plan) return std::nullopt;
  plan.shoulder = *of_shoulder.plan;
  plan.wrist = *of_wrist.plan;
  Laboratory lab(chain);
  const Expression swivel = lab.joints.front().sine;  // any number
  std::vector<JointValues> values;
  for (const Branch& branch : swivel_branches(lab.graph, plan, lab.target, lab.references, swivel, nullptr))
    values.push_back(branch.values);
  plan.closure = cheapest_closure(lab.graph, {lab.graph, chain, lab.target}, chain, values);
  return plan;
}

std::vector<Branch> swivel_branches(
    Graph& graph,
    const SwivelPlan& plan,
    const Target& target,
    const std::vector<Expression>& references,
    const Expression& swivel,
    const std::vector<Expression>* signs,
    double margin) {
  StepSolver solver(graph, plan.chain, target, references, {}, margin);
  const TargetLoop& loop = solver.loop();
  graph.begin_section("swivel", "swivel");
  const Vector3 S = constant(graph, plan.shoulder_point), W = constant(graph, plan.wrist_point);
  const Vector3 axis = constant(graph, plan.chain.axis(kElbow).direction);
  const Line l = line(graph, plan, loop.of_target(W, false) - S);
  const Expression s = sin(swivel), c = cos(swivel);
  const Vector3 n0 = c * l.n + s * l.across, across = cross(l.u, n0);
  std::array<Vector3, 3> columns;
  for (std::size_t k = 0; k < 3; ++k) columns[k] = loop.of_target(unit_vector(graph, k), true);
  const Matrix3 whole = of_columns(columns);

  std::vector<Expression> of_elbow = {graph.one(), graph.constant(-1.0)};
  if (signs) of_elbow = {signs->front()};
  std::vector<Branch> result;
  for (const Expression& sign : of_elbow) {
    graph.begin_section("joint " + describe(plan.chain, plan.elbow), plan.chain.axis(kElbow).name);
    JointValues values(plan.chain.axes.size());
    const auto elbow = solver.solve(plan.elbow, values, sign);
    if (!elbow) return {};
    values[at(kElbow)] = elbow->value;
    // The same line in coordinates of the link before the elbow, where its axis is known too.
    const Vector3 u3 = unit(graph, loop.moved(W, false, values, kElbow, kElbow + 1) - S);
    Matrix3 upper;
    add_product(upper, l.u, u3);
    add_product(upper, n0, axis);
    add_product(upper, across, cross(u3, axis));
    for (std::size_t k = 0; k < 3; ++k)
      columns[k] = multiply(upper, loop.moved(unit_vector(graph, k), true, values, kElbow, kElbow + 1));
    const Matrix3 lower = transposed(of_columns(columns)) * whole;

    StepSolver of_shoulder = part_solver(graph, plan.shoulder, upper, references, 0, margin);
    StepSolver of_wrist = part_solver(graph, plan.wrist, lower, references, kElbow + 1, margin);
    const int roots = plan.shoulder.roots();
    const std::vector<Expression> signs_of_shoulder = signs ? part_of(*signs, 1, roots) : std::vector<Expression>();
    const std::vector<Expression> signs_of_wrist =
        signs ? part_of(*signs, 1 + roots, plan.wrist.roots()) : std::vector<Expression>();
    const std::vector<Branch> shoulders = branches(
        graph, of_shoulder, plan.shoulder.chain, plan.shoulder.steps, JointValues(plan.shoulder.chain.axes.size()),
        signs ? &signs_of_shoulder : nullptr);
    const std::vector<Branch> wrists = branches(
        graph, of_wrist, plan.wrist.chain, plan.wrist.steps, JointValues(plan.wrist.chain.axes.size()),
        signs ? &signs_of_wrist : nullptr);
    for (const Branch& shoulder : shoulders)
      for (const Branch& wrist : wrists) {
        Branch& branch = result.emplace_back();
        branch.values = values;
        for (int k = 0; k < 3; ++k) {
          branch.values[at(k)] = shoulder.values[at(k)];
          branch.values[at(kElbow + 1 + k)] = wrist.values[at(k)];
        }
        branch.product = elbow->root * shoulder.product * wrist.product;
      }
  }
  return result;
}

Expression swivel_of(Graph& graph, const SwivelPlan& plan, const JointValues& values) {
  const TargetLoop loop(graph, plan.chain, {});
  const Vector3 S = constant(graph, plan.shoulder_point), W = constant(graph, plan.wrist_point);
  const Line l = line(graph, plan, loop.moved(W, false, values, 0, kElbow + 1) - S);
  const Vector3 n0 = loop.moved(constant(graph, plan.chain.axis(kElbow).direction), true, values, 0, kElbow);
  return atan2(dot(n0, l.across), dot(n0, l.n));
}

Condition swivel_condition(Graph& graph, const SwivelPlan& plan, const Expression& swivel, const JointValues& values) {
  const TargetLoop loop(graph, plan.chain, {});
  const auto moved = [&](const Numbers3& x, bool is_direction, int end) {
    return loop.moved(constant(graph, x), is_direction, values, 0, end);
  };
  const auto axis = [&](int k) { return moved(plan.chain.axis(k).direction, true, k); };
  const Vector3 W = moved(plan.wrist_point, false, kElbow + 1), to_wrist = W - constant(graph, plan.shoulder_point);
  const Line l = line(graph, plan, to_wrist);
  const Vector3 first = constant(graph, plan.chain.axis(0).direction), elbow = axis(kElbow);
  const Expression along = dot(first, l.u), rho = dot(first, l.across);
  const Expression s = sin(swivel), c = cos(swivel);
  Condition condition;
  condition.missing = rho * difference_of_products(s, dot(elbow, l.n), c, dot(elbow, l.across));
  // Joints before the elbow turn its axis and the line, and with the line the direction from which the angle is
  // measured, which stays across the first axis: the first joint does not change the angle. The elbow moves the line.
  condition.derivatives.resize(plan.chain.axes.size());
  for (int k = 1; k < kElbow; ++k) {
    const Vector3 h = axis(k);
    condition.derivatives[at(k)] = difference_of_products(rho, dot(h, l.u), along, dot(h, l.across));
  }
  const Vector3 displaced = cross(elbow, W - moved(plan.chain.axis(kElbow).point, false, kElbow));
  condition.derivatives[at(kElbow)] = -(along * dot(displaced, l.n)) * inverse_length(graph, to_wrist);
  return condition;
}

std::vector<Expression> swivel_roots(
    Graph& graph,
    const SwivelPlan& plan,
    const std::vector<Expression>& references,
    const JointValues& values) {
  const StepSolver solver(graph, plan.chain, {}, references);
  std::vector<Expression> roots = {solver.root(plan.elbow, values)};
  int first = 0;
  for (const Plan* part : {&plan.shoulder, &plan.wrist}) {
    const StepSolver of_part = part_solver(graph, *part, {}, references, first, 0.0);
    const JointValues of_joints = part_of(values, *part, first);
    for (const Step& step : part->steps)
      if (step.has_two_roots(part->chain)) roots.push_back(of_part.root(step, of_joints));
    first = kElbow + 1;
  }
  return roots;
}

}  // namespace robcogen::algorithm::inversion
