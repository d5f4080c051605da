#include "import/shapes.h"

#include <fmt/format.h>

#include <optional>
#include <utility>

#include "import/mesh_file.h"
#include "import/resource.h"
#include "support/files.h"

namespace robcogen::import {

namespace fs = std::filesystem;

ShapeMeshes::Known ShapeMeshes::read(const std::string& uri) {
  const std::optional<fs::path> path = find_resource(uri, folder_, folders_);
  if (!path)
    return {
        nullptr, "is not found",
        "the folders of -I, ROS_PACKAGE_PATH and AMENT_PREFIX_PATH are searched for packages, and those around the "
        "file"};
  std::string fault;
  const std::optional<std::string> content = read_file(*path, fault);
  if (!content) return {nullptr, fmt::format("cannot be read: {}", fault), ""};
  std::optional<TriangleMesh> mesh = read_mesh(*path, *content, fault);
  if (!mesh) return {nullptr, fmt::format("cannot be read: {}", fault), ""};
  if (mesh->faces.empty()) return {nullptr, "has no triangle", ""};
  files_.push_back(*path);
  return {std::make_shared<const TriangleMesh>(std::move(*mesh)), "", ""};
}

std::shared_ptr<const TriangleMesh> ShapeMeshes::find(const std::string& uri, std::string& fault, std::string& hint) {
  auto known = known_.find(uri);
  if (known == known_.end()) known = known_.insert({uri, read(uri)}).first;
  fault = known->second.fault;
  hint = known->second.hint;
  return known->second.mesh;
}

}  // namespace robcogen::import
