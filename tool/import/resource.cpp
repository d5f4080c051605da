#include "import/resource.h"

#include <system_error>

namespace robcogen::import {

namespace fs = std::filesystem;

namespace {

constexpr std::size_t kMaxLength = 4096;  // of a path

std::optional<fs::path> existing(const fs::path& path) {
  std::error_code fault;
  const bool is_there = path.native().size() <= kMaxLength && fs::exists(path, fault);
  return is_there ? std::optional(path.lexically_normal()) : std::nullopt;
}

// Looks up NAME/PATH.
std::optional<fs::path> in_named_folder(
    const fs::path& name_and_path,
    const fs::path& folder,
    const std::vector<fs::path>& folders) {
  const fs::path name = *name_and_path.begin();
  for (const fs::path& searched : folders) {
    if (const auto found = existing(searched / name_and_path)) return found;
    const fs::path itself = (searched / "").lexically_normal().parent_path();
    if (itself.filename() == name)
      if (const auto found = existing(itself.parent_path() / name_and_path)) return found;
  }
  std::error_code fault;
  const fs::path start = fs::absolute(folder, fault).lexically_normal();
  for (fs::path around = start; !fault; around = around.parent_path()) {
    if (const auto found = existing(around / name_and_path)) return found;
    if (around == around.parent_path()) break;
  }
  return std::nullopt;
}

}  // namespace

std::optional<fs::path> find_resource(
    const std::string& uri,
    const fs::path& folder,
    const std::vector<fs::path>& folders) {
  if (uri.empty() || uri.find('\0') != std::string::npos) return std::nullopt;
  for (const std::string scheme : {"model://", "package://"}) {
    if (!uri.starts_with(scheme)) continue;
    const fs::path rest = uri.substr(scheme.size());
    return rest.empty() || rest.is_absolute() ? std::nullopt : in_named_folder(rest, folder, folders);
  }
  const std::string file = "file://";
  if (uri.starts_with(file)) return existing(folder / uri.substr(file.size()));
  if (uri.find("://") != std::string::npos) return std::nullopt;
  return existing(folder / uri);
}

}  // namespace robcogen::import
