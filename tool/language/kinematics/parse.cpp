#include <fmt/format.h>

#include <algorithm>
#include <climits>

#include "language/common/parser.h"
#include "language/kinematics/document.h"
#include "language/kinematics/keywords.h"

namespace robcogen::language::kinematics {
namespace {

class Parser {
 public:
  Parser(std::shared_ptr<const Source> source, Diagnostics& diagnostics)
      : source_(std::move(source)), cursor_(tokenize(source_, diagnostics), keywords(), diagnostics) {
    document_.source = source_;
  }

  Document run() {
    try {
      document_.comments = comments();
      if (cursor_.at_end()) {
        cursor_.error("empty-document", "the document is empty; expected 'Robot <name> { … }'");
        return std::move(document_);
      }
      cursor_.expect("Robot", "at the beginning of a robot document");
      document_.robot = name("the name of the robot");
      cursor_.expect("{", "after the name of the robot");
      elements();
      if (!cursor_.accept("}")) cursor_.unexpected("'}'", "at the end of the robot");
      document_.trailing_comments = cursor_.comments_before(source_->text().size() + 1);
      if (!cursor_.at_end())
        cursor_.error("text-after-end", fmt::format("{} stands after the end of the robot", describe(cursor_.peek())));
      check_base();
    } catch (const SyntaxError&) {
      // reported; nothing further can be made of the file
    }
    return std::move(document_);
  }

 private:
  std::shared_ptr<const Source> source_;
  Cursor cursor_;
  Document document_;

  std::vector<std::string> comments() { return cursor_.comments_before(cursor_.peek().span.begin); }

  Name name(std::string_view what) {
    const Token token = cursor_.expect_name(what);
    return {token.text, token.span};
  }

  void elements() {
    while (!cursor_.at_end() && !cursor_.at("}")) {
      if (cursor_.at_any({"RobotBase", "link"})) {
        element([&] { link(); });
      } else if (cursor_.at_any({"r_joint", "p_joint"})) {
        element([&] { joint(); });
      } else {
        unknown_element();
      }
    }
  }

  // After a fault inside an element, parsing goes on at the next element, wherever the braces are.
  template <class F>
  void element(F parse) {
    try {
      parse();
    } catch (const SyntaxError&) {
      while (!cursor_.at_end() && !starts_element()) cursor_.take();
      if (cursor_.at_end()) throw;
    }
  }

  bool starts_element() const {
    const bool keyword = cursor_.at_any({"RobotBase", "link", "r_joint", "p_joint"});
    return keyword && cursor_.peek(1).kind == Token::Kind::identifier;
  }

  void unknown_element() {
    Diagnostic& d = cursor_.error(
        "unknown-element",
        fmt::format("expected RobotBase, link, r_joint or p_joint, found {}", describe(cursor_.peek())));
    if (cursor_.peek().kind == Token::Kind::identifier)
      d.hint = did_you_mean(cursor_.peek().text, {"RobotBase", "link", "r_joint", "p_joint"});
    while (!cursor_.at_end() && !cursor_.at("{") && !cursor_.at("}") && !starts_element()) cursor_.take();
    if (!cursor_.accept("{")) return;
    cursor_.skip_to({});
    if (!cursor_.accept("}")) throw SyntaxError{};
  }

  // -------------------------------------------------------------------------------------------------------------------
  void link() {
    Link link;
    link.comments = comments();
    const Token keyword = cursor_.take();
    link.is_base = keyword.text == "RobotBase";
    link.name = name(link.is_base ? "the name of the base" : "the name of a link");
    if (link.is_base) link.floating = cursor_.accept("floating");
    cursor_.expect("{", fmt::format("after the name of '{}'", link.name.text));
    bool has_children = false;
    std::optional<Span> frames;
    while (!cursor_.at("}")) {
      if (cursor_.at("id")) {
        id(link, keyword);
      } else if (cursor_.at_any({"inertia_params", "inertia_properties"})) {
        const Token word = cursor_.peek();
        Inertia inertia = this->inertia();
        if (link.inertia) duplicate(word.span, "inertia", link.inertia->span);
        link.inertia = std::move(inertia);
      } else if (cursor_.at("children")) {
        if (has_children) cursor_.error("duplicate-section", "a second 'children' in one link");
        has_children = true;
        children(link);
      } else if (cursor_.at("frames")) {
        this->frames(link);
      } else {
        section_fault(link);
      }
    }
    if (!has_children)
      cursor_.error(
          "missing-children",
          fmt::format("'{}' has no 'children' section; write 'children {{}}' when it has none", link.name.text));
    if (!link.is_base && !link.id)
      cursor_.error_at(link.name.span, "missing-id", fmt::format("link '{}' has no 'id'", link.name.text));
    link.span = {keyword.span.begin, cursor_.take().span.end};
    document_.links.push_back(std::move(link));
  }

  [[noreturn]] void section_fault(const Link& link) {
    if (cursor_.at("ref_frame")) old_dialect("a link-level 'ref_frame'");
    const Token& token = cursor_.peek();
    Diagnostic& d = cursor_.error(
        "unknown-section", fmt::format(
                               "expected {}inertia_params, children, frames or '}}' in '{}', found {}",
                               link.is_base ? "" : "id, ", link.name.text, describe(token)));
    if (token.kind == Token::Kind::identifier)
      d.hint = did_you_mean(token.text, {"id", "inertia_params", "inertia_properties", "children", "frames"});
    throw SyntaxError{};
  }

  [[noreturn]] void old_dialect(std::string_view sign) {
    cursor_.error("old-dialect", fmt::format("{} belongs to the dialect of 2011-2012, which is not supported", sign))
        .hint = "write 'translation = (x, y, z)', 'inertia_params { mass = … CoM = (…) Ix=… }'";
    throw SyntaxError{};
  }

  void duplicate(Span span, std::string_view what, Span first) {
    cursor_.error_at(span, "duplicate-section", fmt::format("a second '{}'", what))
        .notes.push_back({cursor_.place(first), "first one here"});
  }

  void id(Link& link, const Token& keyword) {
    const Token word = cursor_.take();
    if (keyword.text == "RobotBase") {
      cursor_.error_at(word.span, "base-with-id", "the base has no 'id'");
    } else if (link.id) {
      duplicate(word.span, "id", link.id_span);
    }
    link.id_span = word.span;
    link.id = integer();
  }

  int integer() {
    cursor_.expect("=", "after 'id'");
    const Token token = cursor_.peek();
    if (token.kind != Token::Kind::number) cursor_.unexpected("an integer", "as id");
    cursor_.take();
    const double value = token.number.value();
    if (token.text.find_first_not_of("0123456789") != std::string::npos || value > INT_MAX) {
      cursor_.error_at(token.span, "bad-id", fmt::format("'{}' is no id: expected an integer", token.text));
      return 0;
    }
    return static_cast<int>(value);
  }

  void children(Link& link) {
    cursor_.take();
    cursor_.expect("{", "after 'children'");
    while (!cursor_.at("}")) {
      Child child;
      child.link = name("the name of a child link");
      cursor_.expect("via", fmt::format("after child '{}'", child.link.text));
      child.joint = name("the name of a joint");
      link.children.push_back(std::move(child));
    }
    cursor_.take();
  }

  void frames(Link& link) {
    cursor_.take();
    if (!cursor_.at("{")) cursor_.unexpected("'{'", "after 'frames'");
    while (cursor_.accept("{")) {
      if (cursor_.at("}")) cursor_.error("empty-frames", "a 'frames' section without frames");
      while (!cursor_.at("}")) {
        Frame frame;
        frame.name = name("the name of a frame");
        frame.placement = placement(fmt::format("frame '{}'", frame.name.text));
        link.frames.push_back(std::move(frame));
      }
      cursor_.take();
    }
  }

  // `{ translation = (…) rotation = (…) }`
  Placement placement(const std::string& owner) {
    Placement placement;
    placement.span.begin = cursor_.expect("{", fmt::format("after {}", owner)).span.begin;
    for (const auto& [word, vector] :
         {std::pair("translation", &placement.translation), std::pair("rotation", &placement.rotation)}) {
      if (!cursor_.at(word)) cursor_.unexpected(fmt::format("'{}'", word), fmt::format("in {}", owner));
      cursor_.take();
      *vector = this->vector(word);
    }
    placement.span.end = cursor_.expect("}", fmt::format("after the rotation of {}", owner)).span.end;
    return placement;
  }

  void equals(std::string_view word) {
    if (cursor_.at(":")) old_dialect(fmt::format("'{} :'", word));
    cursor_.expect("=", fmt::format("after '{}'", word));
  }

  Vector vector(std::string_view word) {
    equals(word);
    Vector v;
    cursor_.expect("(", fmt::format("before the three components of '{}'", word));
    for (std::size_t i = 0; i < 3; ++i) {
      if (i > 0) cursor_.expect(",", fmt::format("between the three components of '{}'", word));
      v[i] = cursor_.expression();
    }
    if (cursor_.at(",")) {
      cursor_.error(
          "too-many-components", fmt::format("'{}' has three components; a decimal comma is not allowed", word));
      throw SyntaxError{};
    }
    cursor_.expect(")", fmt::format("after the three components of '{}'", word));
    return v;
  }

  Inertia inertia() {
    Inertia inertia;
    const Token word = cursor_.take();
    cursor_.expect("{", fmt::format("after '{}'", word.text));
    struct Moment {
      const char* word;
      ExpressionPtr* value;
    };
    const std::array<Moment, 6> moments = {Moment{"Ix", &inertia.ix},   Moment{"Iy", &inertia.iy},
                                           Moment{"Iz", &inertia.iz},   Moment{"Ixy", &inertia.ixy},
                                           Moment{"Ixz", &inertia.ixz}, Moment{"Iyz", &inertia.iyz}};
    bool has_com = false;
    while (!cursor_.at("}")) {
      const Token key = cursor_.peek();
      if (cursor_.accept("mass")) {
        if (inertia.mass) duplicate(key.span, "mass", inertia.mass->span);
        equals("mass");
        inertia.mass = cursor_.expression();
      } else if (cursor_.accept("CoM")) {
        if (has_com) duplicate(key.span, "CoM", inertia.com[0]->span);
        inertia.com = vector("CoM");
        has_com = true;
      } else if (cursor_.accept("ref_frame")) {
        equals("ref_frame");
        if (inertia.reference) duplicate(key.span, "ref_frame", inertia.reference->span);
        inertia.reference = name("the name of a frame");
      } else {
        ExpressionPtr* value = nullptr;
        for (const Moment& moment : moments)
          if (cursor_.at(moment.word)) value = moment.value;
        if (!value) inertia_fault();
        cursor_.take();
        if (*value) duplicate(key.span, key.text, (*value)->span);
        equals(key.text);
        *value = cursor_.expression();
      }
    }
    inertia.span = {word.span.begin, cursor_.take().span.end};
    std::string missing;
    const auto miss = [&](const char* what) { missing += fmt::format("{}{}", missing.empty() ? "" : ", ", what); };
    if (!inertia.mass) miss("mass");
    if (!has_com) miss("CoM");
    for (const Moment& moment : moments)
      if (!*moment.value) miss(moment.word);
    if (!missing.empty()) {
      cursor_.error_at(word.span, "incomplete-inertia", fmt::format("the inertia lacks {}", missing));
      throw SyntaxError{};
    }
    return inertia;
  }

  [[noreturn]] void inertia_fault() {
    const Token& token = cursor_.peek();
    if (token.text == "moments" || token.text == "products") old_dialect(fmt::format("'{}'", token.text));
    Diagnostic& d = cursor_.error(
        "unknown-inertia-item",
        fmt::format("expected mass, CoM, Ix, Iy, Iz, Ixy, Ixz, Iyz, ref_frame or '}}', found {}", describe(token)));
    if (token.kind == Token::Kind::identifier)
      d.hint = did_you_mean(token.text, {"mass", "CoM", "Ix", "Iy", "Iz", "Ixy", "Ixz", "Iyz", "ref_frame"});
    throw SyntaxError{};
  }

  // -------------------------------------------------------------------------------------------------------------------
  void joint() {
    Joint joint;
    joint.comments = comments();
    const Token keyword = cursor_.take();
    joint.type = keyword.text == "r_joint" ? Joint::Type::revolute : Joint::Type::prismatic;
    joint.name = name("the name of a joint");
    cursor_.expect("{", fmt::format("after the name of joint '{}'", joint.name.text));
    if (cursor_.accept("id")) joint.id = integer();
    if (cursor_.at("translation")) old_dialect("a placement without 'ref_frame'");
    cursor_.expect("ref_frame", fmt::format("in joint '{}'", joint.name.text));
    joint.placement = placement(fmt::format("'ref_frame' of joint '{}'", joint.name.text));
    joint.span = {
        keyword.span.begin, cursor_.expect("}", fmt::format("at the end of joint '{}'", joint.name.text)).span.end};
    document_.joints.push_back(std::move(joint));
  }

  void check_base() {
    const Link* first = nullptr;
    for (const Link& link : document_.links) {
      if (!link.is_base) continue;
      if (first)
        cursor_.error_at(link.name.span, "two-bases", fmt::format("a second base '{}'", link.name.text))
            .notes.push_back({cursor_.place(first->name.span), "first one here"});
      else
        first = &link;
    }
    std::stable_partition(
        document_.links.begin(), document_.links.end(), [](const Link& link) { return link.is_base; });
    if (!first)
      cursor_.error_at(
          document_.robot.span, "no-base", fmt::format("robot '{}' has no RobotBase", document_.robot.text));
  }
};

}  // namespace

Document parse(std::shared_ptr<const Source> source, Diagnostics& diagnostics) {
  return Parser(std::move(source), diagnostics).run();
}

}  // namespace robcogen::language::kinematics
