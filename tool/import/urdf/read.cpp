// From elements to the document.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "import/urdf/document.h"

namespace robcogen::import::from_urdf {

namespace {

// What a robot has is below this in SI units, and what is as small as that is nothing: beyond, products of a few
// quantities would overflow.
constexpr double kTooLarge = 1e15;
constexpr double kNothing = 1e-60;

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

// A word of an attribute, and where it stands.
struct Word {
  std::string text;
  Span span;
};

class DocumentReader {
 public:
  DocumentReader(std::shared_ptr<const Source> source, Diagnostics& diagnostics)
      : source_(std::move(source)), diagnostics_(diagnostics) {}

  Document read(const Element& root) {
    Document document;
    document.source = source_;
    document.name = name(root, "name");
    if (const Attribute* version = find(root, "version")) document.version = version->value;
    for (const Element& child : root.children) {
      if (child.name == "link") {
        document.links.push_back(link(child));
      } else if (child.name == "joint") {
        document.joints.push_back(joint(child));
      } else {
        ++ignored_[child.name];
      }
    }
    if (document.links.empty())
      diagnostics_.error("no-link", place(root.span), fmt::format("robot '{}' has no link", document.name.text));
    document.ignored = std::move(ignored_);
    return document;
  }

 private:
  Place place(const Span& span) const { return {source_, span}; }

  static const Attribute* find(const Element& element, const char* attribute) {
    const auto found = std::find_if(
        element.attributes.begin(), element.attributes.end(), [&](const Attribute& a) { return a.name == attribute; });
    return found == element.attributes.end() ? nullptr : &*found;
  }

  const Attribute* require(const Element& element, const char* attribute) {
    const Attribute* found = find(element, attribute);
    if (found != nullptr) return found;
    diagnostics_.error(
        "missing-attribute", place(element.span),
        fmt::format("this '{}' has no attribute '{}'", element.name, attribute));
    return nullptr;
  }

  Name name(const Element& element, const char* attribute) {
    const Attribute* found = require(element, attribute);
    if (found == nullptr) return {"", place(element.span)};
    if (found->value.empty())
      diagnostics_.error(
          "missing-attribute", place(found->span), fmt::format("the name of this '{}' is empty", element.name));
    return {found->value, place(found->span)};
  }

  // The elements of these names, each at most once; all others are counted as ignored.
  std::map<std::string, const Element*> parts(const Element& element, std::initializer_list<const char*> names) {
    std::map<std::string, const Element*> found;
    for (const Element& child : element.children) {
      if (std::find(names.begin(), names.end(), child.name) == names.end()) {
        ++ignored_[child.name];
      } else if (const auto [first, is_new] = found.insert({child.name, &child}); !is_new) {
        diagnostics_
            .warning(
                "repeated-element", place(child.span),
                fmt::format("a second '{}' of this '{}': only the first counts", child.name, element.name))
            .notes.push_back({place(first->second->span), "the first one"});
      }
    }
    return found;
  }

  const Element* require_part(
      const Element& element,
      const std::map<std::string, const Element*>& parts,
      const char* part) {
    const auto found = parts.find(part);
    if (found != parts.end()) return found->second;
    diagnostics_.error(
        "missing-element", place(element.span), fmt::format("this '{}' has no '{}'", element.name, part));
    return nullptr;
  }

  // Words between blanks, each with its own place where the value stands in the text as it is.
  std::vector<Word> words(const Attribute& attribute) const {
    constexpr const char* kBlanks = " \t\n\r";
    const std::string& value = attribute.value;
    const bool is_plain = attribute.span.end - attribute.span.begin == value.size();
    std::vector<Word> result;
    for (std::size_t at = 0; (at = value.find_first_not_of(kBlanks, at)) != std::string::npos;) {
      const std::size_t end = std::min(value.find_first_of(kBlanks, at), value.size());
      const Span own = {attribute.span.begin + at, attribute.span.begin + end};
      result.push_back({value.substr(at, end - at), is_plain ? own : attribute.span});
      at = end;
    }
    return result;
  }

  enum class Range { of_a_robot, any };

  Number number(const Word& word, Range range = Range::of_a_robot) {
    const std::optional<Number> parsed = Number::parse(word.text);
    if (!parsed) {
      report_no_number(word);
      return Number();
    }
    const double magnitude = std::abs(parsed->value());
    if (magnitude >= kTooLarge && range == Range::of_a_robot) {
      diagnostics_.error(
          "too-large", place(word.span),
          fmt::format("{} is too large: what a robot has is below {} in SI units", word.text, print_double(kTooLarge)));
    }
    return magnitude < kNothing ? Number() : *parsed;
  }

  void report_no_number(const Word& word) {
    constexpr std::size_t kShown = 40;
    const std::string shown = word.text.size() > kShown ? word.text.substr(0, kShown) + "…" : word.text;
    Diagnostic& error =
        diagnostics_.error("not-a-number", place(word.span), fmt::format("'{}' is no finite decimal number", shown));
    if (word.text.find(',') != std::string::npos) {
      error.hint = "a decimal point is '.', and blanks stand between numbers";
    }
  }

  std::vector<Number> numbers(const Attribute& attribute, std::size_t count, Range range = Range::of_a_robot) {
    std::vector<Number> result;
    const std::vector<Word> all = words(attribute);
    if (all.size() != count) {
      diagnostics_.error(
          "component-count", place(attribute.span),
          fmt::format("'{}' needs {} number{}, and has {}", attribute.name, count, count == 1 ? "" : "s", all.size()));
    }
    for (const Word& word : all)
      if (result.size() < count) result.push_back(number(word, range));
    result.resize(count);
    return result;
  }

  std::array<Number, 3> triple(const Attribute& attribute) {
    const std::vector<Number> n = numbers(attribute, 3);
    return {n[0], n[1], n[2]};
  }

  Number scalar(const Element& element, const char* attribute) {
    const Attribute* found = require(element, attribute);
    return found == nullptr ? Number() : numbers(*found, 1)[0];
  }

  Origin origin(const std::map<std::string, const Element*>& parts) {
    Origin result;
    const auto found = parts.find("origin");
    if (found == parts.end()) return result;
    const Element& element = *found->second;
    if (const Attribute* xyz = find(element, "xyz")) result.xyz = triple(*xyz);
    if (const Attribute* rpy = find(element, "rpy")) {
      result.rpy = triple(*rpy);
      const std::vector<Word> all = words(*rpy);
      for (std::size_t i = 0; i < 3 && i < all.size(); ++i) result.rpy_places[i] = place(all[i].span);
    }
    if (const Attribute* quaternion = find(element, "quat_xyzw")) {
      diagnostics_.error(
          "unsupported-quaternion", place(quaternion->span), "rotations as quaternions are not supported: give 'rpy'");
    }
    return result;
  }

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
    result.place = place(element.span);
    const auto own = parts(element, {"origin", "mass", "inertia"});
    result.origin = origin(own);
    const auto mass = own.find("mass");
    if (mass != own.end()) {
      result.mass = scalar(*mass->second, "value");
    } else {
      diagnostics_.error("missing-element", result.place, fmt::format("the inertial of link '{}' has no mass", link))
          .hint = "give it <mass value=\"...\"/>; a link without mass has no 'inertial'";
    }
    if (const auto inertia = own.find("inertia"); inertia != own.end()) {
      read_moments(*inertia->second, link, result);
    } else if (mass != own.end()) {
      diagnostics_.warning(
          "missing-inertia", result.place,
          fmt::format("the inertial of link '{}' has no 'inertia': it is taken for a point mass", link));
    }
    return result;
  }

  void read_moments(const Element& element, const std::string& link, Inertial& inertial) {
    inertial.ixx = scalar(element, "ixx");
    inertial.iyy = scalar(element, "iyy");
    inertial.izz = scalar(element, "izz");
    std::string missing;
    for (const auto& [attribute, product] :
         {std::pair("ixy", &inertial.ixy), std::pair("ixz", &inertial.ixz), std::pair("iyz", &inertial.iyz)}) {
      if (find(element, attribute) != nullptr)
        *product = scalar(element, attribute);
      else
        missing += fmt::format("{}'{}'", missing.empty() ? "" : ", ", attribute);
    }
    if (missing.empty()) return;
    diagnostics_.warning(
        "missing-product", place(element.span),
        fmt::format("the inertia of link '{}' has no {}: taken to be zero", link, missing));
  }

  Joint joint(const Element& element) {
    Joint result;
    result.name = name(element, "name");
    const bool has_type = read_type(element, result);
    const auto own = parts(element, {"origin", "parent", "child", "axis", "limit", "mimic"});
    if (const Element* parent = require_part(element, own, "parent")) result.parent = name(*parent, "link");
    if (const Element* child = require_part(element, own, "child")) result.child = name(*child, "link");
    result.origin = origin(own);
    if (!has_type || !is_movable(result)) return result;  // what follows would mean nothing
    if (const auto axis = own.find("axis"); axis != own.end()) read_axis(*axis->second, result);
    if (const auto mimic = own.find("mimic"); mimic != own.end()) result.mimic = name(*mimic->second, "joint");
    if (const auto found = own.find("limit"); found != own.end()) {
      result.limit = limit(*found->second, result);
    } else if (result.type != JointType::continuous) {
      diagnostics_.warning(
          "missing-limit", result.name.place,
          fmt::format(
              "{} joint '{}' has no 'limit': it is taken to have none", name_of(result.type), result.name.text));
    }
    return result;
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
    diagnostics_
        .error(
            "unknown-joint-type", joint.type_place,
            fmt::format("joint '{}' is of no known type: '{}'", joint.name.text, type->value))
        .hint = did_you_mean(type->value, names);
    return false;
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
        fmt::format("the axis of joint '{}' has no direction: it is zero", joint.name.text));
  }

  Limit limit(const Element& element, const Joint& joint) {
    Limit result;
    result.place = place(element.span);
    const auto read = [&](const char* attribute) -> std::optional<Number> {
      const Attribute* found = find(element, attribute);
      if (found == nullptr) return std::nullopt;
      return numbers(*found, 1, Range::any)[0];
    };
    result.lower = read("lower"), result.upper = read("upper");
    result.effort = read("effort"), result.velocity = read("velocity");
    for (const auto& [value, what] : {std::pair(result.effort, "effort"), std::pair(result.velocity, "velocity")}) {
      if (value) continue;
      diagnostics_.warning(
          "missing-limit", result.place,
          fmt::format("joint '{0}' has a 'limit' without '{1}': its {1} is taken to have none", joint.name.text, what));
    }
    const double lower = result.lower.value_or(Number()).value(), upper = result.upper.value_or(Number()).value();
    if (lower > upper && joint.type != JointType::continuous) {
      diagnostics_.warning(
          "crossed-limits", result.place,
          fmt::format(
              "joint '{}' has no position to be in: its lower limit is {}, its upper limit {}", joint.name.text,
              print_double(lower), print_double(upper)));
    }
    return result;
  }

  std::shared_ptr<const Source> source_;
  Diagnostics& diagnostics_;
  std::map<std::string, int> ignored_;
};

}  // namespace

const char* name_of(JointType type) {
  return std::find_if(kTypes.begin(), kTypes.end(), [&](const auto& known) { return known.second == type; })->first;
}

Document read_document(const Element& root, std::shared_ptr<const Source> source, Diagnostics& diagnostics) {
  if (root.name == "robot") return DocumentReader(std::move(source), diagnostics).read(root);
  diagnostics.error(
      "other-format", {std::move(source), root.span},
      fmt::format("this is XML, and no URDF: its root element is '{}', not 'robot'", root.name));
  return {};
}

}  // namespace robcogen::import::from_urdf
