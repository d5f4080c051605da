// Finds the two links that a loop or a coupling names, and the joints between them.
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
  std::array<std::vector<int>, 2> paths;  // non-fixed joints to each, from the last link that carries both
};

// `names` are the names of predecessor and successor. Reports a link that does not exist, or that is not part of the
// robot according to `carried`. `owner` is the loop or coupling, as in `loop 'bar'`.
std::optional<LinkPair> find_link_pair(
    const std::array<Name, 2>& names,
    const std::string& owner,
    const Document& document,
    const Topology& topology,
    const std::vector<Carried>& carried,
    Diagnostics& diagnostics);

}  // namespace robcogen::import::from_urdf
