// Replaces the other sources of this folder in a build without urdfdom.
#include "import/sdf.h"

namespace robcogen::import {

std::optional<Sdf> sdf(
    const std::shared_ptr<const Source>& source,
    const std::filesystem::path&,
    const SdfOptions&,
    Diagnostics& diagnostics) {
  diagnostics
      .error("sdf-unavailable", {source, {}}, "this generator was built without urdfdom and TinyXML and cannot read SDF")
      .hint = "install urdfdom and TinyXML (Debian: liburdfdom-dev, libtinyxml-dev), then configure and build it again";
  return std::nullopt;
}

}  // namespace robcogen::import
