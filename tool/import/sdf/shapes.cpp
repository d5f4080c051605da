#include "import/sdf/shapes.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace robcogen::import::from_sdf {
namespace {

using Kind = model::Shape::Kind;
using Use = model::Shape::Use;

class ShapeReader {
 public:
  ShapeReader(const std::string& link, ShapeMeshes& meshes, Diagnostics& found)
      : link_(link), meshes_(meshes), found_(found), snapper_(false, found), reader_(snapper_, found) {}

  // Whether the document says that there is no geometry.
  bool is_empty(const Element& element) const {
    const Element* geometry = child_of(element, "geometry");
    return geometry != nullptr && child_of(*geometry, "empty") != nullptr;
  }

  void read(const Element& element, ReadShape& result) {
    result.pose = reader_.pose(element, result.name.text);
    const Element* geometry = reader_.require_child(element, "geometry");
    if (geometry == nullptr) return;
    for (const Element& child : geometry->children) {
      if (child.name == "mesh") return read_mesh(child, result.shape.shape);
      if (read_solid(child, result.shape)) return;
    }
    Diagnostic& error = found_.error("missing-element", geometry->place, "this 'geometry' has no shape that is read");
    error.hint = "write a sphere, capsule, cylinder, ellipsoid, box or mesh";
  }

  // Which shapes collide by their masks is not read: all are checked.
  void check_mask(const Element& element) {
    const Element* surface = child_of(element, "surface");
    const Element* contact = surface == nullptr ? nullptr : child_of(*surface, "contact");
    const Element* mask = contact == nullptr ? nullptr : child_of(*contact, "collide_bitmask");
    if (mask != nullptr)
      found_.warning(
          "unread-mask", mask->place, "this 'collide_bitmask' is not read: the shape is checked with all others");
  }

 private:
  static const Element* child_of(const Element& element, const char* name) {
    const auto found = std::find_if(
        element.children.begin(), element.children.end(), [&](const Element& child) { return child.name == name; });
    return found == element.children.end() ? nullptr : &*found;
  }

  bool read_solid(const Element& solid, BodyShape& result) {
    model::Shape& shape = result.shape;
    if (solid.name == "sphere") {
      shape.kind = Kind::sphere;
      shape.size = {length(solid, "radius"), 0, 0};
    } else if (solid.name == "capsule" || solid.name == "cylinder") {
      shape.kind = solid.name == "capsule" ? Kind::capsule : Kind::cylinder;
      shape.size = {length(solid, "radius"), length(solid, "length"), 0};
    } else if (solid.name == "box") {
      shape.kind = Kind::box;
      shape.size = lengths(solid, "size");
    } else if (solid.name == "ellipsoid") {
      set_ellipsoid(result, lengths(solid, "radii"));
    } else {
      return false;
    }
    return true;
  }

  void refuse(const Element& child, const std::string& fault) {
    found_.error(
        "shape-size", xml::text_of(child).place,
        fmt::format("'{}' of a shape of link '{}' {}", child.name, link_, fault));
  }

  double length(const Element& solid, const char* name) {
    const std::size_t errors_before = found_.error_count();
    const Element* child = reader_.require_child(solid, name);
    const double value = reader_.number(solid, name).value();
    if (const std::string fault = fault_of_length(value); !fault.empty() && found_.error_count() == errors_before)
      refuse(*child, fault);
    return value;
  }

  std::array<double, 3> lengths(const Element& solid, const char* name) {
    std::array<double, 3> result = {};
    const std::size_t errors_before = found_.error_count();
    const Element* child = reader_.require_child(solid, name);
    if (child == nullptr) return result;
    const std::array<Number, 3> numbers = reader_.triple(*child);
    for (std::size_t k = 0; k < 3; ++k) {
      result[k] = numbers[k].value();
      if (const std::string fault = fault_of_length(result[k]); !fault.empty() && found_.error_count() == errors_before)
        refuse(*child, fault);
    }
    return result;
  }

  void read_mesh(const Element& mesh, model::Shape& shape) {
    shape.kind = Kind::mesh;
    shape.size = {1, 1, 1};
    if (const Element* scale = reader_.child(mesh, "scale")) {
      const std::size_t errors_before = found_.error_count();
      const std::array<Number, 3> factors = reader_.triple(*scale);
      for (std::size_t k = 0; k < 3; ++k) shape.size[k] = factors[k].value();
      const bool is_flat = factors[0].is_zero() || factors[1].is_zero() || factors[2].is_zero();
      if (is_flat && found_.error_count() == errors_before) refuse(*scale, "is zero");
    }
    if (const Element* part = reader_.child(mesh, "submesh"))
      found_.warning("unread-submesh", part->place, "this 'submesh' is not read: the shape is the whole mesh");
    const Element* uri = reader_.require_child(mesh, "uri");
    if (uri == nullptr) return;
    const Name file = ElementReader::reference(*uri);
    shape.file = file.text;
    std::string fault, hint;
    shape.mesh = meshes_.find(file.text, fault, hint);
    if (shape.mesh && is_too_large(*shape.mesh, shape.size)) shape.mesh = nullptr, fault = "is larger than 1e6 m";
    if (!shape.mesh)
      found_.error("unread-mesh", file.place, fmt::format("mesh '{}' of link '{}' {}", file.text, link_, fault)).hint =
          hint;
  }

  const std::string& link_;
  ShapeMeshes& meshes_;
  Diagnostics& found_;
  AngleSnapper snapper_;
  ElementReader reader_;
};

}  // namespace

std::optional<ReadShape> read_shape(
    const Element& element,
    const std::string& link,
    const ShapeOptions& options,
    ShapeMeshes& meshes,
    Diagnostics& diagnostics) {
  const Use use = element.name == "visual" ? Use::visual : Use::collision;
  if (!options.reads(use)) return std::nullopt;
  ReadShape result;
  result.name = {fmt::format("a {} of link '{}'", element.name, link), element.place};
  result.shape.shape.use = use;
  result.shape.shape.place = element.place;
  Diagnostics found;
  ShapeReader reader(link, meshes, found);
  if (reader.is_empty(element)) return std::nullopt;
  reader.read(element, result);
  const bool is_needed = use == Use::collision && options.are_checked;
  if (is_needed) reader.check_mask(element);
  return add_findings(found, is_needed, diagnostics) ? std::optional(std::move(result)) : std::nullopt;
}

}  // namespace robcogen::import::from_sdf
