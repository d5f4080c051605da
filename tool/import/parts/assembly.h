// A part with all that is attached in it, before it is attached to a link itself: in its own names and in the frame
// where it is attached.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "language/kinematics/document.h"
#include "support/diagnostics.h"

namespace robcogen::import::parts {

namespace kinematics = language::kinematics;

struct Assembly {
  kinematics::Body body;                 // without base, and without instances
  std::vector<kinematics::Child> roots;  // the joints that carry it, and their links
  std::optional<kinematics::Link> base;  // of a robot; its children are the roots
  std::vector<kinematics::Limb> limbs;   // what the instances in it have become
};

// What the part becomes as this instance. Its names are still those in the part.
kinematics::Limb limb_of(const Assembly& part, const kinematics::Instance& instance);

// The mirror image, of positions that make mirrored postures where they are equal: joints that turn do so in the
// reflected sense, and those of `mirror` keep theirs about the reflected axis, so that their positions are opposite. A
// joint that slides follows the reflected axis. Frames of links have their z axis reversed where a joint turns in the
// reflected sense, else y; user frames the axis that turns them least. Reports joints of `mirror` that the part does
// not have, and those that slide, at `source`.
void reflect(
    Assembly& assembly,
    const kinematics::Mirror& mirror,
    const std::shared_ptr<const Source>& source,
    Diagnostics& diagnostics);

// The name of an element or of a frame of the part that is attached as `instance`: `LF_hip`, and `fr_LF_foot` for
// `fr_foot`, as the frame of link LF_hip is fr_LF_hip.
std::string element_name(const std::string& instance, const std::string& name);
std::string frame_name(const std::string& instance, const std::string& name);

// Of the joint, or of its coordinates where it has several.
std::vector<std::string> coordinate_names(const kinematics::Joint& joint);

// Those of the joint and of its coordinates.
std::vector<kinematics::Rotor*> rotors_of(kinematics::Joint& joint);

// Gives all names in it this prefix.
void name_after(Assembly& assembly, const std::string& instance);

// The mass properties of the base, at this pose in the frame of the link, become part of those of the link. nullopt for
// two massless links.
std::optional<kinematics::Inertia> lumped(
    const kinematics::Link& link,
    const kinematics::Link& base,
    const kinematics::Placement& placement);

// Puts elements behind those of the body.
void append(kinematics::Body& body, kinematics::Body added);

// Links without an id get the next ones, parents first.
void number_links(Assembly& robot);

}  // namespace robcogen::import::parts
