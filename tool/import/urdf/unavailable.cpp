// Replaces the other sources of this folder in a build without urdfdom.
#include <utility>

#include "import/srdf.h"
#include "import/urdf.h"

namespace robcogen::import {

std::optional<model::KinematicTree> urdf(
    std::shared_ptr<const Source> source,
    const UrdfOptions&,
    Diagnostics& diagnostics) {
  diagnostics
      .error(
          "urdf-unavailable", {std::move(source), {}}, "this generator was built without urdfdom and cannot read URDF")
      .hint = "install urdfdom and TinyXML (Debian: liburdfdom-dev, libtinyxml-dev), then configure and build it again";
  return std::nullopt;
}

bool read_srdf(const std::shared_ptr<const Source>&, model::KinematicTree&, Diagnostics&) {
  return false;  // there is no robot in URDF
}

}  // namespace robcogen::import
