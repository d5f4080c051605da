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

// Up to about that many.
template <class T>
rc::Gen<std::vector<T>> up_to(int count, const rc::Gen<T>& what) {
  return rc::gen::resize(count, rc::gen::container<std::vector<T>>(what));
}

template <class T>
rc::Gen<std::optional<T>> maybe(const rc::Gen<T>& what) {
  return rc::gen::map(
      rc::gen::maybe(what), [](const rc::Maybe<T>& m) { return m ? std::optional<T>(*m) : std::nullopt; });
}

// A value that may be left out.
rc::Gen<ExpressionPtr> maybe_expression() {
  return rc::gen::oneOf(rc::gen::just(ExpressionPtr()), expression(2));
}

rc::Gen<kinematics::Vector> vector() {
  return rc::gen::container<kinematics::Vector>(expression(3));
}

rc::Gen<kinematics::Placement> placement() {
  return rc::gen::exec([] {
    kinematics::Placement placement;
    placement.translation = *vector();
    placement.rotation = *vector();
    return placement;
  });
}

rc::Gen<kinematics::Inertia> inertia() {
  return rc::gen::exec([] {
    kinematics::Inertia inertia;
    inertia.mass = *expression(3);
    inertia.com = *vector();
    for (ExpressionPtr* moment : {&inertia.ix, &inertia.iy, &inertia.iz}) *moment = *expression(2);
    for (ExpressionPtr* product : {&inertia.ixy, &inertia.ixz, &inertia.iyz}) *product = *expression(1);
    inertia.reference = *maybe(robot_name());
    return inertia;
  });
}

rc::Gen<std::optional<int>> id() {
  return rc::gen::map(rc::gen::inRange(0, 1000), [](int i) { return std::optional(i == 999 ? INT_MAX : i); });
}

rc::Gen<kinematics::Child> child() {
  return rc::gen::exec([] {
    kinematics::Child child;
    child.link = *robot_name();
    child.joint = *robot_name();
    return child;
  });
}

rc::Gen<kinematics::Frame> frame() {
  return rc::gen::exec([] {
    kinematics::Frame frame;
    frame.name = *robot_name();
    frame.placement = *placement();
    return frame;
  });
}

rc::Gen<kinematics::Link> link(bool is_base) {
  return rc::gen::exec([is_base] {
    kinematics::Link link;
    link.name = *robot_name();
    link.is_base = is_base;
    if (is_base)
      link.floating = *rc::gen::arbitrary<bool>();
    else
      link.id = *id();
    link.inertia = *maybe(inertia());
    link.children = *up_to(4, child());
    link.frames = *up_to(3, frame());
    link.comments = *comments();
    return link;
  });
}

rc::Gen<kinematics::Drive> drive() {
  return rc::gen::exec([] {
    kinematics::Drive drive;
    drive.damping = *maybe_expression();
    drive.friction = *maybe_expression();
    if (drive.friction) drive.friction_velocity = *maybe_expression();
    drive.armature = *maybe_expression();
    drive.stiffness = *maybe_expression();
    if (drive.stiffness) drive.rest = *maybe_expression();
    return drive;
  });
}

rc::Gen<kinematics::Rotor> rotor() {
  return rc::gen::exec([] {
    kinematics::Rotor rotor;
    rotor.inertia = *expression(1);
    rotor.ratio = *expression(1);
    rotor.axis = *maybe(vector());
    rotor.carrier = *maybe(robot_name());
    return rotor;
  });
}

rc::Gen<kinematics::Limits> limits() {
  return rc::gen::exec([] {
    kinematics::Limits limits;
    limits.position = *maybe(rc::gen::container<std::array<ExpressionPtr, 2>>(expression(2)));
    limits.velocity = *maybe_expression();
    limits.effort = *maybe_expression();
    return limits;
  });
}

rc::Gen<kinematics::Joint> joint() {
  using kinematics::Joint;
  return rc::gen::exec([] {
    Joint joint;
    joint.name = *robot_name();
    joint.type = *rc::gen::element(
        Joint::Type::revolute, Joint::Type::prismatic, Joint::Type::helical, Joint::Type::cylindrical,
        Joint::Type::universal, Joint::Type::planar);
    joint.id = *rc::gen::oneOf(id(), rc::gen::just(std::optional<int>()));
    joint.placement = *placement();
    joint.comments = *comments();
    if (joint.type == Joint::Type::helical) joint.pitch = *expression(1);
    kinematics::DriveAndLimits one;
    one.drive = *drive();
    one.rotor = *maybe(rotor());
    one.limits = *limits();
    one.assembled = *maybe_expression();
    const auto words = kinematics::coordinate_words(joint.type);
    if (words.empty()) static_cast<kinematics::DriveAndLimits&>(joint) = one;
    // Of all coordinates, or of all but the first.
    for (std::size_t k = *rc::gen::inRange(0, 2); k < words.size(); ++k)
      joint.coordinates.push_back({one, {std::string(words[k]), {}}});
    return joint;
  });
}

rc::Gen<kinematics::Coupling> coupling() {
  return rc::gen::exec([] {
    kinematics::Coupling coupling;
    coupling.joint = *robot_name();
    coupling.value = *expression(3);
    return coupling;
  });
}

// With a type, or a distance; of either branch, or without a word.
rc::Gen<kinematics::LoopJoint> loop_joint() {
  return rc::gen::exec([] {
    kinematics::LoopJoint loop;
    loop.name = *robot_name();
    loop.frames = {*robot_name(), *robot_name()};
    const std::size_t type = *rc::gen::inRange<std::size_t>(0, kinematics::kLoopTypes.size() + 1);
    if (type < kinematics::kLoopTypes.size())
      loop.type.text = kinematics::kLoopTypes.begin()[type];
    else
      loop.distance = *expression(3);
    const std::size_t branch = *rc::gen::inRange<std::size_t>(0, kinematics::kLoopBranches.size() + 1);
    if (branch < kinematics::kLoopBranches.size()) loop.branch.text = kinematics::kLoopBranches.begin()[branch];
    return loop;
  });
}

rc::Gen<kinematics::Actuator> actuator() {
  return rc::gen::exec([] {
    kinematics::Actuator actuator;
    actuator.name = *robot_name();
    actuator.frames = {*robot_name(), *robot_name()};
    return actuator;
  });
}

rc::Gen<kinematics::Document> robot() {
  return rc::gen::exec([] {
    kinematics::Document document;
    document.robot = *robot_name();
    document.comments = *comments();
    document.trailing_comments = *comments();
    document.links = *up_to(5, link(false));
    document.links.insert(document.links.begin(), *link(true));
    document.joints = *up_to(5, joint());
    document.couplings = *up_to(4, coupling());
    document.loop_joints = *up_to(3, loop_joint());
    document.actuators = *up_to(3, actuator());
    document.independents = *up_to(3, robot_name());
    return document;
  });
}

rc::Gen<desired::Name> frame_name() {
  return name<desired::Name>(desired::keywords());
}

rc::Gen<desired::Pair> pair() {
  return rc::gen::exec([] {
    desired::Pair pair;
    pair.left = *frame_name();
    pair.right = *frame_name();
    return pair;
  });
}

rc::Gen<desired::Contact> contact() {
  return rc::gen::exec([] {
    desired::Contact contact;
    contact.frame = *frame_name();
    contact.is_surface = *rc::gen::arbitrary<bool>();
    return contact;
  });
}

rc::Gen<desired::Document> list() {
  return rc::gen::exec([] {
    desired::Document document;
    document.robot = *frame_name();
    document.comments = *comments();
    document.contacts = *up_to(5, contact());
    document.frames = *up_to(10, frame_name());
    document.transforms = *up_to(10, pair());
    document.jacobians = *up_to(10, pair());
    return document;
  });
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
  return up_to<AxisStep>(6, rc::gen::exec([keywords] {
                           AxisStep step;
                           step.rotation = *rc::gen::arbitrary<bool>();
                           step.axis = *rc::gen::inRange(0, 3);
                           step.amount = qualified(*expression(2), keywords, *rc::gen::inRange(0, 3));
                           return step;
                         }));
}

rc::Gen<ParameterGroup> group(const std::vector<std::string>& keywords) {
  return rc::gen::exec([keywords] {
    ParameterGroup group;
    group.name = *name<Name>(keywords);
    group.parameters = *up_to(6, name<Name>(keywords));
    group.comments = *comments();
    return group;
  });
}

rc::Gen<FramesHeader> header(const std::vector<std::string>& keywords) {
  return rc::gen::exec([keywords] {
    FramesHeader header;
    header.model = *name<Name>(keywords);
    header.frames = *maybe(rc::gen::nonEmpty(up_to(6, name<Name>(keywords))));
    header.groups = *up_to(3, group(keywords));
    header.comments = *comments();
    return header;
  });
}

// Of a motion or a transform, all but what its frames are called.
template <class Entry>
Entry entry(std::vector<AxisStep> Entry::*its_steps, const std::vector<std::string>& keywords) {
  Entry entry;
  entry.*its_steps = *steps(keywords);
  entry.name = *maybe(name<Name>(keywords));
  entry.comments = *comments();
  return entry;
}

rc::Gen<motion::Motion> one_motion() {
  return rc::gen::exec([] {
    auto motion = entry(&motion::Motion::steps, motion::keywords());
    motion.from = *name<Name>(motion::keywords());
    motion.to = *name<Name>(motion::keywords());
    return motion;
  });
}

rc::Gen<motion::Document> motions() {
  using motion::Convention;
  return rc::gen::exec([] {
    motion::Document document;
    document.header = *header(motion::keywords());
    document.convention = *rc::gen::element(Convention::local, Convention::fixed);
    document.convention_comments = *comments();
    document.motions = *up_to(5, one_motion());
    document.trailing_comments = *comments();
    return document;
  });
}

rc::Gen<transforms::Transform> one_transform() {
  return rc::gen::exec([] {
    auto transform = entry(&transforms::Transform::primitives, transforms::keywords());
    transform.left = *name<Name>(transforms::keywords());
    transform.right = *name<Name>(transforms::keywords());
    return transform;
  });
}

rc::Gen<transforms::Document> transforms_document() {
  using transforms::MovedFramePosition;
  return rc::gen::exec([] {
    transforms::Document document;
    document.header = *header(transforms::keywords());
    document.position = *rc::gen::element(MovedFramePosition::left, MovedFramePosition::right);
    document.position_comments = *comments();
    document.transforms = *up_to(5, one_transform());
    document.trailing_comments = *comments();
    return document;
  });
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
