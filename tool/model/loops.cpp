#include "model/loops.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <set>
#include <tuple>

#include "model/loop_ends.h"
#include "model/loop_plane.h"
#include "model/named_frame.h"
#include "model/parallelogram.h"
#include "support/index.h"

namespace robcogen::model {

namespace {

// Of the length of a loop: how far its ends may miss one another.
constexpr double kClosed = 1e-9;
// A loop is stretched where the sine between the directions of its dependent joints is smaller.
constexpr double kStretched = 1e-4;
constexpr double kWellDetermined = 0.1;

class LoopResolution {
 public:
  LoopResolution(const Description& description, KinematicTree& tree, Diagnostics& diagnostics)
      : description_(description), tree_(tree), diagnostics_(diagnostics) {
    for (const Parameter& p : tree.parameters) parameters_.push_back(p.default_value.value_or(1.0));
    for (const Coupling& coupling : tree.couplings) {
      given_.insert(coupling.joint);
      for (const Coupling::Term& term : coupling.terms) given_.insert(term.joint);
    }
  }

  void run() {
    for (const DescribedIndependent& named : description_.independents) declare(named);
    for (const DescribedLoop& loop : description_.loops) declare(loop);
    if (has_errors()) return;
    for (const LoopJoint& loop : tree_.loops)
      for (const LoopEnd& end : loop.ends)
        for (const int joint : end.joints) ++loops_of_[joint];
    for (std::size_t k = 0; k < tree_.loops.size(); ++k) resolve(static_cast<int>(k));
    if (has_errors()) return;
    order();
    if (!has_errors()) couple_parallelograms(tree_);
    if (!has_errors()) assemble();
    if (!has_errors()) add_couplings();
  }

 private:
  const Description& description_;
  KinematicTree& tree_;
  Diagnostics& diagnostics_;
  std::size_t errors_before_ = diagnostics_.error_count();
  std::vector<double> parameters_;
  std::set<int> given_;               // joints of couplings
  std::map<int, Place> independent_;  // joints that are to be independent
  std::map<int, int> loops_of_;       // by joint: how many it is part of
  std::map<int, int> followed_;       // dependent joints, and their closures
  std::vector<double> at_zero_;       // positions of all joints at q = 0

  bool has_errors() const { return diagnostics_.error_count() > errors_before_; }
  const std::string& name(int joint) const { return tree_.joints[at(joint)].name; }
  std::vector<double> zeros() const { return std::vector<double>(tree_.joints.size()); }

  std::string quoted(const std::vector<int>& joints) const {
    std::string text;
    for (std::size_t k = 0; k < joints.size(); ++k)
      text += (k == 0 ? "'" : k + 1 == joints.size() ? " and '" : ", '") + name(joints[k]) + "'";
    return text;
  }

  // -------------------------------------------------------------------------------------------------------------------
  // Names.

  void declare(const DescribedIndependent& named) {
    const auto joint = tree_.find_joint(named.joint);
    if (!joint) {
      diagnostics_.error("unknown-joint", named.place, fmt::format("joint '{}' is not declared", named.joint)).hint =
          did_you_mean(named.joint, names_of(tree_.joints));
      return;
    }
    const auto [earlier, is_new] = independent_.insert({*joint, named.place});
    if (!is_new) {
      diagnostics_.error("independent-twice", named.place, fmt::format("joint '{}' is listed twice", named.joint))
          .notes.push_back({earlier->second, "first listed here"});
    } else if (tree_.coupling_of(*joint) != nullptr) {
      diagnostics_.error(
          "independent-coupled", named.place,
          fmt::format("joint '{}' cannot be independent: a coupling ties it to others", named.joint));
    }
  }

  void declare(const DescribedLoop& described) {
    for (const LoopJoint& other : tree_.loops)
      if (other.name == described.name)
        diagnostics_.error("duplicate-loop", described.place, fmt::format("loop '{}' is declared twice", other.name))
            .notes.push_back({other.place, "first declared here"});
    LoopJoint loop = {described.name, described.type, {}, described.length, described.place};
    std::array<std::optional<Frame>, 2> frames;
    for (std::size_t e = 0; e < 2; ++e)
      frames[e] =
          find_named_frame(tree_, described.frames[e], described.frame_places[e], "unknown-loop-frame", diagnostics_);
    if (!frames[0] || !frames[1]) return;
    loop.ends = ends_between(tree_, *frames[0], *frames[1]);
    if (loop.ends[0].joints.empty() && loop.ends[1].joints.empty()) {
      diagnostics_
          .error(
              "loop-on-one-link", described.place,
              fmt::format(
                  "loop '{}' connects two frames of link '{}'", described.name,
                  tree_.links[at(loop.ends[0].link)].name))
          .hint = "the frames of a loop are on links that move with respect to one another";
      return;
    }
    if (const Parameter* unknown = parameter_without_value(loop)) {
      diagnostics_
          .error(
              "loop-without-value", described.place,
              fmt::format(
                  "loop '{}' depends on parameter '{}', which has no default value: how it is assembled is unknown",
                  loop.name, unknown->name))
          .hint = fmt::format("write '{}[0.35]', for example, where it stands", unknown->name);
      return;
    }
    tree_.loops.push_back(std::move(loop));
  }

  // One that the geometry depends on; nullptr where there is none.
  const Parameter* parameter_without_value(const LoopJoint& loop) const {
    const Parameter* found = nullptr;
    const auto look = [&](const Quantity& q) {
      for (const int index : parameters_of(q))
        if (!tree_.parameters[at(index)].default_value) found = &tree_.parameters[at(index)];
    };
    const auto look_at = [&](const Placement& placement) {
      for (const auto* amounts : {&placement.translation, &placement.rotation})
        for (const Quantity& q : *amounts) look(q);
    };
    look(loop.length);
    for (const LoopEnd& end : loop.ends) {
      look_at(end.placement);
      for (const int joint : end.joints) look_at(tree_.joints[at(joint)].placement);
    }
    return found;
  }

  static std::vector<int> parameters_of(const Quantity& q) {
    switch (q.op()) {
      case Quantity::Op::constant:
      case Quantity::Op::variable:
        return {};
      case Quantity::Op::parameter:
        return {q.index()};
      default:
        break;
    }
    std::vector<int> result = parameters_of(q.left());
    if (has_right(q.op())) {
      const std::vector<int> more = parameters_of(q.right());
      result.insert(result.end(), more.begin(), more.end());
    }
    return result;
  }

  static bool has_right(Quantity::Op op) {
    return op == Quantity::Op::add || op == Quantity::Op::subtract || op == Quantity::Op::multiply ||
           op == Quantity::Op::divide;
  }

  // -------------------------------------------------------------------------------------------------------------------
  // What a loop is, and which joints follow.

  void resolve(int index) {
    const LoopJoint& loop = tree_.loops[at(index)];
    Closure closure;
    closure.loop = index;
    closure.method = loop.type == LoopType::distance ? Closure::Method::distance : Closure::Method::planar;
    const LoopPosture start = posture(tree_, loop, zeros(), parameters_);
    for (const LoopScrew& screw : start.screws) {
      const Joint& joint = tree_.joints[at(screw.joint)];
      if (joint.type != JointType::spherical) continue;
      diagnostics_.error(
          "loop-spherical", loop.place,
          fmt::format("spherical joint '{}' cannot be part of loop '{}'", joint.name, loop.name));
      return;
    }
    if (closure.method == Closure::Method::planar) {
      const PlaneFault fault = find_plane(tree_, loop, parameters_, closure);
      if (!fault.code.empty()) return report(loop, fault);
    }
    const std::vector<int> free = candidates(loop);
    const std::size_t wanted = closure.method == Closure::Method::planar ? 2 : 1;
    if (free.size() < wanted) {
      std::vector<int> kept;
      for (const LoopScrew& screw : start.screws)
        if (independent_.contains(screw.joint)) kept.push_back(screw.joint);
      Diagnostic& error = diagnostics_.error(
          "loop-over-constrained", loop.place,
          fmt::format(
              "loop '{}' takes away {}, but only {} of its joints can follow the others", loop.name,
              wanted == 1 ? "one motion" : "two motions", free.empty() ? "none" : "one"));
      if (!kept.empty())
        error.hint = fmt::format("leave {}{} out of 'independent'", kept.size() > 1 ? "one of " : "", quoted(kept));
      return;
    }
    const auto parallelogram = find_parallelogram(tree_, loop, parameters_, closure);
    choose(loop, start, free, wanted, parallelogram, closure);
    if (closure.dependents.empty()) {
      diagnostics_
          .error(
              "loop-without-form", loop.place,
              fmt::format(
                  "no {} of the joints of loop '{}' can follow the others at q = 0: it is stretched, or they slide "
                  "side by "
                  "side",
                  wanted == 1 ? "one" : "two", loop.name))
          .hint = "place the links so that the loop is open at q = 0";
      return;
    }
    const int number = static_cast<int>(tree_.closures.size());
    for (const int joint : closure.dependents) followed_.insert({joint, number});
    if (parallelogram) {
      closure.shares = parallelogram->shares(closure.dependents);
      if (parallelogram->is_flat()) warn_of_flat(loop);
    }
    tree_.closures.push_back(std::move(closure));
  }

  void warn_of_flat(const LoopJoint& loop) {
    diagnostics_
        .warning(
            "loop-flat", loop.place,
            fmt::format(
                "loop '{}' is flat at q = 0: it is taken for a parallelogram, whose opposite links stay parallel, not "
                "for crossed links",
                loop.name))
        .hint = "turn the placement of a joint so that the loop is open at q = 0";
  }

  // Joints that may follow.
  std::vector<int> candidates(const LoopJoint& loop) const {
    std::vector<int> result;
    for (const LoopEnd& end : loop.ends)
      for (const int joint : end.joints)
        if (may_follow(joint) && !given_.contains(joint) && !independent_.contains(joint) && !followed_.contains(joint))
          result.push_back(joint);
    return result;
  }

  bool may_follow(int joint) const {
    const JointType type = tree_.joints[at(joint)].type;
    return type == JointType::revolute || type == JointType::prismatic;
  }

  bool is_driven(int joint) const {
    const Joint& j = tree_.joints[at(joint)];
    return j.drive.has_inertia() || std::isfinite(j.limits.effort);
  }

  // The number of driven joints, that of joints that other loops share, whether they are determined badly, and how
  // early they stand in the document.
  using Score = std::tuple<int, int, bool, int>;

  void choose(
      const LoopJoint& loop,
      const LoopPosture& start,
      const std::vector<int>& free,
      std::size_t wanted,
      const std::optional<Parallelogram>& parallelogram,
      Closure& closure) const {
    std::optional<Score> best;
    const auto consider = [&](std::vector<int> joints) {
      Closure trial = closure;
      trial.dependents = std::move(joints);
      const double condition =
          parallelogram ? (parallelogram->determines(trial.dependents) ? 1.0 : 0.0)
                        : conditioning(trial, start, error_of(trial, start, evaluate(loop.length, parameters_)));
      if (!(condition > kStretched) || slides(trial.dependents) > 1) return;
      Score score = {0, 0, condition < kWellDetermined, 0};
      for (const int joint : trial.dependents) {
        std::get<0>(score) += is_driven(joint) ? 1 : 0;
        std::get<1>(score) += loops_of_.at(joint) - 1;
        std::get<3>(score) -= joint;
      }
      if (best && !(score < *best)) return;
      best = score;
      closure.dependents = trial.dependents;
    };
    for (std::size_t i = 0; i < free.size(); ++i) {
      if (wanted == 1) consider({free[i]});
      for (std::size_t k = i + 1; wanted == 2 && k < free.size(); ++k) consider({free[i], free[k]});
    }
  }

  int slides(const std::vector<int>& joints) const {
    return static_cast<int>(std::count_if(
        joints.begin(), joints.end(), [&](int j) { return tree_.joints[at(j)].type == JointType::prismatic; }));
  }

  void report(const LoopJoint& loop, const PlaneFault& fault) {
    diagnostics_.error(fault.code, loop.place, fault.message).hint = fault.hint;
  }

  // -------------------------------------------------------------------------------------------------------------------
  // All of them.

  // Every closure behind those whose joints it takes as given.
  void order() {
    std::vector<Closure> sorted;
    std::vector<bool> done(tree_.closures.size());
    while (sorted.size() < tree_.closures.size()) {
      bool progress = false;
      for (std::size_t k = 0; k < tree_.closures.size(); ++k) {
        if (done[k] || !is_ready(static_cast<int>(k), done)) continue;
        sorted.push_back(tree_.closures[k]);
        done[k] = progress = true;
      }
      if (progress) continue;
      std::string text;
      const LoopJoint* first = nullptr;
      for (std::size_t k = 0; k < done.size(); ++k) {
        if (done[k]) continue;
        const LoopJoint& loop = tree_.loops[at(tree_.closures[k].loop)];
        if (first == nullptr) first = &loop;
        text += (text.empty() ? "'" : ", '") + loop.name + "'";
      }
      diagnostics_.error("loops-entangled", first->place, fmt::format("loops {} can only be closed together", text))
          .hint = "list joints in 'independent' so that each loop follows from them, or from other loops";
      return;
    }
    tree_.closures = std::move(sorted);
    followed_.clear();
    for (std::size_t k = 0; k < tree_.closures.size(); ++k)
      for (const int joint : tree_.closures[k].dependents) followed_.insert({joint, static_cast<int>(k)});
  }

  bool is_ready(int closure, const std::vector<bool>& done) const {
    for (const LoopEnd& end : tree_.loops[at(tree_.closures[at(closure)].loop)].ends)
      for (const int joint : end.joints) {
        const auto other = followed_.find(joint);
        if (other != followed_.end() && other->second != closure && !done[at(other->second)]) return false;
      }
    return true;
  }

  // At q = 0 of the independent joints: whether the loops close, and how.
  void assemble() {
    std::vector<double>& q = at_zero_;
    q = zeros();
    for (const Coupling& coupling : tree_.couplings) q[at(coupling.joint)] = evaluate(coupling.offset, parameters_);
    for (Closure& closure : tree_.closures) {
      const LoopJoint& loop = tree_.loops[at(closure.loop)];
      const double gap = model::close(tree_, closure, q, parameters_);
      const LoopPosture now = posture(tree_, loop, q, parameters_);
      if (!(gap <= kClosed * size_of(now))) {
        report(loop, open_loop(loop, gap));
        return;
      }
      const double length = evaluate(loop.length, parameters_);
      if (conditioning(closure, now, error_of(closure, now, length)) < kStretched) {
        diagnostics_
            .error(
                "loop-stretched", loop.place,
                fmt::format(
                    "loop '{}' is stretched at q = 0: the way it is assembled, and the motions of {}, are undefined",
                    loop.name, quoted(closure.dependents)))
            .hint = "turn the placement of a joint so that the loop is open at q = 0";
        return;
      }
      closure.branch = branch_of(tree_, closure, now);
    }
  }

  // -------------------------------------------------------------------------------------------------------------------
  // The joints of the tree that follow.

  void add_couplings() {
    for (std::size_t k = 0; k < tree_.closures.size(); ++k) {
      const Closure& closure = tree_.closures[k];
      std::set<int> followed;
      for (const LoopEnd& end : tree_.loops[at(closure.loop)].ends)
        for (const int joint : end.joints) {
          if (std::find(closure.dependents.begin(), closure.dependents.end(), joint) != closure.dependents.end())
            continue;
          if (const Coupling* coupling = tree_.coupling_of(joint))
            for (const Coupling::Term& term : coupling->terms) followed.insert(term.joint);
          else
            followed.insert(joint);
        }
      for (const int joint : closure.dependents) {
        Coupling coupling;
        coupling.joint = joint;
        for (const int other : followed) coupling.terms.push_back({other, Quantity()});
        coupling.closure = static_cast<int>(k);
        coupling.offset = Quantity(at_zero_[at(joint)]);
        const auto place = std::lower_bound(
            tree_.couplings.begin(), tree_.couplings.end(), joint,
            [](const Coupling& c, int j) { return c.joint < j; });
        tree_.couplings.insert(place, std::move(coupling));
      }
    }
  }
};

}  // namespace

void resolve_loops(const Description& description, KinematicTree& tree, Diagnostics& diagnostics) {
  if (description.loops.empty() && description.independents.empty()) return;
  LoopResolution(description, tree, diagnostics).run();
}

}  // namespace robcogen::model
