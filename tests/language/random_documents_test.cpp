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

// RapidCheck prints a failing case through functions with this name.
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

// Plain functions build documents from these draws, because each type of generator takes long to compile.

// A random number below `count` that shrinks to 0.
std::size_t below(std::size_t count) {
  return *rc::gen::resize(rc::kNominalSize, rc::gen::inRange<std::size_t>(0, count));
}

bool flipped() {
  return below(2) == 1;
}

template <class T>
T one_of(const std::vector<T>& choices) {
  return choices[below(choices.size())];
}

// Returns at most `count` results of `draw`, fewer in the first documents.
template <class Draw>
auto up_to(std::size_t count, const Draw& draw) {
  std::vector<decltype(draw())> result;
  for (std::size_t size = *rc::gen::inRange<std::size_t>(0, count + 1); result.size() < size;) result.push_back(draw());
  return result;
}

template <class Draw>
auto maybe(const Draw& draw) {
  return flipped() ? std::optional(draw()) : std::nullopt;
}

// Returns at most `count` of these characters.
std::string text_of(const std::string& characters, std::size_t count) {
  const std::vector<char> text = up_to(count, [&] { return characters[below(characters.size())]; });
  return {text.begin(), text.end()};
}

std::string name_text(const std::vector<std::string>& keywords) {
  std::vector<std::string> words = keywords;
  for (const char* word : {"a", "x9", "_", "fr_base", "LF_HAA", "e5", "E5", "PI", "nan", "sin", "wrt"})
    words.emplace_back(word);
  if (flipped()) return one_of(words);
  return one_of<std::string>({"a", "Z", "_", "q", "n0", "n7"}) + text_of("aZ_q07", 20);
}

// A number as a document's literal gives it: never negative zero or infinite.
Number literal(double value) {
  return Number::parse(print_double(std::isfinite(value) ? value : 1.0)).value_or(Number());
}

Number number() {
  const std::size_t kind = below(3);
  if (kind == 2) return literal(std::bit_cast<double>(*rc::gen::arbitrary<std::uint64_t>()));
  return literal((static_cast<double>(below(2000)) - 1000) / (kind == 0 ? 8 : 100));
}

ExpressionPtr made(Expression e) {
  return std::make_shared<const Expression>(std::move(e));
}

// Four times in nine a number, twice PI, twice a name, once a constant.
ExpressionPtr leaf() {
  Expression e;
  const std::size_t kind = below(9);
  if (kind < 4) {
    e.number = number();
  } else if (kind < 6) {
    e.kind = Kind::pi;
    e.name = one_of<std::string>({"PI", "pi", "Pi", "pI"});
  } else if (kind < 8) {
    e.kind = Kind::name;
    e.name = name_text(kinematics::keywords());
    e.default_value = maybe(number);
    e.escaped = kinematics::is_keyword(e.name) || e.name == "PI" || e.name == "nan";
  } else {
    e.kind = Kind::constant;
    e.name = name_text(kinematics::keywords());
    e.escaped = kinematics::is_keyword(e.name);
    Expression value;
    value.number = number();
    if (flipped()) e.left = made(value);
  }
  return made(e);
}

// The sign of a number belongs to the number: the parser's trees do not negate one.
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

ExpressionPtr expression(int depth) {
  if (depth == 0 || flipped()) return leaf();
  const Kind kind = one_of<Kind>(
      {Kind::negate, Kind::add, Kind::subtract, Kind::multiply, Kind::multiply, Kind::divide, Kind::sine, Kind::cosine,
       Kind::tangent, Kind::square_root});
  const ExpressionPtr left = expression(depth - 1);
  return operation(kind, left, expression(depth - 1));
}

// ---------------------------------------------------------------------------------------------------------------------
// Documents.

template <class Name>
Name name(const std::vector<std::string>& keywords) {
  return {name_text(keywords), {}};
}

kinematics::Name robot_name() {
  return name<kinematics::Name>(kinematics::keywords());
}

std::string comment() {
  std::string inside = text_of("a */{\"\xc3\t", 20);
  for (std::size_t at; (at = inside.find("*/")) != std::string::npos;) inside.erase(at, 2);
  return flipped() ? "//" + inside.substr(0, inside.find_last_not_of(" \t") + 1) : "/*" + inside + " */";
}

std::vector<std::string> comments() {
  return up_to(4, comment);
}

// An expression, or none.
ExpressionPtr maybe_expression() {
  return flipped() ? expression(2) : nullptr;
}

kinematics::Vector vector() {
  return {expression(3), expression(3), expression(3)};
}

kinematics::Placement placement() {
  kinematics::Placement placement;
  placement.translation = vector();
  placement.rotation = vector();
  return placement;
}

kinematics::Inertia inertia() {
  kinematics::Inertia inertia;
  inertia.mass = expression(3);
  inertia.com = vector();
  for (ExpressionPtr* moment : {&inertia.ix, &inertia.iy, &inertia.iz}) *moment = expression(2);
  for (ExpressionPtr* product : {&inertia.ixy, &inertia.ixz, &inertia.iyz}) *product = expression(1);
  inertia.reference = maybe(robot_name);
  return inertia;
}

std::optional<int> id() {
  return below(20) == 0 ? INT_MAX : static_cast<int>(below(1000));
}

kinematics::Child child() {
  kinematics::Child child;
  child.link = robot_name();
  child.joint = robot_name();
  return child;
}

kinematics::Frame frame() {
  kinematics::Frame frame;
  frame.name = robot_name();
  frame.placement = placement();
  return frame;
}

kinematics::Link link(bool is_base) {
  kinematics::Link link;
  link.name = robot_name();
  link.is_base = is_base;
  if (is_base)
    link.floating = flipped();
  else
    link.id = id();
  link.inertia = maybe(inertia);
  link.children = up_to(4, child);
  link.frames = up_to(3, frame);
  link.comments = comments();
  return link;
}

kinematics::Drive drive() {
  kinematics::Drive drive;
  drive.damping = maybe_expression();
  drive.friction = maybe_expression();
  if (drive.friction) drive.friction_velocity = maybe_expression();
  drive.armature = maybe_expression();
  drive.stiffness = maybe_expression();
  if (drive.stiffness) drive.rest = maybe_expression();
  return drive;
}

kinematics::Rotor rotor() {
  kinematics::Rotor rotor;
  rotor.inertia = expression(1);
  rotor.ratio = expression(1);
  rotor.axis = maybe(vector);
  rotor.carrier = maybe(robot_name);
  return rotor;
}

kinematics::Elasticity elasticity() {
  kinematics::Elasticity elasticity;
  elasticity.stiffness = expression(2);
  elasticity.damping = maybe_expression();
  return elasticity;
}

kinematics::Limits limits() {
  kinematics::Limits limits;
  limits.position = maybe([] { return std::array{expression(2), expression(2)}; });
  limits.velocity = maybe_expression();
  limits.effort = maybe_expression();
  return limits;
}

kinematics::Joint joint() {
  using kinematics::Joint;
  Joint joint;
  joint.name = robot_name();
  joint.type = one_of<Joint::Type>(
      {Joint::Type::revolute, Joint::Type::prismatic, Joint::Type::helical, Joint::Type::cylindrical,
       Joint::Type::universal, Joint::Type::planar});
  joint.id = flipped() ? id() : std::nullopt;
  joint.placement = placement();
  joint.comments = comments();
  if (joint.type == Joint::Type::helical) joint.pitch = expression(1);
  kinematics::DriveAndLimits one;
  one.drive = drive();
  one.rotor = maybe(rotor);
  one.elasticity = maybe(elasticity);
  one.limits = limits();
  one.assembled = maybe_expression();
  const auto words = kinematics::coordinate_words(joint.type);
  if (words.empty()) static_cast<kinematics::DriveAndLimits&>(joint) = one;
  // All coordinates, or all but the first.
  for (std::size_t k = below(2); k < words.size(); ++k) joint.coordinates.push_back({one, {std::string(words[k]), {}}});
  return joint;
}

kinematics::Coupling coupling() {
  kinematics::Coupling coupling;
  coupling.joint = robot_name();
  coupling.value = expression(3);
  return coupling;
}

// A loop with a type or a distance, and either branch or none.
kinematics::LoopJoint loop_joint() {
  kinematics::LoopJoint loop;
  loop.name = robot_name();
  loop.frames = {robot_name(), robot_name()};
  const std::size_t type = below(kinematics::kLoopTypes.size() + 1);
  if (type < kinematics::kLoopTypes.size())
    loop.type.text = kinematics::kLoopTypes.begin()[type];
  else
    loop.distance = expression(3);
  const std::size_t branch = below(kinematics::kLoopBranches.size() + 1);
  if (branch < kinematics::kLoopBranches.size()) loop.branch.text = kinematics::kLoopBranches.begin()[branch];
  return loop;
}

kinematics::Actuator actuator() {
  kinematics::Actuator actuator;
  actuator.name = robot_name();
  actuator.frames = {robot_name(), robot_name()};
  return actuator;
}

kinematics::Tendon tendon() {
  kinematics::Tendon tendon;
  tendon.name = robot_name();
  tendon.length = expression(3);
  tendon.stiffness = maybe_expression();
  tendon.damping = maybe_expression();
  tendon.rest = maybe_expression();
  return tendon;
}

kinematics::Document robot() {
  kinematics::Document document;
  document.robot = robot_name();
  document.comments = comments();
  document.trailing_comments = comments();
  document.links = up_to(5, [&] { return link(false); });
  document.links.insert(document.links.begin(), link(true));
  document.joints = up_to(5, joint);
  document.couplings = up_to(4, coupling);
  document.loop_joints = up_to(3, loop_joint);
  document.actuators = up_to(3, actuator);
  document.tendons = up_to(3, tendon);
  document.independents = up_to(3, robot_name);
  return document;
}

desired::Name frame_name() {
  return name<desired::Name>(desired::keywords());
}

desired::Pair pair() {
  desired::Pair pair;
  pair.left = frame_name();
  pair.right = frame_name();
  return pair;
}

desired::Contact contact() {
  desired::Contact contact;
  contact.frame = frame_name();
  contact.is_surface = flipped();
  return contact;
}

desired::Inverse inverse() {
  desired::Inverse inverse;
  inverse.pair = pair();
  using Task = desired::Inverse::Task;
  inverse.task = flipped()   ? flipped() ? Task::pose : Task::point
                 : flipped() ? Task::axis
                 : flipped() ? Task::swivel
                             : Task::given;
  if (inverse.task == Task::given) inverse.given = frame_name();
  if (flipped()) inverse.tolerance = flipped() ? 1e-3 : 0.05;
  return inverse;
}

desired::Document list() {
  desired::Document document;
  document.robot = frame_name();
  document.comments = comments();
  document.contacts = up_to(5, contact);
  document.inverses = up_to(5, inverse);
  document.frames = up_to(10, frame_name);
  document.transforms = up_to(10, pair);
  document.jacobians = up_to(10, pair);
  return document;
}

// Turns names into constructs that only documents about frames have: parameters in a group, and parameters declared by
// their use.
ExpressionPtr qualified(const ExpressionPtr& from, const std::vector<std::string>& keywords, std::size_t how) {
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

std::vector<AxisStep> steps(const std::vector<std::string>& keywords) {
  return up_to(6, [&] {
    AxisStep step;
    step.rotation = flipped();
    step.axis = static_cast<int>(below(3));
    step.amount = qualified(expression(2), keywords, below(3));
    return step;
  });
}

ParameterGroup group(const std::vector<std::string>& keywords) {
  ParameterGroup group;
  group.name = name<Name>(keywords);
  group.parameters = up_to(6, [&] { return name<Name>(keywords); });
  group.comments = comments();
  return group;
}

FramesHeader header(const std::vector<std::string>& keywords) {
  FramesHeader header;
  header.model = name<Name>(keywords);
  const auto frame = [&] { return name<Name>(keywords); };
  if (flipped()) header.frames = up_to(5, frame);
  if (header.frames) header.frames->push_back(frame());
  header.groups = up_to(3, [&] { return group(keywords); });
  header.comments = comments();
  return header;
}

// A motion or a transform, except the names of its frames.
template <class Entry>
Entry entry(std::vector<AxisStep> Entry::*its_steps, const std::vector<std::string>& keywords) {
  Entry entry;
  entry.*its_steps = steps(keywords);
  entry.name = maybe([&] { return name<Name>(keywords); });
  entry.comments = comments();
  return entry;
}

motion::Motion one_motion() {
  auto motion = entry(&motion::Motion::steps, motion::keywords());
  motion.from = name<Name>(motion::keywords());
  motion.to = name<Name>(motion::keywords());
  return motion;
}

motion::Document motions() {
  using motion::Convention;
  motion::Document document;
  document.header = header(motion::keywords());
  document.convention = flipped() ? Convention::local : Convention::fixed;
  document.convention_comments = comments();
  document.motions = up_to(5, one_motion);
  document.trailing_comments = comments();
  return document;
}

transforms::Transform one_transform() {
  auto transform = entry(&transforms::Transform::primitives, transforms::keywords());
  transform.left = name<Name>(transforms::keywords());
  transform.right = name<Name>(transforms::keywords());
  return transform;
}

transforms::Document transforms_document() {
  using transforms::MovedFramePosition;
  transforms::Document document;
  document.header = header(transforms::keywords());
  document.position = flipped() ? MovedFramePosition::left : MovedFramePosition::right;
  document.position_comments = comments();
  document.transforms = up_to(5, one_transform);
  document.trailing_comments = comments();
  return document;
}

template <class Document>
void survives_printing(Document (*random)(), Document (*parse)(std::shared_ptr<const Source>, Diagnostics&)) {
  const Document document = *rc::gen::exec(random);
  const std::string text = print(document);
  Diagnostics diagnostics;
  const Document again = parse(test::source(text), diagnostics);
  RC_LOG() << diagnostics.render();
  RC_ASSERT(diagnostics.all().empty());
  RC_ASSERT(equal(document, again));
  RC_ASSERT(print(again) == text);
}

TEST(RandomDocuments, OfRobotsSurvivePrinting) {
  EXPECT_TRUE(rc::check([] { survives_printing(robot, &kinematics::parse); }));
}

TEST(RandomDocuments, OfDesiredTransformsSurvivePrinting) {
  EXPECT_TRUE(rc::check([] { survives_printing(list, &desired::parse); }));
}

TEST(RandomDocuments, OfMotionsSurvivePrinting) {
  EXPECT_TRUE(rc::check([] { survives_printing(motions, &motion::parse); }));
}

TEST(RandomDocuments, OfTransformsSurvivePrinting) {
  EXPECT_TRUE(rc::check([] { survives_printing(transforms_document, &transforms::parse); }));
}

// Checks that the random documents contain every construct of the syntax.
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
  const auto generator = rc::gen::exec(robot);
  for (int i = 0; i < 100; ++i) {
    const kinematics::Document d = generator(random.split(), rc::kNominalSize).value();
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
