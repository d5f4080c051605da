// Relations between fixed tendons, solved for the joints that follow.
#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <utility>

#include "import/linear_relations.h"
#include "import/mjcf/describe_loops.h"
#include "support/index.h"

namespace robcogen::import::from_mjcf {

namespace {

// Stands for the number one in a relation. It never follows.
constexpr int kOne = -1;

class TendonSolver {
 public:
  TendonSolver(
      const Document& document,
      const Identifiers& identifiers,
      model::Description& description,
      Diagnostics& diagnostics)
      : document_(document), description_(description), diagnostics_(diagnostics) {
    // Later joints follow first, and those that actuators pull follow last.
    for (const bool is_pulled : {true, false})
      for (std::size_t b = 0; b < document.bodies.size(); ++b)
        for (std::size_t j = 0; j < document.bodies[b].joints.size(); ++j)
          if (document.bodies[b].joints[j].is_pulled == is_pulled)
            joints_.push_back({&document.bodies[b].joints[j], identifiers.joints[b][j], b});
  }

  void run() {
    std::vector<LinearRelation> relations;
    std::vector<Name> tendons;
    for (const TendonCoupling& coupling : document_.tendon_couplings)
      if (std::optional<LinearRelation> found = relation(coupling)) {
        relations.push_back(std::move(*found));
        tendons.push_back(coupling.tendon);
      }
    const SolvedRelations solved = solve(relations, [&](int joint) { return joint != kOne; });
    for (const auto& unsolved : solved.unsolved)
      diagnostics_.error(
          "tendon-without-follower", tendons[unsolved.relation].place,
          fmt::format(
              "this equality of tendon '{}' determines no joint: other equalities determine all of them",
              tendons[unsolved.relation].text));
    for (const auto& [joint, follower] : solved.followers) {
      model::DescribedCoupling coupling = {name(joint), tendons[follower.relation].place, {}, {}};
      for (const auto& [followed, factor] : follower.sum) {
        if (followed == kOne)
          coupling.offset = quantity(-factor);
        else if (followed != joint)
          coupling.terms.push_back({name(followed), quantity(-factor), coupling.place});
      }
      description_.couplings.push_back(std::move(coupling));
    }
  }

 private:
  struct Candidate {
    const Joint* joint = nullptr;
    std::string name;
    std::size_t body = 0;
  };

  const Document& document_;
  model::Description& description_;
  Diagnostics& diagnostics_;
  std::vector<Candidate> joints_;

  const std::string& name(int joint) const { return joints_[at(joint)].name; }

  // The index of the joint of this name. Of copies, the first one.
  std::optional<int> find(const Name& name) {
    std::vector<std::string> names;
    for (std::size_t j = 0; j < joints_.size(); ++j) {
      if (is_named(*joints_[j].joint, name.text)) return static_cast<int>(j);
      if (!joints_[j].joint->name.text.empty()) names.push_back(joints_[j].joint->name.text);
    }
    diagnostics_.error("coupled-joint", name.place, fmt::format("joint '{}' is not declared", name.text)).hint =
        did_you_mean(name.text, names);
    return std::nullopt;
  }

  // The sum over joints, with those of the robot that follow others replaced. nullopt if there is nothing to solve, or
  // after a message.
  std::optional<LinearRelation> relation(const TendonCoupling& coupling) {
    LinearRelation sum;
    sum[kOne] = -coupling.offset;
    std::size_t inside = 0;
    for (const Tendon::Term& term : coupling.terms) {
      const std::optional<int> joint = find(term.joint);
      if (!joint) return std::nullopt;
      const Candidate& candidate = joints_[at(*joint)];
      if (document_.robot.has[candidate.body]) ++inside;
      add(term.factor, *joint, sum);
      sum[kOne] = sum[kOne] - term.factor * candidate.joint->reference;
    }
    if (inside == 0) return std::nullopt;
    if (inside < coupling.terms.size()) {
      diagnostics_.warning(
          "constraints-ignored", coupling.tendon.place,
          fmt::format(
              "this equality of tendon '{}' is ignored: one of its joints is not part of the robot",
              coupling.tendon.text));
      return std::nullopt;
    }
    std::erase_if(sum, [](const auto& entry) { return entry.second.is_zero(); });
    return sum;
  }

  // Adds a multiple of the position of the joint, or of the sum that an equality of joints gives for it.
  void add(const Number& factor, int joint, LinearRelation& sum, std::size_t depth = 0) {
    const auto follows = [&](const model::DescribedCoupling& c) { return c.joint == name(joint); };
    const auto coupling = std::find_if(description_.couplings.begin(), description_.couplings.end(), follows);
    // Couplings that follow one another in a circle are reported later.
    if (coupling == description_.couplings.end() || depth > description_.couplings.size()) {
      sum[joint] = sum[joint] + factor;
      return;
    }
    sum[kOne] = sum[kOne] + factor * coupling->offset.number();
    for (const auto& term : coupling->terms) {
      const auto same = [&](const Candidate& candidate) { return candidate.name == term.joint; };
      const auto followed = std::find_if(joints_.begin(), joints_.end(), same);
      add(factor * term.factor.number(), static_cast<int>(followed - joints_.begin()), sum, depth + 1);
    }
  }
};

}  // namespace

void add_tendon_couplings(
    const Document& document,
    const Identifiers& identifiers,
    model::Description& description,
    Diagnostics& diagnostics) {
  if (!document.tendon_couplings.empty()) TendonSolver(document, identifiers, description, diagnostics).run();
}

}  // namespace robcogen::import::from_mjcf
