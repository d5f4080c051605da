// Reads files of triangle meshes.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace robcogen::import::from_mjcf {

struct TriangleMesh {
  // In single precision, as MuJoCo stores them, so that masses agree with those of MuJoCo.
  std::vector<std::array<float, 3>> vertices;
  std::vector<std::array<std::uint32_t, 3>> faces;  // indices of vertices, counter-clockwise from outside
};

// Reads an STL file, binary or text. Equal vertices become one. nullopt with a `fault` if the content is not an STL.
std::optional<TriangleMesh> read_stl(std::string_view content, std::string& fault);

// Reads vertices and faces of an OBJ file; a face with more than three vertices is divided into triangles. nullopt with
// a `fault` if a line is malformed.
std::optional<TriangleMesh> read_obj(std::string_view content, std::string& fault);

// Reads MuJoCo's own binary format. nullopt with a `fault` if the sizes do not match the content.
std::optional<TriangleMesh> read_msh(std::string_view content, std::string& fault);

}  // namespace robcogen::import::from_mjcf
