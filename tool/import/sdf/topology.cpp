#include "import/sdf/topology.h"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>
#include <utility>

#include "support/index.h"

namespace robcogen::import::from_sdf {
namespace {

class Connector {
 public:
  Connector(const Document& document, Diagnostics& diagnostics) : document_(document), diagnostics_(diagnostics) {}

  std::optional<Topology> connect() {
    const std::size_t errors_before = diagnostics_.error_count();
    topology_.parent_joint.assign(document_.links.size(), -1);
    trees_.resize(document_.links.size() + 1);  // the last one is that of the world
    std::iota(trees_.begin(), trees_.end(), std::size_t{0});
    for (std::size_t j = 0; j < document_.joints.size(); ++j) add(static_cast<int>(j));
    if (document_.is_static) refuse_motion();
    choose_root();
    if (diagnostics_.error_count() > errors_before) return std::nullopt;
    walk_from_root();
    return std::move(topology_);
  }

 private:
  std::size_t node(int link) const { return link == kWorldLink ? document_.links.size() : at(link); }

  // The representative of the tree that a link belongs to so far.
  std::size_t tree_of(int link) {
    std::size_t n = node(link);
    while (trees_[n] != n) n = trees_[n] = trees_[trees_[n]];
    return n;
  }

  void add(int j) {
    const Joint& joint = document_.joints[at(j)];
    if (joint.parent_link == joint.child_link) {
      diagnostics_.error(
          "self-loop", joint.child.place,
          fmt::format("joint '{}' connects '{}' to itself", joint.name.text, joint.child.text));
    } else if (joint.child_link == kWorldLink) {
      diagnostics_.error(
          "world-as-child", joint.child.place,
          fmt::format("the child of joint '{}' is attached to the world", joint.name.text));
    } else if (
        tree_of(joint.parent_link) == tree_of(joint.child_link) || topology_.parent_joint[at(joint.child_link)] >= 0) {
      topology_.loops.push_back(j);
      trees_[tree_of(joint.child_link)] = tree_of(joint.parent_link);
    } else {
      topology_.parent_joint[at(joint.child_link)] = j;
      trees_[tree_of(joint.child_link)] = tree_of(joint.parent_link);
    }
  }

  void refuse_motion() {
    for (const Joint& joint : document_.joints) {
      if (joint.type == JointType::fixed) continue;
      diagnostics_
          .error(
              "static-model", joint.name.place,
              fmt::format("joint '{}' cannot move: its model is static", joint.name.text))
          .hint = "remove <static>; to fix the base only, connect it to the world by a joint of type \"fixed\"";
      return;
    }
  }

  void choose_root() {
    const bool has_world = document_.is_static || std::any_of(
                                                      document_.joints.begin(), document_.joints.end(),
                                                      [](const Joint& j) { return j.parent_link == kWorldLink; });
    if (document_.is_static) return;
    int first = has_world ? kWorldLink : -2;
    for (std::size_t l = 0; l < document_.links.size(); ++l) {
      if (topology_.parent_joint[l] >= 0) continue;
      if (first == -2) {
        first = static_cast<int>(l);
        continue;
      }
      const Name& name = document_.links[l].name;
      const std::string other =
          first == kWorldLink ? "the world" : fmt::format("link '{}'", document_.links[at(first)].name.text);
      diagnostics_
          .error(
              "two-roots", name.place,
              fmt::format("link '{}' and {} are both roots: neither is the child of a joint", name.text, other))
          .hint = way_to_connect(static_cast<int>(l));
      return;
    }
    topology_.root = first == -2 ? kWorldLink : first;
  }

  // A link that joints lead to only backwards becomes a child if one of them changes its direction.
  std::string way_to_connect(int root) const {
    for (const Joint& joint : document_.joints)
      if (joint.parent_link == root && topology_.parent_joint[at(joint.child_link)] != &joint - document_.joints.data())
        return fmt::format(
            "let joint '{}' lead to it: exchange 'parent' and 'child', reverse its axis, and keep the place of its "
            "pose",
            joint.name.text);
    return "connect them by a joint";
  }

  void walk_from_root() {
    std::vector<std::vector<int>> children(document_.links.size() + 1);
    for (std::size_t l = 0; l < document_.links.size(); ++l) {
      const int j = topology_.parent_joint[l];
      const int parent = j < 0 ? kWorldLink : document_.joints[at(j)].parent_link;
      if (static_cast<int>(l) != topology_.root) children[node(parent)].push_back(static_cast<int>(l));
    }
    if (topology_.root == kWorldLink)
      topology_.order = children[node(kWorldLink)];
    else
      topology_.order = {topology_.root};
    for (std::size_t i = 0; i < topology_.order.size(); ++i) {
      const std::vector<int>& next = children[at(topology_.order[i])];
      topology_.order.insert(topology_.order.end(), next.begin(), next.end());
    }
  }

  const Document& document_;
  Diagnostics& diagnostics_;
  Topology topology_;
  std::vector<std::size_t> trees_;  // by link, and for the world: another node of its tree; itself for representatives
};

}  // namespace

std::optional<Topology> connect(const Document& document, Diagnostics& diagnostics) {
  return Connector(document, diagnostics).connect();
}

}  // namespace robcogen::import::from_sdf
