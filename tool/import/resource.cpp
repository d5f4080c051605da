#include "import/resource.h"

#include <cstdlib>
#include <string_view>
#include <system_error>
#include <utility>

#include "support/files.h"

namespace robcogen::import {

namespace fs = std::filesystem;

namespace {

constexpr std::size_t kMaxLength = 4096;  // of a path
#ifdef _WIN32
constexpr char kListSeparator = ';';
#else
constexpr char kListSeparator = ':';
#endif

std::optional<fs::path> existing(const fs::path& path) {
  std::error_code fault;
  const bool is_there = path.native().size() <= kMaxLength && fs::exists(path, fault);
  return is_there ? std::optional(path.lexically_normal()) : std::nullopt;
}

// Folders of packages of ROS, from the environment.
std::vector<fs::path> package_folders() {
  std::vector<fs::path> folders;
  const auto add = [&](const char* variable, const fs::path& inside) {
    const char* value = std::getenv(variable);
    if (value == nullptr) return;
    const std::string_view list = value;
    for (std::size_t begin = 0, end = 0; end != std::string_view::npos; begin = end + 1) {
      end = list.find(kListSeparator, begin);
      const std::string_view folder = list.substr(begin, end == std::string_view::npos ? end : end - begin);
      if (!folder.empty()) folders.push_back(fs::path(folder) / inside);
    }
  };
  add("ROS_PACKAGE_PATH", "");
  add("AMENT_PREFIX_PATH", "share");
  return folders;
}

// Whether the folder is the package of this name, whatever the folder is called.
bool is_package(const fs::path& folder, const std::string& name) {
  std::error_code fault;
  if (!fs::is_regular_file(folder / "package.xml", fault)) return false;
  std::string unreadable;
  const std::optional<std::string> text = read_file(folder / "package.xml", unreadable);
  if (!text) return false;
  const std::size_t open = text->find("<name>"), end = text->find("</name>");
  if (open == std::string::npos || end == std::string::npos || end < open) return false;
  std::string found = text->substr(open + 6, end - open - 6);
  found.erase(0, found.find_first_not_of(" \t\r\n"));
  found.erase(found.find_last_not_of(" \t\r\n") + 1);
  return found == name;
}

// Looks up NAME/PATH.
std::optional<fs::path> in_named_folder(
    const fs::path& name_and_path,
    const fs::path& folder,
    const std::vector<fs::path>& folders) {
  const fs::path name = *name_and_path.begin(), path = name_and_path.lexically_relative(name);
  std::vector<fs::path> all = folders;
  for (fs::path& of_ros : package_folders()) all.push_back(std::move(of_ros));
  for (const fs::path& searched : all) {
    if (const auto found = existing(searched / name_and_path)) return found;
    const fs::path itself = (searched / "").lexically_normal().parent_path();
    if (itself.filename() == name)
      if (const auto found = existing(itself.parent_path() / name_and_path)) return found;
    if (is_package(searched, name.string()))
      if (const auto found = existing(searched / path)) return found;
  }
  std::vector<fs::path> inner = {folder};
  inner.insert(inner.end(), folders.begin(), folders.end());
  for (const fs::path& start : inner) {
    std::error_code fault;
    for (fs::path around = fs::absolute(start, fault).lexically_normal(); !fault; around = around.parent_path()) {
      if (const auto found = existing(around / name_and_path)) return found;
      if (is_package(around, name.string()))
        if (const auto found = existing(around / path)) return found;
      if (around == around.parent_path()) break;
    }
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
  if (const auto found = existing(folder / uri)) return found;
  for (const fs::path& searched : folders)
    if (const auto found = existing(searched / uri)) return found;
  return std::nullopt;
}

}  // namespace robcogen::import
