#include "import/srdf.h"

#include <fmt/format.h>

#include <set>
#include <string>
#include <utility>
#include <vector>

#include "import/identifier.h"
#include "import/urdf/element_reader.h"
#include "support/words.h"

namespace robcogen::import {
namespace from_urdf {
namespace {

// Elements that say nothing about pairs of links.
const std::vector<std::string> kOthers = {"chain",         "end_effector",   "group",
                                          "group_state",   "joint_property", "link_sphere_approximation",
                                          "passive_joint", "virtual_joint"};

// The names of links as the model has them.
std::set<std::string> bodies_of(const model::KinematicTree& tree) {
  std::set<std::string> names;
  for (const model::UserFrame& frame : tree.user_frames) names.insert(frame.name);
  for (const model::Link& link : tree.links) names.insert(link.name);
  for (const model::Shape& shape : tree.geometry.shapes) names.insert(shape.body);
  return names;
}

class SrdfReader {
 public:
  SrdfReader(std::shared_ptr<const Source> source, model::KinematicTree& tree, Diagnostics& diagnostics)
      : reader_(std::move(source), diagnostics), tree_(tree), diagnostics_(diagnostics), bodies_(bodies_of(tree)) {}

  void read(const Element& root) {
    tree_.geometry.has_srdf = true;
    for (const Element& element : root.children) {
      if (element.name == "disable_collisions") {
        read_pair(element);
      } else if (!is_among(kOthers, element.name)) {
        diagnostics_.warning(
            "unknown-element", reader_.place(element.span),
            fmt::format("element '{}' of this SRDF is not read", element.name));
      }
    }
  }

 private:
  ElementReader reader_;
  model::KinematicTree& tree_;
  Diagnostics& diagnostics_;
  std::set<std::string> bodies_;

  void read_pair(const Element& element) {
    const std::size_t errors_before = diagnostics_.error_count();
    const Name first = reader_.name(element, "link1"), second = reader_.name(element, "link2");
    if (diagnostics_.error_count() > errors_before) return;
    const std::string a = identifier(first.text), b = identifier(second.text);
    for (const auto& [written, name] : {std::pair{&first, &a}, {&second, &b}}) {
      if (bodies_.contains(*name)) continue;
      diagnostics_
          .warning(
              "unknown-link", written->place,
              fmt::format("robot '{}' has no link '{}': the pair is ignored", tree_.name, written->text))
          .hint = did_you_mean(*name, {bodies_.begin(), bodies_.end()});
      return;
    }
    tree_.geometry.may_touch.push_back({a, b});
  }
};

}  // namespace
}  // namespace from_urdf

bool read_srdf(const std::shared_ptr<const Source>& source, model::KinematicTree& tree, Diagnostics& diagnostics) {
  const std::size_t errors_before = diagnostics.error_count();
  const std::optional<xml::Element> root = xml::read(source, diagnostics);
  if (!root) return false;
  if (root->name != "robot") {
    diagnostics.error(
        "other-format", {source, root->span},
        fmt::format("this XML is not an SRDF: its root element is '{}', not 'robot'", root->name));
    return false;
  }
  from_urdf::SrdfReader(source, tree, diagnostics).read(*root);
  return diagnostics.error_count() == errors_before;
}

}  // namespace robcogen::import
