// Files of meshes that assimp reads.
#include "import/mesh_file.h"

#if ROBCOGEN_HAS_ASSIMP
#include <assimp/config.h>
#include <assimp/postprocess.h>
#include <assimp/scene.h>

#include <assimp/Importer.hpp>
#include <cmath>
#endif

namespace robcogen::import {

#if ROBCOGEN_HAS_ASSIMP
namespace {

void add_meshes(const aiScene& scene, const aiNode& node, const aiMatrix4x4& outer, TriangleMesh& result) {
  const aiMatrix4x4 pose = outer * node.mTransformation;
  for (unsigned m = 0; m < node.mNumMeshes; ++m) {
    const aiMesh& mesh = *scene.mMeshes[node.mMeshes[m]];
    const auto first = static_cast<std::uint32_t>(result.vertices.size());
    for (unsigned v = 0; v < mesh.mNumVertices; ++v) {
      const aiVector3D p = pose * mesh.mVertices[v];
      result.vertices.push_back({static_cast<float>(p.x), static_cast<float>(p.y), static_cast<float>(p.z)});
    }
    for (unsigned f = 0; f < mesh.mNumFaces; ++f) {
      const aiFace& face = mesh.mFaces[f];
      if (face.mNumIndices != 3) continue;  // points and lines
      result.faces.push_back({first + face.mIndices[0], first + face.mIndices[1], first + face.mIndices[2]});
    }
  }
  for (unsigned c = 0; c < node.mNumChildren; ++c) add_meshes(scene, *node.mChildren[c], pose, result);
}

}  // namespace

std::optional<TriangleMesh> read_scene(
    const std::filesystem::path& path,
    std::string_view content,
    std::string& fault) {
  Assimp::Importer importer;
  // As RViz and MoveIt read them: z is up, whatever the file says.
  importer.SetPropertyBool(AI_CONFIG_IMPORT_COLLADA_IGNORE_UP_DIRECTION, true);
  importer.SetPropertyInteger(AI_CONFIG_PP_RVC_FLAGS, aiComponent_NORMALS | aiComponent_TEXCOORDS | aiComponent_COLORS);
  const unsigned steps = aiProcess_Triangulate | aiProcess_RemoveComponent | aiProcess_JoinIdenticalVertices;
  const std::string extension = extension_of(path);
  const aiScene* scene = importer.ReadFileFromMemory(
      content.data(), content.size(), steps, extension.empty() ? "" : extension.c_str() + 1);
  if (scene == nullptr || scene->mRootNode == nullptr) {
    fault = importer.GetErrorString();
    if (fault.empty()) fault = "assimp does not read it";
    return std::nullopt;
  }
  TriangleMesh result;
  add_meshes(*scene, *scene->mRootNode, aiMatrix4x4(), result);
  for (const auto& v : result.vertices)
    if (!std::isfinite(v[0]) || !std::isfinite(v[1]) || !std::isfinite(v[2]))
      return fault = "it contains a number that is not finite", std::nullopt;
  return result;
}
#else
std::optional<TriangleMesh> read_scene(const std::filesystem::path&, std::string_view, std::string& fault) {
  fault = "it is not an STL or OBJ file, and this robcogen was built without assimp";
  return std::nullopt;
}
#endif

}  // namespace robcogen::import
