// The files of the folder page, which the build puts into the program.
#pragma once

#include <string_view>

namespace robcogen::view {

// The text of the file of this name; empty when there is none.
std::string_view page_file(std::string_view name);

}  // namespace robcogen::view
