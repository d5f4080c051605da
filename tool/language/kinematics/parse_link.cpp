#include "language/kinematics/parse_link.h"

#include <array>
#include <utility>

#include "language/kinematics/parse_part.h"

namespace robcogen::language::kinematics {
namespace {

const WordList kLinkItems = {"id", "inertia_params", "inertia_properties", "children", "frames"};
const WordList kLinkNeeds = {"id", "children"};
const WordList kLinkNeedsInPart = {"children"};
const WordList kBaseItems = {"inertia_params", "inertia_properties", "children", "frames"};
const WordList kInertiaItems = {"mass", "CoM", "Ix", "Iy", "Iz", "Ixy", "Ixz", "Iyz", "ref_frame"};
const WordList kInertiaNeeds = {"mass", "CoM", "Ix", "Iy", "Iz", "Ixy", "Ixz", "Iyz"};

class LinkParser {
 public:
  LinkParser(BlockParser& parser, Body& body, const Part* part)
      : parser_(parser), cursor_(parser.cursor()), body_(body), part_(part) {}

  void run() {
    Link link;
    const Token keyword = cursor_.take();
    link.is_base = keyword.text == "RobotBase";
    if (link.is_base && part_ != nullptr)
      cursor_.error_at(keyword.span, "base-in-part", fmt::format("part '{}' cannot have a base", part_->name.text))
          .hint =
          "a part is attached to a link: write 'root LINK via JOINT' for its first link and the joint that carries it";
    link.name = parser_.name(link.is_base ? "the name of the base" : "the name of a link");
    const std::string owner = fmt::format("{} '{}'", link.is_base ? "base" : "link", link.name.text);
    link.floating = link.is_base && cursor_.accept("floating");
    if (link.is_base && !link.floating && !cursor_.at("{")) cursor_.unexpected("'floating' or '{'", "after " + owner);
    Words found;
    const bool sound = parser_.block(owner, kLinkItems, [&] {
      if (cursor_.at("id")) {
        const Token id = parser_.word(found);
        if (link.is_base) cursor_.error_at(id.span, "base-with-id", "a base cannot have an 'id'");
        link.id_span = id.span;
        link.id = parser_.integer(id);
      } else if (cursor_.at_any({"inertia_params", "inertia_properties"})) {
        link.inertia = inertia(parser_.word(found), owner);
      } else if (cursor_.at("children")) {
        parser_.word(found);
        children(link);
      } else if (cursor_.at("frames")) {
        parser_.word(found);
        frames(link);
      } else {
        if (cursor_.at("ref_frame")) parser_.old_dialect("a 'ref_frame' of a link");
        parser_.unknown_item(owner, link.is_base ? kBaseItems : kLinkItems);
      }
    });
    if (sound && link.is_base) parser_.check_complete(owner, link.name.span, found, {"children"});
    if (sound && !link.is_base)
      parser_.check_complete(owner, link.name.span, found, part_ != nullptr ? kLinkNeedsInPart : kLinkNeeds);
    link.span = {keyword.span.begin, cursor_.previous().span.end};
    link.comments = cursor_.comments_before(link.span.end);
    body_.links.push_back(std::move(link));
  }

 private:
  BlockParser& parser_;
  Cursor& cursor_;
  Body& body_;
  const Part* part_;

  void children(Link& link) {
    parser_.block(
        "'children'", [&] { return (cursor_.at_name() && cursor_.at("via", 1)) || at_instance(cursor_); },
        [&] {
          if (at_instance(cursor_)) {
            link.instances.push_back(instance(parser_));
            return;
          }
          link.children.push_back(child());
        },
        kLinkItems);
  }

  Child child() {
    Child child;
    child.link = parser_.name("the name of a child link");
    std::string hint;
    if (cursor_.at_name())
      hint =
          fmt::format("write '{0} via {1}' for a link, '{0} {1}()' for a part", child.link.text, cursor_.peek().text);
    cursor_.expect("via", fmt::format("after '{}'", child.link.text), hint);
    child.joint = parser_.name("the name of a joint");
    return child;
  }

  // Parses one block, or several in a row; blocks may be empty.
  void frames(Link& link) {
    do {
      parser_.block(
          "'frames'", [&] { return cursor_.at_name() && cursor_.at("{", 1); },
          [&] {
            const Name name = parser_.name("the name of a frame");
            const auto placement = parser_.placement(fmt::format("frame '{}'", name.text), name.span);
            if (placement) link.frames.push_back({name, *placement});
          },
          kLinkItems);
    } while (cursor_.at("{"));
  }

  // Returns nullopt if an error in it was reported.
  std::optional<Inertia> inertia(const Token& keyword, const std::string& link) {
    Inertia inertia;
    const std::string owner = fmt::format("the inertia of {}", link);
    const std::array moments = {std::pair("Ix", &inertia.ix),   std::pair("Iy", &inertia.iy),
                                std::pair("Iz", &inertia.iz),   std::pair("Ixy", &inertia.ixy),
                                std::pair("Ixz", &inertia.ixz), std::pair("Iyz", &inertia.iyz)};
    Words found;
    const bool sound = parser_.block(
        owner, kInertiaItems,
        [&] {
          const Token key = cursor_.peek();
          if (cursor_.at_any({"moments", "products"})) parser_.old_dialect(fmt::format("'{}'", key.text));
          if (!cursor_.at_any(kInertiaItems)) parser_.unknown_item(owner, kInertiaItems);
          parser_.word(found);
          parser_.equals(key);
          if (key.text == "ref_frame") {
            inertia.reference = parser_.name("the name of a frame");
          } else if (key.text == "CoM") {
            inertia.com = parser_.vector(key);
          } else if (key.text == "mass") {
            inertia.mass = parser_.scalar();
          } else {
            for (const auto& [moment, value] : moments)
              if (key.text == moment) *value = parser_.scalar();
          }
        },
        kLinkItems);
    inertia.span = {keyword.span.begin, cursor_.previous().span.end};
    if (!sound || !parser_.check_complete(owner, keyword.span, found, kInertiaNeeds)) return std::nullopt;
    return inertia;
  }
};

}  // namespace

void link(BlockParser& parser, Body& body, const Part* part) {
  LinkParser(parser, body, part).run();
}

}  // namespace robcogen::language::kinematics
