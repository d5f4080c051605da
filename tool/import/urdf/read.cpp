// From elements to the document.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <utility>

#include "import/urdf/element_reader.h"

namespace robcogen::import::from_urdf {

namespace {

constexpr std::array<std::pair<const char*, JointType>, 6> kTypes = {{
    {"revolute", JointType::revolute},
    {"continuous", JointType::continuous},
    {"prismatic", JointType::prismatic},
    {"fixed", JointType::fixed},
    {"floating", JointType::floating},
    {"planar", JointType::planar},
}};

bool is_inertia(const Inertial& i) {
  const auto all = {i.mass, i.ixx, i.ixy, i.ixz, i.iyy, i.iyz, i.izz};
  return std::any_of(all.begin(), all.end(), [](const Number& n) { return !n.is_zero(); });
}

class DocumentReader : ElementReader {
 public:
  DocumentReader(std::shared_ptr<const Source> source, Diagnostics& diagnostics)
      : ElementReader(std::move(source), diagnostics) {}

  Document read(const Element& root) {
    Document document;
    document.source = source();
    document.name = name(root, "name");
    if (const Attribute* version = find(root, "version")) document.version = version->value;
    for (const Element& child : root.children) {
      if (child.name == "link") {
        document.links.push_back(link(child));
      } else if (child.name == "joint") {
        document.joints.push_back(joint(child));
      } else if (child.name != "loop" && child.name != "coupling") {
        ignore(child, root, {"link", "joint"});
      }
    }
    if (document.links.empty())
      diagnostics_.error("no-link", place(root.span), fmt::format("robot '{}' has no link", document.name.text));
    document.ignored = ignored();
    return document;
  }

 private:
  Link link(const Element& element) {
    Link result;
    result.name = name(element, "name");
    const auto own = parts(element, {"inertial"});
    const auto inertial_element = own.find("inertial");
    if (inertial_element == own.end()) return result;
    const Inertial read = inertial(*inertial_element->second, result.name.text);
    if (is_inertia(read)) result.inertial = read;
    return result;
  }

  Inertial inertial(const Element& element, const std::string& link) {
    Inertial result;
    const Place own_place = place(element.span);
    result.mass_place = result.inertia_place = own_place;
    const auto own = parts(element, {"origin", "mass", "inertia"});
    result.origin = origin(own);
    const auto mass = own.find("mass");
    if (mass != own.end()) {
      result.mass = scalar(*mass->second, "value");
      if (const Attribute* value = find(*mass->second, "value")) result.mass_place = place(value->span);
    } else {
      Diagnostic& error =
          report_missing_element(element, "mass", fmt::format("the inertial of link '{}' has no mass", link));
      if (error.hint.empty()) error.hint = "write <mass value=\"...\"/>; a link without mass has no 'inertial'";
    }
    if (const auto inertia = own.find("inertia"); inertia != own.end()) {
      result.inertia_place = place(inertia->second->span);
      read_moments(*inertia->second, link, result);
    } else if (mass != own.end()) {
      diagnostics_.warning(
          "missing-inertia", own_place,
          fmt::format("the inertial of link '{}' has no 'inertia': the link is a point mass", link));
    }
    return result;
  }

  void read_moments(const Element& element, const std::string& link, Inertial& inertial) {
    Names missing_moments, missing_products;
    const auto read = [&](const char* attribute, Number& value, Names& missing) {
      if (find(element, attribute) != nullptr) {
        value = scalar(element, attribute);
      } else {
        missing.push_back(attribute);
      }
    };
    read("ixx", inertial.ixx, missing_moments);
    read("iyy", inertial.iyy, missing_moments);
    read("izz", inertial.izz, missing_moments);
    read("ixy", inertial.ixy, missing_products);
    read("ixz", inertial.ixz, missing_products);
    read("iyz", inertial.iyz, missing_products);
    if (!missing_moments.empty()) {
      report_missing_attributes(element, missing_moments);
    } else if (!missing_products.empty()) {
      Diagnostic& warning = diagnostics_.warning(
          "missing-product", place(element.span),
          fmt::format(
              "the inertia of link '{}' has no '{}': taken as zero", link, fmt::join(missing_products, "', '")));
      for (const Attribute& attribute : element.attributes)
        if (warning.hint.empty())
          warning.hint = suggestion(attribute.name, element.attributes, missing_products, known_attributes());
    }
  }

  Joint joint(const Element& element) {
    Joint result;
    result.name = name(element, "name");
    const bool has_type = read_type(element, result);
    read_independent(element, result);
    const auto own = parts(element, {"origin", "parent", "child", "axis", "limit", "dynamics", "mimic"});
    if (const Element* parent = require_part(element, own, "parent")) result.parent = name(*parent, "link");
    if (const Element* child = require_part(element, own, "child")) result.child = name(*child, "link");
    result.origin = origin(own);
    if (!has_type || !has_axis(result)) return result;  // the rest has no meaning
    if (const auto axis = own.find("axis"); axis != own.end()) read_axis(*axis->second, result);
    if (result.type == JointType::planar) {
      report_items_of_planar(own, result);
      return result;
    }
    if (const auto mimic = own.find("mimic"); mimic != own.end()) result.mimic = this->mimic(*mimic->second);
    if (const auto dynamics = own.find("dynamics"); dynamics != own.end())
      result.dynamics = dynamics_of(*dynamics->second, result);
    if (const auto found = own.find("limit"); found != own.end()) {
      result.limit = limit(*found->second, result);
    } else if (result.type != JointType::continuous) {
      diagnostics_.warning(
          "missing-limit", result.name.place,
          fmt::format(
              "{} joint '{}' has no 'limit': its motion is taken as unlimited", name_of(result.type),
              result.name.text));
    }
    return result;
  }

  // A URDF does not say which of its coordinates they are about.
  template <class Parts>
  void report_items_of_planar(const Parts& own, const Joint& joint) {
    if (const auto mimic = own.find("mimic"); mimic != own.end())
      diagnostics_.error(
          "planar-mimic", place(mimic->second->span),
          fmt::format("planar joint '{}' has three coordinates and cannot mimic one", joint.name.text));
    for (const char* item : {"dynamics", "limit"})
      if (const auto found = own.find(item); found != own.end())
        diagnostics_.warning(
            "planar-item", place(found->second->span),
            fmt::format("'{}' of planar joint '{}' is left out: it has three coordinates", item, joint.name.text));
  }

  bool read_type(const Element& element, Joint& joint) {
    const Attribute* type = require(element, "type");
    if (type == nullptr) return false;
    joint.type_place = place(type->span);
    std::vector<std::string> names;
    for (const auto& [type_name, value] : kTypes) {
      names.emplace_back(type_name);
      if (type->value != type_name) continue;
      joint.type = value;
      return true;
    }
    const std::string hint = did_you_mean(type->value, names);
    diagnostics_
        .error(
            "unknown-joint-type", joint.type_place,
            fmt::format("joint '{}' has unknown type '{}'", joint.name.text, type->value))
        .hint = hint.empty() ? fmt::format("the types are {}", fmt::join(names, ", ")) : hint;
    return false;
  }

  void read_independent(const Element& element, Joint& joint) {
    const Attribute* attribute = find(element, "independent");
    if (attribute == nullptr) return;
    joint.independent_place = place(attribute->span);
    const bool is_true = attribute->value == "true" || attribute->value == "True";
    if (is_true || attribute->value == "false" || attribute->value == "False") {
      joint.is_independent = is_true;
      return;
    }
    diagnostics_.error(
        "bad-independent", joint.independent_place,
        fmt::format("'independent' of joint '{}' is 'true' or 'false', not '{}'", joint.name.text, attribute->value));
  }

  void read_axis(const Element& element, Joint& joint) {
    const Attribute* xyz = require(element, "xyz");
    if (xyz == nullptr) return;
    const std::size_t errors_before = diagnostics_.error_count();
    joint.axis = triple(*xyz);
    const bool is_zero = joint.axis[0].is_zero() && joint.axis[1].is_zero() && joint.axis[2].is_zero();
    if (!is_zero || diagnostics_.error_count() > errors_before) return;
    diagnostics_.error(
        "zero-axis", place(xyz->span),
        fmt::format("the axis of joint '{}' is zero: it has no direction", joint.name.text));
  }

  Mimic mimic(const Element& element) {
    Mimic result;
    result.joint = name(element, "joint");
    check_attributes(element, {"multiplier", "offset"}, {"joint", "multiplier", "offset"}, false);
    if (const Attribute* found = find(element, "multiplier")) result.multiplier = numbers(*found, 1, Range::any)[0];
    if (const Attribute* found = find(element, "offset")) result.offset = numbers(*found, 1, Range::any)[0];
    return result;
  }

  // Programs that simulate take a negative value as none.
  Dynamics dynamics_of(const Element& element, const Joint& joint) {
    Dynamics result;
    result.place = place(element.span);
    check_attributes(element, {"damping", "friction"}, {"damping", "friction"}, false);
    const auto read = [&](const char* attribute) {
      const Attribute* found = find(element, attribute);
      const Number value = found == nullptr ? Number() : numbers(*found, 1)[0];
      if (value.value() >= 0) return value;
      diagnostics_.warning(
          "negative-dynamics", place(found->span),
          fmt::format(
              "the {} of joint '{}' is negative: {}; taken as zero", attribute, joint.name.text,
              print_double(value.value())));
      return Number();
    };
    result.damping = read("damping");
    result.friction = read("friction");
    return result;
  }

  Limit limit(const Element& element, const Joint& joint) {
    Limit result;
    const Place own_place = place(element.span);
    const Names known = {"lower", "upper", "effort", "velocity"};
    check_attributes(element, {"lower", "upper"}, known, false);
    const auto read = [&](const char* attribute) -> std::optional<Number> {
      const Attribute* found = find(element, attribute);
      if (found == nullptr) return std::nullopt;
      return numbers(*found, 1, Range::any)[0];
    };
    result.lower = read("lower"), result.upper = read("upper");
    result.effort = read("effort"), result.velocity = read("velocity");
    Names missing;
    if (!result.effort) missing.push_back("effort");
    if (!result.velocity) missing.push_back("velocity");
    if (!missing.empty()) {
      Diagnostic& warning = diagnostics_.warning(
          "missing-limit", own_place,
          fmt::format(
              "the 'limit' of joint '{}' has no '{}': taken as unlimited", joint.name.text,
              fmt::join(missing, "', '")));
      for (const Attribute& attribute : element.attributes)
        if (warning.hint.empty()) warning.hint = suggestion(attribute.name, element.attributes, missing, known);
    }
    const double lower = result.lower.value_or(Number()).value(), upper = result.upper.value_or(Number()).value();
    if (lower > upper && joint.type != JointType::continuous) {
      diagnostics_.warning(
          "crossed-limits", own_place,
          fmt::format(
              "no position of joint '{}' is within its limits: the lower is {}, the upper is {}", joint.name.text,
              print_double(lower), print_double(upper)));
    }
    return result;
  }
};

}  // namespace

const char* name_of(JointType type) {
  return std::find_if(kTypes.begin(), kTypes.end(), [&](const auto& known) { return known.second == type; })->first;
}

Document read_document(const Element& root, std::shared_ptr<const Source> source, Diagnostics& diagnostics) {
  if (root.name == "robot") return DocumentReader(std::move(source), diagnostics).read(root);
  diagnostics.error(
      "other-format", {std::move(source), root.span},
      fmt::format("this XML is not a URDF: its root element is '{}', not 'robot'", root.name));
  return {};
}

}  // namespace robcogen::import::from_urdf
