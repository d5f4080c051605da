// Conversion between paths and the URIs by which an editor names documents.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace robcogen::server {

// Returns the path of a `file:` URI, without `.` and `..`; for another URI, such as `untitled:Untitled-1`, the text
// itself.
std::filesystem::path path_of(std::string_view uri);
std::string uri_of(const std::filesystem::path& path);

}  // namespace robcogen::server
