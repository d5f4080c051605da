#include "import/mesh_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>
#include <cstring>
#include <map>
#include <utility>

namespace robcogen::import {

namespace {

using Vertex = std::array<float, 3>;

// Little-endian, as in all of these formats.
std::uint32_t integer_at(std::string_view content, std::size_t at) {
  std::uint32_t result = 0;
  for (std::size_t i = 4; i-- > 0;) result = (result << 8) | static_cast<unsigned char>(content[at + i]);
  return result;
}

float real_at(std::string_view content, std::size_t at) {
  const std::uint32_t bits = integer_at(content, at);
  float result = 0;
  std::memcpy(&result, &bits, sizeof result);
  return result;
}

Vertex vertex_at(std::string_view content, std::size_t at) {
  return {real_at(content, at), real_at(content, at + 4), real_at(content, at + 8)};
}

// Gives equal vertices one index.
class VertexList {
 public:
  explicit VertexList(TriangleMesh& mesh) : mesh_(mesh) {}

  std::uint32_t add(Vertex vertex) {
    for (float& x : vertex) x += 0.0f;  // one zero instead of two
    const auto [at, is_new] = indices_.insert({vertex, static_cast<std::uint32_t>(mesh_.vertices.size())});
    if (is_new) mesh_.vertices.push_back(vertex);
    return at->second;
  }

 private:
  TriangleMesh& mesh_;
  std::map<Vertex, std::uint32_t> indices_;
};

// Splits a text into lines and words.
class Words {
 public:
  explicit Words(std::string_view text) : text_(text) {}

  // The next word; empty at the end of the text, or of the line if `in_line`.
  std::string_view next(bool in_line = false) {
    while (at_ < text_.size() && is_blank(text_[at_]) && !(in_line && text_[at_] == '\n')) ++at_;
    const std::size_t begin = at_;
    while (at_ < text_.size() && !is_blank(text_[at_])) ++at_;
    return text_.substr(begin, at_ - begin);
  }

  // Skips the rest of the line; false at the end of the text.
  bool next_line() {
    const std::size_t end = text_.find('\n', at_);
    at_ = end == std::string_view::npos ? text_.size() : end + 1;
    return at_ < text_.size();
  }

 private:
  std::string_view text_;
  std::size_t at_ = 0;

  static bool is_blank(char c) { return std::isspace(static_cast<unsigned char>(c)) != 0; }
};

template <class Value>
bool parse(std::string_view word, Value& value) {
  if (!word.empty() && word.front() == '+') word.remove_prefix(1);
  const auto [end, code] = std::from_chars(word.data(), word.data() + word.size(), value);
  return code == std::errc() && end == word.data() + word.size() && !word.empty();
}

std::optional<Vertex> read_vertex(Words& words, bool in_line) {
  Vertex vertex;
  for (float& x : vertex)
    if (!parse(words.next(in_line), x) || !std::isfinite(x)) return std::nullopt;
  return vertex;
}

std::optional<TriangleMesh> read_binary_stl(std::string_view content, std::uint32_t count, std::string& fault) {
  TriangleMesh mesh;
  VertexList list(mesh);
  for (std::size_t face = 0; face < count; ++face) {
    std::array<std::uint32_t, 3> corners;
    for (std::size_t i = 0; i < 3; ++i) {
      const Vertex vertex = vertex_at(content, 84 + 50 * face + 12 * (i + 1));
      for (const float x : vertex)
        if (!std::isfinite(x)) return fault = "it contains a number that is not finite", std::nullopt;
      corners[i] = list.add(vertex);
    }
    mesh.faces.push_back(corners);
  }
  return mesh;
}

std::optional<TriangleMesh> read_text_stl(std::string_view content, std::string& fault) {
  TriangleMesh mesh;
  VertexList list(mesh);
  Words words(content);
  std::vector<std::uint32_t> corners;
  bool is_complete = false;
  for (std::string_view word = words.next(); !word.empty(); word = words.next()) {
    if (word == "solid" || word == "endsolid") {
      is_complete = word == "endsolid";
      words.next_line();  // a name
    } else if (word == "vertex") {
      const std::optional<Vertex> vertex = read_vertex(words, false);
      if (!vertex) return fault = "it contains a malformed 'vertex'", std::nullopt;
      corners.push_back(list.add(*vertex));
    } else if (word == "endfacet") {
      if (corners.size() != 3) return fault = "a facet does not have three vertices", std::nullopt;
      mesh.faces.push_back({corners[0], corners[1], corners[2]});
      corners.clear();
    }
  }
  if (!is_complete) return fault = "it ends within a solid", std::nullopt;
  return mesh;
}

float squared_distance(const Vertex& a, const Vertex& b) {
  float sum = 0;
  for (std::size_t i = 0; i < 3; ++i) sum += (a[i] - b[i]) * (a[i] - b[i]);
  return sum;
}

// Divides a quadrilateral at its shorter diagonal, and other faces from their first vertex.
void add_face(const std::vector<std::uint32_t>& corners, TriangleMesh& mesh) {
  const auto& v = mesh.vertices;
  const bool is_odd = corners.size() == 4 &&
                      squared_distance(v[corners[0]], v[corners[2]]) >= squared_distance(v[corners[1]], v[corners[3]]);
  if (is_odd) {
    mesh.faces.push_back({corners[0], corners[1], corners[3]});
    mesh.faces.push_back({corners[1], corners[2], corners[3]});
    return;
  }
  for (std::size_t i = 2; i < corners.size(); ++i) mesh.faces.push_back({corners[0], corners[i - 1], corners[i]});
}

}  // namespace

std::optional<TriangleMesh> read_stl(std::string_view content, std::string& fault) {
  if (content.size() >= 84) {
    const std::uint32_t count = integer_at(content, 80);
    if (content.size() == 84 + std::uint64_t{50} * count) return read_binary_stl(content, count, fault);
  }
  if (content.substr(0, 5) == "solid") return read_text_stl(content, fault);
  fault = "it is not an STL: the number of triangles does not match its size";
  return std::nullopt;
}

std::optional<TriangleMesh> read_obj(std::string_view content, std::string& fault) {
  TriangleMesh mesh;
  std::vector<std::vector<std::uint32_t>> faces;
  Words words(content);
  std::size_t line = 0;
  do {
    ++line;
    const std::string_view kind = words.next(true);
    if (kind == "v") {
      const std::optional<Vertex> vertex = read_vertex(words, true);
      if (!vertex) return fault = fmt::format("line {} is a malformed vertex", line), std::nullopt;
      mesh.vertices.push_back(*vertex);
    } else if (kind == "f") {
      std::vector<std::uint32_t> corners;
      for (std::string_view word = words.next(true); !word.empty(); word = words.next(true)) {
        const auto count = static_cast<std::int64_t>(mesh.vertices.size());
        std::int64_t index = 0;
        const bool is_number = parse(word.substr(0, word.find('/')), index);
        if (index < 0) index += count + 1;  // counts back from the last vertex
        if (!is_number || index < 1 || index > UINT32_MAX)
          return fault = fmt::format("line {} is a malformed face", line), std::nullopt;
        corners.push_back(static_cast<std::uint32_t>(index - 1));
      }
      if (corners.size() < 3) return fault = fmt::format("line {} is a malformed face", line), std::nullopt;
      faces.push_back(std::move(corners));
    }
  } while (words.next_line());
  for (const std::vector<std::uint32_t>& corners : faces) {
    for (const std::uint32_t corner : corners)
      if (corner >= mesh.vertices.size())
        return fault = fmt::format("a face refers to vertex {}, which it does not have", corner + 1), std::nullopt;
    add_face(corners, mesh);
  }
  return mesh;
}

// Four numbers of vertices, normals, texture coordinates and faces; then these arrays.
std::optional<TriangleMesh> read_msh(std::string_view content, std::string& fault) {
  fault = "it is not an MSH of MuJoCo: the sizes in it do not match its own";
  if (content.size() < 16) return std::nullopt;
  const std::uint64_t vertices = integer_at(content, 0), normals = integer_at(content, 4),
                      coordinates = integer_at(content, 8), faces = integer_at(content, 12);
  const std::uint64_t before_faces = 16 + 12 * vertices + 12 * normals + 8 * coordinates;
  if (content.size() != before_faces + 12 * faces) return std::nullopt;
  TriangleMesh mesh;
  for (std::size_t i = 0; i < vertices; ++i) {
    mesh.vertices.push_back(vertex_at(content, 16 + 12 * i));
    for (const float x : mesh.vertices.back())
      if (!std::isfinite(x)) return fault = "it contains a number that is not finite", std::nullopt;
  }
  for (std::size_t i = 0; i < faces; ++i) {
    std::array<std::uint32_t, 3> corners;
    for (std::size_t k = 0; k < 3; ++k) {
      corners[k] = integer_at(content, before_faces + 12 * i + 4 * k);
      if (corners[k] >= vertices) return fault = "a face refers to a vertex that it does not have", std::nullopt;
    }
    mesh.faces.push_back(corners);
  }
  return mesh;
}

std::string extension_of(const std::filesystem::path& path) {
  std::string extension = path.extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(), [](unsigned char c) {
    return static_cast<char>(std::tolower(c));
  });
  return extension;
}

std::optional<TriangleMesh> read_mesh(const std::filesystem::path& path, std::string_view content, std::string& fault) {
  const std::string extension = extension_of(path);
  if (extension == ".stl") return read_stl(content, fault);
  if (extension == ".obj") return read_obj(content, fault);
  if (extension == ".msh") return read_msh(content, fault);
  return read_scene(path, content, fault);
}

}  // namespace robcogen::import
