// The shapes of links: what a robot looks like, and what it may collide with.
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "model/placement.h"
#include "support/diagnostics.h"

namespace robcogen::model {

struct TriangleMesh {
  // In single precision, as MuJoCo stores them, so that masses agree with those of MuJoCo.
  std::vector<std::array<float, 3>> vertices;
  std::vector<std::array<std::uint32_t, 3>> faces;  // indices of vertices, counter-clockwise from outside
};

struct Shape {
  // A cylinder and a capsule lie along z, and the other shapes in the middle of their frame; a mesh has its own origin.
  enum class Kind { sphere, capsule, cylinder, box, mesh };
  enum class Use { visual, collision };
  Kind kind = Kind::sphere;
  Use use = Use::visual;
  std::string body;     // the link of the document that has it: fixed joints may make one link of several
  int link = -1;        // set by `build`
  Placement placement;  // in the link frame; constant
  // m: the radius; the radius and the length, of a capsule without its half spheres; the edges along x, y and z. Of a
  // mesh: factors of its coordinates.
  std::array<double, 3> size = {};
  std::string file = {};                          // of a mesh, as the document names it
  std::shared_ptr<const TriangleMesh> mesh = {};  // of a mesh
  Place place = {};
};

struct Geometry {
  std::vector<Shape> shapes = {};                          // in the order of links
  std::vector<std::array<std::string, 2>> may_touch = {};  // pairs of bodies that are not checked
  bool has_srdf = false;                                   // one was read: all other pairs are checked
  std::vector<std::filesystem::path> files = {};           // of meshes, that were read
};

}  // namespace robcogen::model
