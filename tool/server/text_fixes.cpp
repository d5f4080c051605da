#include "server/text_fixes.h"

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <map>
#include <optional>
#include <utility>

#include "import/parameters.h"
#include "language/common/lexer.h"
#include "language/kinematics/document.h"
#include "support/number.h"

namespace robcogen::server {
namespace {

namespace kinematics = language::kinematics;
using language::Token;

std::string_view text_at(const Place& place) {
  return place.source->text().substr(place.span.begin, place.span.end - place.span.begin);
}

std::vector<Token> tokens_of(const std::shared_ptr<const Source>& source) {
  Diagnostics ignored;
  return language::tokenize(source, ignored).tokens;
}

// Returns the text that follows the first `before`, up to the next quote.
std::string quoted(const std::string& text, std::string_view before) {
  const std::size_t begin = text.find(before);
  if (begin == std::string::npos) return "";
  const std::size_t open = begin + before.size(), close = text.find('\'', open);
  return close == std::string::npos ? "" : text.substr(open, close - open);
}

void add_spellings(const Diagnostic& d, const Place& place, std::vector<QuickFix>& fixes) {
  const auto offer = [&](const std::string& spelling) {
    if (!spelling.empty() && spelling != text_at(place))
      fixes.push_back({fmt::format("Write '{}'", spelling), {{place.span, spelling}}});
  };
  const bool is_spelt = d.code == "signed-product" || d.code == "number-runs-into-name" || d.code == "bad-number";
  if (is_spelt) offer(quoted(d.hint, "write '"));
  if (d.code == "signed-product") offer(quoted(d.hint, ", '"));
  if (d.code == "decimal-comma" && text_at(place) == ",") offer(".");
  const bool is_superfluous = text_at(place) == "," || text_at(place) == ";";
  if (is_superfluous && d.message.starts_with("unexpected "))
    fixes.push_back({fmt::format("Remove '{}'", text_at(place)), {{place.span, ""}}});
}

void add_degrees(const Place& place, std::vector<QuickFix>& fixes) {
  std::string number(text_at(place));
  if (!Number::parse(number)) return;
  if (number.find_first_of(".eE") == std::string::npos) number += ".0";
  const std::string degrees = number + " PI/180.0";
  fixes.push_back({fmt::format("Write '{}': degrees", degrees), {{place.span, degrees}}});
}

// Returns the number after the word `id` at the offset.
std::optional<Span> number_of_id(const std::vector<Token>& tokens, std::size_t offset) {
  for (std::size_t i = 0; i + 2 < tokens.size(); ++i)
    if (tokens[i].span.begin == offset && tokens[i + 2].kind == Token::Kind::number) return tokens[i + 2].span;
  return std::nullopt;
}

// Returns the links from the base outwards, in the order of the children, followed by links without a parent.
std::vector<const kinematics::Link*> from_base(const kinematics::Body& body) {
  std::map<std::string_view, const kinematics::Link*> left;
  for (const kinematics::Link& link : body.links) left.insert({link.name.text, &link});
  std::vector<const kinematics::Link*> pending, order;
  for (auto link = body.links.rbegin(); link != body.links.rend(); ++link) pending.push_back(&*link);
  while (!pending.empty()) {
    const kinematics::Link* link = pending.back();
    pending.pop_back();
    if (left.erase(link->name.text) == 0) continue;
    order.push_back(link);
    for (auto child = link->children.rbegin(); child != link->children.rend(); ++child)
      if (const auto next = left.find(child->link.text); next != left.end()) pending.push_back(next->second);
  }
  return order;
}

void add_ids(const Place& place, std::vector<QuickFix>& fixes) {
  Diagnostics ignored;
  const kinematics::Document document = kinematics::parse(place.source, ignored);
  const std::vector<Token> tokens = tokens_of(place.source);
  QuickFix fix = {"Renumber the links, parents first", {}};
  int next = 1;
  for (const kinematics::Link* link : from_base(document)) {
    if (link->is_base || !link->id) continue;
    const std::optional<Span> number = number_of_id(tokens, link->id_span.begin);
    if (number && *link->id != next) fix.changes.push_back({*number, std::to_string(next)});
    ++next;
  }
  if (!fix.changes.empty()) fixes.push_back(std::move(fix));
}

// Turns `translation : (…)  rotation : (…)` in a joint into `ref_frame { translation = (…)  rotation = (…) }`.
void add_present_dialect(const Place& place, std::vector<QuickFix>& fixes) {
  const std::vector<Token> tokens = tokens_of(place.source);
  QuickFix fix = {"Rewrite the placements in the current dialect", {}};
  std::vector<std::size_t> open;  // tokens that open the enclosing blocks
  bool is_begun = false;
  for (std::size_t i = 0; i < tokens.size(); ++i) {
    if (tokens[i].text == "{") open.push_back(i);
    if (tokens[i].text == "}" && !open.empty()) open.pop_back();
    const bool is_part = tokens[i].text == "translation" || tokens[i].text == "rotation";
    if (!is_part || i + 2 >= tokens.size()) continue;
    if (tokens[i + 1].text == ":") fix.changes.push_back({tokens[i + 1].span, "="});
    const std::size_t head = open.empty() ? 0 : open.back();
    const bool in_joint = head >= 2 && (tokens[head - 2].text == "r_joint" || tokens[head - 2].text == "p_joint");
    if (!in_joint) continue;
    const std::size_t begin = tokens[i].span.begin;
    const bool begins = tokens[i].text == "translation";
    if (begins == is_begun) return;  // not these two in this order
    if (begins) fix.changes.push_back({{begin, begin}, "ref_frame { "});
    std::size_t end = i;
    while (end < tokens.size() && tokens[end].text != ")" && tokens[end].text != "}") ++end;
    if (end >= tokens.size() || tokens[end].text == "}") return;
    const std::size_t behind = tokens[end].span.end;
    const bool goes_on = end + 1 < tokens.size() && tokens[end + 1].text == "rotation";
    if (!goes_on) fix.changes.push_back({{behind, behind}, " }"});
    is_begun = goes_on;
  }
  if (!fix.changes.empty()) fixes.push_back(std::move(fix));
}

// Returns the value of a constant expression.
class Constants {
 public:
  explicit Constants(const std::shared_ptr<const Source>& source) : reader_(source, ignored_) {}

  std::optional<double> operator()(const language::ExpressionPtr& e) {
    if (!e) return std::nullopt;
    reader_.declare_names_in(*e);
    const model::Quantity q = reader_.read(*e, model::ParameterKind::inertial);
    return q.is_constant() ? std::optional(q.number().value()) : std::nullopt;
  }

 private:
  Diagnostics ignored_;
  import::QuantityReader reader_;
};

// Computes the moments about the origin by Steiner's theorem, from moments that are about the centre of mass.
void add_moments_about_origin(const Place& place, std::vector<QuickFix>& fixes) {
  Diagnostics ignored;
  const kinematics::Document document = kinematics::parse(place.source, ignored);
  const auto is_meant = [&](const kinematics::Link& link) {
    return link.inertia && link.inertia->span.begin <= place.span.begin && place.span.begin < link.inertia->span.end;
  };
  const auto link = std::find_if(document.links.begin(), document.links.end(), is_meant);
  if (link == document.links.end()) return;
  const kinematics::Inertia& inertia = *link->inertia;
  Constants value(place.source);
  const std::optional<double> m = value(inertia.mass), x = value(inertia.com[0]), y = value(inertia.com[1]),
                              z = value(inertia.com[2]);
  if (!m || !x || !y || !z) return;
  const std::array<std::pair<const language::ExpressionPtr*, double>, 6> moments = {
      {{&inertia.ix, *y * *y + *z * *z},
       {&inertia.iy, *x * *x + *z * *z},
       {&inertia.iz, *x * *x + *y * *y},
       {&inertia.ixy, *x * *y},
       {&inertia.ixz, *x * *z},
       {&inertia.iyz, *y * *z}}};
  QuickFix fix = {"Add the mass times squared distances: these moments are about the centre of mass", {}};
  for (const auto& [moment, area] : moments) {
    const std::optional<double> given = value(*moment);
    if (!given) return;
    if (*m * area != 0.0) fix.changes.push_back({(*moment)->span, print_double(*given + *m * area)});
  }
  if (!fix.changes.empty()) fixes.push_back(std::move(fix));
}

}  // namespace

void add_text_fixes(const Diagnostic& d, const Place& place, std::vector<QuickFix>& fixes) {
  if (place.source->name().ends_with(".urdf")) return;
  add_spellings(d, place, fixes);
  if (d.code == "large-angle") add_degrees(place, fixes);
  if (d.code == "duplicate-id" || d.code == "gapped-ids" || d.code == "child-before-parent") add_ids(place, fixes);
  if (d.code == "old-dialect") add_present_dialect(place, fixes);
  if (d.hint.ends_with("are these about the centre of mass?")) add_moments_about_origin(place, fixes);
}

}  // namespace robcogen::server
