#include "import/names.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string_view>

namespace robcogen::import {

using language::Expression;

namespace {

struct Unit {
  std::string_view name;
  std::string_view instead;  // what to write
};

constexpr std::string_view kMass = "masses are in kg", kLength = "lengths are in m",
                           kDegrees = "angles are in rad, and one degree is 'PI/180.0'", kRadians = "angles are in rad",
                           kOther = "numbers are in SI units";

constexpr auto kUnits = std::to_array<Unit>(
    {{"kg", kMass},       {"g", kMass},      {"mg", kMass},      {"gram", kMass},      {"grams", kMass},
     {"lb", kMass},       {"lbs", kMass},    {"oz", kMass},      {"kgm2", kOther},     {"kgmm2", kOther},
     {"m", kLength},      {"mm", kLength},   {"cm", kLength},    {"dm", kLength},      {"km", kLength},
     {"um", kLength},     {"in", kLength},   {"inch", kLength},  {"inches", kLength},  {"ft", kLength},
     {"foot", kLength},   {"feet", kLength}, {"meter", kLength}, {"meters", kLength},  {"metre", kLength},
     {"metres", kLength}, {"rad", kRadians}, {"rads", kRadians}, {"radian", kRadians}, {"radians", kRadians},
     {"mrad", kRadians},  {"deg", kDegrees}, {"degs", kDegrees}, {"degree", kDegrees}, {"degrees", kDegrees},
     {"grad", kDegrees},  {"n", kOther},     {"nm", kOther},     {"kn", kOther},       {"nms", kOther},
     {"s", kOther},       {"sec", kOther},   {"ms", kOther},     {"hz", kOther},       {"rpm", kOther}});

// Names of PI and its multiples in other languages.
constexpr auto kPiSpellings = std::to_array<std::string_view>(
    {"m_pi", "m_pi_2", "m_pi_4", "pi_2", "pi_4", "pi2", "pi4", "twopi", "two_pi", "halfpi", "half_pi", "mpi"});

char lower(char c) {
  return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
}

std::string lower(std::string_view word) {
  std::string text(word);
  for (char& c : text) c = lower(c);
  return text;
}

bool is_letter(char c) {
  return lower(c) >= 'a' && lower(c) <= 'z';
}

const Unit* unit_of(const std::string& name) {
  const std::string wanted = lower(name);
  const auto found = std::find_if(kUnits.begin(), kUnits.end(), [&](const Unit& unit) { return unit.name == wanted; });
  return found == kUnits.end() ? nullptr : &*found;
}

bool is_spelling_of_pi(const std::string& name) {
  return std::find(kPiSpellings.begin(), kPiSpellings.end(), lower(name)) != kPiSpellings.end();
}

// The letters around [begin, end).
struct Word {
  std::size_t begin, end;
};

Word word_around(const std::string& text, std::size_t begin, std::size_t end) {
  while (begin > 0 && is_letter(text[begin - 1])) --begin;
  while (end < text.size() && is_letter(text[end])) ++end;
  return {begin, end};
}

constexpr std::size_t kMinWordLength = 4;
// Larger documents are written by programs, which do not misspell names; comparing all pairs of names would take long.
constexpr std::size_t kMaxCompared = 3000;

}  // namespace

bool differ_by_slip(const std::string& a, const std::string& b) {
  if (a.size() > b.size()) return differ_by_slip(b, a);
  if (a == b || b.size() - a.size() > 1) return false;
  std::size_t begin = 0, end = 0;  // lengths of the common beginning and end
  while (begin < a.size() && lower(a[begin]) == lower(b[begin])) ++begin;
  if (begin == b.size()) return a.size() >= kMinWordLength;  // the names differ in case only
  while (end < a.size() - begin && lower(a[a.size() - 1 - end]) == lower(b[b.size() - 1 - end])) ++end;
  const std::string_view in_a = std::string_view(a).substr(begin, a.size() - end - begin);
  const std::string_view in_b = std::string_view(b).substr(begin, b.size() - end - begin);
  if (!std::all_of(in_a.begin(), in_a.end(), is_letter) || !std::all_of(in_b.begin(), in_b.end(), is_letter))
    return false;
  const Word word = word_around(a, begin, a.size() - end);
  if (word.end - word.begin < kMinWordLength) return false;
  const bool exchanged =
      in_a.size() == 2 && in_b.size() == 2 && lower(in_a[0]) == lower(in_b[1]) && lower(in_a[1]) == lower(in_b[0]);
  if (exchanged) return true;
  if (in_b.size() != 1) return false;
  // The first or the last letter of a word may distinguish two names: `hipx` and `hipy`. A doubled letter does not.
  const bool doubled = in_a.empty() && begin > 0 && lower(b[begin - 1]) == lower(in_b[0]);
  const bool inside = begin > word.begin && a.size() - end < word.end;
  return doubled || inside;
}

void NameUses::use(const Expression& name, const std::string& what, const Place& place) {
  Name& entry = names_[name.name];
  if (entry.count++ == 0) entry.first = place;
  entry.what = what;
  entry.is_meant |= name.escaped || name.is_parameter || name.default_value.has_value() || !name.group.empty();
}

void NameUses::declare(const std::string& name, const Place& place) {
  Name& entry = names_[name];
  entry.is_meant = true;
  entry.first = place;
}

void NameUses::multiply_by_number(const Expression& product, const Place& place) {
  Name& entry = names_[product.right->name];
  ++entry.after_number;
  const Span number = product.left->span, name = product.right->span;
  if (number.end != name.begin || entry.run_in.source) return;
  const std::string_view text = place.source->text();
  entry.run_in = {place.source, {number.begin, name.end}};
  entry.number = text.substr(number.begin, number.end - number.begin);
  entry.text = text.substr(number.begin, name.end - number.begin);
}

void NameUses::report(Diagnostics& diagnostics) const {
  for (const auto& [text, name] : names_) {
    if (name.is_meant || name.count == 0) continue;
    if (!report_accident(text, name, diagnostics)) report_similar(text, name, diagnostics);
  }
}

bool NameUses::report_accident(const std::string& text, const Name& name, Diagnostics& diagnostics) const {
  const std::string otherwise = fmt::format("; write '^{}' for a {} of this name", text, name.what);
  const Unit* unit = unit_of(text);
  // A single letter counts as a unit only after a number.
  if (unit != nullptr && (text.size() > 1 || name.after_number == name.count)) {
    diagnostics.warning("unit-as-name", name.first, fmt::format("'{}' is a {} here, not a unit", text, name.what))
        .hint = fmt::format("{}{}", unit->instead, otherwise);
    return true;
  }
  if (is_spelling_of_pi(text)) {
    diagnostics
        .warning("constant-as-name", name.first, fmt::format("'{}' is a {} here, not a constant", text, name.what))
        .hint = fmt::format("the constant is 'PI'{}", otherwise);
    return true;
  }
  if (!name.run_in.source) return false;
  diagnostics
      .warning(
          "number-runs-into-name", name.run_in,
          fmt::format("'{}' is the product of {} and {} '{}'", name.text, name.number, name.what, text))
      .hint = fmt::format("write '{} {}', with a blank, for this product", name.number, text);
  return true;
}

void NameUses::report_similar(const std::string& text, const Name& name, Diagnostics& diagnostics) const {
  if (name.count > 1 || names_.size() > kMaxCompared) return;
  for (const auto& [other_text, other] : names_) {
    if (!differ_by_slip(text, other_text)) continue;
    // Of two similar names that are used once, only the later one is reported.
    const bool other_is_later = other.first.span.begin > name.first.span.begin;
    if (!other.is_meant && other.count == 1 && other_is_later) continue;
    Diagnostic& warning =
        diagnostics.warning("similar-name", name.first, fmt::format("{} '{}' is used only here", name.what, text));
    warning.hint = fmt::format("did you mean '{}'? If not, write '^{}'", other_text, text);
    warning.notes.push_back({other.first, fmt::format("'{}' is here", other_text)});
    return;
  }
}

const std::vector<std::string>& accident_codes() {
  static const std::vector<std::string> codes = {"unit-as-name", "constant-as-name", "number-runs-into-name",
                                                 "similar-name", "large-angle",      "product-after-division"};
  return codes;
}

}  // namespace robcogen::import
