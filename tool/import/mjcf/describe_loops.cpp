#include "import/mjcf/describe_loops.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>
#include <utility>

#include "import/identifier.h"
#include "import/mjcf/anchors.h"
#include "support/index.h"
#include "support/unique_names.h"

namespace robcogen::import::from_mjcf {

namespace {

// Those whose joints move the ends of a loop relative to each other.
std::set<std::size_t> bodies_in_loops(const Document& document) {
  std::set<std::size_t> bodies;
  for (const Loop& loop : document.loops) {
    const std::size_t ancestor = common_ancestor(document, loop.ends[0].body, loop.ends[1].body);
    for (const Anchor& end : loop.ends)
      for (const std::size_t b : path(document, end.body, ancestor)) bodies.insert(b);
  }
  return bodies;
}

class LoopDescriber {
 public:
  LoopDescriber(
      const Document& document,
      const Identifiers& identifiers,
      const std::vector<Carried>& carried,
      model::Description& description)
      : document_(document), identifiers_(identifiers), carried_(carried), description_(description) {
    frames_.reserve_all(identifiers.bodies);
    for (const auto& sites : identifiers.sites) frames_.reserve_all(sites);
  }

  void add() {
    description_.assembled_form = model::AssembledForm::key;
    for (const Loop& loop : document_.loops) add(loop);
    for (const Cylinder& cylinder : document_.cylinders) add(cylinder);
    if (!document_.loops.empty()) add_joints();
  }

 private:
  const Document& document_;
  const Identifiers& identifiers_;
  const std::vector<Carried>& carried_;
  model::Description& description_;
  UniqueNames frames_, loops_, actuators_;

  const std::string& site(const Anchor& end) const { return identifiers_.sites[end.body][at(end.site)]; }

  void add(const Loop& loop) {
    model::DescribedLoop described;
    described.name = loops_.add(identifier(loop.name));
    described.place = loop.place;
    described.type = loop.type;
    described.length = quantity(loop.length);
    for (std::size_t e = 0; e < 2; ++e) {
      const Anchor& end = loop.ends[e];
      described.frames[e] = end.site >= 0 ? site(end) : add_frame(described.name + (e == 0 ? "_1" : "_2"), end);
      described.frame_places[e] = end.place;
    }
    description_.loops.push_back(std::move(described));
  }

  // Returns the name of a new user frame.
  std::string add_frame(const std::string& wanted, const Anchor& end) {
    const Carried& carried = carried_[end.body];
    model::DescribedLink& link = carried.link == 0 ? description_.base : description_.links[at(carried.link) - 1];
    const std::string name = frames_.add(wanted);
    link.frames.push_back({name, placement_of(carried.pose * end.pose), end.place});
    return name;
  }

  void add(const Cylinder& cylinder) {
    model::DescribedActuator described;
    described.name = actuators_.add(identifier(cylinder.name.text));
    described.place = cylinder.name.place;
    for (std::size_t e = 0; e < 2; ++e) {
      described.frames[e] = site(cylinder.ends[e]);
      described.frame_places[e] = cylinder.ends[e].place;
    }
    description_.actuators.push_back(std::move(described));
  }

  // The joints that move loops themselves, or that such joints are coupled to.
  std::set<std::string> movers() const {
    std::set<std::string> names;
    for (const std::size_t b : bodies_in_loops(document_))
      names.insert(identifiers_.joints[b].begin(), identifiers_.joints[b].end());
    for (std::size_t repeated = 0; repeated < description_.couplings.size(); ++repeated)
      for (const model::DescribedCoupling& coupling : description_.couplings)
        for (const auto& term : coupling.terms)
          if (names.contains(coupling.joint)) names.insert(term.joint);
    for (const model::DescribedCoupling& coupling : description_.couplings) names.erase(coupling.joint);
    return names;
  }

  void add_joints() {
    const std::set<std::string> moving = movers();
    std::map<std::string, model::DescribedJoint*> described;
    for (model::DescribedJoint& joint : description_.joints) described[joint.name] = &joint;
    for (std::size_t b = 0; b < document_.bodies.size(); ++b)
      for (std::size_t j = 0; j < document_.bodies[b].joints.size(); ++j) {
        const Joint& joint = document_.bodies[b].joints[j];
        const std::string& name = identifiers_.joints[b][j];
        if (!moving.contains(name) || !described.contains(name)) continue;
        if (joint.is_pulled || !joint.drive.stiffness.is_zero()) description_.driven.push_back(name);
        const double position = document_.has_key && !joint.key.empty() ? joint.key.front() : joint.reference.value();
        if (position != 0.0) described[name]->assembled = position;
        described[name]->assembled_place = joint.name.place;
      }
  }
};

}  // namespace

void add_loops(
    const Document& document,
    const Identifiers& identifiers,
    const std::vector<Carried>& carried,
    model::Description& description) {
  if (document.loops.empty() && document.cylinders.empty()) return;
  LoopDescriber(document, identifiers, carried, description).add();
}

void check_drawn_loops(const Document& document, Diagnostics& diagnostics) {
  std::string names;
  Place first;
  for (const std::size_t b : bodies_in_loops(document))
    for (const Joint& joint : document.bodies[b].joints) {
      const double drawn = joint.reference.value();
      if (drawn >= joint.limits.lower && drawn <= joint.limits.upper) continue;
      if (names.empty()) first = joint.name.place;
      names += fmt::format("{}'{}'", names.empty() ? "" : ", ", joint.name.text);
    }
  if (names.empty()) return;
  diagnostics
      .warning(
          "loop-outside-range", first,
          fmt::format(
              "loops are assembled as drawn, where these joints are outside their ranges: {}; links may fold to the "
              "wrong side",
              names))
      .hint = "give the model a 'key' whose 'qpos' closes the loops within the ranges";
}

}  // namespace robcogen::import::from_mjcf
