// From loops and couplings of a document to those of a description.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>
#include <optional>
#include <set>

#include "import/identifier.h"
#include "import/urdf/describe.h"
#include "import/urdf/mass.h"
#include "model/name_index.h"
#include "support/index.h"

namespace robcogen::import::from_urdf {
namespace {

class LoopWriter {
 public:
  LoopWriter(
      const Document& document,
      const Topology& topology,
      const Identifiers& identifiers,
      model::Description& description,
      Diagnostics& diagnostics)
      : document_(document),
        topology_(topology),
        identifiers_(identifiers),
        carried_(carry(document, topology)),
        description_(description),
        diagnostics_(diagnostics) {
    for (const Joint& joint : document.joints)
      if (joint.is_independent == false) has_followers_ = true;
  }

  void run() {
    const std::size_t errors_before = diagnostics_.error_count();
    for (const Loop& loop : document_.loops) add(loop);
    for (const Coupling& coupling : document_.couplings) add(coupling);
    eliminate();
    if (diagnostics_.error_count() == errors_before) add_independents();
  }

 private:
  // A sum over joints of the document that is zero.
  struct Row {
    const Coupling* coupling;
    std::map<int, Number> factors;
  };

  const Document& document_;
  const Topology& topology_;
  const Identifiers& identifiers_;
  const std::vector<Carried> carried_;
  model::Description& description_;
  Diagnostics& diagnostics_;
  bool has_followers_ = false;
  std::set<int> of_loops_;  // joints
  std::set<int> coupled_;   // joints of couplings
  std::vector<Row> rows_;

  std::optional<int> find_link(const Name& name, const std::string& owner) {
    model::NameIndex names;
    for (const Link& link : document_.links) names.add(link.name.text);
    const auto found = names.find(name.text);
    if (found && carried_[at(*found)].body >= 0) return found;
    Diagnostic& error = diagnostics_.error(
        "loop-without-link", name.place,
        found ? fmt::format("{} refers to link '{}', which is not part of the robot", owner, name.text)
              : fmt::format("{} refers to undeclared link '{}'", owner, name.text));
    if (const auto similar = found ? std::nullopt : names.nearest_to(name.text))
      error.hint = fmt::format("did you mean '{}'?", names.name_of(*similar));
    return std::nullopt;
  }

  // Joints of the document from the root to the link.
  std::vector<int> path_to(int link) const {
    std::vector<int> joints;
    for (int j = topology_.parent_joint[at(link)]; j >= 0; j = topology_.parent_joint[at(topology_.parent[at(j)])])
      joints.push_back(j);
    std::reverse(joints.begin(), joints.end());
    return joints;
  }

  // From the last link that carries both, without fixed joints.
  std::array<std::vector<int>, 2> paths_to(int predecessor, int successor) const {
    std::array<std::vector<int>, 2> paths = {path_to(predecessor), path_to(successor)};
    const auto [first, second] = std::mismatch(paths[0].begin(), paths[0].end(), paths[1].begin(), paths[1].end());
    paths[0].erase(paths[0].begin(), first);
    paths[1].erase(paths[1].begin(), second);
    for (std::vector<int>& path : paths)
      std::erase_if(path, [&](int j) { return document_.joints[at(j)].type == JointType::fixed; });
    return paths;
  }

  // ---- Loops.

  model::DescribedLink& body_of(int link) const {
    const std::string& name = identifiers_.links[at(carried_[at(link)].body)];
    if (description_.base.name == name) return description_.base;
    return *std::find_if(
        description_.links.begin(), description_.links.end(), [&](const auto& body) { return body.name == name; });
  }

  void add(const Loop& loop) {
    if (loop.type != JointType::revolute && loop.type != JointType::continuous) {
      diagnostics_
          .error(
              "unsupported-loop-type", loop.type_place,
              fmt::format("loop '{}': type '{}' is not supported", loop.name.text, name_of(loop.type)))
          .hint = "supported are 'revolute' and 'continuous'";
      return;
    }
    const std::string owner = fmt::format("loop '{}'", loop.name.text);
    const auto first = find_link(loop.ends[0].link, owner), second = find_link(loop.ends[1].link, owner);
    if (!first || !second) return;
    model::DescribedLoop result;
    result.name = identifier(loop.name.text);
    result.place = loop.name.place;
    result.type = model::LoopType::hinge;
    const std::array<int, 2> links = {*first, *second};
    for (std::size_t e = 0; e < 2; ++e) {
      const LoopEnd& end = loop.ends[e];
      result.frames[e] = result.name + (e == 0 ? "_predecessor" : "_successor");
      result.frame_places[e] = end.link.place;
      const Pose pose = carried_[at(links[e])].pose * pose_of(end.origin) * Pose{{}, rotation_to_axis(loop.axis)};
      body_of(links[e]).frames.push_back({result.frames[e], placement_of(pose), loop.name.place});
    }
    description_.loops.push_back(std::move(result));
    for (const std::vector<int>& path : paths_to(*first, *second)) of_loops_.insert(path.begin(), path.end());
  }

  // ---- Couplings.

  void add(const Coupling& coupling) {
    const std::string owner = fmt::format("coupling '{}'", coupling.name.text);
    const auto predecessor = find_link(coupling.links[0], owner), successor = find_link(coupling.links[1], owner);
    if (!predecessor || !successor) return;
    Row row = {&coupling, {}};
    const auto paths = paths_to(*predecessor, *successor);
    for (std::size_t e = 0; e < 2; ++e)
      for (const int j : paths[e]) {
        const Joint& joint = document_.joints[at(j)];
        if (!is_movable(joint)) {
          diagnostics_.error(
              "coupling-without-joint", coupling.links[e].place,
              fmt::format("{}: {} joint '{}' is between its links", owner, name_of(joint.type), joint.name.text));
          return;
        }
        row.factors[j] = e == 0 ? -coupling.ratio : Number::rational(1);
        coupled_.insert(j);
      }
    rows_.push_back(std::move(row));
  }

  static void drop_zeros(Row& row) {
    std::erase_if(row.factors, [](const auto& factor) { return factor.second.is_zero(); });
  }

  bool may_follow(int joint) const {
    const Joint& j = document_.joints[at(joint)];
    return has_followers_ ? j.is_independent == false : !j.is_independent.value_or(false);
  }

  // The joint that follows by this row: of those that may, the last of the document.
  std::optional<int> follower(const Row& row) const {
    for (auto factor = row.factors.rbegin(); factor != row.factors.rend(); ++factor)
      if (may_follow(factor->first)) return factor->first;
    return std::nullopt;
  }

  // Adds `share` times the other row.
  static void add_to(Row& row, const Row& other, const Number& share) {
    for (const auto& [joint, factor] : other.factors) {
      Number& sum = row.factors[joint];
      sum = sum + share * factor;
    }
    drop_zeros(row);
  }

  // Every row becomes the sum by which one joint follows others, none of which follow.
  void eliminate() {
    std::map<int, Row> solved;
    for (Row& row : rows_) {
      for (const auto& [joint, other] : solved) {
        const auto factor = row.factors.find(joint);
        if (factor != row.factors.end()) add_to(row, other, -Number(factor->second));
      }
      drop_zeros(row);
      const std::optional<int> joint = follower(row);
      if (!joint) {
        report_unsolved(row);
        continue;
      }
      const Number pivot = row.factors.at(*joint);
      for (auto& [other, factor] : row.factors) factor = factor / pivot;
      for (auto& [followed, other] : solved) {
        const auto factor = other.factors.find(*joint);
        if (factor != other.factors.end()) add_to(other, row, -Number(factor->second));
      }
      solved.emplace(*joint, row);
    }
    for (const auto& [joint, row] : solved) couple(joint, row);
  }

  void report_unsolved(const Row& row) {
    const Name& name = row.coupling->name;
    if (row.factors.empty()) {
      diagnostics_.error(
          "coupling-redundant", name.place,
          fmt::format("coupling '{}' says nothing that other couplings do not say, or has no joint", name.text));
      return;
    }
    diagnostics_
        .error(
            "coupling-without-follower", name.place,
            fmt::format("none of the joints of coupling '{}' can follow the others", name.text))
        .hint = "give one of them independent=\"false\"";
  }

  void couple(int joint, const Row& row) {
    const Place& place = row.coupling->name.place;
    model::DescribedCoupling result = {identifiers_.joints[at(joint)], place, {}, {}};
    for (const auto& [followed, factor] : row.factors)
      if (followed != joint)
        result.terms.push_back({identifiers_.joints[at(followed)], model::Quantity(-factor), place});
    description_.couplings.push_back(std::move(result));
  }

  // ---- Joints that lead loops, or are said to follow.

  void add_independents() {
    std::set<std::string> followers;
    for (const model::DescribedCoupling& coupling : description_.couplings) followers.insert(coupling.joint);
    for (std::size_t j = 0; j < document_.joints.size(); ++j) {
      const Joint& joint = document_.joints[j];
      const bool is_of_loop = of_loops_.contains(static_cast<int>(j));
      if (joint.is_independent == false && !is_of_loop && !followers.contains(identifiers_.joints[j]))
        diagnostics_.error(
            "independent-without-loop", joint.independent_place,
            fmt::format("joint '{}' is not independent, but it follows by no loop or coupling", joint.name.text));
      const bool leads = joint.is_independent.value_or(has_followers_);
      if (is_of_loop && leads && is_movable(joint) && !followers.contains(identifiers_.joints[j]))
        description_.independents.push_back(
            {identifiers_.joints[j], joint.is_independent ? joint.independent_place : joint.name.place});
    }
  }
};

}  // namespace

void add_loops(
    const Document& document,
    const Topology& topology,
    const Identifiers& identifiers,
    model::Description& description,
    Diagnostics& diagnostics) {
  LoopWriter(document, topology, identifiers, description, diagnostics).run();
}

}  // namespace robcogen::import::from_urdf
