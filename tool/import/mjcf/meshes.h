// The meshes that a model declares.
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "import/mjcf/defaults.h"
#include "import/mjcf/settings.h"
#include "import/mjcf/solid.h"

namespace robcogen::import::from_mjcf {

class Meshes {
 public:
  // `folder` is that of the model. Files that are read are appended to `read`.
  Meshes(
      const Element& root,
      const Settings& settings,
      const Defaults& defaults,
      std::filesystem::path folder,
      std::vector<std::filesystem::path>& read,
      Diagnostics& diagnostics);

  // Returns the body that the mesh of this name encloses. nullptr if it cannot be computed, which is reported once for
  // each mesh.
  const Solid* find(const Attribute& name);

 private:
  struct Asset {
    Element element;  // including its default attributes
    bool is_read = false;
    std::optional<Solid> solid;
  };

  std::optional<TriangleMesh> read_triangles(const Element& mesh);
  std::optional<TriangleMesh> read_inline(const Element& mesh, const Attribute& vertices);
  std::filesystem::path path_of(const Attribute& file) const;
  std::optional<Solid> refuse(const Place& place, const std::string& name, const std::string& fault);
  std::optional<Solid> read(const Element& mesh);

  const Settings& settings_;
  std::filesystem::path folder_;
  std::vector<std::filesystem::path>& read_;
  Diagnostics& diagnostics_;
  std::map<std::string, Asset> assets_;
};

}  // namespace robcogen::import::from_mjcf
