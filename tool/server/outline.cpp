// The outline of a document, and its foldable ranges. The outline of a robot is its kinematic tree.
#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <iterator>
#include <map>

#include "server/features.h"
#include "server/lookup.h"

namespace robcogen::server {
namespace {

namespace kinematics = language::kinematics;

// Symbol kinds of the protocol.
constexpr int kModule = 2, kNamespace = 3, kClass = 5, kMethod = 6, kProperty = 7, kObject = 19, kKey = 20;

constexpr int kMaxDepth = 200;  // of links, nested

class Outline {
 public:
  Outline(const Parsed& document, const Positions& positions) : document_(document), positions_(positions) {}

  Json robot(const kinematics::Document& robot) {
    Json list = Json::array();
    for (const kinematics::Part& part : robot.parts)
      list.push_back(symbol(part.name, kModule, "part", block(part.name.span), roots(part)));
    if (!robot.has_robot()) return list;
    Json links = Json::array();
    if (!robot.links.empty()) links.push_back(link(robot, robot.links.front(), nullptr));
    add_rest(robot, links);
    add_loops(robot, links);
    list.push_back(symbol(robot.robot, kModule, "robot", block(robot.robot.span), std::move(links)));
    return list;
  }

  template <class Name>
  Json symbol(const Name& name, int kind, const std::string& detail, const Span& whole, Json children = Json::array())
      const {
    Json result = {
        {"name", name.text.empty() ? "?" : name.text},
        {"kind", kind},
        {"detail", detail},
        {"range", positions_.json(Span{std::min(whole.begin, name.span.begin), std::max(whole.end, name.span.end)})},
        {"selectionRange", positions_.json(name.span)}};
    if (!children.empty()) result["children"] = std::move(children);
    return result;
  }

 private:
  const Parsed& document_;
  const Positions& positions_;
  std::set<std::string> seen_;  // links that are in the outline already: an invalid document may contain cycles

  // Returns the span from the word that begins the element to its closing brace.
  Span block(const Span& name) const {
    const auto& tokens = document_.tokens.tokens;
    auto token = std::lower_bound(
        tokens.begin(), tokens.end(), name.begin, [](const auto& t, std::size_t at) { return t.span.begin < at; });
    const std::size_t begin = token == tokens.begin() ? name.begin : std::prev(token)->span.begin;
    int open = 0;
    for (; token != tokens.end(); ++token) {
      if (token->kind != language::Token::Kind::symbol) continue;
      if (token->text == "{") ++open;
      if (token->text == "}" && --open <= 0) return {begin, token->span.end};
    }
    return {begin, name.end};
  }

  Json roots(const kinematics::Part& part) {
    seen_.clear();
    Json links = Json::array();
    for (const kinematics::Child& root : part.roots)
      for (const kinematics::Link& link : part.links)
        if (link.name.text == root.link.text && !seen_.contains(link.name.text))
          links.push_back(this->link(part, link, &root.joint));
    add_rest(part, links);
    add_loops(part, links);
    seen_.clear();
    return links;
  }

  // Adds links that the tree does not reach, as happens while a document is being written.
  void add_rest(const kinematics::Body& body, Json& links) {
    for (const kinematics::Link& link : body.links)
      if (!seen_.contains(link.name.text)) links.push_back(this->link(body, link, nullptr));
  }

  void add_loops(const kinematics::Body& body, Json& list) const {
    for (const kinematics::LoopJoint& loop : body.loop_joints)
      list.push_back(symbol(
          loop.name, kMethod, fmt::format("loop of {} and {}", loop.frames[0].text, loop.frames[1].text),
          loop.name.span));
  }

  // Links nested too deeply are listed next to the tree.
  Json link(const kinematics::Body& body, const kinematics::Link& link, const kinematics::Name* joint, int depth = 0) {
    seen_.insert(link.name.text);
    Json children = Json::array();
    for (const kinematics::Frame& frame : link.frames)
      children.push_back(symbol(frame.name, kProperty, "frame", frame.name.span));
    for (const kinematics::Instance& instance : link.instances)
      children.push_back(symbol(instance.name, kObject, "part " + instance.part.text, instance.part.span));
    for (const kinematics::Child& child : link.children) {
      const auto found = std::find_if(body.links.begin(), body.links.end(), [&](const kinematics::Link& other) {
        return other.name.text == child.link.text;
      });
      if (found != body.links.end() && !seen_.contains(child.link.text) && depth < kMaxDepth)
        children.push_back(this->link(body, *found, &child.joint, depth + 1));
    }
    const std::string detail = joint != nullptr ? "via " + joint->text : link.is_base ? "base" : "link";
    return symbol(link.name, kClass, detail, block(link.name.span), std::move(children));
  }
};

// The outline of a URDF: the links that no joint moves, and the trees that they carry.
class UrdfOutline {
 public:
  UrdfOutline(const UrdfNames& urdf, const Outline& outline) : urdf_(urdf), outline_(outline) {
    for (const UrdfLink& link : urdf.links) links_.insert({link.name.text, &link});
    for (const UrdfJoint& joint : urdf.joints) {
      joints_[joint.parent.text].push_back(&joint);
      moved_.insert(joint.child.text);
    }
  }

  Json run() {
    Json links = Json::array();
    for (const bool is_moved : {false, true})
      for (const UrdfLink& link : urdf_.links)
        if (moved_.contains(link.name.text) == is_moved && !seen_.contains(link.name.text))
          links.push_back(this->link(link, "base"));
    Span whole = urdf_.robot.span;
    for (const UrdfLink& link : urdf_.links) whole.end = std::max(whole.end, link.element.end);
    for (const UrdfJoint& joint : urdf_.joints) whole.end = std::max(whole.end, joint.element.end);
    return Json::array({outline_.symbol(urdf_.robot, kModule, "robot", whole, std::move(links))});
  }

 private:
  const UrdfNames& urdf_;
  const Outline& outline_;
  std::map<std::string_view, const UrdfLink*> links_;
  std::map<std::string_view, std::vector<const UrdfJoint*>> joints_;  // by parent
  std::set<std::string_view> moved_, seen_;

  Json link(const UrdfLink& link, const std::string& detail, int depth = 0) {
    seen_.insert(link.name.text);
    Json children = Json::array();
    for (const UrdfJoint* joint : joints_[link.name.text]) {
      const auto child = links_.find(joint->child.text);
      if (child != links_.end() && !seen_.contains(joint->child.text) && depth < kMaxDepth)
        children.push_back(this->link(*child->second, "via " + joint->name.text, depth + 1));
    }
    return outline_.symbol(link.name, kClass, detail, link.element, std::move(children));
  }
};

Json of_frames(const Lookup& lookup, const Outline& outline) {
  Json list = Json::array();
  for (const Occurrence& o : lookup.occurrences) {
    const bool is_shown = o.is_declaration && o.symbol.kind != NameKind::constant;
    const int kind = o.symbol.kind == NameKind::frame       ? kProperty
                     : o.symbol.kind == NameKind::transform ? kMethod
                                                            : kKey;
    if (is_shown)
      list.push_back(outline.symbol(language::Name{o.symbol.name, o.span}, kind, describe(o.symbol.kind), o.span));
  }
  return list;
}

Json of_list(const language::desired::Document& list, const Outline& outline) {
  Json result = Json::array();
  using language::desired::Name;
  const auto text = [](const Name& name) { return (name.instance.empty() ? "" : name.instance + ".") + name.text; };
  const auto pairs = [&](const std::vector<language::desired::Pair>& of, const char* link, const char* detail) {
    for (const language::desired::Pair& pair : of)
      result.push_back(outline.symbol(
          Name{fmt::format("{}{}{}", text(pair.left), link, text(pair.right)), pair.span}, kMethod, detail, pair.span));
  };
  result.push_back(outline.symbol(list.robot, kModule, "robot", list.robot.span));
  pairs(list.transforms, "_X_", "transform");
  pairs(list.jacobians, "_J_", "Jacobian");
  for (const auto& inverse : list.inverses) pairs({inverse.pair}, "_X_", "inverse kinematics");
  for (const auto& contact : list.contacts)
    result.push_back(
        outline.symbol(Name{text(contact.frame), contact.frame.span}, kNamespace, "contact", contact.frame.span));
  for (const auto& function : list.functions)
    result.push_back(outline.symbol(function.name, kMethod, "function", function.name.span));
  return result;
}

}  // namespace

Json document_symbols(Workspace& workspace, const Json& parameters) {
  Lookup lookup(workspace, parameters);
  if (lookup.document == nullptr) return Json::array();
  Outline outline(*lookup.document, lookup.here());
  if (lookup.document->robot() != nullptr) return outline.robot(*lookup.document->robot());
  if (lookup.document->urdf() != nullptr) return UrdfOutline(*lookup.document->urdf(), outline).run();
  if (lookup.document->desired() != nullptr) return of_list(*lookup.document->desired(), outline);
  return of_frames(lookup, outline);
}

Json folding_ranges(Workspace& workspace, const Json& parameters) {
  Lookup lookup(workspace, parameters);
  Json result = Json::array();
  if (lookup.document == nullptr) return result;
  const auto add = [&](std::size_t begin, std::size_t end, std::size_t lines_kept, const char* kind) {
    const std::size_t first = lookup.here().position(begin).line, last = lookup.here().position(end).line;
    if (last < first + lines_kept + 1) return;
    Json range = {{"startLine", first}, {"endLine", last - lines_kept}};
    if (kind != nullptr) range["kind"] = kind;
    result.push_back(std::move(range));
  };
  std::vector<std::size_t> open;
  for (const language::Token& token : lookup.document->tokens.tokens) {
    if (token.kind != language::Token::Kind::symbol) continue;
    if (token.text == "{") open.push_back(token.span.begin);
    if (token.text != "}" || open.empty()) continue;
    add(open.back(), token.span.begin, 1, nullptr);  // the line of the closing brace stays
    open.pop_back();
  }
  for (const language::Comment& comment : lookup.document->tokens.comments)
    if (comment.text.starts_with("/*")) add(comment.span.begin, comment.span.end, 0, "comment");
  return result;
}

}  // namespace robcogen::server
