// The meshes that a model declares.
#pragma once

#include <filesystem>
#include <map>
#include <memory>
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

  // Returns the mesh of this name as a shape. nullptr after reporting that it cannot be read.
  std::shared_ptr<const TriangleMesh> find_shape(const Attribute& name, Diagnostics& diagnostics);

 private:
  struct Asset {
    Element element;  // including its default attributes
    bool is_read = false;
    std::optional<Solid> solid;
    std::shared_ptr<const TriangleMesh> shape = {};
  };
  // Why a mesh cannot be read.
  struct Fault {
    Place place;
    std::string text;
    bool is_of_file = false;  // which is not there; the text is a whole message
  };

  Asset* asset(const Attribute& name, Diagnostics& diagnostics);
  MeshTransform transform_of(const Element& mesh, Diagnostics& diagnostics) const;
  std::optional<TriangleMesh> read_triangles(const Element& mesh, Diagnostics& diagnostics, Fault& fault);
  static std::optional<TriangleMesh> read_inline(
      const Element& mesh,
      const Attribute& vertices,
      Diagnostics& diagnostics,
      Fault& fault);
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
