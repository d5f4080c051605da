#include "algorithm/kinematics/inverse/plan.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>
#include <mutex>
#include <tuple>
#include <utility>

#include "algorithm/kinematics/inverse/arrangements.h"
#include "algorithm/kinematics/inverse/calibration.h"
#include "algorithm/kinematics/inverse/laboratory.h"
#include "algorithm/kinematics/inverse/swivel.h"

namespace robcogen::algorithm::inversion {
namespace {

// How many orders are kept for each set of found joints, and steps for each joint.
constexpr std::size_t kOrders = 20, kSteps = 8;
// A root that differs by more is not the joint's position.
constexpr double kSameRoot = 1e-6;

// ---------------------------------------------------------------------------------------------------------------------
// Search

struct Order {
  int roots = 0;
  double cost = 0.0;
  std::vector<Step> steps;
};

bool is_cheaper(const Order& a, const Order& b) {
  return a.roots != b.roots ? a.roots < b.roots : a.cost < b.cost;
}

class PlanSearch {
 public:
  explicit PlanSearch(const SerialChain& chain)
      : chain_(chain),
        features_(features_of(chain).all),
        lab_(chain),
        solver_(lab_.graph, chain, lab_.target, lab_.references) {
    Random random(1);
    for (std::size_t state = 0; state < kProbes; ++state) {
      q_.push_back(random_positions(chain, random, false));
      values_.push_back(sines_cosines(chain, q_.back()));
      lab_.set(state, pose(chain, values_.back()), q_.back());
    }
    probes_ = std::make_unique<Probes>(lab_.graph, lab_.inputs);
  }

  // All orders that were kept, or the joints that are found.
  std::vector<Order> orders(Known& found) {
    Known start(chain_.axes.size());
    for (int k = 0; k < chain_.joints; ++k) start[at(k)] = chain_.is_known(k);
    std::map<Known, std::vector<Order>> layer = {{start, {Order()}}};
    for (int depth = static_cast<int>(std::count(start.begin(), start.end(), true)); depth < chain_.joints; ++depth) {
      std::map<Known, std::vector<Order>> next;
      for (const auto& [known, orders] : layer) extend(known, orders, next);
      if (next.empty()) {
        found = layer.begin()->first;
        return {};
      }
      for (auto& [known, orders] : next) {
        std::stable_sort(orders.begin(), orders.end(), is_cheaper);
        if (orders.size() > kOrders) orders.resize(kOrders);
      }
      layer = std::move(next);
    }
    found = layer.begin()->first;
    return layer.begin()->second;
  }

 private:
  const SerialChain& chain_;
  std::vector<Feature> features_;
  Laboratory lab_;
  StepSolver solver_;
  std::vector<std::vector<double>> q_;  // by state
  std::vector<std::vector<SineCosine>> values_;
  std::unique_ptr<Probes> probes_;

  void extend(const Known& known, const std::vector<Order>& orders, std::map<Known, std::vector<Order>>& next) {
    std::map<std::pair<int, bool>, std::vector<std::pair<int, Step>>> found;
    for (Step& step : possible_steps(chain_, features_, known))
      if (const auto cost = cost_of(step, known)) {
        const std::pair<int, bool> kind = {step.joint, step.has_two_roots(chain_)};
        found[kind].emplace_back(*cost, std::move(step));
      }
    for (auto& [kind, steps] : found) {
      const auto& [joint, has_two_roots] = kind;
      std::stable_sort(steps.begin(), steps.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
      if (steps.size() > kSteps) steps.resize(kSteps);
      Known then = known;
      then[at(joint)] = true;
      std::vector<Order>& list = next[then];
      for (const auto& [cost, step] : steps)
        for (const Order& order : orders) {
          Order& longer = list.emplace_back(order);
          longer.roots += has_two_roots ? 1 : 0;
          longer.cost += cost * static_cast<double>(1 << order.roots);
          longer.steps.push_back(step);
        }
    }
  }

  // nullopt if the step does not find the joint.
  std::optional<int> cost_of(const Step& step, const Known& known) {
    JointValues values(chain_.axes.size());
    for (int k = 0; k < chain_.joints; ++k)
      if (known[at(k)]) values[at(k)] = lab_.joints[at(k)];
    const std::size_t mark = lab_.graph.mark();
    ProbeValues best;
    best.fill(10.0);
    bool is_solved = true;
    for (const double sign : {1.0, -1.0}) {
      const auto found = solver_.solve(step, values, lab_.graph.constant(sign));
      is_solved = is_solved && found;
      if (!is_solved) break;
      const ProbeValues sine = (*probes_)(found->value.sine), cosine = (*probes_)(found->value.cosine);
      for (std::size_t state = 0; state < kProbes; ++state) {
        const SineCosine& expected = values_[state][at(step.joint)];
        const double error = std::hypot(sine[state] - expected.sine, cosine[state] - expected.cosine);
        if (error < best[state]) best[state] = error;  // not if it is NaN
      }
      if (!step.has_two_roots(chain_)) break;
    }
    const int cost = weight(lab_.graph, mark);
    lab_.graph.rollback(mark);
    probes_->forget(mark);
    const bool is_right = std::all_of(best.begin(), best.end(), [](double error) { return error < kSameRoot; });
    return is_solved && is_right ? std::optional<int>(cost) : std::nullopt;
  }
};

// ---------------------------------------------------------------------------------------------------------------------
// Comparison of complete plans

// Which vector steps need no square root, because lengths agree for targets in and out of reach, also near the axes.
std::vector<bool> lengths_that_agree(const SerialChain& chain, const std::vector<Step>& steps, int rounds) {
  Laboratory lab(chain);
  StepSolver solver(lab.graph, chain, lab.target, lab.references);
  branches(lab.graph, solver, chain, steps, lab.known());
  std::vector<bool> agree(chain.axes.size(), true);
  Random random(3);
  for (int round = 0; round < rounds; ++round) {
    for (std::size_t state = 0; state < kProbes; ++state) {
      const std::vector<double> q = random_positions(chain, random, false);
      NumberPose target = pose(chain, sines_cosines(chain, random_positions(chain, random, false)));
      const double size = std::pow(10.0, random.uniform(-4.0, 1.0));
      for (double& x : target.position) x = size * random.uniform(-1.0, 1.0);
      lab.set(state, target, q);
    }
    Probes probes(lab.graph, lab.inputs);
    for (const StepSolver::Lengths& lengths : solver.lengths()) {
      const ProbeValues a = probes(lengths.a), b = probes(lengths.b);
      for (std::size_t state = 0; state < kProbes; ++state)
        if (!(std::abs(a[state] - b[state]) <= 1e-12 + 1e-9 * std::abs(b[state]))) agree[at(lengths.joint)] = false;
    }
  }
  return agree;
}

double determinant(std::vector<std::vector<double>> m) {
  double result = 1.0;
  for (std::size_t k = 0; k < m.size(); ++k) {
    std::size_t pivot = k;
    for (std::size_t i = k; i < m.size(); ++i)
      if (std::abs(m[i][k]) > std::abs(m[pivot][k])) pivot = i;
    if (pivot != k) result = -result;
    std::swap(m[k], m[pivot]);
    result *= m[k][k];
    if (m[k][k] == 0.0) return 0.0;
    for (std::size_t i = k + 1; i < m.size(); ++i)
      for (std::size_t c = m.size(); c-- > k;) m[i][c] -= m[i][k] / m[k][k] * m[k][c];
  }
  return result;
}

// Of the Jacobian of a pose by six joints, or of a point by three, not counting known joints; zero for others.
double determinant_of_jacobian(const SerialChain& chain, const std::vector<SineCosine>& q) {
  const bool is_of_point = chain.task.kind == model::InverseTask::Kind::point;
  const std::size_t rows = is_of_point ? 3 : 6;
  NumberPose end = pose(chain, q);
  std::vector<std::vector<double>> columns;
  for (int k = 0; k < chain.joints; ++k) {
    if (chain.is_known(k)) continue;
    // The axis where the joints before it have moved it.
    SerialChain before = chain;
    before.joints = k;
    before.rotation = {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
    before.position = chain.axis(k).point;
    const NumberPose frame = pose(before, q);
    const Numbers3 direction = frame.rotation * chain.axis(k).direction;
    const bool turns = chain.axis(k).turns;
    const Numbers3 angular = turns ? direction : Numbers3{};
    const Numbers3 linear = turns ? cross(direction, end.position - frame.position) : direction;
    std::vector<double> column(linear.begin(), linear.end());
    if (!is_of_point) column.insert(column.begin(), angular.begin(), angular.end());
    columns.push_back(std::move(column));
  }
  return columns.size() == rows && chain.task.kind != model::InverseTask::Kind::axis ? determinant(columns) : 0.0;
}

// A plan, traced and measured.
class Trial {
 public:
  Trial(const SerialChain& chain, std::vector<Step> steps, int rounds = 4)
      : chain_(chain),
        lab_(chain),
        plan_{chain, std::move(steps)},
        solver_(lab_.graph, chain, lab_.target, lab_.references, lengths(rounds)) {
    const std::size_t mark = lab_.graph.mark();
    branches_ = branches(lab_.graph, solver_, chain, plan_.steps, lab_.known());
    cost_ = weight(lab_.graph, mark);
  }

  // The largest error of the best branch, at random and at special positions.
  double error() {
    double largest = 0.0;
    Random random(5);
    constexpr int kRounds = 24;
    for (int round = 0; round < kRounds; ++round) {
      std::vector<NumberPose> targets;
      for (std::size_t state = 0; state < kProbes; ++state) {
        const std::vector<double> q = random_positions(chain_, random, round % 2 == 1);
        targets.push_back(pose(chain_, sines_cosines(chain_, q)));
        lab_.set(state, targets.back(), q);
      }
      Probes probes(lab_.graph, lab_.inputs);
      ProbeValues least;
      least.fill(10.0);
      for (const Branch& branch : branches_) {
        const auto found = numbers_of(branch, probes);
        for (std::size_t state = 0; state < kProbes; ++state) {
          const double error = task_error(chain_, pose(chain_, found[state]), targets[state]);
          if (error < least[state]) least[state] = error;  // not if it is NaN
        }
      }
      largest = std::max(largest, *std::max_element(least.begin(), least.end()));
    }
    return largest;
  }

  int cost() const { return cost_; }

  // With the check of its branches, and the factor between roots and determinant.
  Plan plan() {
    std::vector<JointValues> values;
    for (const Branch& branch : branches_) values.push_back(branch.values);
    plan_.closure = cheapest_closure(lab_.graph, solver_.loop(), chain_, values);
    Random random(7);
    std::vector<NumberPose> targets;
    for (std::size_t state = 0; state < kProbes; ++state) {
      const std::vector<double> q = random_positions(chain_, random, false);
      targets.push_back(pose(chain_, sines_cosines(chain_, q)));
      lab_.set(state, targets.back(), q);
    }
    Probes probes(lab_.graph, lab_.inputs);
    std::vector<double> ratios;
    for (const Branch& branch : branches_) {
      const ProbeValues product = probes(branch.product);
      const auto found = numbers_of(branch, probes);
      for (std::size_t state = 0; state < kProbes; ++state)
        if (task_error(chain_, pose(chain_, found[state]), targets[state]) < 1e-9)
          ratios.push_back(determinant_of_jacobian(chain_, found[state]) / product[state]);
    }
    plan_.determinant_per_root = ratios.empty() ? 0.0 : ratios.front();
    for (const double ratio : ratios)
      if (!(std::abs(ratio - plan_.determinant_per_root) <= 1e-6 * std::abs(ratio))) plan_.determinant_per_root = 0.0;
    return plan_;
  }

 private:
  const SerialChain& chain_;
  Laboratory lab_;
  Plan plan_;
  StepSolver solver_;
  std::vector<Branch> branches_;
  int cost_ = 0;

  const std::vector<bool>& lengths(int rounds) {
    plan_.lengths_agree = lengths_that_agree(chain_, plan_.steps, rounds);
    return plan_.lengths_agree;
  }

  // By state.
  std::vector<std::vector<SineCosine>> numbers_of(const Branch& branch, Probes& probes) const {
    std::vector<std::vector<SineCosine>> result(kProbes);
    for (int k = 0; k < chain_.joints; ++k) {
      const JointValue& value = *branch.values[at(k)];
      const ProbeValues sine = probes(value.sine), cosine = probes(value.cosine);
      for (std::size_t state = 0; state < kProbes; ++state) result[state].push_back({sine[state], cosine[state]});
    }
    return result;
  }
};

// Digits count in pairs, down to rounding.
int class_of(double error) {
  constexpr double kGood = 1e-13;
  return static_cast<int>(std::ceil(std::log10(std::max(error, kGood)) / 2.0 + 7.0));
}

struct Measured {
  std::tuple<int, int, int> measure;  // roots, class of the error, cost
  std::vector<Step> steps;
};

// The cheapest of the most accurate orders with the fewest roots; the joints that are found.
std::optional<Measured> best_order(const SerialChain& chain, Known& found) {
  std::vector<Order> orders = PlanSearch(chain).orders(found);
  std::optional<Measured> best;
  for (Order& order : orders) {
    if (order.roots > orders.front().roots) break;
    Trial trial(chain, order.steps);
    const std::tuple<int, int, int> measure = {order.roots, class_of(trial.error()), trial.cost()};
    if (!best || measure < best->measure) best = {measure, std::move(order.steps)};
  }
  return best;
}

// What a search depends on.
std::vector<double> numbers_of(const SerialChain& chain) {
  std::vector<double> numbers = {
      static_cast<double>(chain.joints), static_cast<double>(chain.given), static_cast<double>(chain.task.kind),
      chain.task.by_swivel ? 1.0 : 0.0, chain.task.tolerance};
  const auto add = [&](const Numbers3& v) { numbers.insert(numbers.end(), v.begin(), v.end()); };
  for (const ChainAxis& axis : chain.axes) {
    numbers.push_back(axis.turns ? 1.0 : 0.0);
    numbers.push_back(static_cast<double>(axis.amount));
    add(axis.direction);
    add(axis.point);
  }
  for (const Numbers3& column : chain.rotation) add(column);
  add(chain.position);
  for (const ToolSlide& slide : chain.tool_slides) {
    numbers.push_back(static_cast<double>(slide.amount));
    numbers.push_back(slide.sign);
  }
  return numbers;
}

// Of the nominal chain of one without a plan; nullopt if that has none either, or there is no other.
std::optional<Search> search_nominal(const SerialChain& chain) {
  const NominalChain nominal = nominal_chain(chain, chain.task.tolerance);
  if (!nominal.differs()) return std::nullopt;
  Search result = search(nominal.chain);
  if (!result.plan && !result.swivel) return std::nullopt;
  result.calibration = std::make_shared<const Calibration>(calibration(chain, nominal, result));
  return result;
}

}  // namespace

int Plan::roots() const {
  return static_cast<int>(
      std::count_if(steps.begin(), steps.end(), [&](const Step& step) { return step.has_two_roots(chain); }));
}

std::vector<Branch> branches(
    Graph& graph,
    StepSolver& solver,
    const SerialChain& chain,
    const std::vector<Step>& steps,
    const JointValues& given,
    const std::vector<Expression>* signs) {
  std::vector<Branch> list = {{given, graph.one()}};
  std::size_t root = 0;
  for (const Step& step : steps) {
    graph.begin_section("joint " + describe(chain, step), chain.axis(step.joint).name);
    std::vector<Expression> of_step = {graph.one()};
    if (step.has_two_roots(chain)) {
      if (signs)
        of_step = {(*signs)[root++]};
      else
        of_step.push_back(graph.constant(-1.0));
    }
    std::vector<Branch> longer;
    for (const Branch& branch : list)
      for (const Expression& sign : of_step) {
        const auto found = solver.solve(step, branch.values, sign);
        if (!found) return {};
        Branch& next = longer.emplace_back(branch);
        next.values[at(step.joint)] = found->value;
        if (step.has_two_roots(chain)) next.product = next.product * found->root;
      }
    list = std::move(longer);
  }
  return list;
}

Search search(const SerialChain& chain) {
  Search result{{}, chain, {}};
  if (chain.task.by_swivel) {
    if (std::optional<SwivelPlan> plan = swivel_plan(chain))
      result.swivel = std::make_shared<const SwivelPlan>(*std::move(plan));
    return result;
  }
  std::optional<Measured> best;
  for (const SerialChain& arranged : arrangements(chain)) {
    Known found;
    std::optional<Measured> here = best_order(arranged, found);
    if (best && (!here || best->measure <= here->measure)) continue;
    best = std::move(here);
    result.chain = arranged;
    result.found = std::move(found);
  }
  // Lengths that differ for few targets out of reach only are found by more of them.
  constexpr int kManyRounds = 500;
  if (best) result.plan = Trial(result.chain, std::move(best->steps), kManyRounds).plan();
  return result;
}

const Search& search(const model::KinematicTree& tree, const model::FramePair& frames, const model::InverseTask& task) {
  static std::mutex mutex;
  static std::map<std::pair<std::vector<double>, std::string>, std::unique_ptr<const Search>> known;
  const Search* exact = nullptr;
  if (task.tolerance > 0.0) {
    model::InverseTask other = task;
    other.tolerance = 0.0;
    exact = &search(tree, frames, other);
    if (exact->plan || exact->swivel) return *exact;
  }
  const SerialChain chain = serial_chain(tree, frames, task);
  std::string joints;
  for (const ChainAxis& axis : chain.axes) joints += std::to_string(axis.joint) + " " + axis.name + " ";
  const std::scoped_lock lock(mutex);
  std::unique_ptr<const Search>& found = known[{numbers_of(chain), joints}];
  if (!found) found = std::make_unique<const Search>(exact ? search_nominal(chain).value_or(*exact) : search(chain));
  return *found;
}

}  // namespace robcogen::algorithm::inversion
