#include "symbolic/quantity.h"

#include <algorithm>
#include <cstddef>
#include <initializer_list>
#include <utility>

#include "symbolic/lane_names.h"

namespace robcogen::symbolic {
namespace {

using Form = Quantity::Form;

// The parts that are not empty, with `_` between them.
std::string joined(std::initializer_list<std::string_view> parts) {
  std::string result;
  for (const std::string_view part : parts) {
    if (part.empty()) continue;
    if (!result.empty()) result += '_';
    result += part;
  }
  return result;
}

NameParts parts_of_value(const Quantity& q) {
  if (!q.of_coordinates) {
    const std::string last = joined({q.symbol + q.element, q.state});
    if (last.empty()) return {joined({q.second, q.qualifier}), q.subject};
    return {joined({q.subject, q.second, q.qualifier}), last};
  }
  if (!q.state.empty()) return {joined({q.symbol, q.subject, q.qualifier, q.second}), q.state};
  if (!q.second.empty()) return {joined({q.symbol, q.subject, q.qualifier}), q.second};
  return {q.symbol, q.subject};
}

// The two quantities, the stem that they may share named once.
NameParts parts_of_both(const Quantity& a, const std::string& word, const Quantity& b) {
  const NameParts x = parts_of(a), y = parts_of(b);
  if (x.stem == y.stem && !x.stem.empty()) return {x.stem, x.last + word + y.last};
  return {"", unsigned_text(a) + word + unsigned_text(b)};
}

NameParts with(const Quantity& q, const std::string& suffix) {
  NameParts parts = parts_of(q);
  parts.last += suffix;
  return parts;
}

// The name of an angle, in names of its sine and cosine.
std::string label(const Quantity& angle) {
  if (angle.form == Form::lane) return label(*angle.a) + "_" + std::to_string(angle.lane);
  return angle.of_coordinates && angle.symbol == "q" ? angle.subject : unsigned_text(angle);
}

std::optional<std::string> common_text(
    const std::vector<QuantityRef>& lanes,
    std::string Quantity::*member,
    bool may_differ) {
  std::vector<std::string> texts;
  for (const QuantityRef& lane : lanes) texts.push_back((*lane).*member);
  const bool are_equal =
      std::all_of(texts.begin(), texts.end(), [&](const std::string& text) { return text == texts.front(); });
  if (are_equal) return texts.front();
  return may_differ ? std::optional(common_words(texts)) : std::nullopt;
}

std::optional<Quantity> common_of_all(const std::vector<QuantityRef>& lanes) {
  const auto is_like_first = [&](const QuantityRef& q) {
    const Quantity& first = *lanes.front();
    return q->form == first.form && q->of_coordinates == first.of_coordinates && q->lane == first.lane;
  };
  if (!std::all_of(lanes.begin(), lanes.end(), is_like_first)) return std::nullopt;
  Quantity result;
  for (std::string Quantity::*member :
       {&Quantity::subject, &Quantity::symbol, &Quantity::element, &Quantity::second, &Quantity::qualifier,
        &Quantity::state}) {
    const bool may_differ = member == &Quantity::subject || member == &Quantity::second;
    const std::optional<std::string> shared = common_text(lanes, member, may_differ);
    if (!shared) return std::nullopt;
    result.*member = *shared;
  }
  result.form = lanes.front()->form;
  result.of_coordinates = lanes.front()->of_coordinates;
  result.lane = lanes.front()->lane;
  for (QuantityRef Quantity::*operand : {&Quantity::a, &Quantity::b}) {
    if (!((*lanes.front()).*operand)) continue;
    std::vector<QuantityRef> operands;
    for (const QuantityRef& lane : lanes) operands.push_back((*lane).*operand);
    std::optional<Quantity> shared = common_of_all(operands);
    if (!shared) return std::nullopt;
    result.*operand = std::make_shared<const Quantity>(*std::move(shared));
  }
  if (unsigned_text(result).empty()) return std::nullopt;
  return result;
}

}  // namespace

NameParts parts_of(const Quantity& q) {
  switch (q.form) {
    case Form::value:
      return parts_of_value(q);
    case Form::lane:
      return with(*q.a, "_" + std::to_string(q.lane));
    case Form::product:
      return parts_of_both(*q.a, "_", *q.b);
    case Form::square:
      if (is_sine(*q.a) || is_cosine(*q.a)) return {is_sine(*q.a) ? "s2" : "c2", angle_of(*q.a)};
      return with(*q.a, "2");
    case Form::sum:
      return parts_of_both(*q.a, "_plus_", *q.b);
    case Form::difference:
      return parts_of_both(*q.a, "_minus_", *q.b);
    case Form::rotated:
      return with(*q.a, "_by_" + angle_of(*q.b));
    case Form::moved:
      return with(*q.a, "_moved");
    case Form::inverse:
      return with(*q.a, "_inv");
    case Form::root:
      return with(*q.a, "_root");
    case Form::sum_of_lanes:
      return with(*q.a, "_sum");
    case Form::sine_cosine:
      return {"sc", angle_of(q)};
    case Form::sine:
    case Form::double_sine:
      return {"s", angle_of(q)};
    case Form::cosine:
    case Form::double_cosine:
      return {"c", angle_of(q)};
  }
  return {};
}

std::string unsigned_text(const Quantity& q) {
  const NameParts parts = parts_of(q);
  return joined({parts.stem, parts.last});
}

std::string text(const Quantity& q) {
  return unsigned_text(q) + (q.negative ? "_neg" : "");
}

bool is_sine(const Quantity& q) {
  return q.form == Form::sine || q.form == Form::double_sine;
}

bool is_cosine(const Quantity& q) {
  return q.form == Form::cosine || q.form == Form::double_cosine;
}

std::string angle_of(const Quantity& q) {
  if (q.form == Form::double_sine || q.form == Form::double_cosine) return "2" + label(*q.a);
  return is_sine(q) || is_cosine(q) || q.form == Form::sine_cosine ? label(*q.a) : "";
}

Quantity made(Form form, QuantityRef a, QuantityRef b) {
  Quantity result;
  result.form = form;
  result.a = std::move(a);
  result.b = std::move(b);
  return result;
}

Quantity product(Quantity a, Quantity b) {
  return made(
      Form::product, std::make_shared<const Quantity>(std::move(a)), std::make_shared<const Quantity>(std::move(b)));
}

std::optional<Quantity> common_quantity(const std::vector<QuantityRef>& lanes) {
  std::optional<Quantity> result = common_of_all(lanes);
  for (std::size_t odd = 0; !result && lanes.size() > 2 && odd < lanes.size(); ++odd) {
    std::vector<QuantityRef> others = lanes;
    others.erase(others.begin() + static_cast<std::ptrdiff_t>(odd));
    result = common_of_all(others);
  }
  const auto is_negative = [](const QuantityRef& q) { return q->negative; };
  if (result) result->negative = std::all_of(lanes.begin(), lanes.end(), is_negative);
  return result;
}

}  // namespace robcogen::symbolic
