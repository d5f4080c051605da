#include <fmt/format.h>

#include <algorithm>
#include <climits>

#include "language/common/content.h"
#include "language/common/parse_expression.h"
#include "language/kinematics/document.h"
#include "language/kinematics/keywords.h"

namespace robcogen::language::kinematics {
namespace {

using WordList = std::initializer_list<std::string_view>;

const WordList kElements = {"RobotBase", "link", "r_joint", "p_joint"};
const WordList kLinkItems = {"id", "inertia_params", "inertia_properties", "children", "frames"};
const WordList kBaseItems = {"inertia_params", "inertia_properties", "children", "frames"};
const WordList kInertiaItems = {"mass", "CoM", "Ix", "Iy", "Iz", "Ixy", "Ixz", "Iyz", "ref_frame"};
const WordList kInertiaNeeds = {"mass", "CoM", "Ix", "Iy", "Iz", "Ixy", "Ixz", "Iyz"};
const WordList kJointItems = {"id", "ref_frame"};
const WordList kPlacementItems = {"translation", "rotation"};

// The words that begin the items of one block, as found.
using Words = std::vector<Token>;

// Elements stand in the robot's block, items in theirs; the order of neither matters. An item that fails is skipped up
// to the next item of its block or its end, and when the braces do not match, up to the next element: the keyword of
// an element cannot stand anywhere else.
class Parser {
 public:
  Parser(std::shared_ptr<const Source> source, Diagnostics& diagnostics)
      : source_(std::move(source)), cursor_(tokenize_document(source_, diagnostics), keywords(), diagnostics) {
    document_.source = source_;
  }

  Document run() {
    try {
      header();
      elements();
      end();
      check_bases();
    } catch (const SyntaxError&) {
    } catch (const OtherLanguage&) {
      // reported; nothing further can be made of the file
    }
    std::stable_partition(
        document_.links.begin(), document_.links.end(), [](const Link& link) { return link.is_base; });
    return std::move(document_);
  }

 private:
  std::shared_ptr<const Source> source_;
  Cursor cursor_;
  Document document_;
  std::vector<Name> bases_;  // those that failed too
  bool base_may_be_missed_ = false;

  // -------------------------------------------------------------------------------------------------------------------
  // The robot: its header, its elements, its end.

  void header() {
    document_.comments = cursor_.comments_before(cursor_.peek().span.begin);
    try {
      cursor_.expect("Robot", "at the beginning of a robot document");
      document_.robot = name("the name of the robot");
      cursor_.expect("{", "after the name of the robot");
    } catch (const SyntaxError&) {
      base_may_be_missed_ = true;
      cursor_.skip_until([&] { return at_element(); });
      if (cursor_.at_end()) throw;
    }
  }

  void elements() {
    while (!cursor_.at("}") && !cursor_.at_end()) {
      try {
        if (cursor_.at_any({"RobotBase", "link"})) {
          link();
        } else if (cursor_.at_any({"r_joint", "p_joint"})) {
          joint();
        } else {
          unknown_element();
        }
      } catch (const SyntaxError&) {
        cursor_.skip_until([&] { return at_element(); });
        if (cursor_.at_end()) throw;
      }
    }
  }

  // A keyword alone may be a name by mistake.
  bool at_element() const { return cursor_.at_any(kElements) && cursor_.peek(1).kind == Token::Kind::identifier; }

  void unknown_element() {
    base_may_be_missed_ = true;
    const Token& token = cursor_.peek();
    Diagnostic& d = cursor_.error(
        "unknown-element", fmt::format("expected {} or '}}', found {}", fmt::join(kElements, ", "), describe(token)));
    if (token.kind == Token::Kind::identifier)
      d.hint = did_you_mean(std::string(token.text), {kElements.begin(), kElements.end()});
    cursor_.skip_until([&] { return cursor_.at("{") || cursor_.at("}") || at_element(); });
    if (!cursor_.accept("{")) return;
    const std::size_t inside = cursor_.open_blocks();
    cursor_.skip_until([&] { return at_element() || (cursor_.at("}") && cursor_.open_blocks() == inside); });
    cursor_.accept("}");
  }

  // When elements follow the brace that ends the robot, a brace before it is one too many: they are read too.
  void end() {
    if (cursor_.at_end() && cursor_.open_blocks() == 0) return;  // the header is faulty, and its brace missing
    const Token brace = cursor_.expect("}", "at the end of the robot");
    document_.trailing_comments = cursor_.comments_before(source_->text().size() + 1);
    if (cursor_.at_end()) return;
    cursor_.error("text-after-end", fmt::format("{} stands after the end of the robot", describe(cursor_.peek())))
        .notes.push_back({cursor_.place(brace.span), "the robot ends here"});
    while (at_element()) {
      elements();
      cursor_.take();
    }
  }

  void check_bases() {
    if (bases_.empty() && !base_may_be_missed_)
      cursor_.error_at(
          document_.robot.span, "no-base", fmt::format("robot '{}' has no RobotBase", document_.robot.text));
    for (std::size_t i = 1; i < bases_.size(); ++i)
      cursor_.error_at(bases_[i].span, "two-bases", fmt::format("a second base '{}'", bases_[i].text))
          .notes.push_back({cursor_.place(bases_[0].span), "first base here"});
  }

  // -------------------------------------------------------------------------------------------------------------------
  // Blocks of items.

  // `{`, items, `}`. Each begins at a token that at_item knows, or else item reports it. Tells whether all went well.
  template <class AtItem, class Item>
  bool block(const std::string& owner, AtItem at_item, Item item) {
    bool sound = true;
    const Token open = cursor_.peek();
    try {
      cursor_.expect("{", "after " + owner);
    } catch (const SyntaxError&) {
      if (!at_item()) throw;
      cursor_.assume_open_brace();
      sound = false;
    }
    const std::size_t inside = cursor_.open_blocks();
    while (!cursor_.at("}")) {
      try {
        if (cursor_.at_end()) cursor_.unexpected("'}'", "");
        if (at_element()) missing_brace(owner, open);
        item();
      } catch (const SyntaxError&) {
        sound = false;
        cursor_.skip_until([&] {
          const bool here = cursor_.open_blocks() == inside && (cursor_.at("}") || at_item());
          return here || cursor_.open_blocks() < inside || at_element();
        });
        if (cursor_.at_end() || cursor_.open_blocks() < inside || at_element()) throw;
      }
    }
    cursor_.take();
    return sound;
  }

  template <class Item>
  bool block(const std::string& owner, WordList words, Item item) {
    return block(
        owner, [&] { return cursor_.at_any(words); }, item);
  }

  [[noreturn]] void missing_brace(const std::string& owner, const Token& open) {
    cursor_.error("missing-brace", fmt::format("the '}}' of {} is missing before this", owner))
        .notes.push_back({cursor_.place(open.span), "opened here"});
    throw SyntaxError{};
  }

  // Takes the word that begins an item; items of one name stand once in a block.
  Token word(Words& found) {
    const Token token = cursor_.take();
    const auto is_inertia = [](const Token& t) { return t.text.starts_with("inertia_"); };
    for (const Token& earlier : found) {
      if (earlier.text != token.text && !(is_inertia(earlier) && is_inertia(token))) continue;
      cursor_.error_at(token.span, "duplicate-item", fmt::format("a second '{}'", token.text))
          .notes.push_back({cursor_.place(earlier.span), "first one here"});
      return token;
    }
    found.push_back(token);
    return token;
  }

  // Reports at the owner which of these words were not found. Tells whether all were.
  bool check_complete(const std::string& owner, Span span, const Words& found, WordList words) {
    std::string missing;
    for (std::string_view word : words) {
      if (std::any_of(found.begin(), found.end(), [&](const Token& t) { return t.text == word; })) continue;
      missing += fmt::format("{}'{}'", missing.empty() ? "" : ", ", word);
    }
    if (!missing.empty()) cursor_.error_at(span, "missing-item", fmt::format("{} lacks {}", owner, missing));
    return missing.empty();
  }

  [[noreturn]] void unknown_item(const std::string& owner, WordList words) {
    const Token& token = cursor_.peek();
    Diagnostic& d = cursor_.error(
        "unknown-item",
        fmt::format("expected {} or '}}' in {}, found {}", fmt::join(words, ", "), owner, describe(token)));
    if (token.kind == Token::Kind::identifier)
      d.hint = did_you_mean(std::string(token.text), {words.begin(), words.end()});
    throw SyntaxError{};
  }

  [[noreturn]] void old_dialect(const std::string& sign) {
    cursor_.error("old-dialect", sign + " belongs to the dialect of 2011-2012, which is not supported").hint =
        "today: translation = (x, y, z), inertia_params { mass = m CoM = (x, y, z) Ix = … }";
    throw OtherLanguage{};
  }

  Name name(std::string_view what) {
    const Token token = cursor_.expect_name(what);
    return {std::string(token.text), token.span};
  }

  // -------------------------------------------------------------------------------------------------------------------
  // Links.

  void link() {
    Link link;
    const Token keyword = cursor_.take();
    link.is_base = keyword.text == "RobotBase";
    if (link.is_base) bases_.push_back({std::string(cursor_.peek().text), cursor_.peek().span});
    link.name = name(link.is_base ? "the name of the base" : "the name of a link");
    const std::string owner = fmt::format("{} '{}'", link.is_base ? "base" : "link", link.name.text);
    link.floating = link.is_base && cursor_.accept("floating");
    if (link.is_base && !link.floating && !cursor_.at("{")) cursor_.unexpected("'floating' or '{'", "after " + owner);
    Words found;
    const bool sound = block(owner, kLinkItems, [&] {
      if (cursor_.at("id")) {
        const Token id = word(found);
        if (link.is_base) cursor_.error_at(id.span, "base-with-id", "the base has no 'id'");
        link.id_span = id.span;
        link.id = integer(id);
      } else if (cursor_.at_any({"inertia_params", "inertia_properties"})) {
        link.inertia = inertia(word(found), owner);
      } else if (cursor_.at("children")) {
        word(found);
        children(link);
      } else if (cursor_.at("frames")) {
        word(found);
        frames(link);
      } else {
        if (cursor_.at("ref_frame")) old_dialect("a 'ref_frame' of a link");
        unknown_item(owner, link.is_base ? kBaseItems : kLinkItems);
      }
    });
    if (sound && link.is_base) check_complete(owner, link.name.span, found, {"children"});
    if (sound && !link.is_base) check_complete(owner, link.name.span, found, {"id", "children"});
    link.span = {keyword.span.begin, cursor_.previous().span.end};
    link.comments = cursor_.comments_before(link.span.end);
    document_.links.push_back(std::move(link));
  }

  int integer(const Token& key) {
    equals(key);
    const Token token = cursor_.peek();
    const bool is_integer = token.kind == Token::Kind::number &&
                            token.text.find_first_not_of("0123456789") == std::string::npos &&
                            number_of(token).value() <= INT_MAX;
    if (!is_integer) {
      cursor_.error("bad-id", fmt::format("an id is an integer from 0 to {}, not {}", INT_MAX, describe(token)));
      throw SyntaxError{};
    }
    cursor_.take();
    return static_cast<int>(number_of(token).value());
  }

  void children(Link& link) {
    block(
        "'children'", [&] { return cursor_.at_name() && cursor_.at("via", 1); },
        [&] {
          Child child;
          child.link = name("the name of a child link");
          cursor_.expect("via", fmt::format("after child '{}'", child.link.text));
          child.joint = name("the name of a joint");
          link.children.push_back(std::move(child));
        });
  }

  // One block, or several in a row; blocks may be empty.
  void frames(Link& link) {
    do {
      block(
          "'frames'", [&] { return cursor_.at_name() && cursor_.at("{", 1); },
          [&] {
            const Name name = this->name("the name of a frame");
            const auto placement = this->placement(fmt::format("frame '{}'", name.text), name.span);
            if (placement) link.frames.push_back({name, *placement});
          });
    } while (cursor_.at("{"));
  }

  // nullopt when something in it was reported.
  std::optional<Inertia> inertia(const Token& keyword, const std::string& link) {
    Inertia inertia;
    const std::string owner = fmt::format("the inertia of {}", link);
    const std::array moments = {std::pair("Ix", &inertia.ix),   std::pair("Iy", &inertia.iy),
                                std::pair("Iz", &inertia.iz),   std::pair("Ixy", &inertia.ixy),
                                std::pair("Ixz", &inertia.ixz), std::pair("Iyz", &inertia.iyz)};
    Words found;
    const bool sound = block(owner, kInertiaItems, [&] {
      const Token key = cursor_.peek();
      if (cursor_.at_any({"moments", "products"})) old_dialect(fmt::format("'{}'", key.text));
      if (!cursor_.at_any(kInertiaItems)) unknown_item(owner, kInertiaItems);
      word(found);
      equals(key);
      if (key.text == "ref_frame") {
        inertia.reference = name("the name of a frame");
      } else if (key.text == "CoM") {
        inertia.com = vector(key);
      } else if (key.text == "mass") {
        inertia.mass = scalar();
      } else {
        for (const auto& [moment, value] : moments)
          if (key.text == moment) *value = scalar();
      }
    });
    inertia.span = {keyword.span.begin, cursor_.previous().span.end};
    if (!sound || !check_complete(owner, keyword.span, found, kInertiaNeeds)) return std::nullopt;
    return inertia;
  }

  // -------------------------------------------------------------------------------------------------------------------
  // Joints, placements, numbers.

  void joint() {
    Joint joint;
    const Token keyword = cursor_.take();
    joint.type = keyword.text == "r_joint" ? Joint::Type::revolute : Joint::Type::prismatic;
    joint.name = name("the name of a joint");
    const std::string owner = fmt::format("joint '{}'", joint.name.text);
    std::optional<Placement> placement;
    Words found;
    bool sound = block(owner, kJointItems, [&] {
      if (cursor_.at("id")) {
        joint.id = integer(word(found));
      } else if (cursor_.at("ref_frame")) {
        const Token reference = word(found);
        placement = this->placement(fmt::format("the 'ref_frame' of {}", owner), reference.span);
      } else {
        if (cursor_.at("translation")) old_dialect("a 'translation' outside 'ref_frame'");
        unknown_item(owner, kJointItems);
      }
    });
    sound = sound && check_complete(owner, joint.name.span, found, {"ref_frame"});
    joint.span = {keyword.span.begin, cursor_.previous().span.end};
    joint.comments = cursor_.comments_before(joint.span.end);
    if (!sound || !placement) return;
    joint.placement = *placement;
    document_.joints.push_back(std::move(joint));
  }

  // `{ translation = (…) rotation = (…) }`; nullopt when something in it was reported.
  std::optional<Placement> placement(const std::string& owner, Span owner_span) {
    Placement placement;
    placement.span.begin = cursor_.peek().span.begin;
    Words found;
    const bool sound = block(owner, kPlacementItems, [&] {
      if (!cursor_.at_any(kPlacementItems)) unknown_item(owner, kPlacementItems);
      const Token key = word(found);
      equals(key);
      (key.text == "translation" ? placement.translation : placement.rotation) = vector(key);
    });
    placement.span.end = cursor_.previous().span.end;
    if (!sound || !check_complete(owner, owner_span, found, kPlacementItems)) return std::nullopt;
    return placement;
  }

  void equals(const Token& key) {
    if (cursor_.at(":")) old_dialect(fmt::format("'{} :'", key.text));
    cursor_.expect("=", fmt::format("after '{}'", key.text));
  }

  ExpressionPtr scalar() {
    ExpressionPtr value = parse_expression(cursor_);
    if (at_decimal_comma()) decimal_comma(cursor_.peek().span);
    return value;
  }

  Vector vector(const Token& key) {
    const Token open = cursor_.expect("(", fmt::format("before the three components of '{}'", key.text));
    std::vector<ExpressionPtr> components = {parse_expression(cursor_)};
    std::optional<Span> comma;
    while (cursor_.at(",")) {
      if (!comma && at_decimal_comma()) comma = cursor_.peek().span;
      cursor_.take();
      components.push_back(parse_expression(cursor_));
    }
    const Token close = cursor_.expect(")", fmt::format("after the components of '{}'", key.text));
    if (components.size() == 3) return {components[0], components[1], components[2]};
    if (components.size() > 3 && comma) decimal_comma(*comma);
    cursor_.error_at(
        {open.span.begin, close.span.end}, "component-count",
        fmt::format("'{}' has {} components instead of 3", key.text, components.size()));
    throw SyntaxError{};
  }

  // `1,5`
  bool at_decimal_comma() const {
    const Token &before = cursor_.previous(), &comma = cursor_.peek(), &after = cursor_.peek(1);
    return cursor_.at(",") && before.kind == Token::Kind::number && after.kind == Token::Kind::number &&
           before.span.end == comma.span.begin && comma.span.end == after.span.begin;
  }

  [[noreturn]] void decimal_comma(Span span) {
    cursor_.error_at(span, "decimal-comma", "a number is written with a point: '1.5', not '1,5'");
    throw SyntaxError{};
  }
};

}  // namespace

Document parse(std::shared_ptr<const Source> source, Diagnostics& diagnostics) {
  return Parser(std::move(source), diagnostics).run();
}

}  // namespace robcogen::language::kinematics
