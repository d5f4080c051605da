#include <fmt/format.h>

#include <array>

#include "import/snap_angles.h"
#include "import/urdf/document.h"

namespace robcogen::import::from_urdf {

namespace {

constexpr std::array<const char*, 3> kAngleNames = {"roll", "pitch", "yaw"};

void treat(Origin& origin, const std::string& owner, AngleSnapper& snapper) {
  for (std::size_t i = 0; i < 3; ++i) snapper.treat(origin.rpy[i], origin.rpy_places[i], kAngleNames[i], owner);
}

}  // namespace

void treat_near_multiples(Document& document, bool snap, Diagnostics& diagnostics) {
  AngleSnapper snapper(snap, diagnostics);
  for (Link& link : document.links)
    if (link.inertial)
      treat(link.inertial->origin, fmt::format("the inertial of link '{}'", link.name.text), snapper);
  for (Joint& joint : document.joints)
    treat(joint.origin, fmt::format("the origin of joint '{}'", joint.name.text), snapper);
  snapper.note_count();
}

}  // namespace robcogen::import::from_urdf
