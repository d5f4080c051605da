// Motion-DSL and Transforms-DSL documents: how each construct is parsed.
#include "reading.h"

namespace robcogen::language::frames_test {
namespace {

std::string text(const ExpressionPtr& e) {
  return print(*e);
}

TEST(Motions, HaveStepsAlongAndAboutAxesInOrder) {
  const auto d = test::read_motions("Model M Convention = local A -> B : trx(1.0) rotz(q) try(l) rotx(PI/2.0)");
  ASSERT_EQ(d.motions.size(), 1u);
  const motion::Motion& m = d.motions[0];
  EXPECT_EQ(m.from.text, "A");
  EXPECT_EQ(m.to.text, "B");
  ASSERT_EQ(m.steps.size(), 4u);
  EXPECT_FALSE(m.steps[0].rotation);
  EXPECT_TRUE(m.steps[1].rotation);
  EXPECT_EQ(m.steps[0].axis, 0);
  EXPECT_EQ(m.steps[1].axis, 2);
  EXPECT_EQ(m.steps[2].axis, 1);
  EXPECT_EQ(m.steps[3].axis, 0);
  EXPECT_EQ(text(m.steps[3].amount), "PI/2.0");
  EXPECT_FALSE(m.name.has_value());
}

TEST(Motions, KnowBothSpellingsOfAConvention) {
  const auto convention = [](const std::string& word) {
    return test::read_motions("Model M Convention = " + word + " A -> B : rotx(q)").convention;
  };
  EXPECT_EQ(convention("local"), motion::Convention::local);
  EXPECT_EQ(convention("currentFrame"), motion::Convention::local);
  EXPECT_EQ(convention("fixed"), motion::Convention::fixed);
  EXPECT_EQ(convention("fixedFrame"), motion::Convention::fixed);
}

TEST(Motions, MayHaveNoFramesNoStepsAndAName) {
  const auto d = test::read_motions("Model M Convention = fixed A -> B : [rest] B -> C :");
  EXPECT_FALSE(d.header.frames.has_value());
  ASSERT_EQ(d.motions.size(), 2u);
  EXPECT_EQ(d.motions[0].name->text, "rest");
  EXPECT_TRUE(d.motions[0].steps.empty());
}

TEST(Motions, KeepCommentsWithWhatTheyPrecede) {
  const auto d =
      test::read_motions("// m\nModel M // c\nConvention = local\n// a\nA -> B : rotx(q) // b\nB -> C : // end");
  EXPECT_EQ(d.header.comments, (std::vector<std::string>{"// m"}));
  EXPECT_EQ(d.convention_comments, (std::vector<std::string>{"// c"}));
  EXPECT_EQ(d.motions[0].comments, (std::vector<std::string>{"// a"}));
  EXPECT_EQ(d.motions[1].comments, (std::vector<std::string>{"// b"}));
  EXPECT_EQ(d.trailing_comments, (std::vector<std::string>{"// end"}));
}

TEST(Arguments, NameParametersAndConstantsInEveryDialect) {
  const auto d = test::read_motions(
      "Model M Params g { a } Convention = local "
      "A -> B : trx(g.a) trx(p:b) trx(p:c[0.5]) trx(c:d:2.5) trx(c:d) trx(consts.d) trx(e) trx(2*p:b) trx(g.a[1.0])");
  const std::vector<AxisStep>& s = d.motions[0].steps;
  ASSERT_EQ(s.size(), 9u);
  EXPECT_EQ(s[0].amount->group, "g");
  EXPECT_EQ(s[0].amount->name, "a");
  EXPECT_TRUE(s[1].amount->is_parameter);
  EXPECT_EQ(s[2].amount->default_value->value(), 0.5);
  EXPECT_EQ(s[3].amount->kind, Expression::Kind::constant);
  EXPECT_EQ(s[3].amount->left->number.value(), 2.5);
  EXPECT_EQ(s[4].amount->kind, Expression::Kind::constant);
  EXPECT_EQ(s[4].amount->left, nullptr);
  EXPECT_EQ(s[5].amount->kind, Expression::Kind::constant);
  EXPECT_EQ(s[5].amount->name, "d");
  EXPECT_EQ(s[6].amount->kind, Expression::Kind::name);
  EXPECT_FALSE(s[6].amount->is_parameter);
  EXPECT_TRUE(s[7].amount->right->is_parameter);
  EXPECT_EQ(s[8].amount->default_value->value(), 1.0);
}

TEST(Arguments, MembersOfGroupsMayBeKeywords) {
  const auto d = test::read_motions(
      "Model M Params lengths { ^Model } Convention = local A -> B : trx(lengths.^Model) try(consts.^Params)");
  const Expression& parameter = *d.motions[0].steps[0].amount;
  EXPECT_EQ(parameter.group, "lengths");
  EXPECT_EQ(parameter.name, "Model");
  EXPECT_EQ(print(parameter), "lengths.^Model");
  EXPECT_EQ(d.motions[0].steps[1].amount->name, "Params");
}

TEST(Arguments, PointsAreMembersOnlyBetweenNames) {
  const auto d = test::read_motions("Model M Convention = local A -> B : trx(.5) trx(1.) trx(2.5) trx(g.x)");
  EXPECT_EQ(d.motions[0].steps[0].amount->number.value(), 0.5);
  EXPECT_EQ(d.motions[0].steps[1].amount->number.value(), 1.0);
  EXPECT_EQ(d.motions[0].steps[3].amount->group, "g");
}

TEST(Transforms, AreBetweenFramesInBraces) {
  const auto d = test::read_transforms(
      "Model M Frames { A, B } TransformedFramePos = right {A}_X_{B} = Tx(1.0) Rz(-q) [home] { B } _X_ { A } =");
  ASSERT_EQ(d.transforms.size(), 2u);
  const transforms::Transform& t = d.transforms[0];
  EXPECT_EQ(t.left.text, "A");
  EXPECT_EQ(t.right.text, "B");
  ASSERT_EQ(t.primitives.size(), 2u);
  EXPECT_FALSE(t.primitives[0].rotation);
  EXPECT_TRUE(t.primitives[1].rotation);
  EXPECT_EQ(t.primitives[1].axis, 2);
  EXPECT_EQ(text(t.primitives[1].amount), "-q");
  EXPECT_EQ(t.name->text, "home");
  EXPECT_EQ(d.transforms[1].left.text, "B");
  EXPECT_TRUE(d.transforms[1].primitives.empty());
  ASSERT_TRUE(d.header.frames.has_value());
  EXPECT_EQ(d.header.frames->size(), 2u);
}

TEST(Transforms, KnowBothWordsForThePosition) {
  const auto position = [](const std::string& words) {
    return test::read_transforms("Model M " + words + " {A}_X_{B} = Rx(q)").position;
  };
  EXPECT_EQ(position("TransformedFramePos = right"), transforms::MovedFramePosition::right);
  EXPECT_EQ(position("MovedFramePos = right"), transforms::MovedFramePosition::right);
  EXPECT_EQ(position("TransformedFramePos = left"), transforms::MovedFramePosition::left);
  EXPECT_EQ(position("MovedFramePos = left"), transforms::MovedFramePosition::left);
}

TEST(Transforms, GroupsOfParametersAreDeclaredInTheHeader) {
  const auto d = test::read_transforms(
      "Model M Params lengths { a, b } Params angles {} MovedFramePos = left {A}_X_{B} = Tx(lengths.a)");
  ASSERT_EQ(d.header.groups.size(), 2u);
  EXPECT_EQ(d.header.groups[0].name.text, "lengths");
  EXPECT_EQ(d.header.groups[0].parameters.size(), 2u);
  EXPECT_TRUE(d.header.groups[1].parameters.empty());
}

}  // namespace
}  // namespace robcogen::language::frames_test
