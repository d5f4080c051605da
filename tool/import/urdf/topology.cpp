#include "import/urdf/topology.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <utility>

#include "model/name_index.h"
#include "support/index.h"

namespace robcogen::import::from_urdf {

namespace {

// Returns the names of links or joints. Reports duplicate names.
template <class Element>
model::NameIndex names_of(
    const std::vector<Element>& elements,
    const char* kind,
    const char* code,
    Diagnostics& diagnostics) {
  model::NameIndex index;
  for (const Element& element : elements) {
    const Name& name = element.name;
    const auto same = name.text.empty() ? std::nullopt : index.find(name.text);
    if (same) {
      diagnostics.error(code, name.place, fmt::format("{} '{}' is declared twice", kind, name.text))
          .notes.push_back({elements[at(*same)].name.place, "first declared here"});
    }
    index.add(name.text);
  }
  return index;
}

class Connector {
 public:
  Connector(const Document& document, Diagnostics& diagnostics) : document_(document), diagnostics_(diagnostics) {}

  std::optional<Topology> connect() {
    const std::size_t errors_before = diagnostics_.error_count();
    links_ = names_of(document_.links, "link", "duplicate-link", diagnostics_);
    names_are_sound_ = diagnostics_.error_count() == errors_before && !links_.find("");
    names_of(document_.joints, "joint", "duplicate-joint", diagnostics_);
    topology_.parent_joint.assign(document_.links.size(), -1);
    for (std::size_t j = 0; j < document_.joints.size(); ++j) {
      const Joint& joint = document_.joints[j];
      topology_.parent.push_back(find(joint.parent, joint));
      topology_.child.push_back(find(joint.child, joint));
      adopt(static_cast<int>(j));
    }
    // If links are unknown, others would seem to be roots.
    const bool is_complete = std::count(topology_.parent.begin(), topology_.parent.end(), -1) == 0 &&
                             std::count(topology_.child.begin(), topology_.child.end(), -1) == 0;
    if (!is_complete || diagnostics_.error_count() > errors_before || document_.links.empty()) return std::nullopt;
    find_root();
    walk_from_root();
    report_cycles();
    if (diagnostics_.error_count() > errors_before) return std::nullopt;
    return std::move(topology_);
  }

 private:
  // Returns -1, and reports an error, if no link has this name. If a link has no name, or the same name as another
  // link, it may be the one that is meant; this was reported, and no further error is.
  int find(const Name& name, const Joint& joint) {
    if (name.text.empty()) return -1;  // reported by read_document
    if (const auto found = links_.find(name.text)) return *found;
    if (!names_are_sound_) return -1;
    Diagnostic& error = diagnostics_.error(
        "unknown-link", name.place,
        fmt::format("joint '{}' refers to undeclared link '{}'", joint.name.text, name.text));
    if (name.text == "world")
      error.hint = "declare <link name=\"world\"/>, or leave the joint out: the root link is fixed to the world";
    else if (const auto similar = links_.nearest_to(name.text))
      error.hint = fmt::format("did you mean '{}'?", links_.name_of(*similar));
    return -1;
  }

  const std::string& link_name(int link) const { return document_.links[at(link)].name.text; }

  void adopt(int j) {
    const Joint& joint = document_.joints[at(j)];
    const int parent = topology_.parent[at(j)], child = topology_.child[at(j)];
    if (parent < 0 || child < 0) return;
    if (parent == child) {
      diagnostics_.error(
          "self-loop", joint.child.place,
          fmt::format("joint '{}' connects link '{}' to itself", joint.name.text, joint.child.text));
      return;
    }
    int& parent_joint = topology_.parent_joint[at(child)];
    if (parent_joint >= 0) {
      const Joint& first = document_.joints[at(parent_joint)];
      diagnostics_
          .error(
              "two-parents", joint.child.place,
              fmt::format(
                  "link '{}' has two parents: '{}' by joint '{}', and '{}' by joint '{}'", joint.child.text,
                  first.parent.text, first.name.text, joint.parent.text, joint.name.text))
          .notes.push_back({first.child.place, "the first parent is given here"});
      return;
    }
    parent_joint = j;
  }

  void find_root() {
    for (std::size_t link = 0; link < document_.links.size(); ++link) {
      if (topology_.parent_joint[link] >= 0) continue;
      if (topology_.root < 0) {
        topology_.root = static_cast<int>(link);
        continue;
      }
      const Link& first = document_.links[at(topology_.root)];
      const Link& second = document_.links[link];
      diagnostics_
          .error(
              "two-roots", second.name.place,
              fmt::format(
                  "links '{}' and '{}' are both roots: neither is the child of a joint", first.name.text,
                  second.name.text))
          .notes.push_back({first.name.place, fmt::format("'{}' is declared here", first.name.text)});
    }
  }

  void walk_from_root() {
    if (topology_.root < 0) return;
    std::vector<std::vector<int>> children(document_.links.size());
    for (std::size_t j = 0; j < document_.joints.size(); ++j)
      children[at(topology_.parent[j])].push_back(topology_.child[j]);
    topology_.order = {topology_.root};
    for (std::size_t i = 0; i < topology_.order.size(); ++i) {
      const std::vector<int>& next = children[at(topology_.order[i])];
      topology_.order.insert(topology_.order.end(), next.begin(), next.end());
    }
  }

  // The path to the parents of a link that no root reaches ends in a cycle.
  void report_cycles() {
    enum class State { unseen, on_this_walk, done };
    std::vector<State> states(document_.links.size(), State::unseen);
    for (std::size_t i = 0; i < states.size(); ++i) {
      std::vector<int> walk;
      int link = static_cast<int>(i);
      while (link >= 0 && states[at(link)] == State::unseen) {
        states[at(link)] = State::on_this_walk;
        walk.push_back(link);
        const int joint = topology_.parent_joint[at(link)];
        link = joint < 0 ? -1 : topology_.parent[at(joint)];
      }
      if (link >= 0 && states[at(link)] == State::on_this_walk)
        report_cycle({std::find(walk.begin(), walk.end(), link), walk.end()});
      for (const int seen : walk) states[at(seen)] = State::done;
    }
  }

  // Reports a cycle. `loop` lists its links, each followed by its parent.
  void report_cycle(std::vector<int> loop) {
    constexpr std::size_t kShown = 8;
    std::rotate(loop.begin(), std::min_element(loop.begin(), loop.end()), loop.end());
    std::reverse(loop.begin() + 1, loop.end());  // from parent to child, starting with the first declared
    std::string text;
    for (std::size_t i = 0; i < loop.size() && i < kShown; ++i) text += fmt::format("'{}' -> ", link_name(loop[i]));
    if (loop.size() > kShown) text += "... -> ";
    const Joint& closing = document_.joints[at(topology_.parent_joint[at(loop.front())])];
    diagnostics_
        .error(
            "cycle", document_.links[at(loop.front())].name.place,
            fmt::format("links form a cycle: {}'{}'", text, link_name(loop.front())))
        .notes.push_back({closing.child.place, fmt::format("'{}' becomes a child here", link_name(loop.front()))});
  }

  const Document& document_;
  Diagnostics& diagnostics_;
  model::NameIndex links_;
  Topology topology_;
  bool names_are_sound_ = true;
};

}  // namespace

void declare_world(Document& document, Diagnostics& diagnostics) {
  const auto first = std::find_if(
      document.joints.begin(), document.joints.end(), [](const Joint& joint) { return joint.parent.text == "world"; });
  if (first == document.joints.end()) return;
  std::set<std::string> children;
  for (const Joint& joint : document.joints) children.insert(joint.child.text);
  // A declared `world` is one of these links, or is a child.
  const bool has_root = std::any_of(
      document.links.begin(), document.links.end(), [&](const Link& l) { return !children.contains(l.name.text); });
  if (has_root || children.contains("world")) return;
  diagnostics
      .warning(
          "implicit-world", first->parent.place,
          "link 'world' is not declared: it becomes the root link, without inertia")
      .hint = "declare <link name=\"world\"/>";
  document.links.push_back({first->parent, std::nullopt});
}

std::optional<Topology> connect(const Document& document, Diagnostics& diagnostics) {
  return Connector(document, diagnostics).connect();
}

}  // namespace robcogen::import::from_urdf
