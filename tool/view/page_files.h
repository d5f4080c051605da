// The files of the folder page, which the build embeds in the program.
#pragma once

#include <string_view>

namespace robcogen::view {

// The text of the file of this name; empty if there is none.
std::string_view page_file(std::string_view name);

}  // namespace robcogen::view
