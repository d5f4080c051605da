// Collects the names in a document, in any of the languages.
#pragma once

#include <vector>

#include "server/names.h"

namespace robcogen::server {

std::vector<Occurrence> collect_names(const Parsed& document, Names& names);

}  // namespace robcogen::server
