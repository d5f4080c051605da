// A session over a stream of bytes.
#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <string_view>
#include <vector>

namespace robcogen::server {

// Reads at most `size` bytes, at least one; 0 at the end of the stream.
using ReadBytes = std::function<std::size_t(char* bytes, std::size_t size)>;
using WriteBytes = std::function<void(std::string_view bytes)>;

// Answers requests until `exit` or the end of the stream. Returns whether the editor ended the session as the protocol
// demands: with `shutdown` first. `import_folders` are searched for imported documents.
bool serve(
    const ReadBytes& read,
    const WriteBytes& write,
    const std::vector<std::filesystem::path>& import_folders = {});

}  // namespace robcogen::server
