// Reads the type and the axis, which joints of the tree and joints of loops give in the same form.
#pragma once

#include "import/urdf/element_reader.h"

namespace robcogen::import::from_urdf {

// Reads the attribute `type` of a joint or loop, which is one of `types`, and stores its place; nullopt after an error.
std::optional<JointType> read_type(
    const Element& element,
    const Name& name,
    const std::vector<JointType>& types,
    Place& place,
    ElementReader& reader);

// Reads the direction of an `axis`. If there is none, reports this and leaves `direction` unchanged. `owner` names the
// element that has the axis, as in `joint 'KFE'`.
void read_axis(const Element& axis, const std::string& owner, std::array<Number, 3>& direction, ElementReader& reader);

}  // namespace robcogen::import::from_urdf
