#include "model/declare_loops.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <utility>

#include "model/loop_ends.h"
#include "model/named_frame.h"
#include "support/index.h"

namespace robcogen::model {
namespace {

class LoopDeclaration {
 public:
  explicit LoopDeclaration(LoopContext& context)
      : tree_(context.tree), diagnostics_(context.diagnostics), independent_(context.independent) {}

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
    LoopJoint loop = {described.name,   described.type,  {},
                      described.length, described.place, described.takes_other_branch};
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
          .hint = "the frames of a loop must be on links that move relative to each other";
      return;
    }
    if (const Parameter* unknown = parameter_without_value(loop)) {
      diagnostics_
          .error(
              "loop-without-value", described.place,
              fmt::format(
                  "loop '{}' depends on parameter '{}', which has no default value: the assembly of the loop is "
                  "unknown",
                  loop.name, unknown->name))
          .hint = fmt::format("give it a default where it is used, such as '{}[0.35]'", unknown->name);
      return;
    }
    const double length = value_at_defaults(loop.length, tree_.parameters).value_or(1.0);
    if (loop.type == LoopType::distance && !(length > 0.0)) {
      diagnostics_
          .error(
              "loop-distance", described.place,
              fmt::format("the distance of loop '{}' is not positive: {} m", loop.name, print_double(length)))
          .hint = "for frames whose origins coincide, write 'type = point'";
      return;
    }
    tree_.loops.push_back(std::move(loop));
  }

  // Checks the position that the document gives a joint for assembling loops. All loops must have been declared.
  void check_assembled(const DescribedJoint& described) {
    const int joint = *tree_.find_joint(described.name);
    if (described.type == JointType::spherical) return;  // reported by check_drives: it has no such position
    if (tree_.coupling_of(joint) != nullptr) {
      diagnostics_
          .error(
              "assembled-coupled", described.assembled_place,
              fmt::format("joint '{}' cannot have 'assembled': a coupling ties it to others", described.name))
          .hint = "write 'assembled' for the joints that it follows";
    } else if (!moves_loop(joint)) {
      diagnostics_.error(
          "assembled-without-loop", described.assembled_place,
          fmt::format("joint '{}' has 'assembled', but does not move a loop", described.name));
    }
  }

 private:
  KinematicTree& tree_;
  Diagnostics& diagnostics_;
  std::map<int, Place>& independent_;

  // Whether this joint, or a joint that a coupling ties to it, is part of a loop.
  bool moves_loop(int joint) const {
    const auto follows = [&](int other) {
      const Coupling* coupling = tree_.coupling_of(other);
      return coupling != nullptr && std::any_of(
                                        coupling->terms.begin(), coupling->terms.end(),
                                        [&](const Coupling::Term& term) { return term.joint == joint; });
    };
    return std::any_of(tree_.loops.begin(), tree_.loops.end(), [&](const LoopJoint& loop) {
      const std::vector<int> joints = joints_of(loop);
      return std::any_of(joints.begin(), joints.end(), [&](int j) { return j == joint || follows(j); });
    });
  }

  // Returns a parameter without default value that the geometry of the loop depends on, or nullptr.
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
};

}  // namespace

void declare_loops(const Description& description, LoopContext& context) {
  LoopDeclaration declaration(context);
  for (const DescribedIndependent& named : description.independents) declaration.declare(named);
  for (const DescribedLoop& loop : description.loops) declaration.declare(loop);
  for (const DescribedJoint& joint : description.joints)
    if (joint.assembled) declaration.check_assembled(joint);
}

}  // namespace robcogen::model
