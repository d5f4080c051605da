// Replaces the other sources of this folder in a build without urdfdom.
#include "import/mjcf.h"

namespace robcogen::import {

std::optional<Mjcf> mjcf(
    const std::shared_ptr<const Source>& source,
    const std::filesystem::path&,
    const MjcfOptions&,
    Diagnostics& diagnostics) {
  diagnostics
      .error(
          "mjcf-unavailable", {source, {}}, "this generator was built without urdfdom and TinyXML and cannot read MJCF")
      .hint = "install urdfdom and TinyXML (Debian: liburdfdom-dev, libtinyxml-dev), then configure and build it again";
  return std::nullopt;
}

}  // namespace robcogen::import
