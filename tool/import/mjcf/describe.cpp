#include "import/mjcf/describe.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "import/mjcf/describe_loops.h"
#include "support/index.h"
#include "support/unique_names.h"

namespace robcogen::import::from_mjcf {

namespace {

// The frame of the joint, with z along its axis, in the frame of its body.
Pose pose_of_joint(const Joint& joint) {
  const Pose pose = joint.frame * Pose{quantities(joint.pos), rotation_to_axis(joint.axis)};
  // The axes of a ball joint are those of its body.
  return joint.type == model::JointType::spherical ? Pose{pose.translation, {}} : pose;
}

// Moves back by the reference position, to where the joint is at zero.
Pose to_zero(const Joint& joint) {
  if (joint.type == model::JointType::spherical) return {};
  if (joint.type == model::JointType::revolute) return {{}, rotation_about(2, -joint.reference)};
  return {{model::Quantity(), model::Quantity(), quantity(-joint.reference)}, {}};
}

class Describer {
 public:
  Describer(const Document& document, const Identifiers& identifiers, Diagnostics& diagnostics)
      : document_(document), identifiers_(identifiers), diagnostics_(diagnostics) {
    names_.reserve_all(identifiers.bodies);
    for (const auto& joints : identifiers.joints) names_.reserve_all(joints);
  }

  model::Description describe() {
    const std::size_t base = document_.robot.base;
    description_.name = identifiers_.robot;
    description_.place = document_.name.place;
    description_.floating_base = document_.bodies[base].floats();
    links_.emplace_back();
    links_[0].name = identifiers_.bodies[base];
    links_[0].place = document_.bodies[base].name.place;
    parts_.emplace_back();
    carried_.resize(document_.bodies.size());
    for (std::size_t b = 0; b < document_.bodies.size(); ++b) add_body(b, base);
    mention_left_out(base);
    for (std::size_t l = 0; l < links_.size(); ++l) {
      links_[l].inertia = model::sum_of(parts_[l]);
      if (l > 0) description_.links.push_back(std::move(links_[l]));
    }
    description_.base = std::move(links_[0]);
    for (const Coupling& coupling : document_.couplings) add_couplings(coupling);
    add_tendon_couplings(document_, identifiers_, description_, diagnostics_);
    add_tendons(document_, identifiers_, description_, diagnostics_);
    add_loops(document_, identifiers_, carried_, description_);
    return std::move(description_);
  }

 private:
  void add_body(std::size_t b, std::size_t base) {
    const Body& body = document_.bodies[b];
    if (b == base) {
      carried_[b] = {0, {}};
    } else if (document_.robot.has[b] && body.parent >= 0 && carried_[at(body.parent)].link >= 0) {
      const Carried& parent = carried_[at(body.parent)];
      carried_[b] = {parent.link, parent.pose * body.pose};
      for (std::size_t j = 0; j < body.joints.size(); ++j) add_joint(b, j);
    }
    const Carried& own = carried_[b];
    if (own.link < 0) {
      leave_out(b);
      return;
    }
    model::DescribedLink& link = links_[at(own.link)];
    const std::string& name = identifiers_.bodies[b];
    link.frames.push_back({name, placement_of(own.pose), body.name.place});
    for (std::size_t s = 0; s < body.sites.size(); ++s) {
      const Site& site = body.sites[s];
      link.frames.push_back({identifiers_.sites[b][s], placement_of(own.pose * site.pose), site.name.place});
    }
    for (const BodyShape& shape : body.shapes) link.shapes.push_back(placed(shape, name, own.pose));
    for (const Part& part : body.parts) {
      if (parts_[at(own.link)].empty()) {
        link.inertia_place = part.inertia_place;
        link.mass_place = part.mass_place;
      }
      parts_[at(own.link)].push_back(inertia_of(part, own.pose));
    }
  }

  // Counts the body, unless it is the world, and its sites.
  void leave_out(std::size_t b) {
    const auto count = [&](std::size_t& number, const Name& name) {
      if (left_out_bodies_ + left_out_sites_ == 0) first_left_out_ = name.place;
      ++number;
    };
    const Body& body = document_.bodies[b];
    if (b != 0) count(left_out_bodies_, body.name);
    for (const Site& site : body.sites) count(left_out_sites_, site.name);
  }

  void mention_left_out(std::size_t base) {
    const auto counted = [](std::size_t count, const char* one, const char* several) {
      return fmt::format("{} {}", count, count == 1 ? one : several);
    };
    std::string list;
    if (left_out_bodies_ > 0) list = counted(left_out_bodies_, "body", "bodies");
    if (left_out_sites_ > 0) list += (list.empty() ? "" : ", ") + counted(left_out_sites_, "site", "sites");
    if (!list.empty())
      diagnostics_.note(
          "outside-robot", first_left_out_,
          fmt::format("not part of the robot, whose base is '{}', and left out: {}", identifiers_.bodies[base], list));
  }

  // Moves the body from the link that has carried it so far to a new link.
  void add_joint(std::size_t b, std::size_t j) {
    const Body& body = document_.bodies[b];
    const Joint& joint = body.joints[j];
    const bool is_last = j + 1 == body.joints.size();
    const std::string& name = identifiers_.joints[b][j];
    const std::string& body_name = identifiers_.bodies[b];
    const std::string link_name = is_last ? body_name : names_.add(fmt::format("{}_{}", body_name, j + 1));

    const Pose in_body = pose_of_joint(joint);
    Carried& carried = carried_[b];
    model::DescribedJoint described;
    described.name = name;
    described.place = joint.name.place;
    described.type = joint.type;
    described.placement = placement_of(carried.pose * in_body * to_zero(joint));
    described.limits = joint.limits;
    described.drive = joint.drive;
    described.drive_places = joint.places;
    description_.joints.push_back(std::move(described));

    links_[at(carried.link)].children.push_back({link_name, name, body.name.place, joint.name.place});
    carried = {static_cast<int>(links_.size()), inverse(in_body)};
    links_.emplace_back();
    links_.back().name = link_name;
    links_.back().place = body.name.place;
    links_.back().is_virtual = !is_last;
    parts_.emplace_back();
  }

  struct FoundJoint {
    std::size_t body = 0, joint = 0;
  };

  // The joints of a name in the file: several if it is copied, none if it is reported.
  std::vector<FoundJoint> find_joints(const Name& name) {
    std::vector<FoundJoint> found;
    std::vector<std::string> names;
    for (std::size_t b = 0; b < document_.bodies.size(); ++b) {
      const std::vector<Joint>& joints = document_.bodies[b].joints;
      for (std::size_t j = 0; j < joints.size(); ++j) {
        if (joints[j].name.text.empty()) continue;
        if (is_named(joints[j], name.text)) found.push_back({b, j});
        names.push_back(joints[j].name.text);
      }
    }
    if (found.empty())
      diagnostics_.error("coupled-joint", name.place, fmt::format("joint '{}' is not declared", name.text)).hint =
          did_you_mean(name.text, names);
    return found;
  }

  const Joint& at_place(const FoundJoint& found) const { return document_.bodies[found.body].joints[found.joint]; }
  const std::string& identifier(const FoundJoint& found) const { return identifiers_.joints[found.body][found.joint]; }
  bool is_part(const FoundJoint& found) const { return document_.robot.has[found.body]; }

  void add_couplings(const Coupling& coupling) {
    const std::vector<FoundJoint> joints = find_joints(coupling.joint);
    if (joints.empty()) return;
    if (coupling.followed.text.empty()) {
      for (const FoundJoint& joint : joints) add_fixed(coupling, joint);
      return;
    }
    const std::vector<FoundJoint> followed = find_joints(coupling.followed);
    if (followed.empty()) return;
    for (const FoundJoint& joint : joints) {
      // A copy follows the joint of the same copy, or the only one.
      const auto same = std::find_if(followed.begin(), followed.end(), [&](const FoundJoint& f) {
        return at_place(f).written.suffix == at_place(joint).written.suffix;
      });
      add_coupling(coupling, joint, same == followed.end() ? followed.front() : *same);
    }
  }

  // y = a + y0
  void add_fixed(const Coupling& coupling, const FoundJoint& joint) {
    if (!is_part(joint)) return;
    const Number offset = coupling.offset + at_place(joint).reference;
    description_.couplings.push_back({identifier(joint), coupling.joint.place, {}, quantity(offset)});
  }

  // y = b x + (a + y0 - b x0)
  void add_coupling(const Coupling& coupling, const FoundJoint& joint, const FoundJoint& followed) {
    if (is_part(joint) != is_part(followed)) {
      const bool is_outside = !is_part(followed);
      diagnostics_
          .error(
              "coupled-joint", coupling.joint.place,
              fmt::format(
                  "joints '{}' and '{}' are coupled, but '{}' is not part of the robot", identifier(joint),
                  identifier(followed), is_outside ? identifier(followed) : identifier(joint)))
          .hint = "--free-mimic-joints ignores the coupling";
      return;
    }
    if (!is_part(joint)) return;
    const Number offset = coupling.offset + at_place(joint).reference - coupling.factor * at_place(followed).reference;
    const model::DescribedCoupling::Term term = {
        identifier(followed), quantity(coupling.factor), coupling.followed.place};
    description_.couplings.push_back({identifier(joint), coupling.joint.place, {term}, quantity(offset)});
  }

  const Document& document_;
  const Identifiers& identifiers_;
  Diagnostics& diagnostics_;
  model::Description description_;
  std::vector<model::DescribedLink> links_;
  std::vector<std::vector<model::Inertia>> parts_;  // by link
  std::vector<Carried> carried_;                    // by body
  std::size_t left_out_bodies_ = 0, left_out_sites_ = 0;
  Place first_left_out_;
  UniqueNames names_;
};

bool may_meet(const Body& a, const Body& b) {
  for (const ContactBits& x : a.contact)
    for (const ContactBits& y : b.contact)
      if ((x.type & y.affinity) != 0 || (y.type & x.affinity) != 0) return true;
  return a.contact.empty() || b.contact.empty();
}

}  // namespace

model::Description describe(const Document& document, const Identifiers& identifiers, Diagnostics& diagnostics) {
  return Describer(document, identifiers, diagnostics).describe();
}

std::vector<std::array<std::string, 2>> excluded_pairs(const Document& document, const Identifiers& identifiers) {
  std::vector<std::array<std::string, 2>> pairs;
  for (const auto& [first, second] : document.excludes)
    for (std::size_t a = 0; a < document.bodies.size(); ++a) {
      if (!is_named(document.bodies[a], first.text)) continue;
      // A copy is excluded from the body of the same copy, or from the only one.
      const auto is_second = [&second = second](const Body& body) { return is_named(body, second.text); };
      auto found = std::find_if(document.bodies.begin(), document.bodies.end(), [&](const Body& body) {
        return is_second(body) && body.written.suffix == document.bodies[a].written.suffix;
      });
      if (found == document.bodies.end())
        found = std::find_if(document.bodies.begin(), document.bodies.end(), is_second);
      const auto b = static_cast<std::size_t>(found - document.bodies.begin());
      pairs.push_back({identifiers.bodies[a], identifiers.bodies[b]});
    }
  for (std::size_t a = 0; a < document.bodies.size(); ++a)
    for (std::size_t b = a + 1; b < document.bodies.size(); ++b)
      if (!may_meet(document.bodies[a], document.bodies[b]))
        pairs.push_back({identifiers.bodies[a], identifiers.bodies[b]});
  return pairs;
}

}  // namespace robcogen::import::from_mjcf
