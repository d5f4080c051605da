// Volume, centre of mass and moments of inertia of a body whose surface is a triangle mesh.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "import/mesh_file.h"
#include "import/mjcf/vector3.h"

namespace robcogen::import::from_mjcf {

// How MuJoCo divides a mesh into tetrahedra with a common point, the centroid of its surface.
enum class MeshInertia {
  legacy,  // all volumes count as positive; exact for convex shapes
  exact,   // volumes have signs
  shell,   // the surface has the mass
};

struct MeshTransform {
  Vector3 shift = {};                                  // subtracted first
  Matrix3 turn = {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};  // its transpose turns vertices
  Vector3 scale = {1, 1, 1};
};

TriangleMesh transformed_mesh(const TriangleMesh& mesh, const MeshTransform& transform);

// Of density 1.
struct Solid {
  double volume = 0.0;                                                // m^3; of a shell, its area (m^2)
  Vector3 center = {};                                                // m
  double xx = 0.0, yy = 0.0, zz = 0.0, xy = 0.0, xz = 0.0, yz = 0.0;  // tensor about the center: xy = - integral of x y
};

// Integrates over the tetrahedra exactly, as MuJoCo does. nullopt with a `fault` if the volume is not positive, or if
// the volumes need signs and two triangles pass an edge in the same direction.
std::optional<Solid> solid_of(
    const TriangleMesh& mesh,
    const MeshTransform& transform,
    MeshInertia kind,
    std::string& fault);

}  // namespace robcogen::import::from_mjcf
