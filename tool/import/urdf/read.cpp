// From elements to the document.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <utility>

#include "import/urdf/document.h"

namespace robcogen::import::from_urdf {

namespace {

// In SI units, no quantity of a robot is as large as this: products of a few quantities would overflow.
constexpr double kTooLarge = 1e15;
// A quantity as small as this is zero: its reciprocal would overflow.
constexpr double kZero = 1e-60;

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

// A word of an attribute, with its place.
struct Word {
  std::string text;
  Span span;
};

// Of attributes or elements.
using Names = std::vector<const char*>;

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
        ignore(child, root, {"link", "joint"});
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

  // `did you mean 'x'?` for a name that is not known here: the nearest of `candidates` that is not among `found`.
  template <class Items>
  static std::string suggestion(
      const std::string& name,
      const Items& found,
      const Names& candidates,
      const Names& known) {
    if (std::find(known.begin(), known.end(), name) != known.end()) return "";
    std::vector<std::string> absent;
    for (const char* candidate : candidates)
      if (std::none_of(found.begin(), found.end(), [&](const auto& item) { return item.name == candidate; }))
        absent.emplace_back(candidate);
    return did_you_mean(name, absent);
  }

  // Of the elements that have attributes which must be there.
  static const Names& known_attributes() {
    static const Names names = {"name", "type", "link", "joint", "value", "xyz",
                                "ixx",  "ixy",  "ixz",  "iyy",   "iyz",   "izz"};
    return names;
  }

  const Attribute* require(const Element& element, const char* attribute) {
    const Attribute* found = find(element, attribute);
    if (found == nullptr) report_missing_attributes(element, {attribute});
    return found;
  }

  void report_missing_attributes(const Element& element, const Names& missing) {
    Diagnostic& error = diagnostics_.error(
        "missing-attribute", place(element.span),
        fmt::format(
            "this '{}' has no attribute{} '{}'", element.name, missing.size() > 1 ? "s" : "",
            fmt::join(missing, "', '")));
    for (const Attribute& attribute : element.attributes) {
      const std::string hint = suggestion(attribute.name, element.attributes, missing, known_attributes());
      if (hint.empty()) continue;
      error.place.span = name_span(attribute);
      error.hint = hint;
      return;
    }
    error.hint = fmt::format("write <{} {}=\"...\">", element.name, fmt::join(missing, "=\"...\" "));
  }

  // The name stands before `=` and the value.
  Span name_span(const Attribute& attribute) const {
    const std::string_view text = source_->text();
    const std::size_t equals = text.rfind('=', attribute.span.begin);
    const std::size_t begin = equals == std::string_view::npos ? equals : text.rfind(attribute.name, equals);
    return begin == std::string_view::npos ? attribute.span : Span{begin, begin + attribute.name.size()};
  }

  // Warns of an attribute that is not read, when it may be a misspelt one of `optional`, or always when `known` are all
  // attributes of such an element.
  void check_attributes(const Element& element, const Names& optional, const Names& known, bool is_all) {
    for (const Attribute& attribute : element.attributes) {
      const bool is_known =
          std::any_of(known.begin(), known.end(), [&](const char* name) { return attribute.name == name; });
      const std::string hint = suggestion(attribute.name, element.attributes, optional, known);
      if (is_known || (hint.empty() && !is_all)) continue;
      diagnostics_
          .warning(
              "unknown-attribute", place(name_span(attribute)),
              fmt::format("attribute '{}' of this '{}' is unknown and ignored", attribute.name, element.name))
          .hint = hint;
    }
  }

  // Counts an element that is not read, or warns of it when it is a misspelt one of `names`. A misspelt element that
  // must be there is reported as missing.
  void ignore(const Element& child, const Element& parent, const Names& names) {
    const std::string hint = suggestion(child.name, parent.children, names, names);
    if (!hint.empty() && hint == did_you_mean(child.name, {"parent", "child", "mass"})) return;
    if (hint.empty()) {
      ++ignored_[child.name];
      return;
    }
    diagnostics_
        .warning(
            "unknown-element", place(child.span),
            fmt::format("element '{}' of this '{}' is unknown and ignored", child.name, parent.name))
        .hint = hint;
  }

  Name name(const Element& element, const char* attribute) {
    const Attribute* found = require(element, attribute);
    if (found == nullptr) return {"", place(element.span)};
    if (found->value.empty())
      diagnostics_.error(
          "missing-attribute", place(found->span), fmt::format("the name of this '{}' is empty", element.name));
    return {found->value, place(found->span)};
  }

  // The elements of these names, each at most once. Other elements are ignored.
  std::map<std::string, const Element*> parts(const Element& element, const Names& names) {
    std::map<std::string, const Element*> found;
    for (const Element& child : element.children) {
      if (std::find(names.begin(), names.end(), child.name) == names.end()) {
        ignore(child, element, names);
      } else if (const auto [first, is_new] = found.insert({child.name, &child}); !is_new) {
        diagnostics_
            .warning(
                "repeated-element", place(child.span),
                fmt::format("this '{}' has a second '{}', which is ignored", element.name, child.name))
            .notes.push_back({place(first->second->span), "the first one is here"});
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
    report_missing_element(element, part, fmt::format("this '{}' has no element '{}'", element.name, part));
    return nullptr;
  }

  // At the element that is probably a misspelt `part`, else at the owner.
  Diagnostic& report_missing_element(const Element& owner, const char* part, const std::string& message) {
    Diagnostic& error = diagnostics_.error("missing-element", place(owner.span), message);
    for (const Element& child : owner.children) {
      if (did_you_mean(child.name, {part}).empty()) continue;
      error.place.span = child.span;
      error.hint = fmt::format("did you mean '{}'?", part);
      break;
    }
    return error;
  }

  // Words between blanks. Each has its own place, unless the value has entities.
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

  Number number(const Word& word, Range range) {
    const Number parsed = Number::parse(word.text).value_or(Number());
    const double magnitude = std::abs(parsed.value());
    if (magnitude >= kTooLarge && range == Range::of_a_robot) {
      diagnostics_.error(
          "too-large", place(word.span),
          fmt::format(
              "{} is too large: a quantity of a robot is below {} in SI units", word.text, print_double(kTooLarge)));
    }
    return magnitude < kZero ? Number() : parsed;
  }

  void report_not_a_number(const Word& word) {
    constexpr std::size_t kMaxShown = 40;
    const std::string& text = word.text;
    const std::string shown = text.size() > kMaxShown ? text.substr(0, kMaxShown) + "…" : text;
    Diagnostic& error =
        diagnostics_.error("not-a-number", place(word.span), fmt::format("'{}' is not a finite decimal number", shown));
    const std::size_t number_end = text.find_first_not_of("+-.0123456789");
    if (text.find(',') != std::string::npos) {
      error.hint = "write a decimal point as '.', and separate numbers by blanks";
    } else if (text.find_first_of("*/()") != std::string::npos || text == "pi" || text == "PI") {
      error.hint = "a URDF holds numbers; xacro evaluates expressions";
    } else if (
        number_end != 0 && number_end < text.size() && std::isalpha(static_cast<unsigned char>(text[number_end])) &&
        std::all_of(text.begin() + static_cast<std::ptrdiff_t>(number_end), text.end(), [](unsigned char c) {
          return std::isalpha(c) != 0;
        })) {
      error.hint = "write numbers without units; they are in SI units and radians";
    }
  }

  // One error at most about the words: the first one that is not a number may be why their count is wrong.
  std::vector<Number> numbers(const Attribute& attribute, std::size_t count, Range range = Range::of_a_robot) {
    std::vector<Number> result(count);
    const std::vector<Word> all = words(attribute);
    const auto bad =
        std::find_if(all.begin(), all.end(), [](const Word& word) { return !Number::parse(word.text).has_value(); });
    if (bad != all.end()) {
      report_not_a_number(*bad);
    } else if (all.size() != count) {
      const bool has_too_many = all.size() > count;
      const Span span = has_too_many ? Span{all[count].span.begin, all.back().span.end} : attribute.span;
      diagnostics_.error(
          "component-count", place(span),
          fmt::format(
              "'{}' needs {} number{}, found {}", attribute.name, count, count == 1 ? "" : "s",
              all.empty() ? "none" : std::to_string(all.size())));
    } else {
      for (std::size_t i = 0; i < count; ++i) result[i] = number(all[i], range);
    }
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
    check_attributes(element, {"xyz", "rpy"}, {"xyz", "rpy", "quat_xyzw"}, true);
    if (const Attribute* xyz = find(element, "xyz")) result.xyz = triple(*xyz);
    if (const Attribute* rpy = find(element, "rpy")) {
      result.rpy = triple(*rpy);
      const std::vector<Word> all = words(*rpy);
      for (std::size_t i = 0; i < 3 && i < all.size(); ++i) result.rpy_places[i] = place(all[i].span);
    }
    if (const Attribute* quaternion = find(element, "quat_xyzw")) {
      diagnostics_.error(
          "unsupported-quaternion", place(quaternion->span), "rotations as quaternions are not supported: write 'rpy'");
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
      fmt::format("this XML is not a URDF: its root element is '{}', not 'robot'", root.name));
  return {};
}

}  // namespace robcogen::import::from_urdf
