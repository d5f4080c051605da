// Shapes of links, and the meshes that they name.
#pragma once

#include <filesystem>
#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "model/geometry.h"

namespace robcogen::import {

// Which shapes are read. The others are elements without effect.
struct ShapeOptions {
  bool visuals = false;
  bool collisions = false;
  // A collision shape that cannot be read is an error. Otherwise a shape that cannot be read is left out, with a
  // warning.
  bool are_checked = false;
  std::vector<std::filesystem::path> folders = {};  // with packages: find_resource

  bool reads(model::Shape::Use use) const { return use == model::Shape::Use::visual ? visuals : collisions; }
  bool are_read() const { return visuals || collisions; }
};

// The meshes of one document, each of which is read once.
class ShapeMeshes {
 public:
  // `folder` is that of the document.
  ShapeMeshes(std::filesystem::path folder, const ShapeOptions& options)
      : folder_(std::move(folder)), folders_(options.folders) {}

  // nullptr with a `fault`, which completes the sentence `mesh 'x' …`, and perhaps a `hint`.
  std::shared_ptr<const model::TriangleMesh> find(const std::string& uri, std::string& fault, std::string& hint);

  // The files that were read.
  const std::vector<std::filesystem::path>& files() const { return files_; }

 private:
  struct Known {
    std::shared_ptr<const model::TriangleMesh> mesh;
    std::string fault, hint;
  };

  std::filesystem::path folder_;
  const std::vector<std::filesystem::path>& folders_;
  std::map<std::string, Known> known_;  // by URI
  std::vector<std::filesystem::path> files_;

  Known read(const std::string& uri);
};

}  // namespace robcogen::import
