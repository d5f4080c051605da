// Free bodies whose frames MuJoCo aligns with their principal axes.
#include <fmt/format.h>

#include "import/mjcf/read.h"

namespace robcogen::import::from_mjcf {

namespace {

// MuJoCo takes the axes of a single geom or of `diaginertia` as they are, and otherwise computes them in an order and
// with signs of its own.
bool has_own_axes(const Body& body) {
  return body.parts.size() == 1 && body.parts.front().has_given_axes;
}

}  // namespace

void align_free_body(Document& document, const Settings& settings, Diagnostics& diagnostics) {
  Body& body = document.bodies[document.robot.base];
  if (!body.floats()) return;
  const FreeJoint& joint = *body.free_joint;
  const bool is_alone = document.robot.base + 1 == document.bodies.size() ||
                        document.bodies[document.robot.base + 1].parent != static_cast<int>(document.robot.base);
  if (!is_alone || !joint.is_aligned.value_or(settings.aligns_free_bodies)) return;
  if (diagnostics.has_errors()) return;
  if (!has_own_axes(body)) {
    const Place& place = joint.is_aligned ? joint.align_place : settings.alignment_place;
    diagnostics
        .error(
            "aligned-body", place,
            fmt::format(
                "MuJoCo would align the frame of body '{}' with principal axes that this file does not give",
                label_of(document, document.robot.base)))
        .hint = "write <inertial pos=\"...\" quat=\"...\" mass=\"...\" diaginertia=\"...\"/>, or do not align the body";
    return;
  }
  Part& part = body.parts.front();
  const Pose back = inverse(part.pose);
  body.pose = body.pose * part.pose;
  for (Site& site : body.sites) site.pose = back * site.pose;
  for (BodyShape& shape : body.shapes) shape.pose = back * shape.pose;
  part.pose = {};
  diagnostics.note(
      "aligned-body", joint.is_aligned ? joint.align_place : settings.alignment_place,
      fmt::format(
          "the frame of body '{}' is at its centre of mass, along its principal axes, as in MuJoCo",
          label_of(document, document.robot.base)));
}

}  // namespace robcogen::import::from_mjcf
