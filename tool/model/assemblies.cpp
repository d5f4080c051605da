#include "model/assemblies.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <utility>

#include "model/loop_cluster.h"
#include "support/index.h"

namespace robcogen::model {
namespace {

constexpr double kSamePosition = 1e-3;  // rad, or m per size of the loops

double turned_back(double angle) {
  return std::remainder(angle, 2.0 * std::acos(-1.0));
}

// To the three digits that a message shows.
double rounded(double position) {
  if (position == 0.0) return 0.0;
  const double unit = std::pow(10.0, std::floor(std::log10(std::abs(position))) - 2.0);
  return std::round(position / unit) * unit;
}

class AssemblySearch {
 public:
  AssemblySearch(
      const LoopContext& context,
      const std::vector<int>& loops,
      const std::vector<double>& start,
      const std::vector<int>& candidates)
      : tree_(context.tree),
        cluster_(context.tree, loops, context.parameters),
        start_(start),
        candidates_(candidates),
        size_(cluster_.size(start)) {}

  LoopAssemblies run() {
    constexpr int kStarts = 100;
    constexpr std::size_t kShown = 2;
    std::minstd_rand engine(1);
    std::uniform_real_distribution<double> any(-1.0, 1.0);
    for (int k = 0; k < kStarts; ++k) {
      std::vector<double> q = start_;
      for (const int joint : candidates_)
        q[at(joint)] += any(engine) * (is_angle(joint) ? std::acos(-1.0) : 2.0 * size_);
      consider(std::move(q));
    }
    if (found_.assemblies.empty()) return found_;
    std::stable_sort(
        found_.assemblies.begin(), found_.assemblies.end(), [&](const LoopAssembly& a, const LoopAssembly& b) {
          const double difference = distance(a) - distance(b);
          return std::abs(difference) > kSamePosition ? difference < 0.0 : a.positions > b.positions;
        });
    found_.assemblies.resize(std::min(found_.assemblies.size(), kShown));
    for (LoopAssembly& way : found_.assemblies) way.leader = leader_of(way);
    found_.is_start_stretched = cluster_.rank(start_) < static_cast<int>(found_.dependents.size());
    return found_;
  }

 private:
  const KinematicTree& tree_;
  LoopCluster cluster_;
  const std::vector<double>& start_;
  const std::vector<int>& candidates_;
  double size_;
  LoopAssemblies found_;

  bool is_angle(int joint) const { return turns(tree_.joints[at(joint)].type); }

  double difference(int joint, double a, double b) const {
    return is_angle(joint) ? std::abs(turned_back(a - b)) : std::abs(a - b) / size_;
  }

  // The places of joints among the candidates, best first: the better of two choices has the smaller list.
  std::vector<std::ptrdiff_t> ranks(const std::vector<int>& joints) const {
    std::vector<std::ptrdiff_t> result;
    for (const int joint : joints)
      result.push_back(std::find(candidates_.begin(), candidates_.end(), joint) - candidates_.begin());
    std::sort(result.begin(), result.end());
    return result;
  }

  double distance(const LoopAssembly& way) const {
    double sum = 0.0;
    for (std::size_t k = 0; k < way.positions.size(); ++k)
      sum += difference(found_.dependents[k], way.positions[k], start_[at(found_.dependents[k])]);
    return sum;
  }

  bool is_same(const LoopAssembly& way, const std::vector<double>& q) const {
    for (std::size_t k = 0; k < way.positions.size(); ++k)
      if (difference(found_.dependents[k], way.positions[k], q[at(found_.dependents[k])]) > kSamePosition) return false;
    return true;
  }

  // Closes the loops from here. Joints that the loops do not determine return to the start first.
  void consider(std::vector<double> q) {
    const std::vector<int> dependents = cluster_.following(q, candidates_);
    if (!found_.assemblies.empty() && ranks(dependents) > ranks(found_.dependents)) return;
    std::vector<double> from = start_;
    for (const int joint : dependents) from[at(joint)] = q[at(joint)];
    if (!(cluster_.close(from, dependents) <= kClosed * cluster_.size(from))) return;
    if (dependents != found_.dependents) found_ = {dependents, {}, false};
    for (const LoopAssembly& way : found_.assemblies)
      if (is_same(way, from)) return;
    LoopAssembly way;
    for (const int joint : dependents)
      way.positions.push_back(is_angle(joint) ? turned_back(from[at(joint)]) : from[at(joint)]);
    found_.assemblies.push_back(std::move(way));
  }

  // The first joint whose position in the assembly, as a message shows it, leads there alone.
  int leader_of(const LoopAssembly& way) const {
    for (std::size_t k = 0; k < way.positions.size(); ++k) {
      std::vector<double> q = start_;
      q[at(found_.dependents[k])] = rounded(way.positions[k]);
      const std::vector<int> dependents = cluster_.following(q, candidates_);
      if (dependents == found_.dependents && cluster_.close(q, dependents) <= kClosed * cluster_.size(q) &&
          is_same(way, q))
        return found_.dependents[k];
    }
    return -1;
  }
};

std::size_t index_of(const LoopAssemblies& assemblies, int joint) {
  return static_cast<std::size_t>(
      std::find(assemblies.dependents.begin(), assemblies.dependents.end(), joint) - assemblies.dependents.begin());
}

// `'b' at 0.927 rad and 'c' at 2.21 rad`.
std::string describe(const LoopContext& context, const LoopAssemblies& assemblies, const LoopAssembly& way) {
  std::string text;
  for (std::size_t k = 0; k < way.positions.size(); ++k) {
    const int joint = assemblies.dependents[k];
    text += k == 0 ? "" : k + 1 == way.positions.size() ? " and " : ", ";
    text += fmt::format(
        "'{}' at {:.3g} {}", context.name(joint), way.positions[k],
        turns(context.tree.joints[at(joint)].type) ? "rad" : "m");
  }
  return text;
}

// How to change the document to get one of the assemblies.
std::string hint_to_choose(const LoopContext& context, const LoopAssemblies& assemblies) {
  const LoopAssembly& first = assemblies.assemblies.front();
  const bool has_two = assemblies.assemblies.size() > 1 && assemblies.assemblies[1].leader == first.leader;
  const auto position = [&](const LoopAssembly& way, int joint) { return way.positions[index_of(assemblies, joint)]; };
  if (context.assembled_form == AssembledForm::key) return "give the model a 'key' whose 'qpos' has these positions";
  if (context.assembled_form == AssembledForm::none) {
    const std::vector<int> turned = first.leader < 0 ? assemblies.dependents : std::vector<int>{first.leader};
    std::string text;
    for (const int joint : turned)
      text += fmt::format("{}'{}' by {:.3g}", text.empty() ? "" : ", ", context.name(joint), position(first, joint));
    return fmt::format("turn or shift the placements of joints about or along their axes: {}", text);
  }
  if (first.leader < 0) {
    std::string text;
    for (const int joint : assemblies.dependents)
      text += fmt::format(
          "{}'{}' in joint '{}'", text.empty() ? "write " : ", ", context.assembled_text(position(first, joint)),
          context.name(joint));
    return text;
  }
  const std::string one = fmt::format("'{}'", context.assembled_text(position(first, first.leader)));
  const std::string other =
      has_two ? fmt::format(" or '{}'", context.assembled_text(position(assemblies.assemblies[1], first.leader))) : "";
  const bool is_angle = turns(context.tree.joints[at(first.leader)].type);
  return fmt::format(
      "write {}{} in joint '{}', or {} by as much {} its axis", one, other, context.name(first.leader),
      is_angle ? "turn its placement" : "shift its placement", is_angle ? "about" : "along");
}

}  // namespace

LoopAssemblies find_assemblies(
    const LoopContext& context,
    const std::vector<int>& loops,
    const std::vector<double>& start,
    const std::vector<int>& candidates) {
  return AssemblySearch(context, loops, start, candidates).run();
}

void explain_open(
    const LoopContext& context,
    const LoopAssemblies& assemblies,
    const std::string& subject,
    const std::string& where,
    PlaneFault& fault) {
  if (assemblies.assemblies.empty()) return;
  std::string ways;
  for (const LoopAssembly& way : assemblies.assemblies)
    ways += (ways.empty() ? "with " : ", or with ") + describe(context, assemblies, way);
  fault.hint = hint_to_choose(context, assemblies);
  if (!assemblies.is_start_stretched) {
    fault.hint = fmt::format("the drawing leads elsewhere, but it closes {}: {}", ways, fault.hint);
    return;
  }
  fault.code = "loop-ambiguous";
  fault.message = fmt::format(
      "{} drawn stretched {}, which does not say to which side the links fold: it closes {}", subject, where, ways);
}

}  // namespace robcogen::model
