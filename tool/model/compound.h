// Joints with several coordinates, in descriptions: each is a chain of joints with one coordinate, without bodies
// between them.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "model/description.h"
#include "model/rigid_motions.h"

namespace robcogen::model {

enum class CompoundType {
  cylindrical,  // slides along z and turns about it
  universal,    // turns about x, then about the z axis that this has turned
  planar,       // slides along x and y and turns about z
};

// One coordinate. Its axis is an axis of the joint frame as the coordinates before it have moved that frame.
struct CompoundCoordinate {
  const char* name;
  JointType type;
  Axis axis;
};

// In order from the parent to the child. The axis of the last coordinate is z for every type.
std::span<const CompoundCoordinate> coordinates_of(CompoundType type);

// `<joint>_<coordinate>`
std::string coordinate_name(const std::string& joint, const CompoundCoordinate& coordinate);

struct DescribedCompound {
  std::string name;
  Place place;
  CompoundType type = CompoundType::cylindrical;
  Placement placement;  // of the joint frame
  Place placement_place;
  std::vector<DescribedJoint> coordinates;  // one entry per coordinate: its drive and limits
};

// Adds the joints of a compound joint to a description that already has all links, one of which names the compound
// joint as the joint of a child. Massless links, `<joint>_<coordinate>_link`, are inserted between these joints.
// Reports a rotation whose parameters do not allow this.
void add_compound(const DescribedCompound& joint, Description& description, Diagnostics& diagnostics);

}  // namespace robcogen::model
