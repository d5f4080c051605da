// Masses of meshes: files in every format, and solids whose moments have formulas. (tests/oracles/mjcf/meshes.xml
// compares others with MuJoCo.)
#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <numbers>

#include "import/mjcf/solid.h"

namespace robcogen::import::from_mjcf::mesh_test {
namespace {

constexpr double kRounding = 1e-14;

// Sums over a box with half edges a, b, c, centred at (x, y, z).
struct Box {
  float a, b, c, x, y, z;

  TriangleMesh mesh() const {
    TriangleMesh result;
    for (int i = 0; i < 8; ++i)
      result.vertices.push_back({x + (i & 1 ? a : -a), y + (i & 2 ? b : -b), z + (i & 4 ? c : -c)});
    result.faces = {{0, 2, 1}, {1, 2, 3}, {4, 5, 6}, {5, 7, 6}, {0, 1, 4}, {1, 5, 4},
                    {2, 6, 3}, {3, 6, 7}, {0, 4, 2}, {2, 4, 6}, {1, 3, 5}, {3, 7, 5}};
    return result;
  }
  double volume() const { return 8.0 * a * b * c; }
};

constexpr Box kBox = {0.5f, 0.25f, 1.0f, 2.0f, -1.0f, 0.5f};  // exact in single precision

void expect_box(const std::optional<Solid>& solid, const Box& box) {
  ASSERT_TRUE(solid);
  EXPECT_NEAR(solid->volume, box.volume(), kRounding);
  EXPECT_NEAR(solid->center[0], box.x, kRounding);
  EXPECT_NEAR(solid->center[1], box.y, kRounding);
  EXPECT_NEAR(solid->center[2], box.z, kRounding);
  const double third = box.volume() / 3.0;
  EXPECT_NEAR(solid->xx, third * (box.b * box.b + box.c * box.c), kRounding);
  EXPECT_NEAR(solid->yy, third * (box.a * box.a + box.c * box.c), kRounding);
  EXPECT_NEAR(solid->zz, third * (box.a * box.a + box.b * box.b), kRounding);
  for (const double product : {solid->xy, solid->xz, solid->yz}) EXPECT_NEAR(product, 0.0, kRounding);
}

std::optional<Solid> solid(
    const std::optional<TriangleMesh>& mesh,
    MeshInertia kind = MeshInertia::exact,
    const MeshTransform& transform = {}) {
  std::string fault;
  const std::optional<Solid> result = mesh ? solid_of(*mesh, transform, kind, fault) : std::nullopt;
  EXPECT_TRUE(result) << fault;
  return result;
}

template <class Value>
void append(std::string& bytes, Value value) {
  std::array<char, sizeof value> raw;
  std::memcpy(raw.data(), &value, sizeof value);  // the machines of the tests are little-endian
  bytes.append(raw.data(), raw.size());
}

std::string binary_stl(const TriangleMesh& mesh) {
  std::string bytes = "solid is how binary files may begin, too";
  bytes.resize(80);
  append(bytes, static_cast<std::uint32_t>(mesh.faces.size()));
  for (const auto& face : mesh.faces) {
    bytes.append(12, '\0');  // the normal
    for (const std::uint32_t corner : face)
      for (const float x : mesh.vertices[corner]) append(bytes, x);
    bytes.append(2, '\0');
  }
  return bytes;
}

std::string text_stl(const TriangleMesh& mesh) {
  std::string text = "solid box of endfacet\r\n";
  for (const auto& face : mesh.faces) {
    text += " facet normal 0 0 0\r\n  outer loop\r\n";
    for (const std::uint32_t corner : face) {
      const auto& v = mesh.vertices[corner];
      text +=
          "   vertex " + std::to_string(v[0]) + " +" + std::to_string(v[1] + 9) + "e0 " + std::to_string(v[2]) + "\n";
    }
    text += "  endloop\n endfacet\n";
  }
  return text + "endsolid box\n";
}

std::string obj(const TriangleMesh& mesh) {
  std::string text = "# a box\nmtllib box.mtl\no box\nvn 0 0 1\nvt 0 0\n";
  for (const auto& v : mesh.vertices)
    text += "v  " + std::to_string(v[0]) + " " + std::to_string(v[1]) + "\t" + std::to_string(v[2]) + " 1.0\n";
  return text +
         "usemtl none\nf 1/1/1 3/1/1 4/1/1 2/1/1\nf 5//1 6//1 8//1 7//1\nf 1 2 6 5\nf 3 7 8 4\nf -8 -4 -2 -6\r\n"
         "f 2 4 8 6";
}

std::string msh(const TriangleMesh& mesh) {
  std::string bytes;
  append(bytes, static_cast<std::int32_t>(mesh.vertices.size()));
  append(bytes, std::int32_t{0});
  append(bytes, static_cast<std::int32_t>(mesh.vertices.size()));  // texture coordinates
  append(bytes, static_cast<std::int32_t>(mesh.faces.size()));
  for (const auto& v : mesh.vertices)
    for (const float x : v) append(bytes, x);
  bytes.append(8 * mesh.vertices.size(), '\0');
  for (const auto& face : mesh.faces)
    for (const std::uint32_t corner : face) append(bytes, corner);
  return bytes;
}

TEST(Meshes, FormatsDescribeTheSameBox) {
  std::string fault;
  const TriangleMesh mesh = kBox.mesh();
  const std::optional<TriangleMesh> stl = read_stl(binary_stl(mesh), fault);
  ASSERT_TRUE(stl) << fault;
  EXPECT_EQ(stl->vertices.size(), 8u);
  expect_box(solid(stl), kBox);
  Box shifted = kBox;
  shifted.y += 9;
  expect_box(solid(read_stl(text_stl(mesh), fault)), shifted);
  expect_box(solid(read_obj(obj(mesh), fault)), kBox);
  expect_box(solid(read_msh(msh(mesh), fault)), kBox);
}

TEST(Meshes, MalformedFilesAreRefused) {
  const TriangleMesh mesh = kBox.mesh();
  std::string fault;
  const auto refuses = [&](const auto& read, const std::string& content) {
    fault.clear();
    return !read(content, fault) && !fault.empty();
  };
  for (const auto& read : {read_stl, read_msh}) EXPECT_TRUE(refuses(read, ""));
  const std::string stl = binary_stl(mesh).replace(0, 5, "other");
  EXPECT_TRUE(refuses(read_stl, stl.substr(0, stl.size() - 1)));
  EXPECT_TRUE(refuses(read_stl, stl + " "));
  EXPECT_TRUE(refuses(read_msh, msh(mesh) + " "));
  EXPECT_TRUE(refuses(read_stl, "solid s\nfacet\nvertex 1 2 x\n"));
  EXPECT_TRUE(refuses(read_stl, "solid s\nfacet\nvertex 1 2 3\nendfacet\n"));
  const std::string whole = text_stl(mesh);
  EXPECT_TRUE(refuses(read_stl, whole.substr(0, whole.find("endsolid"))));
  EXPECT_TRUE(refuses(read_stl, whole.substr(0, whole.rfind("vertex"))));
  for (const char* text :
       {"v 1 2", "v 1 2 inf", "v 0 0 0\nf 1 1", "v 0 0 0\nf 1 1 2", "v 0 0 0\nf 1 1 -2", "f 0 1 2", "f a b c"})
    EXPECT_TRUE(refuses(read_obj, text)) << text;
  std::string bytes = msh(mesh);
  bytes.back() = '\x7f';
  EXPECT_TRUE(refuses(read_msh, bytes));
  EXPECT_TRUE(refuses(read_msh, std::string(16, '\xff')));
  bytes = binary_stl(mesh);
  for (std::size_t i = 96; i < 100; ++i) bytes[i] = '\xff';  // not a number
  EXPECT_TRUE(refuses(read_stl, bytes));
}

TEST(Meshes, AreScaledTurnedAndShifted) {
  MeshTransform transform;
  transform.shift = {1, 2, 3};
  transform.turn = {{{0, -1, 0}, {1, 0, 0}, {0, 0, 1}}};  // a quarter turn about z
  transform.scale = {2, -1, 1};
  // (x, y, z) becomes (2 (y - 2), x - 1, z - 3).
  const Box expected = {2 * kBox.b, kBox.a, kBox.c, 2 * (kBox.y - 2), kBox.x - 1, kBox.z - 3};
  expect_box(solid(kBox.mesh(), MeshInertia::exact, transform), expected);
  expect_box(solid(kBox.mesh(), MeshInertia::legacy, transform), expected);
}

// A square prism with a square recess: the recess counts as negative, or, in the legacy of MuJoCo, as positive.
TEST(Meshes, RecessesAreSubtracted) {
  TriangleMesh mesh = Box{1, 1, 1, 0, 0, 0}.mesh();
  const TriangleMesh hole = Box{0.5f, 0.5f, 0.5f, 0, 0, 0}.mesh();
  for (const auto& v : hole.vertices) mesh.vertices.push_back(v);
  for (const auto& f : hole.faces) mesh.faces.push_back({f[0] + 8, f[2] + 8, f[1] + 8});
  EXPECT_NEAR(solid(mesh)->volume, 8.0 - 1.0, kRounding);
  EXPECT_NEAR(solid(mesh)->xx, 8.0 * 2.0 / 3.0 - 0.5 / 3.0, kRounding);
  EXPECT_NEAR(solid(mesh, MeshInertia::legacy)->volume, 8.0 + 1.0, kRounding);
}

// The moment of a hollow cube with edge s and mass m is 5/18 m s^2.
TEST(Meshes, ShellsHaveTheirMassOnTheSurface) {
  const std::optional<Solid> shell = solid(Box{0.5f, 0.5f, 0.5f, 0, 0, 0}.mesh(), MeshInertia::shell);
  ASSERT_TRUE(shell);
  EXPECT_NEAR(shell->volume, 6.0, kRounding);
  EXPECT_NEAR(shell->xx, 6.0 * 5.0 / 18.0, kRounding);
}

}  // namespace
}  // namespace robcogen::import::from_mjcf::mesh_test
