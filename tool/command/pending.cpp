// Stands in for tool/import/urdf until that is there.
#include "import/urdf.h"
namespace robcogen::import {
__attribute__((weak)) std::optional<model::KinematicTree> urdf(std::shared_ptr<const Source>, const UrdfOptions&, Diagnostics& d) {
  d.error("pending", {}, "import::urdf is not there yet");
  return std::nullopt;
}
}
