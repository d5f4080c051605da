#include "view/page_shapes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <map>
#include <string>
#include <utility>

#include "model/kinematic_tree.h"
#include "view/simplify.h"

namespace robcogen::view {
namespace {

using Json = nlohmann::ordered_json;
using model::Shape;
using model::TriangleMesh;

constexpr std::size_t kTriangles = 9000;  // that a canvas paints in a few hundredths of a second
constexpr std::size_t kFewest = 60;       // of one mesh

std::string base64(const std::vector<std::uint16_t>& numbers) {
  constexpr const char* kDigits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string bytes, result;
  for (const std::uint16_t number : numbers) {
    bytes += static_cast<char>(number & 0xff);
    bytes += static_cast<char>(number >> 8);
  }
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    std::uint32_t group = 0;
    const std::size_t count = std::min<std::size_t>(3, bytes.size() - i);
    for (std::size_t k = 0; k < 3; ++k)
      group = (group << 8) | (k < count ? static_cast<unsigned char>(bytes[i + k]) : 0U);
    for (std::size_t k = 0; k < 4; ++k) result += k <= count ? kDigits[(group >> (18 - 6 * k)) & 63] : '=';
  }
  return result;
}

// Coordinates are multiples of `step` from `low`: a 65,535th of the largest edge.
Json data_of(const TriangleMesh& mesh) {
  constexpr float kSteps = 65535;
  std::array<float, 3> low = mesh.vertices.front(), high = low;
  for (const auto& v : mesh.vertices)
    for (std::size_t k = 0; k < 3; ++k) low[k] = std::min(low[k], v[k]), high[k] = std::max(high[k], v[k]);
  const float edge = std::max({high[0] - low[0], high[1] - low[1], high[2] - low[2], 1e-9F});
  std::vector<std::uint16_t> points, faces;
  for (const auto& v : mesh.vertices)
    for (std::size_t k = 0; k < 3; ++k)
      points.push_back(static_cast<std::uint16_t>(std::lround((v[k] - low[k]) / edge * kSteps)));
  for (const auto& face : mesh.faces)
    for (const std::uint32_t corner : face) faces.push_back(static_cast<std::uint16_t>(corner));
  return {{"low", low}, {"step", edge / kSteps}, {"points", base64(points)}, {"faces", base64(faces)}};
}

// Only the vertices that triangles use; there are at most three for each.
TriangleMesh compact(const TriangleMesh& mesh) {
  TriangleMesh result;
  std::map<std::uint32_t, std::uint32_t> places;
  for (std::array<std::uint32_t, 3> face : mesh.faces) {
    for (std::uint32_t& corner : face) {
      const auto [at, is_new] = places.insert({corner, static_cast<std::uint32_t>(result.vertices.size())});
      if (is_new) result.vertices.push_back(mesh.vertices[corner]);
      corner = at->second;
    }
    result.faces.push_back(face);
  }
  return result;
}

const char* name_of(Shape::Kind kind) {
  switch (kind) {
    case Shape::Kind::sphere:
      return "sphere";
    case Shape::Kind::capsule:
      return "capsule";
    case Shape::Kind::cylinder:
      return "cylinder";
    case Shape::Kind::box:
      return "box";
    case Shape::Kind::mesh:
      break;
  }
  return "mesh";
}

// link_X_shape by rows.
std::array<std::array<double, 4>, 3> pose_of(const model::Placement& placement) {
  const auto R = model::rotation_matrix(placement);
  std::array<std::array<double, 4>, 3> rows{};
  for (std::size_t r = 0; r < 3; ++r) {
    for (std::size_t c = 0; c < 3; ++c) rows[r][c] = model::evaluate(R[r][c]);
    rows[r][3] = model::evaluate(placement.translation[r]);
  }
  return rows;
}

}  // namespace

PageShapes page_shapes(const std::vector<Shape>& shapes) {
  PageShapes result;
  result.shapes = Json::array();
  result.meshes = Json::array();
  for (const Shape& shape : shapes)
    if (shape.mesh) result.triangles += shape.mesh->faces.size();
  std::map<const TriangleMesh*, std::pair<std::size_t, std::size_t>> shown;  // index, number of triangles
  for (const Shape& shape : shapes) {
    if (shape.mesh && shape.mesh->faces.empty()) continue;  // vertices of a hull, which has no picture
    Json data = {{"link", shape.link},          {"body", shape.body}, {"isVisual", shape.use == Shape::Use::visual},
                 {"kind", name_of(shape.kind)}, {"size", shape.size}, {"pose", pose_of(shape.placement)}};
    if (shape.mesh) {
      auto known = shown.find(shape.mesh.get());
      if (known == shown.end()) {
        const std::size_t own = shape.mesh->faces.size();
        const std::size_t share = result.triangles <= kTriangles ? own : own * kTriangles / result.triangles;
        const TriangleMesh mesh = compact(simplified(*shape.mesh, std::max(kFewest, share)));
        known = shown.insert({shape.mesh.get(), {result.meshes.size(), mesh.faces.size()}}).first;
        result.meshes.push_back(data_of(mesh));
      }
      data["mesh"] = known->second.first;
      result.shown_triangles += known->second.second;
    }
    result.shapes.push_back(std::move(data));
  }
  return result;
}

}  // namespace robcogen::view
