#include "model/couplings.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <optional>
#include <utility>

#include "support/index.h"

namespace robcogen::model {
namespace {

// q = offset + sum of factor * q_k; the factors are indexed by joint k.
struct Sum {
  std::map<int, Quantity> factors;
  Quantity offset;

  void add(const Quantity& factor, const Sum& other) {
    offset = offset + factor * other.offset;
    for (const auto& [joint, share] : other.factors) factors[joint] = factors[joint] + factor * share;
  }
};

class Resolution {
 public:
  Resolution(const Description& description, NameIndex& joints, bool joints_repeat, Diagnostics& diagnostics)
      : description_(description),
        joints_(joints),
        joints_repeat_(joints_repeat),
        diagnostics_(diagnostics),
        errors_before_(diagnostics.error_count()),
        declared_(description.joints.size()),
        states_(description.joints.size(), State::unseen),
        sums_(description.joints.size()) {}

  std::vector<Coupling> run() {
    for (const DescribedCoupling& coupling : description_.couplings) declare(coupling);
    if (diagnostics_.error_count() > errors_before_) return {};
    std::vector<Coupling> result;
    for (int j = 0; j < static_cast<int>(declared_.size()); ++j) {
      if (!declared_[at(j)]) continue;
      resolve_from(j);
      Coupling coupling = {j, {}, sums_[at(j)].offset};
      for (const auto& [joint, factor] : sums_[at(j)].factors)
        if (!factor.is_zero()) coupling.terms.push_back({joint, factor});
      result.push_back(std::move(coupling));
    }
    if (diagnostics_.error_count() > errors_before_) return {};
    return result;
  }

 private:
  struct Declared {
    const DescribedCoupling* coupling;
    std::vector<int> joints;  // of its terms
  };
  enum class State { unseen, on_this_walk, done };

  const Description& description_;
  NameIndex& joints_;
  bool joints_repeat_;
  Diagnostics& diagnostics_;
  std::size_t errors_before_;
  std::vector<std::optional<Declared>> declared_;  // by joint, like the next two
  std::vector<State> states_;
  std::vector<Sum> sums_;
  std::vector<int> walk_;  // stack of joints to resolve: the joints that a joint follows lie above it

  const std::string& name(int joint) const { return description_.joints[at(joint)].name; }

  std::optional<int> find(const std::string& joint, const Place& place) {
    if (const auto found = joints_.find(joint)) return found;
    if (joints_repeat_) return std::nullopt;
    Diagnostic& error = diagnostics_.error("unknown-joint", place, fmt::format("joint '{}' is not declared", joint));
    if (const auto similar = joints_.nearest_to(joint))
      error.hint = fmt::format("did you mean '{}'?", joints_.name_of(*similar));
    return std::nullopt;
  }

  void declare(const DescribedCoupling& coupling) {
    const auto joint = find(coupling.joint, coupling.place);
    Declared declared = {&coupling, {}};
    refuse_spherical(joint, coupling.place);
    for (const DescribedCoupling::Term& term : coupling.terms) {
      const auto followed = find(term.joint, term.place);
      refuse_spherical(followed, term.place);
      declared.joints.push_back(followed.value_or(-1));
      if (joint && followed == joint)
        diagnostics_.error(
            "coupled-to-itself", term.place, fmt::format("joint '{}' is coupled to itself", coupling.joint));
    }
    if (!joint) return;
    if (const auto& earlier = declared_[at(*joint)]) {
      diagnostics_.error("coupled-twice", coupling.place, fmt::format("joint '{}' is coupled twice", coupling.joint))
          .notes.push_back({earlier->coupling->place, "first coupled here"});
      return;
    }
    declared_[at(*joint)] = std::move(declared);
  }

  void refuse_spherical(const std::optional<int>& joint, const Place& place) {
    if (!joint || description_.joints[at(*joint)].type != JointType::spherical) return;
    diagnostics_.error(
        "coupled-spherical-joint", place,
        fmt::format("spherical joint '{}' cannot be coupled: its position is not a single number", name(*joint)));
  }

  // Resolves this joint and all joints that it follows. Uses an explicit stack, because a chain may be deeper than the
  // call stack.
  void resolve_from(int first) {
    walk_ = {first};
    while (!walk_.empty()) {
      const int joint = walk_.back();
      State& state = states_[at(joint)];
      if (state == State::unseen && declared_[at(joint)]) {
        state = State::on_this_walk;
        for (const int followed : declared_[at(joint)]->joints) {
          if (states_[at(followed)] == State::unseen) walk_.push_back(followed);
          if (states_[at(followed)] == State::on_this_walk) report_cycle(joint, followed);
        }
        continue;
      }
      walk_.pop_back();
      if (state != State::done) sums_[at(joint)] = sum_of(joint);
      state = State::done;
    }
  }

  // Returns the sum over independent joints. The joints that this joint follows must be resolved.
  Sum sum_of(int joint) const {
    Sum sum;
    const auto& declared = declared_[at(joint)];
    if (!declared) {
      sum.factors[joint] = Quantity(1.0);
      return sum;
    }
    sum.offset = declared->coupling->offset;
    for (std::size_t t = 0; t < declared->joints.size(); ++t)
      sum.add(declared->coupling->terms[t].factor, sums_[at(declared->joints[t])]);
    return sum;
  }

  // Reports a cycle: joint `last`, reached last, follows `first`, which follows `last` directly or through others.
  void report_cycle(int last, int first) {
    std::vector<int> loop = {last};
    while (loop.back() != first) {
      const auto follows_loop = [&](int joint) {
        if (states_[at(joint)] != State::on_this_walk) return false;
        const std::vector<int>& followed = declared_[at(joint)]->joints;
        return std::find(followed.begin(), followed.end(), loop.back()) != followed.end();
      };
      loop.push_back(*std::find_if(walk_.rbegin(), walk_.rend(), follows_loop));
    }
    std::string text;
    for (auto joint = loop.rbegin(); joint != loop.rend(); ++joint) text += fmt::format("'{}' -> ", name(*joint));
    diagnostics_.error(
        "coupling-cycle", declared_[at(first)]->coupling->place,
        fmt::format("couplings form a cycle: {}'{}'", text, name(first)));
  }
};

}  // namespace

std::vector<Coupling> resolve_couplings(
    const Description& description,
    NameIndex& joints,
    bool joints_repeat,
    Diagnostics& diagnostics) {
  if (description.couplings.empty()) return {};
  return Resolution(description, joints, joints_repeat, diagnostics).run();
}

}  // namespace robcogen::model
