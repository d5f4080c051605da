#include "model/locked_joints.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <deque>
#include <set>
#include <utility>

#include "model/couplings.h"
#include "model/locked_loops.h"
#include "model/name_index.h"
#include "model/rotations.h"
#include "support/index.h"
#include "support/wildcards.h"

namespace robcogen::model {
namespace {

constexpr double kSame = 1e-9;      // rad, m: positions that differ by less are the same
constexpr double kNothing = 1e-14;  // rad, m: rounding of a position that is meant to be zero

std::string text_of(const Quantity& position, const std::vector<Parameter>& parameters) {
  return position.is_constant() ? fmt::format("{:.6g}", position.number().value()) : print(position, parameters);
}

class Locking {
 public:
  Locking(const Description& description, const KinematicTree& tree, const Changes& changes, Diagnostics& diagnostics)
      : description_(description),
        tree_(tree),
        changes_(changes),
        diagnostics_(diagnostics),
        errors_before_(diagnostics.error_count()),
        named_(description.joints.size()),
        positions_(description.joints.size()) {
    for (const DescribedJoint& joint : description.joints) joints_.add(joint.name);
    Diagnostics known;  // the couplings are valid, because the tree was built
    for (Coupling& coupling : resolve_couplings(description, joints_, false, known))
      couplings_.push_back(std::move(coupling));
    result_.joints.resize(named_.size());
    result_.assembled.resize(named_.size());
  }

  std::optional<LockedJoints> run() {
    name_joints();
    lock_named();
    if (!failed()) lock_leaders();
    if (!failed()) lock_followers();
    if (!failed()) lock_loops();
    if (!failed()) lock_followers();
    if (failed()) return std::nullopt;
    note_others();
    for (std::size_t j = 0; j < positions_.size(); ++j)
      if (positions_[j]) result_.joints[j] = {motion_of(description_.joints[j], *positions_[j]), *positions_[j]};
    return std::move(result_);
  }

 private:
  const Description& description_;
  const KinematicTree& tree_;
  const Changes& changes_;
  Diagnostics& diagnostics_;
  std::size_t errors_before_;
  NameIndex joints_;
  std::vector<Coupling> couplings_;                 // that the document declares; joints are those of the description
  std::deque<Lock> made_;                           // for joints that are not kept
  std::vector<const Lock*> named_;                  // by joint, like the next one
  std::vector<std::optional<Quantity>> positions_;  // of locked joints, unless they are spherical
  LockedJoints result_;

  bool failed() const { return diagnostics_.error_count() > errors_before_; }
  const std::string& name(int joint) const { return description_.joints[at(joint)].name; }
  bool is_spherical(int joint) const { return description_.joints[at(joint)].type == JointType::spherical; }
  std::string text(const Quantity& position) const { return text_of(position, description_.parameters); }

  // The joint of the description that this joint of the tree is, or is a component of.
  int described(int joint) const { return *joints_.find(tree_.joints[at(joint)].declared_name()); }

  const Coupling* coupling_of(int joint) const {
    for (const Coupling& coupling : couplings_)
      if (coupling.joint == joint) return &coupling;
    return nullptr;
  }

  // ---- The joints that are named.

  void name_joints() {
    if (!changes_.kept.empty()) lock_all_but_kept();
    for (const Lock& lock : changes_.locks)
      for (std::size_t j = 0; j < named_.size(); ++j)
        if (matches(lock.name.text, description_.joints[j].name)) named_[j] = &lock;
  }

  // Joints that follow others are locked only if those are.
  void lock_all_but_kept() {
    std::set<int> kept;
    for (std::size_t j = 0; j < named_.size(); ++j) {
      const std::string& own = description_.joints[j].name;
      // An elastic joint is kept with its motor.
      const std::string& moved = description_.joints[j].motor_of;
      const auto is_own = [&](const NamePattern& pattern) {
        return matches(pattern.text, own) || (!moved.empty() && matches(pattern.text, moved));
      };
      if (std::none_of(changes_.kept.begin(), changes_.kept.end(), is_own)) continue;
      kept.insert(static_cast<int>(j));
      if (const Coupling* coupling = tree_.coupling_of(*tree_.find_joint(own)))
        for (const Coupling::Term& term : coupling->terms) kept.insert(described(term.joint));
    }
    for (const int joint : tree_.coordinates()) {
      const int own = described(joint);
      if (kept.contains(own) || named_[at(own)] != nullptr) continue;
      named_[at(own)] = &made_.emplace_back(Lock{{name(own), changes_.kept.front().place}, {}});
    }
  }

  // Sets the positions of the joints that are named and follow no coupling.
  void lock_named() {
    for (int j = 0; j < static_cast<int>(named_.size()); ++j) {
      const Lock* lock = named_[at(j)];
      if (lock == nullptr) continue;
      check_position(j, *lock);
      if (is_spherical(j))
        result_.joints[at(j)] = {{{}, angles_of_quaternion(lock->quaternion)}, {}};
      else if (coupling_of(j) == nullptr)
        positions_[at(j)] = lock->position;
    }
  }

  void check_position(int joint, const Lock& lock) {
    const Place& place = lock.name.place;
    if (is_spherical(joint)) {
      if (!lock.quaternion && !lock.position.is_zero())
        diagnostics_
            .error(
                "lock-spherical", place,
                fmt::format("joint '{}' is spherical: its position is not a single number", name(joint)))
            .hint = fmt::format("write its unit quaternion, as in {} = (1, 0, 0, 0)", name(joint));
      else if (lock.quaternion && !(length_of(*lock.quaternion) > 0.0))
        diagnostics_.error("lock-spherical", place, fmt::format("the quaternion of joint '{}' is zero", name(joint)));
      return;
    }
    if (lock.quaternion)
      diagnostics_.error(
          "lock-spherical", place,
          fmt::format("joint '{}' is not spherical: its position is a single number", name(joint)));
    else
      check_limits(joint, lock.position, place);
  }

  void check_limits(int joint, const Quantity& position, const Place& place) {
    const JointLimits& limits = description_.joints[at(joint)].limits;
    const std::optional<double> q = value_at_defaults(position, description_.parameters);
    if (!q || limits.lower > limits.upper) return;
    if (*q >= limits.lower - kSame && *q <= limits.upper + kSame) return;
    diagnostics_
        .error(
            "lock-outside-limits", place,
            fmt::format(
                "joint '{}' cannot be locked at {:.6g}: its limits are {:.6g} and {:.6g}", name(joint), *q,
                limits.lower, limits.upper))
        .hint = fmt::format("lock it at a position in between, as in {} = {:.3g}", name(joint), middle_of(limits));
  }

  static double middle_of(const JointLimits& limits) {
    if (std::isinf(limits.lower)) return limits.upper;
    return std::isinf(limits.upper) ? limits.lower : 0.5 * (limits.lower + limits.upper);
  }

  static double length_of(const std::array<Quantity, 4>& quaternion) {
    double sum = 0.0;
    for (const Quantity& q : quaternion) sum += q.number().value() * q.number().value();
    return std::sqrt(sum);
  }

  // The identity if there is no quaternion. Of any length.
  static std::array<Quantity, 3> angles_of_quaternion(const std::optional<std::array<Quantity, 4>>& quaternion) {
    if (!quaternion || !(length_of(*quaternion) > 0.0)) return {};
    const Quantity one(Number::rational(1)), two(Number::rational(2));
    const auto& [w, x, y, z] = *quaternion;
    const Quantity s = two / (w * w + x * x + y * y + z * z);
    return angles_of(
        {{{one - s * (y * y + z * z), s * (x * y - w * z), s * (x * z + w * y)},
          {s * (x * y + w * z), one - s * (x * x + z * z), s * (y * z - w * x)},
          {s * (x * z - w * y), s * (y * z + w * x), one - s * (x * x + y * y)}}});
  }

  // ---- Couplings.

  // The position of the joint, as far as the joints that it follows are locked, and the others.
  std::pair<Quantity, std::vector<const Coupling::Term*>> partial_sum(const Coupling& coupling) const {
    std::pair<Quantity, std::vector<const Coupling::Term*>> result = {coupling.offset, {}};
    for (const Coupling::Term& term : coupling.terms) {
      if (const auto& position = positions_[at(term.joint)])
        result.first = result.first + term.factor * *position;
      else
        result.second.push_back(&term);
    }
    return result;
  }

  // Locks the joints that a locked joint follows.
  void lock_leaders() {
    std::vector<const Coupling*> pending;
    for (const Coupling& coupling : couplings_)
      if (named_[at(coupling.joint)] != nullptr) pending.push_back(&coupling);
    for (bool has_changed = true; has_changed;) {
      has_changed = false;
      for (const Coupling*& coupling : pending) {
        if (coupling == nullptr) continue;
        const Lock& lock = *named_[at(coupling->joint)];
        const auto [sum, others] = partial_sum(*coupling);
        if (others.size() > 1) continue;
        if (others.empty()) {
          if (!has_wildcards(lock.name.text)) require_same(coupling->joint, sum, lock);
        } else {
          const int leader = others.front()->joint;
          const Quantity position = (lock.position - sum) / others.front()->factor;
          positions_[at(leader)] = position;
          check_limits(leader, position, lock.name.place);
        }
        coupling = nullptr;
        has_changed = true;
      }
    }
    for (const Coupling* coupling : pending)
      if (coupling != nullptr) report_free(*coupling);
  }

  void require_same(int joint, const Quantity& sum, const Lock& lock) {
    if (sum == lock.position) return;
    const auto value = value_at_defaults(sum - lock.position, description_.parameters);
    if (value && std::abs(*value) <= kSame) return;
    diagnostics_
        .error(
            "lock-contradiction", lock.name.place,
            fmt::format(
                "joint '{}' cannot be locked at {}: the joints that it follows are locked, and put it at {}",
                name(joint), text(lock.position), text(sum)))
        .hint = "lock the joints that it follows only";
  }

  void report_free(const Coupling& coupling) {
    std::vector<std::string> leaders;
    for (const Coupling::Term* term : partial_sum(coupling).second)
      leaders.push_back(fmt::format("'{}'", name(term->joint)));
    diagnostics_
        .error(
            "lock-follower", named_[at(coupling.joint)]->name.place,
            fmt::format(
                "joint '{}' cannot be locked: it follows {}, which would remain free to move against one another",
                name(coupling.joint), fmt::join(leaders, " and ")))
        .hint = "lock these joints instead";
  }

  // Locks the joints that follow locked joints only.
  void lock_followers() {
    for (const Coupling& coupling : couplings_) {
      const auto [sum, others] = partial_sum(coupling);
      if (others.empty() && (!coupling.terms.empty() || named_[at(coupling.joint)] != nullptr))
        positions_[at(coupling.joint)] = sum;
    }
  }

  // ---- Loops.

  // The tree with the couplings that the document declares, and no others.
  KinematicTree open_tree() const {
    KinematicTree open = tree_;
    open.closures.clear();
    open.parallelograms.clear();
    open.couplings = couplings_;
    const auto in_tree = [&](int joint) { return *tree_.find_joint(name(joint)); };
    for (Coupling& coupling : open.couplings) {
      coupling.joint = in_tree(coupling.joint);
      for (Coupling::Term& term : coupling.terms) term.joint = in_tree(term.joint);
    }
    return open;
  }

  void lock_loops() {
    if (tree_.loops.empty()) return;
    std::vector<double> parameters;
    for (const Parameter& p : description_.parameters) parameters.push_back(p.default_value.value_or(1.0));
    std::vector<std::optional<double>> targets(tree_.joints.size());
    for (std::size_t j = 0; j < targets.size(); ++j)
      if (const auto& position = positions_[at(described(static_cast<int>(j)))])
        targets[j] = evaluate(*position, parameters);
    for (const LockedGroup& group :
         locked_groups(tree_, open_tree(), tree_.assembled_positions(parameters), targets, parameters)) {
      if (!group.is_closed)
        report_open(group);
      else if (!group.is_rigid)
        assemble(group);
      else if (may_be_rigid(group))
        lock_rigid(group);
    }
  }

  std::string names_of_loops(const LockedGroup& group) const {
    std::vector<std::string> names;
    for (const int loop : group.loops) names.push_back(fmt::format("'{}'", tree_.loops[at(loop)].name));
    return fmt::format("loop{} {}", names.size() > 1 ? "s" : "", fmt::join(names, ", "));
  }

  // Where the user locked one of these joints, or a joint that follows them.
  Place place_of(const LockedGroup& group) const {
    for (const int joint : group.locked)
      if (const Lock* lock = named_[at(described(joint))]) return lock->name.place;
    for (const Lock* lock : named_)
      if (lock != nullptr) return lock->name.place;
    return {};
  }

  void report_open(const LockedGroup& group) {
    std::vector<std::string> positions;
    for (const int joint : group.locked)
      positions.push_back(
          fmt::format("'{}' at {}", tree_.joints[at(joint)].name, text(*positions_[at(described(joint))])));
    diagnostics_
        .error(
            "lock-open-loop", place_of(group),
            fmt::format(
                "{} cannot close with {}: a gap of {:.3g} m remains", names_of_loops(group), fmt::join(positions, ", "),
                group.gap))
        .hint = "lock one of its joints only, and the others follow; or choose a position that the loop reaches";
  }

  // The joints of the loops that can still move are near their positions in the group.
  void assemble(const LockedGroup& group) {
    for (const int loop : group.loops) result_.reassembled.push_back(tree_.loops[at(loop)].name);
    std::vector<std::string> independent;
    for (const int joint : group.joints) {
      const int own = described(joint);
      const double q = group.positions[at(joint)];
      if (std::abs(q) >= kNothing || description_.joints[at(own)].assembled) result_.assembled[at(own)] = q;
      for (const DescribedIndependent& named : description_.independents)
        if (named.joint == name(own)) independent.push_back(named.joint);
    }
    if (static_cast<int>(independent.size()) > group.freedoms)
      result_.rechosen.insert(result_.rechosen.end(), independent.begin(), independent.end());
  }

  // Whether the geometry of the loops is constant: otherwise, the positions of the joints depend on parameters.
  bool may_be_rigid(const LockedGroup& group) {
    std::set<int> parameters;
    const auto look = [&](const Quantity& q) {
      for (const int index : parameters_of(q)) parameters.insert(index);
    };
    const auto look_at = [&](const Placement& placement) {
      for (const auto* amounts : {&placement.translation, &placement.rotation})
        for (const Quantity& q : *amounts) look(q);
    };
    for (const int index : group.loops) {
      const LoopJoint& loop = tree_.loops[at(index)];
      look(loop.length);
      for (const LoopEnd& end : loop.ends) {
        look_at(end.placement);
        for (const int joint : end.joints) look_at(tree_.joints[at(joint)].placement);
      }
    }
    for (const int joint : group.locked) look(*positions_[at(described(joint))]);
    if (parameters.empty()) return true;
    const std::string& parameter = description_.parameters[at(*parameters.begin())].name;
    diagnostics_
        .error(
            "lock-parametric-loop", place_of(group),
            fmt::format(
                "{} cannot move any more, but parameter '{}' determines where its joints are", names_of_loops(group),
                parameter))
        .hint = fmt::format("lock the parameter, too, at its value: {} = …", parameter);
    return false;
  }

  void lock_rigid(const LockedGroup& group) {
    for (const int loop : group.loops) result_.loops.push_back(tree_.loops[at(loop)].name);
    for (const int joint : group.joints) {
      const double q = group.positions[at(joint)];
      positions_[at(described(joint))] = std::abs(q) < kNothing ? Quantity() : Quantity(q);
    }
  }

  // ---- Results.

  // Adds one note that lists the joints that nobody named.
  void note_others() {
    std::vector<std::string> others;
    Place place;
    for (int j = 0; j < static_cast<int>(named_.size()); ++j) {
      if (named_[at(j)] != nullptr && place.source == nullptr) place = named_[at(j)]->name.place;
      if (positions_[at(j)] && named_[at(j)] == nullptr)
        others.push_back(fmt::format("'{}' at {}", name(j), text(*positions_[at(j)])));
    }
    if (others.empty()) return;
    diagnostics_.note(
        "locked-too", place,
        fmt::format("locked joints determine further joints, which are locked too: {}", fmt::join(others, ", ")));
  }

  static Placement motion_of(const DescribedJoint& joint, const Quantity& q) {
    const Quantity none;
    switch (joint.type) {
      case JointType::prismatic:
        return {{none, none, q}, {}};
      case JointType::helical:
        return {{none, none, joint.pitch * q}, {none, none, q}};
      case JointType::revolute:
      case JointType::spherical:
        break;
    }
    return {{}, {none, none, q}};
  }
};

}  // namespace

std::optional<LockedJoints> locked_joints(
    const Description& description,
    const KinematicTree& tree,
    const Changes& changes,
    Diagnostics& diagnostics) {
  return Locking(description, tree, changes, diagnostics).run();
}

}  // namespace robcogen::model
