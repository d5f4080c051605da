// The names of the robot, links and joints in a URDF, with their places, as far as the text can be read.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "support/source.h"

namespace robcogen::server {

struct UrdfName {
  std::string text;
  Span span;  // between the quotes
};

struct UrdfJoint {
  UrdfName name;
  UrdfName parent, child;  // links
  Span element;
};

struct UrdfLink {
  UrdfName name;
  Span element;
};

struct UrdfNames {
  UrdfName robot;
  std::vector<UrdfLink> links;
  std::vector<UrdfJoint> joints;
  // Other uses: joints in `mimic` and in transmissions, links in loops and couplings, links and joints in `gazebo`.
  std::vector<UrdfName> uses;
};

UrdfNames urdf_names(std::string_view text);

}  // namespace robcogen::server
