#include "backend/common/constants.h"

#include <array>
#include <utility>

#include "backend/common/meaning.h"
#include "support/index.h"

namespace robcogen::backend {
namespace {

std::vector<double> numbers(const std::array<double, 3>& values) {
  return {values.begin(), values.end()};
}

std::string name_of(model::JointType type) {
  switch (type) {
    case model::JointType::revolute:
      return "revolute";
    case model::JointType::prismatic:
      return "prismatic";
    case model::JointType::helical:
      return "helical";
    case model::JointType::spherical:
      break;
  }
  return "spherical";
}

// The lists of one robot.
class Lists {
 public:
  explicit Lists(const model::KinematicTree& tree) : tree_(tree), value_(tree.parameters) {}

  std::vector<ConstantList> all() const {
    std::vector<ConstantList> lists = {
        {"joints", {}}, {"coupled_joints", {}}, {"links", {}}, {"frames", {}}, {"limbs", {}}};
    for (const int j : tree_.coordinates()) lists[0].items.push_back(joint(j));
    for (const model::Coupling& coupling : tree_.couplings) lists[1].items.push_back(coupled_joint(coupling));
    const std::vector<int> carriers = model::carrying_joints(tree_);
    for (std::size_t l = 0; l < carriers.size(); ++l) lists[2].items.push_back(link(tree_.links[l], carriers[l]));
    for (const model::Frame& f : tree_.frames())
      lists[3].items.push_back(placed({{"name", f.name}, {"link", tree_.link_of(f)}}, tree_.placement_of(f)));
    for (const model::Limb& l : model::listed_limbs(tree_)) lists[4].items.push_back(limb(l));
    if (!tree_.tendons.empty()) lists.push_back({"tendons", {}});
    for (const model::Tendon& t : tree_.tendons) lists.back().items.push_back(tendon(t));
    return lists;
  }

 private:
  using Members = std::vector<Constant>;

  Members placed(Members members, const model::Placement& placement) const {
    members.push_back({"translation", numbers(value_(placement.translation))});
    members.push_back({"rotation", numbers(value_(placement.rotation))});
    return members;
  }

  Record drive(const model::Joint& joint) const {
    constexpr std::size_t kOfRotor = 6;  // the first number of the rotor
    Record record(2);
    const std::array<double, 8> all = model::drive_numbers(joint, value_);
    for (std::size_t k = 0; k < all.size(); ++k)
      record[k < kOfRotor ? 0 : 1].push_back({model::kDriveNumbers[k], all[k]});
    record[1].push_back({"rotor_axis", numbers(model::rotor_axis(joint, value_))});
    record[1].push_back({"rotor_carrier", model::rotor_carrier(joint)});
    return record;
  }

  Members joint(int index) const {
    const model::Joint& j = tree_.joints[at(index)];
    Members members = placed(
        {{"name", j.name},
         {"type", name_of(j.type)},
         {"parent", model::parent_link(tree_, index)},
         {"child", model::child_link(tree_, index)}},
        model::placement_of_joint(tree_, index));
    members.insert(
        members.end(), {{"lower", j.limits.lower},
                        {"upper", j.limits.upper},
                        {"velocity", j.limits.velocity},
                        {"effort", j.limits.effort}});
    if (j.type == model::JointType::helical) members.push_back({"pitch", value_(j.pitch)});
    if (!j.drive.is_absent()) members.push_back({"drive", drive(j)});
    return members;
  }

  Members coupled_joint(const model::Coupling& coupling) const {
    Members members = joint(coupling.joint);
    model::CouplingNumbers sum = model::coupling_numbers(tree_, coupling, value_);
    members.push_back({"factors", std::move(sum.factors)});
    members.push_back({"offset", sum.offset});
    return members;
  }

  Members link(const model::Link& l, int carrier) const {
    const auto [mass, com, inertia] = model::mass_properties(l, value_);
    return {
        {"name", l.name},
        {"parent_joint", carrier},
        {"mass", mass},
        {"com", numbers(com)},
        {"moments", std::vector<double>(inertia.begin(), inertia.begin() + 3)},
        {"products", std::vector<double>(inertia.begin() + 3, inertia.end())}};
  }

  Members tendon(const model::Tendon& t) const {
    model::TendonNumbers n = model::tendon_numbers(tree_, t, value_);
    return {
        {"name", t.name},
        {"factors", std::move(n.factors)},
        {"stiffness", n.stiffness},
        {"damping", n.damping},
        {"rest", n.rest}};
  }

  static Members limb(const model::Limb& l) {
    const auto indices = [](const std::vector<model::Limb::Element>& elements) {
      Record record(elements.empty() ? 0 : 1);
      for (const model::Limb::Element& e : elements) record.front().push_back({e.own, e.index});
      return record;
    };
    return {
        {"name", l.name},
        {"part", l.part},
        {"first_link", l.first_link},
        {"links", indices(l.links)},
        {"joints", indices(l.joints)},
        {"frames", indices(l.frames)}};
  }

  const model::KinematicTree& tree_;
  model::DefaultValues value_;
};

}  // namespace

std::vector<ConstantList> constants(const Library& library) {
  return Lists(library.tree).all();
}

std::vector<std::string> describe_constants(const Library& library) {
  const model::KinematicTree& tree = library.tree;
  std::vector<std::string> lines = {
      "Constants of the robot, in SI units. Indices count from 0; link 0 is the base, whose parent_joint is -1.",
      "joints: in the order of joint arrays, with the pose of the joint frame in the frame of the parent link "
      "(translation, then rotation about the axes x, y', z'') and limits.",
      "coupled_joints: joints that follow the others, at factors * q + offset. Their indices come after those of "
      "joints.",
      "links: mass, com, and moments of inertia xx, yy, zz and products of inertia xy, xz, yz, of positive sign, about "
      "the origin of the link frame.",
      "frames: the link that a frame moves with, and its pose in the frame of this link.",
      "limbs: for each instance of a part in the document, the index of its first link, and the indices of its links, "
      "joints and user frames, by their names in the part."};
  if (!tree.tendons.empty())
    lines.push_back(
        "tendons: springs and dampers; the length is the sum of factors * positions of joints, coupled joints last.");
  if (!tree.spherical_joints().empty())
    lines.push_back(
        "positions: the elements of q. A spherical joint has a unit quaternion, scalar part first; in joints it has "
        "three components, for its angular velocities about the axes of the child. Factors multiply q without the "
        "scalar parts.");
  if (!tree.followers_in_q().empty())
    lines.push_back(
        "positions: the elements of q. The positions of joints come first, then those of coupled joints that "
        "close_loops computes.");
  if (tree.has_closures())
    lines.push_back(
        "factors and offset are NaN for joints that follow through a loop: joint_positions computes their positions.");
  if (!library.parameters().empty())
    lines.push_back(
        "Numbers that depend on parameters are computed from the declared values; they are NaN if a value is missing.");
  return lines;
}

std::vector<std::pair<std::string, std::size_t>> sizes(const Library& library) {
  const model::KinematicTree& tree = library.tree;
  std::vector<std::pair<std::string, std::size_t>> all;
  if (library.has_robot()) all = {{"dof", at(tree.dof())}, {"link_count", at(tree.link_count())}};
  if (model::has_own_positions(tree)) all.emplace_back("positions", at(tree.position_count()));
  if (!library.parameters().empty()) all.emplace_back("parameter_count", library.parameters().size());
  return all;
}

std::vector<Table> tables(const Library& library) {
  const model::KinematicTree& tree = library.tree;
  const bool has_own_positions = model::has_own_positions(tree);
  const std::vector<int> joints = tree.coordinates();
  std::vector<Table> all;
  if (library.has_robot()) {
    const std::string but = !tree.spherical_joints().empty() ? " except q; a spherical joint has three elements"
                            : has_own_positions              ? " except q"
                                                             : "";
    all.push_back({"joint_names", "The joints, in the order of all arrays of joints" + but, names_of(tree, joints)});
    if (has_own_positions)
      all.push_back(
          {"position_names", "The elements of q: " + meaning_of_positions(library), model::position_names(tree)});
    all.push_back({"link_names", "The links, the base first", model::link_names(tree)});
  }
  all.push_back({"frame_names", "The frames of transforms", library.frames()});
  if (!library.parameters().empty())
    all.push_back({"parameter_names", "The parameters", model::names_of(library.parameters())});
  if (joints.empty()) return all;
  const auto add = [&](const std::string& name, const std::string& what, double model::JointLimits::*limit) {
    all.push_back({name, what, {}, {}, true});
    for (const int j : joints) all.back().numbers.push_back(tree.joints[at(j)].limits.*limit);
  };
  add("joint_lower", "Lower position limits: rad or m.", &model::JointLimits::lower);
  add("joint_upper", "Upper position limits: rad or m.", &model::JointLimits::upper);
  add("joint_velocity", "Velocity limits: rad/s or m/s.", &model::JointLimits::velocity);
  add("joint_effort", "Effort limits: N m or N.", &model::JointLimits::effort);
  return all;
}

}  // namespace robcogen::backend
