#include "import/mjcf/meshes.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <system_error>
#include <utility>

#include "import/body_shape.h"
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
      if (asset.name == "mesh") assets_.insert({mesh_name(asset), {defaults.resolved(asset, nullptr), false, {}, {}}});
  }
}

Meshes::Asset* Meshes::asset(const Attribute& name, Diagnostics& diagnostics) {
  const auto found = assets_.find(name.value);
  if (found != assets_.end()) return &found->second;
  std::vector<std::string> names;
  for (const auto& [known, asset] : assets_) names.push_back(known);
  diagnostics.error("unknown-mesh", name.place, fmt::format("mesh '{}' is not declared", name.value)).hint =
      did_you_mean(name.value, names);
  return nullptr;
}

const Solid* Meshes::find(const Attribute& name) {
  Asset* found = asset(name, diagnostics_);
  if (found == nullptr) return nullptr;
  if (!found->is_read) found->solid = read(found->element);
  found->is_read = true;
  return found->solid ? &*found->solid : nullptr;
}

std::shared_ptr<const TriangleMesh> Meshes::find_shape(const Attribute& name, Diagnostics& diagnostics) {
  Asset* found = asset(name, diagnostics);
  if (found == nullptr || found->shape) return found == nullptr ? nullptr : found->shape;
  const Element& mesh = found->element;
  const std::size_t errors_before = diagnostics.error_count();
  const MeshTransform transform = transform_of(mesh, diagnostics);
  Fault fault;
  const std::optional<TriangleMesh> triangles = read_triangles(mesh, diagnostics, fault);
  if (diagnostics.error_count() > errors_before) return nullptr;
  const bool is_flat = transform.scale[0] * transform.scale[1] * transform.scale[2] == 0.0;
  if (triangles && triangles->vertices.empty()) fault = {mesh.place, "it has no vertex"};
  if (triangles && is_flat) fault = {mesh.place, "its scale is zero"};
  std::optional<TriangleMesh> result;
  if (fault.text.empty()) result = transformed_mesh(*triangles, transform);
  if (result && is_too_large(*result, {1, 1, 1})) fault = {mesh.place, "it is larger than 1e6 m"};
  if (!fault.text.empty()) {
    const std::string message = fmt::format("mesh '{}' cannot be read: {}", mesh_name(mesh), fault.text);
    diagnostics.error("unread-mesh", fault.place, fault.is_of_file ? fault.text : message);
    return nullptr;
  }
  found->shape = std::make_shared<const TriangleMesh>(*std::move(result));
  return found->shape;
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
  const MeshTransform transform = transform_of(mesh, diagnostics_);
  Fault fault;
  const std::optional<TriangleMesh> triangles = read_triangles(mesh, diagnostics_, fault);
  if (fault.is_of_file) diagnostics_.error("unreadable-mesh", fault.place, fault.text);
  if (diagnostics_.error_count() > errors_before) return std::nullopt;
  if (!triangles) return refuse(fault.place, mesh_name(mesh), fault.text);
  if (triangles->faces.empty()) return refuse(mesh.place, mesh_name(mesh), "it has vertices only, and needs a hull");
  std::optional<Solid> solid = solid_of(*triangles, transform, static_cast<MeshInertia>(kind), fault.text);
  return solid ? solid : refuse(mesh.place, mesh_name(mesh), fault.text);
}

MeshTransform Meshes::transform_of(const Element& mesh, Diagnostics& diagnostics) const {
  Values values(diagnostics);
  MeshTransform transform;
  transform.shift = values_of(values.triple(mesh, "refpos", {}));
  const Number one = Number::rational(1);
  transform.scale = values_of(values.triple(mesh, "scale", {one, one, one}));
  if (const Attribute* turn = from_mjcf::find(mesh, "refquat")) {
    Element orientation;
    orientation.attributes.push_back(*turn);
    orientation.attributes.back().name = "quat";
    const Rotation rotation = orientation_of(orientation, settings_, diagnostics);
    const auto R = model::rotation_matrix(placement_of({{}, rotation}));
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t k = 0; k < 3; ++k) transform.turn[i][k] = model::evaluate(R[i][k]);
  }
  return transform;
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

// nullopt with a fault, or after reporting malformed numbers.
std::optional<TriangleMesh> Meshes::read_triangles(const Element& mesh, Diagnostics& diagnostics, Fault& fault) {
  if (from_mjcf::find(mesh, "builtin") != nullptr || !mesh.children.empty())
    return fault = {mesh.place, "MuJoCo generates it"}, std::nullopt;
  const Attribute* file = from_mjcf::find(mesh, "file");
  if (file == nullptr) {
    const Attribute* vertices = from_mjcf::find(mesh, "vertex");
    if (vertices != nullptr) return read_inline(mesh, *vertices, diagnostics, fault);
    return fault = {mesh.place, "it has neither 'file' nor 'vertex'"}, std::nullopt;
  }
  const fs::path path = path_of(*file);
  std::string reason;
  const std::optional<std::string> content = read_file(path, reason);
  if (!content) {
    fault = {file->place, fmt::format("file '{}' of this mesh cannot be read", path.string()), true};
    return std::nullopt;
  }
  if (std::find(read_.begin(), read_.end(), path) == read_.end()) read_.push_back(path);
  const std::string extension = extension_of(path);
  const bool is_known = extension == ".stl" || extension == ".obj" || extension == ".msh";
  if (!is_known) reason = "it is not an STL, OBJ or MSH file";
  std::optional<TriangleMesh> result = is_known ? read_mesh(path, *content, reason) : std::nullopt;
  if (!result) fault = {file->place, reason};
  return result;
}

std::optional<TriangleMesh> Meshes::read_inline(
    const Element& mesh,
    const Attribute& vertices,
    Diagnostics& diagnostics,
    Fault& fault) {
  constexpr std::size_t kMost = 1000000;
  Values values(diagnostics);
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
      if (!(index >= 0.0 && index < static_cast<double>(result.vertices.size()) && index == std::floor(index)))
        return fault = {faces->place, "a face refers to a vertex that it does not have"}, std::nullopt;
      corners[k] = static_cast<std::uint32_t>(index);
    }
    result.faces.push_back(corners);
  }
  return result;
}

}  // namespace robcogen::import::from_mjcf
