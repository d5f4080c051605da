// A part with everything that is attached within it, before it is attached to a link itself. It uses its own names, and
// the frame where it will be attached.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "language/kinematics/document.h"
#include "support/diagnostics.h"

namespace robcogen::import::parts {

namespace kinematics = language::kinematics;

struct Assembly {
  kinematics::Body body;                 // without the base and without instances
  std::vector<kinematics::Child> roots;  // the joints that carry the part, and their links
  std::optional<kinematics::Link> base;  // if the part is a robot; its children are the roots
  std::vector<kinematics::Limb> limbs;   // of the instances in the part
};

// Returns the limb that the part becomes as this instance. The part still has its own names.
kinematics::Limb limb_of(const Assembly& part, const kinematics::Instance& instance);

// Replaces the assembly by its mirror image, in which equal joint positions give mirrored postures: joints that turn do
// so in the reflected sense. The joints of `mirror` keep their sense about the reflected axis, so mirrored postures
// have opposite positions. A joint that slides follows the reflected axis. Frames stay right-handed by reversing one
// axis: in a link frame, z if the joint turns in the reflected sense, otherwise y; in a user frame, the axis that
// rotates the frame least. Reports joints of `mirror` that the part does not have, or that slide; `source` contains
// their names.
void reflect(
    Assembly& assembly,
    const kinematics::Mirror& mirror,
    const std::shared_ptr<const Source>& source,
    Diagnostics& diagnostics);

// Returns the name of an element or of a frame of the part that is attached as `instance`: `LF_hip`, and `fr_LF_foot`
// for `fr_foot`, because the frame of link LF_hip is fr_LF_hip.
std::string element_name(const std::string& instance, const std::string& name);
std::string frame_name(const std::string& instance, const std::string& name);

// The name of the joint, or the names of its coordinates if it has several; then the names of motors.
std::vector<std::string> coordinate_names(const kinematics::Joint& joint);

// The rotors of the joint and of its coordinates.
std::vector<kinematics::Rotor*> rotors_of(kinematics::Joint& joint);

// Prefixes all names in the assembly with the name of the instance.
void name_after(Assembly& assembly, const std::string& instance);

// Returns the mass properties of the link plus those of the base, which is at this pose in the frame of the link.
// nullopt if both are massless.
std::optional<kinematics::Inertia> lumped(
    const kinematics::Link& link,
    const kinematics::Link& base,
    const kinematics::Placement& placement);

// Appends the added elements to those of the body.
void append(kinematics::Body& body, kinematics::Body added);

// Gives links without an id the next ids, parents first.
void number_links(Assembly& robot);

}  // namespace robcogen::import::parts
