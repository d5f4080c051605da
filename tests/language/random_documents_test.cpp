// Random documents: parse(print(d)) == d, and printing again gives the same text. A failure shows its seed and the
// smallest document that fails.
#include <rapidcheck.h>

#include <algorithm>
#include <bit>
#include <climits>
#include <cmath>
#include <functional>
#include <set>

#include "language/desired/keywords.h"
#include "language/kinematics/keywords.h"
#include "language/motion/document.h"
#include "language/transforms/document.h"
#include "reading.h"

namespace robcogen::language {

// How RapidCheck shows a failing case: it looks for functions of this name.
// NOLINTBEGIN(readability-identifier-naming)
namespace kinematics {
void showValue(const Document& document, std::ostream& stream) {
  stream << print(document);
}
}  // namespace kinematics
namespace desired {
void showValue(const Document& document, std::ostream& stream) {
  stream << print(document);
}
}  // namespace desired
namespace motion {
void showValue(const Document& document, std::ostream& stream) {
  stream << print(document);
}
}  // namespace motion
namespace transforms {
void showValue(const Document& document, std::ostream& stream) {
  stream << print(document);
}
}  // namespace transforms
// NOLINTEND(readability-identifier-naming)

namespace {

using Kind = Expression::Kind;

rc::Gen<std::string> name_text(const std::vector<std::string>& keywords) {
  std::vector<std::string> words = keywords;
  for (const char* word : {"a", "x9", "_", "fr_base", "LF_HAA", "e5", "E5", "PI", "nan", "sin", "wrt"})
    words.emplace_back(word);
  const auto random = rc::gen::map(
      rc::gen::nonEmpty(rc::gen::container<std::string>(rc::gen::element('a', 'Z', '_', 'q', '0', '7'))),
      [](std::string text) { return text[0] < 'A' ? "n" + text : text; });
  return rc::gen::oneOf(rc::gen::elementOf(words), random);
}

// A number as a literal of a document gives it; never negative zero, nor infinite.
Number literal(double value) {
  return Number::parse(print_double(std::isfinite(value) ? value : 1.0)).value_or(Number());
}

rc::Gen<Number> number() {
  return rc::gen::oneOf(
      rc::gen::map(rc::gen::inRange(-1000, 1000), [](int i) { return literal(i / 8.0); }),
      rc::gen::map(rc::gen::inRange(-1000, 1000), [](int i) { return literal(i / 100.0); }),
      rc::gen::map(rc::gen::arbitrary<std::uint64_t>(), [](std::uint64_t bits) {
        return literal(std::bit_cast<double>(bits));
      }));
}

ExpressionPtr made(Expression e) {
  return std::make_shared<const Expression>(std::move(e));
}

rc::Gen<ExpressionPtr> leaf() {
  const auto constant_number = rc::gen::map(number(), [](const Number& value) {
    Expression e;
    e.number = value;
    return made(e);
  });
  const auto pi = rc::gen::map(rc::gen::element<std::string>("PI", "pi", "Pi", "pI"), [](const std::string& spelling) {
    Expression e;
    e.kind = Kind::pi;
    e.name = spelling;
    return made(e);
  });
  const auto name = rc::gen::map(
      rc::gen::pair(name_text(kinematics::keywords()), rc::gen::maybe(number())),
      [](const std::pair<std::string, rc::Maybe<Number>>& parts) {
        Expression e;
        e.kind = Kind::name;
        e.name = parts.first;
        if (parts.second) e.default_value = *parts.second;
        const bool is_reserved = kinematics::is_keyword(e.name) || e.name == "PI" || e.name == "nan";
        e.escaped = is_reserved;
        return made(e);
      });
  const auto constant = rc::gen::map(
      rc::gen::pair(name_text(kinematics::keywords()), rc::gen::maybe(number())),
      [](const std::pair<std::string, rc::Maybe<Number>>& parts) {
        Expression e;
        e.kind = Kind::constant;
        e.name = parts.first;
        e.escaped = kinematics::is_keyword(e.name);
        if (parts.second) {
          Expression value;
          value.number = *parts.second;
          e.left = made(value);
        }
        return made(e);
      });
  return rc::gen::weightedOneOf<ExpressionPtr>({{4, constant_number}, {2, pi}, {2, name}, {1, constant}});
}

// The sign of a number is part of it: no tree of the parser negates one.
ExpressionPtr operation(Kind kind, const ExpressionPtr& left, const ExpressionPtr& right) {
  Expression e;
  e.kind = kind;
  e.left = left;
  const bool is_binary = kind == Kind::add || kind == Kind::subtract || kind == Kind::multiply || kind == Kind::divide;
  if (is_binary) e.right = right;
  if (kind == Kind::negate && left->kind == Kind::number) {
    e = *left;
    e.number = -e.number;
  }
  return made(e);
}

rc::Gen<ExpressionPtr> expression(int depth) {
  if (depth == 0) return leaf();
  const auto kind = rc::gen::element(
      Kind::negate, Kind::add, Kind::subtract, Kind::multiply, Kind::multiply, Kind::divide, Kind::sine, Kind::cosine,
      Kind::tangent, Kind::square_root);
  const auto deeper = rc::gen::map(
      rc::gen::tuple(kind, expression(depth - 1), expression(depth - 1)),
      [](const std::tuple<Kind, ExpressionPtr, ExpressionPtr>& parts) {
        return operation(std::get<0>(parts), std::get<1>(parts), std::get<2>(parts));
      });
  return rc::gen::oneOf(leaf(), deeper);
}

// ---------------------------------------------------------------------------------------------------------------------
// Documents.

template <class Name>
rc::Gen<Name> name(const std::vector<std::string>& keywords) {
  return rc::gen::map(name_text(keywords), [](std::string text) { return Name{std::move(text), {}}; });
}

rc::Gen<kinematics::Name> robot_name() {
  return name<kinematics::Name>(kinematics::keywords());
}

rc::Gen<std::vector<std::string>> comments() {
  const auto text = rc::gen::container<std::string>(rc::gen::element('a', ' ', '*', '/', '{', '"', '\xc3', '\t'));
  const auto comment = rc::gen::map(rc::gen::pair(text, rc::gen::arbitrary<bool>()), [](auto parts) {
    auto& [inside, is_line] = parts;
    for (std::size_t at; (at = inside.find("*/")) != std::string::npos;) inside.erase(at, 2);
    if (is_line) return "//" + inside.substr(0, inside.find_last_not_of(" \t") + 1);
    return "/*" + inside + " */";
  });
  return rc::gen::resize(4, rc::gen::container<std::vector<std::string>>(comment));
}

rc::Gen<kinematics::Vector> vector() {
  return rc::gen::container<kinematics::Vector>(expression(3));
}

rc::Gen<kinematics::Placement> placement() {
  using kinematics::Placement;
  return rc::gen::build<Placement>(
      rc::gen::set(&Placement::translation, vector()), rc::gen::set(&Placement::rotation, vector()));
}

template <class T>
rc::Gen<std::optional<T>> maybe(const rc::Gen<T>& what) {
  return rc::gen::map(
      rc::gen::maybe(what), [](const rc::Maybe<T>& m) { return m ? std::optional<T>(*m) : std::nullopt; });
}

rc::Gen<kinematics::Inertia> inertia() {
  using kinematics::Inertia;
  return rc::gen::build<Inertia>(
      rc::gen::set(&Inertia::mass, expression(3)), rc::gen::set(&Inertia::com, vector()),
      rc::gen::set(&Inertia::ix, expression(2)), rc::gen::set(&Inertia::iy, expression(2)),
      rc::gen::set(&Inertia::iz, expression(2)), rc::gen::set(&Inertia::ixy, expression(1)),
      rc::gen::set(&Inertia::ixz, expression(1)), rc::gen::set(&Inertia::iyz, expression(1)),
      rc::gen::set(&Inertia::reference, maybe(robot_name())));
}

rc::Gen<std::optional<int>> id() {
  return rc::gen::map(rc::gen::inRange(0, 1000), [](int i) { return std::optional(i == 999 ? INT_MAX : i); });
}

rc::Gen<kinematics::Link> link(bool is_base) {
  using kinematics::Child, kinematics::Frame, kinematics::Inertia, kinematics::Link;
  const auto children = rc::gen::container<std::vector<Child>>(
      rc::gen::build<Child>(rc::gen::set(&Child::link, robot_name()), rc::gen::set(&Child::joint, robot_name())));
  const auto frames = rc::gen::container<std::vector<Frame>>(
      rc::gen::build<Frame>(rc::gen::set(&Frame::name, robot_name()), rc::gen::set(&Frame::placement, placement())));
  return rc::gen::build<Link>(
      rc::gen::set(&Link::name, robot_name()), rc::gen::set(&Link::is_base, rc::gen::just(is_base)),
      rc::gen::set(&Link::floating, is_base ? rc::gen::arbitrary<bool>() : rc::gen::just(false)),
      rc::gen::set(&Link::id, is_base ? rc::gen::just(std::optional<int>()) : id()),
      rc::gen::set(&Link::inertia, maybe(inertia())), rc::gen::set(&Link::children, rc::gen::resize(4, children)),
      rc::gen::set(&Link::frames, rc::gen::resize(3, frames)), rc::gen::set(&Link::comments, comments()));
}

// A value that may be left out.
rc::Gen<ExpressionPtr> maybe_expression() {
  return rc::gen::oneOf(rc::gen::just(ExpressionPtr()), expression(2));
}

rc::Gen<kinematics::Drive> drive() {
  using kinematics::Drive;
  const auto any = rc::gen::build<Drive>(
      rc::gen::set(&Drive::damping, maybe_expression()), rc::gen::set(&Drive::friction, maybe_expression()),
      rc::gen::set(&Drive::friction_velocity, maybe_expression()), rc::gen::set(&Drive::armature, maybe_expression()),
      rc::gen::set(&Drive::stiffness, maybe_expression()), rc::gen::set(&Drive::rest, maybe_expression()));
  return rc::gen::map(any, [](Drive d) {
    if (!d.friction) d.friction_velocity = nullptr;
    if (!d.stiffness) d.rest = nullptr;
    return d;
  });
}

rc::Gen<kinematics::Rotor> rotor() {
  using kinematics::Rotor;
  return rc::gen::build<Rotor>(
      rc::gen::set(&Rotor::inertia, expression(1)), rc::gen::set(&Rotor::ratio, expression(1)),
      rc::gen::set(&Rotor::axis, maybe(vector())), rc::gen::set(&Rotor::carrier, maybe(robot_name())));
}

rc::Gen<kinematics::Limits> limits() {
  using kinematics::Limits;
  using Bounds = std::array<ExpressionPtr, 2>;
  const auto bounds = maybe(rc::gen::container<Bounds>(expression(2)));
  return rc::gen::build<Limits>(
      rc::gen::set(&Limits::position, bounds), rc::gen::set(&Limits::velocity, maybe_expression()),
      rc::gen::set(&Limits::effort, maybe_expression()));
}

rc::Gen<kinematics::Joint> joint() {
  using kinematics::Joint;
  const auto of_its_type = [](std::pair<Joint, ExpressionPtr> made) {
    Joint& joint = made.first;
    if (joint.type == Joint::Type::helical) joint.pitch = made.second;
    const auto words = kinematics::coordinate_words(joint.type);
    if (words.empty()) return joint;
    for (std::size_t k = joint.comments.size() % 2; k < words.size(); ++k)
      joint.coordinates.push_back({kinematics::DriveAndLimits(joint), {std::string(words[k]), {}}});
    joint.drive = {};
    joint.rotor.reset();
    joint.limits = {};
    joint.assembled = nullptr;
    return joint;
  };
  const auto any = rc::gen::build<Joint>(
      rc::gen::set(&Joint::name, robot_name()),
      rc::gen::set(
          &Joint::type, rc::gen::element(
                            Joint::Type::revolute, Joint::Type::prismatic, Joint::Type::helical,
                            Joint::Type::cylindrical, Joint::Type::universal, Joint::Type::planar)),
      rc::gen::set(&Joint::id, rc::gen::oneOf(id(), rc::gen::just(std::optional<int>()))),
      rc::gen::set(&Joint::placement, placement()), rc::gen::set(&Joint::drive, drive()),
      rc::gen::set(&Joint::rotor, maybe(rotor())), rc::gen::set(&Joint::limits, limits()),
      rc::gen::set(&Joint::assembled, maybe_expression()), rc::gen::set(&Joint::comments, comments()));
  return rc::gen::map(rc::gen::pair(any, expression(1)), of_its_type);
}

rc::Gen<kinematics::Coupling> coupling() {
  using kinematics::Coupling;
  return rc::gen::build<Coupling>(
      rc::gen::set(&Coupling::joint, robot_name()), rc::gen::set(&Coupling::value, expression(3)));
}

rc::Gen<kinematics::LoopJoint> loop_joint() {
  using kinematics::LoopJoint;
  const auto any = rc::gen::build<LoopJoint>(
      rc::gen::set(&LoopJoint::name, robot_name()),
      rc::gen::set(
          &LoopJoint::frames, rc::gen::map(
                                  rc::gen::pair(robot_name(), robot_name()),
                                  [](const auto& both) {
                                    return std::array{both.first, both.second};
                                  })),
      rc::gen::set(&LoopJoint::distance, expression(3)));
  // With a type, or a distance; of either branch, or without a word.
  return rc::gen::map(rc::gen::pair(any, rc::gen::inRange<std::size_t>(0, 15)), [](auto made) {
    auto [loop, choice] = made;
    const std::size_t type = choice % 5, branch = choice / 5;
    if (branch > 0) loop.branch.text = kinematics::kLoopBranches.begin()[branch - 1];
    if (type == kinematics::kLoopTypes.size()) return loop;
    loop.distance = nullptr;
    loop.type.text = kinematics::kLoopTypes.begin()[type];
    return loop;
  });
}

rc::Gen<kinematics::Actuator> actuator() {
  using kinematics::Actuator;
  return rc::gen::map(rc::gen::tuple(robot_name(), robot_name(), robot_name()), [](const auto& names) {
    const auto& [name, from, to] = names;
    return Actuator{name, {from, to}};
  });
}

rc::Gen<kinematics::Document> robot() {
  using kinematics::Document, kinematics::Joint, kinematics::Link;
  const auto links = rc::gen::map(
      rc::gen::pair(link(true), rc::gen::resize(5, rc::gen::container<std::vector<Link>>(link(false)))),
      [](std::pair<Link, std::vector<Link>> parts) {
        parts.second.insert(parts.second.begin(), parts.first);
        return parts.second;
      });
  return rc::gen::build<Document>(
      rc::gen::set(&Document::robot, robot_name()), rc::gen::set(&Document::comments, comments()),
      rc::gen::set(&Document::trailing_comments, comments()), rc::gen::set(&Document::links, links),
      rc::gen::set(&Document::joints, rc::gen::resize(5, rc::gen::container<std::vector<Joint>>(joint()))),
      rc::gen::set(
          &Document::couplings, rc::gen::resize(4, rc::gen::container<std::vector<kinematics::Coupling>>(coupling()))),
      rc::gen::set(
          &Document::loop_joints,
          rc::gen::resize(3, rc::gen::container<std::vector<kinematics::LoopJoint>>(loop_joint()))),
      rc::gen::set(
          &Document::actuators, rc::gen::resize(3, rc::gen::container<std::vector<kinematics::Actuator>>(actuator()))),
      rc::gen::set(
          &Document::independents,
          rc::gen::resize(3, rc::gen::container<std::vector<kinematics::Name>>(robot_name()))));
}

rc::Gen<desired::Document> list() {
  using desired::Contact, desired::Document, desired::Pair;
  const auto frame = name<desired::Name>(desired::keywords());
  const auto pairs = rc::gen::resize(
      10, rc::gen::container<std::vector<Pair>>(
              rc::gen::build<Pair>(rc::gen::set(&Pair::left, frame), rc::gen::set(&Pair::right, frame))));
  const auto contacts = rc::gen::resize(
      5, rc::gen::container<std::vector<Contact>>(rc::gen::build<Contact>(
             rc::gen::set(&Contact::frame, frame), rc::gen::set(&Contact::is_surface, rc::gen::arbitrary<bool>()))));
  return rc::gen::build<Document>(
      rc::gen::set(&Document::robot, frame), rc::gen::set(&Document::comments, comments()),
      rc::gen::set(&Document::contacts, contacts),
      rc::gen::set(&Document::frames, rc::gen::resize(10, rc::gen::container<std::vector<desired::Name>>(frame))),
      rc::gen::set(&Document::transforms, pairs), rc::gen::set(&Document::jacobians, pairs));
}

// Constructs of documents about frames only: parameters by group, and those that their use declares.
ExpressionPtr qualified(const ExpressionPtr& from, const std::vector<std::string>& keywords, int how) {
  if (!from) return from;
  Expression e = *from;
  if (e.kind == Kind::name || e.kind == Kind::constant) {
    const auto is_keyword = [&](const std::string& word) {
      return std::find(keywords.begin(), keywords.end(), word) != keywords.end();
    };
    e.escaped = e.escaped || is_keyword(e.name);
  }
  if (e.kind == Kind::name && how == 1) e.is_parameter = true;
  if (e.kind == Kind::name && how == 2) e.group = "lengths";
  e.left = qualified(e.left, keywords, how);
  e.right = qualified(e.right, keywords, how);
  return made(e);
}

rc::Gen<std::vector<AxisStep>> steps(const std::vector<std::string>& keywords) {
  const auto amount = rc::gen::map(
      rc::gen::pair(expression(2), rc::gen::inRange(0, 3)), [keywords](const std::pair<ExpressionPtr, int>& parts) {
        return qualified(parts.first, keywords, parts.second);
      });
  return rc::gen::resize(
      6, rc::gen::container<std::vector<AxisStep>>(rc::gen::build<AxisStep>(
             rc::gen::set(&AxisStep::rotation), rc::gen::set(&AxisStep::axis, rc::gen::inRange(0, 3)),
             rc::gen::set(&AxisStep::amount, amount))));
}

rc::Gen<FramesHeader> header(const std::vector<std::string>& keywords) {
  const auto names = rc::gen::resize(6, rc::gen::container<std::vector<Name>>(name<Name>(keywords)));
  const auto some_names =
      rc::gen::resize(6, rc::gen::nonEmpty(rc::gen::container<std::vector<Name>>(name<Name>(keywords))));
  const auto group = rc::gen::build<ParameterGroup>(
      rc::gen::set(&ParameterGroup::name, name<Name>(keywords)), rc::gen::set(&ParameterGroup::parameters, names),
      rc::gen::set(&ParameterGroup::comments, comments()));
  return rc::gen::build<FramesHeader>(
      rc::gen::set(&FramesHeader::model, name<Name>(keywords)), rc::gen::set(&FramesHeader::frames, maybe(some_names)),
      rc::gen::set(&FramesHeader::groups, rc::gen::resize(3, rc::gen::container<std::vector<ParameterGroup>>(group))),
      rc::gen::set(&FramesHeader::comments, comments()));
}

rc::Gen<motion::Document> motions() {
  using motion::Convention, motion::Document, motion::Motion;
  const auto frame = name<Name>(motion::keywords());
  const auto one = rc::gen::build<Motion>(
      rc::gen::set(&Motion::from, frame), rc::gen::set(&Motion::to, frame),
      rc::gen::set(&Motion::steps, steps(motion::keywords())), rc::gen::set(&Motion::name, maybe(frame)),
      rc::gen::set(&Motion::comments, comments()));
  return rc::gen::build<Document>(
      rc::gen::set(&Document::header, header(motion::keywords())),
      rc::gen::set(&Document::convention, rc::gen::element(Convention::local, Convention::fixed)),
      rc::gen::set(&Document::convention_comments, comments()),
      rc::gen::set(&Document::motions, rc::gen::resize(5, rc::gen::container<std::vector<Motion>>(one))),
      rc::gen::set(&Document::trailing_comments, comments()));
}

rc::Gen<transforms::Document> transforms_document() {
  using transforms::Document, transforms::MovedFramePosition, transforms::Transform;
  const auto frame = name<Name>(transforms::keywords());
  const auto one = rc::gen::build<Transform>(
      rc::gen::set(&Transform::left, frame), rc::gen::set(&Transform::right, frame),
      rc::gen::set(&Transform::primitives, steps(transforms::keywords())), rc::gen::set(&Transform::name, maybe(frame)),
      rc::gen::set(&Transform::comments, comments()));
  return rc::gen::build<Document>(
      rc::gen::set(&Document::header, header(transforms::keywords())),
      rc::gen::set(&Document::position, rc::gen::element(MovedFramePosition::left, MovedFramePosition::right)),
      rc::gen::set(&Document::position_comments, comments()),
      rc::gen::set(&Document::transforms, rc::gen::resize(5, rc::gen::container<std::vector<Transform>>(one))),
      rc::gen::set(&Document::trailing_comments, comments()));
}

template <class Document>
void survives_printing(const Document& document, Document (*parse)(std::shared_ptr<const Source>, Diagnostics&)) {
  const std::string text = print(document);
  Diagnostics diagnostics;
  const Document again = parse(test::source(text), diagnostics);
  RC_LOG() << diagnostics.render();
  RC_ASSERT(diagnostics.all().empty());
  RC_ASSERT(equal(document, again));
  RC_ASSERT(print(again) == text);
}

TEST(RandomDocuments, OfRobotsSurvivePrinting) {
  EXPECT_TRUE(rc::check([] { survives_printing(*robot(), &kinematics::parse); }));
}

TEST(RandomDocuments, OfDesiredTransformsSurvivePrinting) {
  EXPECT_TRUE(rc::check([] { survives_printing(*list(), &desired::parse); }));
}

TEST(RandomDocuments, OfMotionsSurvivePrinting) {
  EXPECT_TRUE(rc::check([] { survives_printing(*motions(), &motion::parse); }));
}

TEST(RandomDocuments, OfTransformsSurvivePrinting) {
  EXPECT_TRUE(rc::check([] { survives_printing(*transforms_document(), &transforms::parse); }));
}

// The documents are worth the name: all that the syntax has does occur.
TEST(RandomDocuments, HaveEveryPartOfTheLanguage) {
  std::set<Kind> kinds;
  int references = 0, massless = 0, floating = 0, defaults = 0, escaped = 0, drives = 0;
  const std::function<void(const ExpressionPtr&)> count = [&](const ExpressionPtr& e) {
    if (!e) return;
    kinds.insert(e->kind);
    defaults += e->default_value ? 1 : 0;
    escaped += e->escaped ? 1 : 0;
    count(e->left);
    count(e->right);
  };
  rc::Random random(2024);
  const auto generator = robot();
  for (int i = 0; i < 100; ++i) {
    const kinematics::Document d = generator(random.split(), 50).value();
    for (const kinematics::Link& l : d.links) {
      floating += l.floating ? 1 : 0;
      massless += l.inertia ? 0 : 1;
      if (!l.inertia) continue;
      references += l.inertia->reference ? 1 : 0;
      count(l.inertia->mass);
    }
    for (const kinematics::Joint& j : d.joints) {
      count(j.placement.rotation[1]);
      drives += j.drive.damping && j.rotor && j.limits.position ? 1 : 0;
    }
  }
  EXPECT_EQ(kinds.size(), 13u);
  for (const int occurrences : {references, massless, floating, defaults, escaped, drives}) EXPECT_GT(occurrences, 5);
}

}  // namespace
}  // namespace robcogen::language
