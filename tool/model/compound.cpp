#include "model/compound.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <optional>
#include <utility>

#include "model/rotations.h"
#include "support/unique_names.h"

namespace robcogen::model {
namespace {

const Quantity kQuarterTurn(Number::pi_multiple(1, 2));

// Rotation angles about x, y and z that turn the z axis to this axis: a joint moves about or along z.
std::array<Quantity, 3> rotation_to(Axis axis) {
  switch (axis) {
    case Axis::x:
      return {Quantity(), kQuarterTurn, Quantity()};
    case Axis::y:
      return {-kQuarterTurn, Quantity(), Quantity()};
    case Axis::z:
      break;
  }
  return {};
}

bool is_constant(const std::array<Quantity, 3>& q) {
  return std::all_of(q.begin(), q.end(), [](const Quantity& e) { return e.is_constant(); });
}

// Returns the angles of the rotation followed by one that turns z to this axis, or nullopt if they cannot be computed
// because of parameters.
std::optional<std::array<Quantity, 3>> turned(const std::array<Quantity, 3>& rotation, Axis axis) {
  if (axis == Axis::z) return rotation;
  if (axis == Axis::x && rotation[2].is_zero()) return std::array{rotation[0], rotation[1] + kQuarterTurn, Quantity()};
  if (!is_constant(rotation)) return std::nullopt;
  return angles_of(product(rotation_matrix({{}, rotation}), rotation_matrix({{}, rotation_to(axis)})));
}

// Returns the rotation from a link whose z axis is along one axis of the joint frame to a frame whose z axis is along
// another.
std::array<Quantity, 3> rotation_between(Axis from, Axis to) {
  return angles_of(
      product(transposed(rotation_matrix({{}, rotation_to(from)})), rotation_matrix({{}, rotation_to(to)})));
}

// The base, then the links.
std::vector<DescribedLink*> all_links(Description& description) {
  std::vector<DescribedLink*> links = {&description.base};
  for (DescribedLink& link : description.links) links.push_back(&link);
  return links;
}

UniqueNames names_in(Description& description) {
  UniqueNames names;
  for (const DescribedLink* link : all_links(description)) names.reserve(link->name);
  for (const DescribedJoint& joint : description.joints) names.reserve(joint.name);
  return names;
}

// Inserts links between the parent and the child of the joint. Returns whether a link names the joint.
bool add_links(const DescribedCompound& joint, Description& description) {
  const std::span<const CompoundCoordinate> coordinates = coordinates_of(joint.type);
  UniqueNames taken = names_in(description);
  std::vector<DescribedLink> between;
  std::string last;  // the child of the compound joint
  for (DescribedLink* link : all_links(description)) {
    for (DescribedChild& child : link->children) {
      if (child.joint != joint.name) continue;
      child.joint = coordinate_name(joint.name, coordinates.front());
      if (!between.empty()) continue;  // a second use of the joint, which `build` reports
      last = child.link;
      DescribedChild* next = &child;
      for (std::size_t k = 1; k < coordinates.size(); ++k) {
        DescribedLink made;
        made.name = taken.add(coordinate_name(joint.name, coordinates[k - 1]) + "_link");
        made.place = joint.place;
        made.is_virtual = true;
        next->link = made.name;
        made.children = {{last, coordinate_name(joint.name, coordinates[k]), child.link_place, child.joint_place}};
        between.push_back(std::move(made));
        next = &between.back().children.front();
      }
    }
  }
  if (between.empty()) return false;
  const auto before = std::find_if(
      description.links.begin(), description.links.end(), [&](const DescribedLink& link) { return link.name == last; });
  description.links.insert(before, std::make_move_iterator(between.begin()), std::make_move_iterator(between.end()));
  return true;
}

}  // namespace

std::span<const CompoundCoordinate> coordinates_of(CompoundType type) {
  static constexpr std::array kCylindrical = {
      CompoundCoordinate{"slide", JointType::prismatic, Axis::z},
      CompoundCoordinate{"turn", JointType::revolute, Axis::z}};
  static constexpr std::array kUniversal = {
      CompoundCoordinate{"turn_x", JointType::revolute, Axis::x},
      CompoundCoordinate{"turn_z", JointType::revolute, Axis::z}};
  static constexpr std::array kPlanar = {
      CompoundCoordinate{"slide_x", JointType::prismatic, Axis::x},
      CompoundCoordinate{"slide_y", JointType::prismatic, Axis::y},
      CompoundCoordinate{"turn", JointType::revolute, Axis::z}};
  switch (type) {
    case CompoundType::cylindrical:
      break;
    case CompoundType::universal:
      return kUniversal;
    case CompoundType::planar:
      return kPlanar;
  }
  return kCylindrical;
}

std::string coordinate_name(const std::string& joint, const CompoundCoordinate& coordinate) {
  return joint + "_" + coordinate.name;
}

void add_compound(const DescribedCompound& joint, Description& description, Diagnostics& diagnostics) {
  const std::span<const CompoundCoordinate> coordinates = coordinates_of(joint.type);
  const auto rotation = turned(joint.placement.rotation, coordinates.front().axis);
  if (!rotation)
    diagnostics
        .error(
            "rotation-with-parameter", joint.placement_place,
            fmt::format("the rotation of joint '{}' depends on a parameter", joint.name))
        .hint = "the first axis is x: angles may be parameters only if the third one is zero, (a, b, 0.0)";
  if (!add_links(joint, description)) {
    // `build` reports the unused joint under its own name.
    DescribedJoint unused;
    unused.name = joint.name;
    unused.place = joint.place;
    description.joints.push_back(std::move(unused));
    return;
  }
  for (std::size_t k = 0; k < coordinates.size(); ++k) {
    DescribedJoint made = joint.coordinates[k];
    made.name = coordinate_name(joint.name, coordinates[k]);
    made.place = joint.place;
    made.type = coordinates[k].type;
    if (k == 0)
      made.placement = {joint.placement.translation, rotation.value_or(joint.placement.rotation)};
    else
      made.placement = {{}, rotation_between(coordinates[k - 1].axis, coordinates[k].axis)};
    description.joints.push_back(std::move(made));
  }
}

}  // namespace robcogen::model
