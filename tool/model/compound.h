// Joints of several coordinates, in descriptions: chains of joints of one coordinate, without bodies between them.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "model/description.h"
#include "model/rigid_motions.h"

namespace robcogen::model {

enum class CompoundType {
  cylindrical,  // slides along z, and turns about it
  universal,    // turns about x, then about z, which has turned with it
  planar,       // slides along x and y, and turns about z
};

// One coordinate: the axis is of the joint frame, as the coordinates before have turned it.
struct CompoundCoordinate {
  const char* name;
  JointType type;
  Axis axis;
};

// From the parent to the child; z is the last axis of all.
std::span<const CompoundCoordinate> coordinates_of(CompoundType type);

// `<joint>_<coordinate>`
std::string coordinate_name(const std::string& joint, const CompoundCoordinate& coordinate);

struct DescribedCompound {
  std::string name;
  Place place;
  CompoundType type = CompoundType::cylindrical;
  Placement placement;  // of the joint frame
  Place placement_place;
  std::vector<DescribedJoint> coordinates;  // one each: their drives and limits
};

// Adds its joints to a description that has all links, one of which names it as the joint of a child. Links without
// mass, `<joint>_<coordinate>_link`, carry all but the first. Reports a rotation whose parameters do not allow this.
void add_compound(const DescribedCompound& joint, Description& description, Diagnostics& diagnostics);

}  // namespace robcogen::model
