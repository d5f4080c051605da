#include "import/sdf/describe.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "import/sdf/frames.h"
#include "support/index.h"

namespace robcogen::import::from_sdf {
namespace {

using model::Quantity;

// The body that a link belongs to, and the pose of its frame in that of the body. Bodies are those links that a joint
// moves, and the base.
struct Carried {
  int body = kWorldLink;  // link index; kWorldLink for the base, whatever it is
  Pose pose;
};

model::JointType type_of(JointType type) {
  switch (type) {
    case JointType::prismatic:
      return model::JointType::prismatic;
    case JointType::screw:
      return model::JointType::helical;
    case JointType::ball:
      return model::JointType::spherical;
    default:
      return model::JointType::revolute;
  }
}

model::Inertia inertia_of(const Inertial& i, const Pose& link) {
  model::Inertia result;
  result.mass = Quantity(i.mass);
  result.ixx = Quantity(i.ixx), result.iyy = Quantity(i.iyy), result.izz = Quantity(i.izz);
  // The model stores products of inertia; the tensor contains their negatives.
  result.ixy = Quantity(-i.ixy), result.ixz = Quantity(-i.ixz), result.iyz = Quantity(-i.iyz);
  result.reference = placement_of(link * i.pose);
  return result;
}

class Describer {
 public:
  Describer(
      const Document& document,
      const Topology& topology,
      const Identifiers& identifiers,
      const SdfOptions& options,
      Diagnostics& diagnostics)
      : document_(document), topology_(topology), names_(identifiers), options_(options), diagnostics_(diagnostics) {}

  model::Description describe() {
    const bool is_fixed = topology_.root == kWorldLink;
    description_.name = names_.robot;
    description_.place = document_.name.place;
    description_.floating_base = !is_fixed;
    bodies_.resize(document_.links.size() + 1);
    masses_.resize(bodies_.size());
    between_.resize(document_.joints.size());
    carried_.resize(document_.links.size());
    for (const int link : topology_.order) carry(link);
    add_links();
    add_frames();
    add_joints();
    for (const int joint : topology_.loops) add_loop(joint);
    finish_links();
    add_couplings();
    return std::move(description_);
  }

 private:
  model::DescribedLink& body(int link) { return bodies_[link == kWorldLink ? document_.links.size() : at(link)]; }
  std::vector<model::Inertia>& masses(int link) {
    return masses_[link == kWorldLink ? document_.links.size() : at(link)];
  }
  Carried carried(int link) const { return link == kWorldLink ? Carried() : carried_[at(link)]; }
  int frame_of(int link) const { return link == kWorldLink ? kWorld : document_.links[at(link)].frame; }

  // The pose of the frame of the joint in the frame of its parent or child.
  Pose joint_in(const Joint& joint, int link) const { return relative_pose(document_, joint.frame, frame_of(link)); }

  // Turns z to the axis, from the frame of the joint.
  Rotation rotation_to(const Joint& joint, const Axis& axis) const {
    const Rotation own = rotation_to_axis(axis.xyz);
    return axis.frame < 0 ? own : relative_pose(document_, axis.frame, joint.frame).rotation * own;
  }

  void carry(int link) {
    Carried& own = carried_[at(link)];
    if (link == topology_.root) return;
    const int j = topology_.parent_joint[at(link)];
    if (j < 0) {
      own.pose = relative_pose(document_, frame_of(link), kWorld);
      return;
    }
    const Joint& joint = document_.joints[at(j)];
    if (joint.type == JointType::fixed) {
      const Carried parent = carried(joint.parent_link);
      own = {parent.body, parent.pose * relative_pose(document_, frame_of(link), frame_of(joint.parent_link))};
    } else {
      const Rotation to_axis = joint.axes.empty() ? Rotation() : rotation_to(joint, joint.axes.back());
      own = {link, inverse(joint_in(joint, link) * Pose{{}, to_axis})};
    }
  }

  void add_links() {
    for (std::size_t l = 0; l < document_.links.size(); ++l) {
      const Link& link = document_.links[l];
      const Carried& own = carried_[l];
      body(own.body).frames.push_back({names_.links[l], placement_of(own.pose), link.name.place});
      for (const FramedShape& shape : link.shapes) {
        const Pose frame = own.pose * relative_pose(document_, shape.frame, link.frame);
        body(own.body).shapes.push_back(placed(shape.shape, names_.links[l], frame));
      }
      if (own.body != kWorldLink || description_.floating_base) add_mass(link, own);
    }
  }

  void add_mass(const Link& link, const Carried& own) {
    const Inertial& inertial = link.inertial;
    if (inertial.is_automatic) {
      diagnostics_
          .error(
              "automatic-inertia", inertial.mass_place,
              fmt::format("the inertia of link '{}' is to be computed from its collisions", link.name.text))
          .hint = "write <mass>, <pose> and <inertia>, as `gz sdf --print --expand-auto-inertials` does";
      return;
    }
    if (!inertial.defaults.empty())
      diagnostics_.warning(
          "default-inertia", inertial.mass_place,
          fmt::format(
              "link '{}' has no {}: the values are those of SDF, 1 kg and 1 kg m^2", link.name.text, inertial.defaults));
    if (masses(own.body).empty()) {
      body(own.body).inertia_place = inertial.inertia_place;
      body(own.body).mass_place = inertial.mass_place;
    }
    masses(own.body).push_back(inertia_of(inertial, own.pose));
  }

  // Frames that the file declares. Those of the world are left out with it if the base floats.
  void add_frames() {
    for (std::size_t f = 1; f < document_.frames.size(); ++f) {
      const Frame& frame = document_.frames[f];
      const bool is_outside = frame.link == kWorldLink && description_.floating_base;
      if (!frame.is_declared || is_outside) continue;
      const Carried link = carried(frame.link);
      const Pose pose = relative_pose(document_, static_cast<int>(f), frame_of(frame.link));
      body(link.body).frames.push_back({names_.frames[f], placement_of(link.pose * pose), frame.name.place});
    }
  }

  bool is_of_tree(std::size_t j) const {
    const int child = document_.joints[j].child_link;
    return child != kWorldLink && topology_.parent_joint[at(child)] == static_cast<int>(j);
  }

  void add_joints() {
    for (std::size_t j = 0; j < document_.joints.size(); ++j) {
      const Joint& joint = document_.joints[j];
      if (joint.type == JointType::fixed || !is_of_tree(j)) continue;
      const Pose in_parent = carried(joint.parent_link).pose * joint_in(joint, joint.parent_link);
      const std::string& link = names_.links[at(joint.child_link)];
      model::DescribedLink& parent = body(carried(joint.parent_link).body);
      if (joint.axes.size() < 2) {
        const Rotation to_axis = joint.axes.empty() ? Rotation() : rotation_to(joint, joint.axes[0]);
        add_joint(j, 0, in_parent * Pose{{}, to_axis}, link, parent);
        continue;
      }
      const Rotation first = rotation_to(joint, joint.axes[0]), second = rotation_to(joint, joint.axes[1]);
      between_[j].name = names_.between[j];
      between_[j].place = joint.name.place;
      between_[j].is_virtual = true;
      add_joint(j, 0, in_parent * Pose{{}, first}, between_[j].name, parent);
      add_joint(j, 1, Pose{{}, inverse(first) * second}, link, between_[j]);
    }
  }

  void add_joint(std::size_t j, std::size_t coordinate, const Pose& pose, const std::string& child, model::DescribedLink& parent) {
    const Joint& joint = document_.joints[j];
    model::DescribedJoint described;
    described.name = names_.joints[j][coordinate];
    described.place = joint.name.place;
    described.type = type_of(joint.type);
    described.placement = placement_of(pose);
    described.pitch = joint.pitch;
    if (coordinate < joint.axes.size()) {
      const Axis& axis = joint.axes[coordinate];
      described.limits = axis.limits;
      described.drive = axis.drive;
      described.drive_places = axis.places;
    }
    parent.children.push_back({child, described.name, joint.child.place, joint.name.place});
    description_.joints.push_back(std::move(described));
  }

  void add_loop(int j) {
    const Joint& joint = document_.joints[at(j)];
    model::DescribedLoop loop;
    loop.name = names_.joints[at(j)][0];
    loop.place = joint.name.place;
    switch (joint.type) {
      case JointType::revolute:
      case JointType::continuous:
        loop.type = model::LoopType::hinge;
        break;
      case JointType::prismatic:
        loop.type = model::LoopType::slider;
        break;
      case JointType::fixed:
        loop.type = model::LoopType::weld;
        break;
      case JointType::ball:
        loop.type = model::LoopType::point;
        break;
      default:
        diagnostics_.error(
            "unsupported-loop-type", joint.type_place,
            fmt::format(
                "joint '{}' closes a loop: its type '{}' is not supported there", joint.name.text, name_of(joint.type)));
        return;
    }
    for (const Axis& axis : joint.axes)
      if (axis.drive.is_passive() || axis.drive.has_inertia())
        diagnostics_.warning(
            "mechanics-not-read", joint.name.place,
            fmt::format("the forces and the armature of joint '{}' are left out: it closes a loop", joint.name.text));
    const Pose to_axis = {{}, joint.axes.empty() ? Rotation() : rotation_to(joint, joint.axes[0])};
    const std::array<int, 2> links = {joint.parent_link, joint.child_link};
    for (std::size_t e = 0; e < 2; ++e) {
      const Carried link = carried(links[e]);
      loop.frames[e] = loop.name + (e == 0 ? "_parent" : "_child");
      loop.frame_places[e] = (e == 0 ? joint.parent : joint.child).place;
      body(link.body).frames.push_back(
          {loop.frames[e], placement_of(link.pose * joint_in(joint, links[e]) * to_axis), joint.name.place});
    }
    description_.loops.push_back(std::move(loop));
  }

  void finish_links() {
    const bool is_world = topology_.root == kWorldLink;
    model::DescribedLink& base = body(kWorldLink);
    base.name = is_world ? names_.world : names_.links[at(topology_.root)];
    base.place = is_world ? document_.name.place : document_.links[at(topology_.root)].name.place;
    base.inertia = model::sum_of(masses(kWorldLink));
    for (std::size_t l = 0; l < document_.links.size(); ++l) {
      if (carried_[l].body != static_cast<int>(l)) continue;
      model::DescribedLink& link = bodies_[l];
      link.name = names_.links[l];
      link.place = document_.links[l].name.place;
      link.inertia = model::sum_of(masses_[l]);
      model::DescribedLink& between = between_[at(topology_.parent_joint[l])];
      if (!between.name.empty()) description_.links.push_back(std::move(between));
      description_.links.push_back(std::move(link));
    }
    description_.base = std::move(base);
  }

  void add_couplings() {
    std::string freed;
    Place first_freed;
    for (std::size_t j = 0; j < document_.joints.size(); ++j) {
      const Joint& joint = document_.joints[j];
      for (std::size_t i = 0; i < joint.axes.size(); ++i) {
        if (!joint.axes[i].mimic) continue;
        const Mimic& mimic = *joint.axes[i].mimic;
        if (!options_.free_mimic_joints) {
          add_coupling(j, i, mimic);
          continue;
        }
        if (freed.empty()) first_freed = mimic.joint.place;
        freed += fmt::format("{}'{}'", freed.empty() ? "" : ", ", joint.name.text);
      }
    }
    if (!freed.empty())
      diagnostics_.note(
          "mimic-joints-freed", first_freed,
          fmt::format("these joints mimic others and are read as independent joints: {}", freed));
  }

  // q = multiplier (q_followed - reference) + offset
  void add_coupling(std::size_t j, std::size_t coordinate, const Mimic& mimic) {
    const Joint& joint = document_.joints[j];
    const auto followed = find_joint(document_, joint.scope, mimic.joint, diagnostics_);
    if (!followed) return;
    const Joint& leader = document_.joints[at(*followed)];
    const std::size_t axis = mimic.second_axis ? 1 : 0;
    const bool is_possible = is_of_tree(j) && is_of_tree(at(*followed)) && axis < leader.axes.size();
    if (!is_possible) {
      diagnostics_
          .error(
              "coupled-joint", mimic.joint.place,
              fmt::format(
                  "joint '{}' mimics '{}', but {}", joint.name.text, mimic.joint.text,
                  axis < leader.axes.size() ? "one of them closes a loop" : "that has no such axis"))
          .hint = "--free-mimic-joints makes it an independent joint";
      return;
    }
    const Place& place = mimic.joint.place;
    const Number offset = mimic.offset - mimic.multiplier * mimic.reference;
    description_.couplings.push_back(
        {names_.joints[j][coordinate], place, {{names_.joints[at(*followed)][axis], Quantity(mimic.multiplier), place}},
         Quantity(offset)});
  }

  const Document& document_;
  const Topology& topology_;
  const Identifiers& names_;
  const SdfOptions& options_;
  Diagnostics& diagnostics_;
  model::Description description_;
  std::vector<Carried> carried_;                    // by link
  std::vector<model::DescribedLink> bodies_;        // by link; the last one is the base
  std::vector<std::vector<model::Inertia>> masses_;  // likewise
  std::vector<model::DescribedLink> between_;       // by joint: the link between its two axes
};

}  // namespace

model::Description describe(
    const Document& document,
    const Topology& topology,
    const Identifiers& identifiers,
    const SdfOptions& options,
    Diagnostics& diagnostics) {
  return Describer(document, topology, identifiers, options, diagnostics).describe();
}

}  // namespace robcogen::import::from_sdf
