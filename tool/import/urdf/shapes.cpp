#include "import/urdf/shapes.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <utility>

#include "import/body_shape.h"
#include "import/urdf/element_reader.h"

namespace robcogen::import::from_urdf {
namespace {

using Kind = model::Shape::Kind;
using Use = model::Shape::Use;

const Names& kinds() {
  static const Names names = {"sphere", "capsule", "cylinder", "box", "mesh"};  // in the order of Kind
  return names;
}

class ShapeReader {
 public:
  ShapeReader(const std::string& link, ElementReader& reader, ShapeMeshes& meshes)
      : link_(link), reader_(reader), meshes_(meshes) {}

  // A shape that is reported is not used.
  PlacedShape read(const Element& element, Use use) {
    PlacedShape result;
    result.shape.use = use;
    result.shape.place = reader_.place(element.span);
    const Parts own = reader_.parts(element, {"geometry", "origin"});
    result.origin = reader_.origin(own);
    if (const Element* geometry = reader_.require_part(element, own, "geometry"))
      read_geometry(*geometry, result.shape);
    return result;
  }

 private:
  const std::string& link_;
  ElementReader& reader_;
  ShapeMeshes& meshes_;

  void read_geometry(const Element& geometry, model::Shape& shape) {
    const Parts parts = reader_.parts(geometry, kinds());
    for (std::size_t k = 0; k < kinds().size(); ++k) {
      const auto found = parts.find(kinds()[k]);
      if (found == parts.end()) continue;
      shape.kind = static_cast<Kind>(k);
      return read_sizes(*found->second, shape);
    }
    reader_.diagnostics().error("missing-element", reader_.place(geometry.span), "this 'geometry' has no shape").hint =
        "write a sphere, capsule, cylinder, box or mesh";
  }

  void read_sizes(const Element& element, model::Shape& shape) {
    switch (shape.kind) {
      case Kind::sphere:
        shape.size[0] = positive(element, "radius");
        return;
      case Kind::capsule:
      case Kind::cylinder:
        shape.size[0] = positive(element, "radius");
        shape.size[1] = positive(element, "length");
        return;
      case Kind::box:
        if (const Attribute* size = reader_.require(element, "size")) shape.size = positive(*size);
        return;
      case Kind::mesh:
        read_mesh(element, shape);
    }
  }

  double positive(const Element& element, const char* attribute) {
    const double value = reader_.scalar(element, attribute).value();
    if (const Attribute* given = find(element, attribute)) require_length(value, *given);
    return value;
  }

  std::array<double, 3> positive(const Attribute& attribute) {
    std::array<double, 3> values{};
    const std::size_t errors_before = reader_.diagnostics().error_count();
    const std::array<Number, 3> numbers = reader_.triple(attribute);
    for (std::size_t k = 0; k < 3; ++k) values[k] = numbers[k].value();
    if (reader_.diagnostics().error_count() > errors_before) return values;
    const auto [least, most] = std::minmax({values[0], values[1], values[2]});
    require_length(least > 0 ? most : least, attribute);
    return values;
  }

  void require_length(double value, const Attribute& attribute) {
    if (const std::string fault = fault_of_length(value); !fault.empty()) refuse_size(attribute, fault);
  }

  void refuse_size(const Attribute& attribute, const std::string& fault) {
    reader_.diagnostics().error(
        "shape-size", reader_.place(attribute.span),
        fmt::format("'{}' of a shape of link '{}' {}", attribute.name, link_, fault));
  }

  void read_mesh(const Element& element, model::Shape& shape) {
    shape.size = {1, 1, 1};
    if (const Attribute* scale = find(element, "scale")) {
      const std::size_t errors_before = reader_.diagnostics().error_count();
      const std::array<Number, 3> factors = reader_.triple(*scale);
      for (std::size_t k = 0; k < 3; ++k) shape.size[k] = factors[k].value();
      if (reader_.diagnostics().error_count() == errors_before && shape.size[0] * shape.size[1] * shape.size[2] == 0)
        refuse_size(*scale, "is zero");
    }
    const Attribute* file = reader_.require(element, "filename");
    if (file == nullptr) return;
    shape.file = file->value;
    std::string fault, hint;
    shape.mesh = meshes_.find(file->value, fault, hint);
    if (shape.mesh && is_too_large(*shape.mesh, shape.size)) shape.mesh = nullptr, fault = "is larger than 1e6 m";
    if (!shape.mesh)
      reader_.diagnostics()
          .error(
              "unread-mesh", reader_.place(file->span),
              fmt::format("mesh '{}' of link '{}' {}", file->value, link_, fault))
          .hint = hint;
  }
};

}  // namespace

std::vector<std::filesystem::path> read_shapes(
    const Element& root,
    const ShapeOptions& options,
    Document& document,
    Diagnostics& diagnostics) {
  if (!options.are_read()) return {};
  ShapeMeshes meshes(std::filesystem::path(document.source->name()).parent_path(), options);
  auto link = document.links.begin();
  for (const Element& element : root.children) {
    if (element.name != "link") continue;
    for (const Element& child : element.children) {
      if (child.name != "visual" && child.name != "collision") continue;
      const Use use = child.name == "visual" ? Use::visual : Use::collision;
      if (!options.reads(use)) continue;
      Diagnostics found;
      ElementReader reader(document.source, found);
      PlacedShape shape = ShapeReader(link->name.text, reader, meshes).read(child, use);
      reader.report_unread();
      if (add_findings(found, use == Use::collision && options.are_checked, diagnostics))
        link->shapes.push_back(std::move(shape));
    }
    ++link;
  }
  if (options.visuals) document.ignored.erase("visual");
  if (options.collisions) document.ignored.erase("collision");
  return meshes.files();
}

}  // namespace robcogen::import::from_urdf
