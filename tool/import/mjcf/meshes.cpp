#include "import/mjcf/meshes.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <system_error>
#include <utility>

#include "import/mjcf/orientation.h"
#include "support/files.h"

namespace robcogen::import::from_mjcf {

namespace fs = std::filesystem;

namespace {

// A mesh without a name has that of its file, without the extension.
std::string mesh_name(const Element& mesh) {
  if (const Attribute* name = from_mjcf::find(mesh, "name"); name != nullptr && !name->value.empty())
    return name->value;
  const Attribute* file = from_mjcf::find(mesh, "file");
  return file == nullptr ? "" : fs::path(file->value).stem().string();
}

Vector3 values_of(const std::array<Number, 3>& numbers) {
  return {numbers[0].value(), numbers[1].value(), numbers[2].value()};
}

}  // namespace

Meshes::Meshes(
    const Element& root,
    const Settings& settings,
    const Defaults& defaults,
    fs::path folder,
    std::vector<fs::path>& read,
    Diagnostics& diagnostics)
    : settings_(settings), folder_(std::move(folder)), read_(read), diagnostics_(diagnostics) {
  for (const Element& section : root.children) {
    if (section.name != "asset") continue;
    for (const Element& asset : section.children)
      if (asset.name == "mesh") assets_.insert({mesh_name(asset), {defaults.resolved(asset, nullptr), false, {}}});
  }
}

const Solid* Meshes::find(const Attribute& name) {
  const auto found = assets_.find(name.value);
  if (found == assets_.end()) {
    std::vector<std::string> names;
    for (const auto& [known, asset] : assets_) names.push_back(known);
    diagnostics_.error("unknown-mesh", name.place, fmt::format("mesh '{}' is not declared", name.value)).hint =
        did_you_mean(name.value, names);
    return nullptr;
  }
  Asset& asset = found->second;
  if (!asset.is_read) asset.solid = read(asset.element);
  asset.is_read = true;
  return asset.solid ? &*asset.solid : nullptr;
}

std::optional<Solid> Meshes::refuse(const Place& place, const std::string& name, const std::string& fault) {
  diagnostics_.error("mass-of-mesh", place, fmt::format("the mass of mesh '{}' cannot be computed: {}", name, fault))
      .hint = "write <inertial pos=\"...\" mass=\"...\" diaginertia=\"...\"/> into the bodies that use it";
  return std::nullopt;
}

std::optional<Solid> Meshes::read(const Element& mesh) {
  Values values(diagnostics_);
  const std::size_t errors_before = diagnostics_.error_count();
  const std::vector<std::string> kinds = {"legacy", "exact", "shell", "convex"};
  const std::size_t kind = values.word(mesh, "inertia", kinds, settings_.has_exact_meshes ? 1 : 0);
  if (kind == 3) return refuse(mesh.place, mesh_name(mesh), "inertia=\"convex\" needs its convex hull");
  if (from_mjcf::find(mesh, "builtin") != nullptr || !mesh.children.empty())
    return refuse(mesh.place, mesh_name(mesh), "MuJoCo generates it");
  MeshTransform transform;
  transform.shift = values_of(values.triple(mesh, "refpos", {}));
  const Number one = Number::rational(1);
  transform.scale = values_of(values.triple(mesh, "scale", {one, one, one}));
  if (const Attribute* turn = from_mjcf::find(mesh, "refquat")) {
    Element orientation;
    orientation.attributes.push_back(*turn);
    orientation.attributes.back().name = "quat";
    const Rotation rotation = orientation_of(orientation, settings_, diagnostics_);
    const auto R = model::rotation_matrix(placement_of({{}, rotation}));
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t k = 0; k < 3; ++k) transform.turn[i][k] = model::evaluate(R[i][k]);
  }
  const std::optional<TriangleMesh> triangles = read_triangles(mesh);
  if (!triangles || diagnostics_.error_count() > errors_before) return std::nullopt;
  if (triangles->faces.empty()) return refuse(mesh.place, mesh_name(mesh), "it has vertices only, and needs a hull");
  std::string fault;
  std::optional<Solid> solid = solid_of(*triangles, transform, static_cast<MeshInertia>(kind), fault);
  return solid ? solid : refuse(mesh.place, mesh_name(mesh), fault);
}

// Returns the path in the folder of meshes of the model, or else beside the file that declares the mesh.
fs::path Meshes::path_of(const Attribute& file) const {
  const fs::path name = settings_.strips_paths ? fs::path(file.value).filename() : fs::path(file.value);
  const fs::path path = (folder_ / settings_.mesh_folder / name).lexically_normal();
  std::error_code fault;
  if (fs::exists(path, fault)) return path;
  const fs::path own = fs::path(file.place.source->name()).parent_path();
  const fs::path beside = (own / settings_.mesh_folder / name).lexically_normal();
  return fs::exists(beside, fault) ? beside : path;
}

std::optional<TriangleMesh> Meshes::read_triangles(const Element& mesh) {
  const Attribute* file = from_mjcf::find(mesh, "file");
  if (file == nullptr) {
    const Attribute* vertices = from_mjcf::find(mesh, "vertex");
    if (vertices != nullptr) return read_inline(mesh, *vertices);
    refuse(mesh.place, mesh_name(mesh), "it has neither 'file' nor 'vertex'");
    return std::nullopt;
  }
  const fs::path path = path_of(*file);
  std::string fault;
  const std::optional<std::string> content = read_file(path, fault);
  if (!content) {
    diagnostics_.error(
        "unreadable-mesh", file->place, fmt::format("file '{}' of this mesh cannot be read", path.string()));
    return std::nullopt;
  }
  if (std::find(read_.begin(), read_.end(), path) == read_.end()) read_.push_back(path);
  const std::string extension = extension_of(path);
  const bool is_known = extension == ".stl" || extension == ".obj" || extension == ".msh";
  if (!is_known) fault = "it is not an STL, OBJ or MSH file";
  std::optional<TriangleMesh> result = is_known ? read_mesh(path, *content, fault) : std::nullopt;
  if (!result) refuse(file->place, mesh_name(mesh), fault);
  return result;
}

std::optional<TriangleMesh> Meshes::read_inline(const Element& mesh, const Attribute& vertices) {
  constexpr std::size_t kMost = 1000000;
  Values values(diagnostics_);
  TriangleMesh result;
  const std::optional<std::vector<Number>> given = values.read(vertices, 0, kMost);
  if (!given) return std::nullopt;
  const std::vector<Number>& v = *given;
  for (std::size_t i = 0; i + 2 < v.size(); i += 3)
    result.vertices.push_back(
        {static_cast<float>(v[i].value()), static_cast<float>(v[i + 1].value()), static_cast<float>(v[i + 2].value())});
  const Attribute* faces = from_mjcf::find(mesh, "face");
  if (faces == nullptr) return result;
  const std::optional<std::vector<Number>> indices = values.read(*faces, 0, kMost);
  if (!indices) return std::nullopt;
  const std::vector<Number>& f = *indices;
  for (std::size_t i = 0; i + 2 < f.size(); i += 3) {
    std::array<std::uint32_t, 3> corners;
    for (std::size_t k = 0; k < 3; ++k) {
      const double index = f[i + k].value();
      if (!(index >= 0.0 && index < static_cast<double>(result.vertices.size()) && index == std::floor(index))) {
        refuse(faces->place, mesh_name(mesh), "a face refers to a vertex that it does not have");
        return std::nullopt;
      }
      corners[k] = static_cast<std::uint32_t>(index);
    }
    result.faces.push_back(corners);
  }
  return result;
}

}  // namespace robcogen::import::from_mjcf
