#include "import/mjcf/shapes.h"

#include <fmt/format.h>

#include <cmath>
#include <utility>

#include "import/mjcf/geom_size.h"

namespace robcogen::import::from_mjcf {
namespace {

using Kind = model::Shape::Kind;
using Use = model::Shape::Use;

constexpr double kLastShownGroup = 2;  // that MuJoCo's viewer shows

class ShapeReader {
 public:
  ShapeReader(const PlacedElement& geom, const Context& context, Diagnostics& found)
      : geom_(geom.element), frame_(geom.frame), context_(context), found_(found), values_(found) {}

  std::uint32_t bits(const char* attribute) {
    const double value = values_.scalar(geom_, attribute, Number::rational(1)).value();
    if (std::abs(value) < 4294967296.0 && value == std::floor(value))
      return static_cast<std::uint32_t>(static_cast<std::int64_t>(value));
    found_.error(
        "geom-bits", find(geom_, attribute)->place, fmt::format("'{}' is not an integer of 32 bits", attribute));
    return 1;
  }

  bool is_shown() { return values_.scalar(geom_, "group").value() <= kLastShownGroup; }

  // An empty mesh in a shape of kind `mesh` was reported.
  BodyShape read(const std::string& type) {
    BodyShape result;
    model::Shape& shape = result.shape;
    shape.place = geom_.place;
    const Attribute* mesh = find(geom_, "mesh");
    if (type == "sdf")
      refuse(geom_.place, "a signed distance field is not read as a shape");
    else if (type == "mesh" && mesh == nullptr)
      refuse(geom_.place, "this 'geom' has no attribute 'mesh'");
    else if (type != "mesh" && mesh != nullptr)
      refuse(mesh->place, "a shape that is fitted to a mesh is not read");
    else if (type == "mesh")
      read_mesh(*mesh, result);
    else
      read_solid(type, result);
    result.pose = frame_ * result.pose;
    return result;
  }

 private:
  void refuse(const Place& place, const char* message) {
    found_.error("unread-geom", place, message).hint =
        "write a sphere, capsule, cylinder, ellipsoid, box or mesh; without bits of contype and conaffinity, it is not "
        "checked";
  }

  void read_mesh(const Attribute& mesh, BodyShape& result) {
    result.shape.kind = Kind::mesh;
    result.shape.size = {1, 1, 1};
    result.shape.file = mesh.value;
    result.shape.mesh = context_.meshes.find_shape(mesh, found_);
    result.pose = pose_of(geom_, context_.settings, found_);
  }

  void read_solid(const std::string& type, BodyShape& result) {
    const GeomSize size = read_size(geom_, type, found_);
    const auto [a, b, c] = size.half;
    for (std::size_t k = 0; k < 3; ++k)
      if (const std::string fault = fault_of_length(size.half[k]); !fault.empty() && !found_.has_errors()) {
        const Attribute* given = find(geom_, k == 2 && size.segment ? "fromto" : "size");
        found_.error("geom-size", given->place, "the size of this geom " + fault);
      }
    if (size.segment)
      result.pose = {size.segment->middle, smallest_rotation_to_axis(size.segment->along)};
    else
      result.pose = pose_of(geom_, context_.settings, found_);
    model::Shape& shape = result.shape;
    if (type == "ellipsoid") return set_ellipsoid(result, size.half);
    shape.kind = type == "sphere"     ? Kind::sphere
                 : type == "capsule"  ? Kind::capsule
                 : type == "cylinder" ? Kind::cylinder
                                      : Kind::box;
    if (type == "sphere")
      shape.size = {a, 0, 0};
    else if (type == "box")
      shape.size = {2 * a, 2 * b, 2 * c};
    else
      shape.size = {a, 2 * c, 0};
  }

  const Element& geom_;
  const Pose& frame_;
  const Context& context_;
  Diagnostics& found_;
  Values values_;
};

void read_geom_shape(const PlacedElement& geom, const ShapeOptions& options, const Context& context, Body& body) {
  Diagnostics found;
  ShapeReader reader(geom, context, found);
  const ContactBits contact = {reader.bits("contype"), reader.bits("conaffinity")};
  const bool is_visual = options.visuals && reader.is_shown();
  const bool is_collision = options.collisions && (contact.type != 0 || contact.affinity != 0);
  if (!is_visual && !is_collision && !found.has_errors()) return;
  const std::string kind = type_of_geom(geom.element, found);
  const bool is_needed = is_collision && options.are_checked;
  if (kind == "plane" || kind == "hfield") {
    if (is_needed)
      context.diagnostics.warning(
          "unread-geom", geom.element.place,
          fmt::format(
              "this {} is not a shape of a link, and is not checked", kind == "plane" ? "plane" : "height field"));
    return;
  }
  const BodyShape shape = reader.read(kind);
  const bool is_complete = shape.shape.kind != Kind::mesh || shape.shape.mesh != nullptr;
  if (!add_findings(found, is_needed, context.diagnostics) || !is_complete) return;
  for (const auto& [use, is_read] : {std::pair{Use::visual, is_visual}, {Use::collision, is_collision}}) {
    if (is_read) body.shapes.emplace_back(shape).shape.use = use;
  }
  if (is_collision) body.contact.push_back(contact);
}

}  // namespace

void read_shapes(Document& document, const ShapeOptions& options, const Context& context) {
  if (!options.are_read()) return;
  for (std::size_t b = 0; b < document.bodies.size(); ++b)
    if (document.robot.has[b])
      for (const PlacedElement& geom : document.bodies[b].geoms)
        read_geom_shape(geom, options, context, document.bodies[b]);
  document.ignored.erase("geom");
}

void read_excludes(const Element& section, Document& document, Diagnostics& diagnostics) {
  const auto body = [&](const Element& exclude, const char* attribute) -> std::optional<Name> {
    const Attribute* given = find(exclude, attribute);
    if (given == nullptr) {
      diagnostics.error(
          "missing-attribute", exclude.place, fmt::format("this 'exclude' has no attribute '{}'", attribute));
      return std::nullopt;
    }
    std::vector<std::string> names;
    for (const Body& known : document.bodies) {
      if (is_named(known, given->value)) return Name{given->value, given->place};
      names.push_back(known.name.text);
    }
    diagnostics
        .warning(
            "unknown-body", given->place, fmt::format("body '{}' is not declared: the pair is checked", given->value))
        .hint = did_you_mean(given->value, names);
    return std::nullopt;
  };
  for (const Element& child : section.children) {
    if (child.name == "exclude") {
      const std::optional<Name> first = body(child, "body1"), second = body(child, "body2");
      if (first && second) document.excludes.push_back({*first, *second});
    } else if (child.name == "pair") {
      diagnostics.warning(
          "unread-pair", child.place, "this pair of geoms is not read: its bodies are checked as all others are");
    }
  }
}

}  // namespace robcogen::import::from_mjcf
