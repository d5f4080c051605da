// The type and the axis, which joints of the tree and joints of loops give in the same form.
#pragma once

#include "import/urdf/element_reader.h"

namespace robcogen::import::from_urdf {

// The attribute `type` of a joint or loop, one of `types`; nullopt after an error. Its place is written to `place`.
std::optional<JointType> read_type(
    const Element& element,
    const Name& name,
    const std::vector<JointType>& types,
    Place& place,
    ElementReader& reader);

// The direction that an `axis` gives. Without one, which is reported, `direction` stays what it was. `owner` has the
// axis: `joint 'KFE'`.
void read_axis(const Element& axis, const std::string& owner, std::array<Number, 3>& direction, ElementReader& reader);

}  // namespace robcogen::import::from_urdf
