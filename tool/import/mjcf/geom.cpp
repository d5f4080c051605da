// Masses of geoms: shapes of uniform density.
#include <fmt/format.h>

#include <numbers>

#include "import/mjcf/document.h"
#include "import/mjcf/geom_size.h"

namespace robcogen::import::from_mjcf {

namespace {

constexpr double kPi = std::numbers::pi;
constexpr double kWater = 1000.0;  // kg/m^3: the default density of a geom

struct Moments {
  double volume = 0.0;
  double x = 0.0, y = 0.0, z = 0.0;  // moments of inertia for unit mass
};

// A solid with half axes a, b, c: `fraction` is the mean squared coordinate along an axis of half length 1.
Moments symmetric(double volume, double fraction, double a, double b, double c) {
  return {volume, fraction * (b * b + c * c), fraction * (a * a + c * c), fraction * (a * a + b * b)};
}

Moments of_cylinder(double radius, double length) {
  const double across = (3.0 * radius * radius + length * length) / 12.0;
  return {kPi * radius * radius * length, across, across, radius * radius / 2.0};
}

// A cylinder between two half spheres. The centre of mass of each half sphere lies 3/8 of the radius beyond the
// cylinder's end.
Moments of_capsule(double radius, double length) {
  const Moments cylinder = of_cylinder(radius, length);
  const double sphere_volume = 4.0 / 3.0 * kPi * radius * radius * radius;
  const double volume = cylinder.volume + sphere_volume;
  const double share = sphere_volume / volume;  // fraction of the mass in the half spheres
  const double sphere = 0.4 * radius * radius;
  const double across = sphere + length * (3.0 * radius + 2.0 * length) / 8.0;
  return {
      volume, (1.0 - share) * cylinder.x + share * across, (1.0 - share) * cylinder.y + share * across,
      (1.0 - share) * cylinder.z + share * sphere};
}

class GeomReader {
 public:
  GeomReader(const Name& body, const PlacedElement& geom, const Context& context)
      : body_(body), element_(geom.element), frame_(geom.frame), context_(context), values_(context.diagnostics) {}

  std::optional<Part> read() {
    const Attribute* mass = find(element_, "mass");
    const Number density = values_.scalar(element_, "density", Number(kWater));
    const std::string shape = type_of_geom(element_, context_.diagnostics);
    if (shape == "plane" || shape == "hfield" || !is_in_range(values_.scalar(element_, "group"))) return std::nullopt;
    if (mass == nullptr ? density.is_zero() : values_.scalar(element_, "mass").is_zero()) return std::nullopt;
    const Attribute* mesh = find(element_, "mesh");
    if (shape == "sdf") return refuse("of a signed distance field");
    if (shape == "mesh" && mesh == nullptr) return refuse("of a mesh without a name");
    if (shape != "mesh" && mesh != nullptr) return refuse("of a shape that MuJoCo fits to a mesh");
    if (const Attribute* shell = find(element_, "shellinertia"); shell != nullptr && shell->value == "true")
      return refuse("of a shell");
    if (mesh != nullptr) return read_mesh(*mesh, mass, density);

    Part part;
    const Moments moments = read_shape(shape, part.pose);
    part.mass = mass != nullptr ? values_.scalar(element_, "mass") : Number(density.value() * moments.volume);
    part.xx = Number(part.mass.value() * moments.x);
    part.yy = Number(part.mass.value() * moments.y);
    part.zz = Number(part.mass.value() * moments.z);
    part.mass_place = mass != nullptr ? mass->place : element_.place;
    part.inertia_place = element_.place;
    part.pose = frame_ * part.pose;
    part.has_given_axes = find(element_, "fromto") == nullptr;
    check_mass(part);
    return part;
  }

 private:
  void check_mass(const Part& part) {
    if (part.mass.value() < 0.0)
      context_.diagnostics.error("negative-mass", part.mass_place, "the mass of this geom is negative");
  }

  // The pose of the geom is that of the axes of the file of its mesh.
  std::optional<Part> read_mesh(const Attribute& mesh, const Attribute* mass, const Number& density) {
    const Solid* solid = context_.meshes.find(mesh);
    if (solid == nullptr) return std::nullopt;
    Part part;
    part.mass = mass != nullptr ? values_.scalar(element_, "mass") : Number(density.value() * solid->volume);
    const double factor = part.mass.value() / solid->volume;
    part.xx = Number(factor * solid->xx), part.yy = Number(factor * solid->yy), part.zz = Number(factor * solid->zz);
    part.xy = Number(factor * solid->xy), part.xz = Number(factor * solid->xz), part.yz = Number(factor * solid->yz);
    part.mass_place = mass != nullptr ? mass->place : element_.place;
    part.inertia_place = element_.place;
    const Vector3& c = solid->center;
    const Pose center = {{model::Quantity(c[0]), model::Quantity(c[1]), model::Quantity(c[2])}, {}};
    part.pose = frame_ * pose_of(element_, context_.settings, context_.diagnostics) * center;
    check_mass(part);
    return part;
  }

  bool is_in_range(const Number& group) const {
    const Settings& settings = context_.settings;
    return group.value() >= settings.first_group.value() && group.value() <= settings.last_group.value();
  }

  std::optional<Part> refuse(const std::string& what) {
    context_.diagnostics
        .error(
            "mass-of-geom", element_.place,
            fmt::format("body '{}' has no inertial, and the mass {} is not computed", body_.text, what))
        .hint = "write <inertial pos=\"...\" mass=\"...\" diaginertia=\"...\"/>";
    return std::nullopt;
  }

  // Sets the pose. With `fromto`, the z axis is along the segment. Shapes with `fromto` are symmetric about this axis,
  // so the directions of z, x and y do not matter.
  Moments read_shape(const std::string& shape, Pose& pose) {
    const GeomSize size = read_size(element_, shape, context_.diagnostics);
    if (size.segment)
      pose = {size.segment->middle, rotation_to_axis(size.segment->along)};
    else
      pose = pose_of(element_, context_.settings, context_.diagnostics);
    const auto [a, b, c] = size.half;
    if (shape == "cylinder") return of_cylinder(a, 2.0 * c);
    if (shape == "capsule") return of_capsule(a, 2.0 * c);
    if (shape == "box") return symmetric(8.0 * a * b * c, 1.0 / 3.0, a, b, c);
    return symmetric(4.0 / 3.0 * kPi * a * b * c, 0.2, a, b, c);
  }

  const Name& body_;
  const Element& element_;
  const Pose& frame_;
  const Context& context_;
  Values values_;
};

}  // namespace

std::optional<Part> read_geom(const Name& body, const PlacedElement& geom, const Context& context) {
  return GeomReader(body, geom, context).read();
}

}  // namespace robcogen::import::from_mjcf
