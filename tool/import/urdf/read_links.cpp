// Reads links and their mass properties.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "import/urdf/read.h"

namespace robcogen::import::from_urdf {
namespace {

bool is_inertia(const Inertial& i) {
  const auto all = {i.mass, i.ixx, i.ixy, i.ixz, i.iyy, i.iyz, i.izz};
  return std::any_of(all.begin(), all.end(), [](const Number& n) { return !n.is_zero(); });
}

void read_moments(const Element& element, const std::string& link, Inertial& inertial, ElementReader& reader) {
  Names missing_moments, missing_products;
  const auto read = [&](const char* attribute, Number& value, Names& missing) {
    if (find(element, attribute) != nullptr) {
      value = reader.scalar(element, attribute);
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
    reader.report_missing_attributes(element, missing_moments);
  } else if (!missing_products.empty()) {
    Diagnostic& warning = reader.diagnostics().warning(
        "missing-product", reader.place(element.span),
        fmt::format("the inertia of link '{}' has no '{}': taken as zero", link, fmt::join(missing_products, "', '")));
    for (const Attribute& attribute : element.attributes)
      if (warning.hint.empty())
        warning.hint = suggestion(attribute.name, element.attributes, missing_products, known_attributes());
  }
}

Inertial read_inertial(const Element& element, const std::string& link, ElementReader& reader) {
  Inertial result;
  const Place own_place = reader.place(element.span);
  result.mass_place = result.inertia_place = own_place;
  const auto own = reader.parts(element, {"origin", "mass", "inertia"});
  result.origin = reader.origin(own);
  const auto mass = own.find("mass");
  if (mass != own.end()) {
    result.mass = reader.scalar(*mass->second, "value");
    if (const Attribute* value = find(*mass->second, "value")) result.mass_place = reader.place(value->span);
  } else {
    result.has_mass = false;  // see check_masses
    if (const Element* child = ElementReader::misspelt(element, "mass")) {
      result.mass_place = reader.place(child->span);
      result.mass_hint = did_you_mean(child->name, {"mass"});
    }
  }
  if (const auto inertia = own.find("inertia"); inertia != own.end()) {
    result.inertia_place = reader.place(inertia->second->span);
    read_moments(*inertia->second, link, result, reader);
  } else if (mass != own.end()) {
    reader.diagnostics().warning(
        "missing-inertia", own_place,
        fmt::format("the inertial of link '{}' has no 'inertia': the link is a point mass", link));
  }
  return result;
}

}  // namespace

Link read_link(const Element& element, ElementReader& reader) {
  Link result;
  result.name = reader.name(element, "name");
  const auto own = reader.parts(element, {"inertial"});
  const auto inertial = own.find("inertial");
  if (inertial == own.end()) return result;
  const Inertial read = read_inertial(*inertial->second, result.name.text, reader);
  if (is_inertia(read) || !read.has_mass) result.inertial = read;
  return result;
}

}  // namespace robcogen::import::from_urdf
