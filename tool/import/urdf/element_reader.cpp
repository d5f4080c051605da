#include "import/urdf/element_reader.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cctype>
#include <cmath>

#include "import/magnitudes.h"
#include "import/urdf/elements.h"

namespace robcogen::import::from_urdf {
namespace {

constexpr const char* kForces = "its forces are not part of the dynamics";
constexpr const char* kConstraint = "the robot moves without this constraint";

// Returns what the robot lacks without an element of another program that affects kinematics or dynamics, or where a
// misplaced element of URDF belongs; empty for all other elements.
std::string mechanical_meaning(const std::string& element) {
  static const std::map<std::string, std::string> of_programs = {
      {"drake:ball_constraint", kConstraint},
      {"drake:distance_constraint", kConstraint},
      {"drake:joint", "the robot lacks this joint"},
      {"drake:linear_bushing_rpy", kForces},
      {"drake:linear_spring_damper", kForces},
      {"drake:tendon_constraint", kConstraint},
      {"force_element", kForces},
      {"joint_properties", "'damping' and 'friction' belong in 'dynamics' of 'joint'"},
      {"loop_joint", "the loop stays open; URDF+ closes one by 'loop'"}};
  static const std::map<std::string, const char*> owners = {
      {"axis", "'joint' or 'loop'"},
      {"child", "'joint'"},
      {"coupling", "'robot'"},
      {"dynamics", "'joint'"},
      {"inertia", "'inertial'"},
      {"inertial", "'link'"},
      {"joint", "'robot'"},
      {"limit", "'joint'"},
      {"link", "'robot'"},
      {"loop", "'robot'"},
      {"mass", "'inertial'"},
      {"mimic", "'joint'"},
      {"origin", "'joint' or 'inertial'"},
      {"parent", "'joint'"}};
  if (const auto found = of_programs.find(element); found != of_programs.end()) return found->second;
  const auto owner = owners.find(element);
  return owner == owners.end() ? "" : fmt::format("it belongs in {}", owner->second);
}

// Whether elements of this name contain elements that are read.
bool has_parts(const std::string& element) {
  return element == "inertial" || element == "predecessor" || element == "successor" || element == "geometry";
}

}  // namespace

bool ElementReader::is_zero(const Attribute& attribute) {
  const std::vector<Word> all = words(attribute);
  return !all.empty() && std::all_of(all.begin(), all.end(), [](const Word& word) {
    const std::optional<Number> number = Number::parse(word.text);
    return number && number->is_zero();
  });
}

const Attribute* find(const Element& element, const char* attribute) {
  const auto found = std::find_if(
      element.attributes.begin(), element.attributes.end(), [&](const Attribute& a) { return a.name == attribute; });
  return found == element.attributes.end() ? nullptr : &*found;
}

const Names& known_attributes() {
  static const Names names = {"name", "type", "link", "joint", "value", "xyz",
                              "ixx",  "ixy",  "ixz",  "iyy",   "iyz",   "izz"};
  return names;
}

const Attribute* ElementReader::require(const Element& element, const char* attribute) {
  const Attribute* found = find(element, attribute);
  if (found == nullptr) report_missing_attributes(element, {attribute});
  return found;
}

void ElementReader::report_missing_attributes(const Element& element, const Names& missing) {
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

Span ElementReader::name_span(const Attribute& attribute) const {
  const std::string_view text = source_->text();
  const std::size_t equals = text.rfind('=', attribute.span.begin);
  const std::size_t begin = equals == std::string_view::npos ? equals : text.rfind(attribute.name, equals);
  return begin == std::string_view::npos ? attribute.span : Span{begin, begin + attribute.name.size()};
}

void ElementReader::check_attributes(const Element& element) {
  const KnownElement* known = known_element(element.name);
  if (known == nullptr) return;
  Names required, names;
  for (const std::string& name : known->required) required.push_back(name.c_str());
  for (const std::string& name : known->optional) names.push_back(name.c_str());
  for (const Attribute& attribute : element.attributes) {
    if (known->has(attribute.name) || attribute.name.starts_with("xmlns")) continue;
    if (!suggestion(attribute.name, element.attributes, required, required).empty()) continue;
    const std::string hint = suggestion(attribute.name, element.attributes, names, names);
    if (hint.empty() && is_zero(attribute)) continue;  // most likely a default
    add({name_span(attribute), "unknown-attribute",
         fmt::format("attribute '{}' of this '{}' is unknown and ignored", attribute.name, element.name), hint, 0},
        unread_);
  }
}

void ElementReader::ignore(const Element& child, const Element& parent, const Names& names) {
  const std::string hint = suggestion(child.name, parent.children, names, names);
  if (!hint.empty() && hint == did_you_mean(child.name, {"parent", "child", "mass"})) return;
  const std::string meaning = hint.empty() ? mechanical_meaning(child.name) : "";
  if (!meaning.empty()) {
    add({child.span, "mechanics-not-read",
         fmt::format("element '{}' of this '{}' is not read", child.name, parent.name), meaning, 0},
        unread_);
  } else if (is_without_effect(child.name, parent.name)) {
    ++ignored_[child.name];
    find_mechanics(child, *source_, unread_);
  } else {
    add({child.span, "unknown-element",
         fmt::format("element '{}' of this '{}' is unknown and ignored", child.name, parent.name), hint, 0},
        unread_);
  }
}

void ElementReader::report_unread() {
  std::stable_sort(
      unread_.begin(), unread_.end(), [](const Unread& a, const Unread& b) { return a.span.begin < b.span.begin; });
  for (const Unread& finding : unread_) {
    const std::string times = finding.count == 1 ? "" : fmt::format(" ({} times)", finding.count);
    diagnostics_.warning(finding.code, place(finding.span), finding.message + times).hint = finding.hint;
  }
  unread_.clear();
}

Name ElementReader::name(const Element& element, const char* attribute) {
  const Attribute* found = require(element, attribute);
  if (found == nullptr) return {"", place(element.span)};
  if (found->value.empty())
    diagnostics_.error(
        "missing-attribute", place(found->span), fmt::format("the name of this '{}' is empty", element.name));
  return {found->value, place(found->span)};
}

Parts ElementReader::parts(const Element& element, const Names& names) {
  Parts found;
  for (const Element& child : element.children) {
    if (std::find(names.begin(), names.end(), child.name) == names.end()) {
      ignore(child, element, names);
    } else if (const auto [first, is_new] = found.insert({child.name, &child}); !is_new) {
      diagnostics_
          .warning(
              "repeated-element", place(child.span),
              fmt::format("this '{}' has a second '{}', which is ignored", element.name, child.name))
          .notes.push_back({place(first->second->span), "the first one is here"});
    } else {
      check_attributes(child);
      if (!has_parts(child.name))
        for (const Element& inner : child.children) ignore(inner, child, {});
    }
  }
  return found;
}

const Element* ElementReader::require_part(const Element& element, const Parts& parts, const char* part) {
  const auto found = parts.find(part);
  if (found != parts.end()) return found->second;
  const Element* child = misspelt(element, part);
  diagnostics_
      .error(
          "missing-element", place(child == nullptr ? element.span : child->span),
          fmt::format("this '{}' has no element '{}'", element.name, part))
      .hint = child == nullptr ? "" : did_you_mean(child->name, {part});
  return nullptr;
}

const Element* ElementReader::misspelt(const Element& owner, const char* part) {
  const auto found = std::find_if(owner.children.begin(), owner.children.end(), [&](const Element& child) {
    return !did_you_mean(child.name, {part}).empty();
  });
  return found == owner.children.end() ? nullptr : &*found;
}

std::vector<ElementReader::Word> ElementReader::words(const Attribute& attribute) {
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

Number ElementReader::number(const Word& word, Range range) {
  const Number parsed = Number::parse(word.text).value_or(Number());
  const double magnitude = std::abs(parsed.value());
  if (magnitude >= kTooLarge && range == Range::of_a_robot) {
    diagnostics_.error("too-large", place(word.span), too_large(word.text));
  }
  return magnitude < kZero ? Number() : parsed;
}

void ElementReader::report_not_a_number(const Word& word) {
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

std::vector<Number> ElementReader::numbers(const Attribute& attribute, std::size_t count, Range range) {
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

std::array<Number, 3> ElementReader::triple(const Attribute& attribute) {
  const std::vector<Number> n = numbers(attribute, 3);
  return {n[0], n[1], n[2]};
}

void ElementReader::check_angle(const Number& angle, const Place& place, double turns) {
  const std::string message = large_angle(angle.value(), turns);
  if (message.empty()) return;
  diagnostics_.warning("large-angle", place, message).hint = "angles are in rad; one degree is 0.017453292519943295";
}

Number ElementReader::scalar(const Element& element, const char* attribute) {
  const Attribute* found = require(element, attribute);
  return found == nullptr ? Number() : numbers(*found, 1)[0];
}

Origin ElementReader::origin(const Parts& parts) {
  Origin result;
  const auto found = parts.find("origin");
  if (found == parts.end()) return result;
  const Element& element = *found->second;
  if (const Attribute* xyz = find(element, "xyz")) result.xyz = triple(*xyz);
  if (const Attribute* rpy = find(element, "rpy")) {
    result.rpy = triple(*rpy);
    const std::vector<Word> all = words(*rpy);
    for (std::size_t i = 0; i < 3 && i < all.size(); ++i) {
      result.rpy_places[i] = place(all[i].span);
      check_angle(result.rpy[i], result.rpy_places[i], 1.0);
    }
  }
  if (const Attribute* quaternion = find(element, "quat_xyzw")) {
    diagnostics_.error(
        "unsupported-quaternion", place(quaternion->span), "rotations as quaternions are not supported: write 'rpy'");
  }
  return result;
}

}  // namespace robcogen::import::from_urdf
