// The two links that a loop or a coupling names, and the joints between them.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "import/urdf/describe.h"

namespace robcogen::import::from_urdf {

// Links and joints of the document, by index.
struct LinkPair {
  std::array<int, 2> links;               // predecessor, successor
  std::array<std::vector<int>, 2> paths;  // joints to each, without fixed ones, from the last link that carries both
};

// `names` are those of predecessor and successor. Reports a link that does not exist, or that `carried` does not have
// as part of the robot; `owner` names it: `loop 'bar'`.
std::optional<LinkPair> find_link_pair(
    const std::array<Name, 2>& names,
    const std::string& owner,
    const Document& document,
    const Topology& topology,
    const std::vector<Carried>& carried,
    Diagnostics& diagnostics);

}  // namespace robcogen::import::from_urdf
