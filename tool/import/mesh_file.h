// Reads files of triangle meshes.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

#include "model/geometry.h"

namespace robcogen::import {

using model::TriangleMesh;

// Reads an STL file, binary or text. Equal vertices become one. nullopt with a `fault` if the content is not an STL.
std::optional<TriangleMesh> read_stl(std::string_view content, std::string& fault);

// Reads vertices and faces of an OBJ file; a face with more than three vertices is divided into triangles. nullopt with
// a `fault` if a line is malformed.
std::optional<TriangleMesh> read_obj(std::string_view content, std::string& fault);

// Reads MuJoCo's own binary format. nullopt with a `fault` if the sizes do not match the content.
std::optional<TriangleMesh> read_msh(std::string_view content, std::string& fault);

// Reads all meshes of a file by assimp, in axes of the file and in metres: other formats, such as DAE. nullopt with a
// `fault` if it cannot be read, or if the generator was built without assimp.
std::optional<TriangleMesh> read_scene(const std::filesystem::path& path, std::string_view content, std::string& fault);

// Reads a file in the format that its name says: the ones above. nullopt with a `fault`, which completes the sentence
// `the file cannot be read: …`.
std::optional<TriangleMesh> read_mesh(const std::filesystem::path& path, std::string_view content, std::string& fault);

// The extension of a file in lower case: `.stl`.
std::string extension_of(const std::filesystem::path& path);

}  // namespace robcogen::import
