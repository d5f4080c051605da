// Documents of an editor are named by URIs.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace robcogen::server {

// The path of a `file:` URI, without `.` and `..`; of others, such as `untitled:Untitled-1`, the text itself.
std::filesystem::path path_of(std::string_view uri);
std::string uri_of(const std::filesystem::path& path);

}  // namespace robcogen::server
