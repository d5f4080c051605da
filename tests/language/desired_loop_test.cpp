// Heads of loops over instances of parts.
#include "language/desired/parse_loop.h"

#include "desired_cursor.h"

namespace robcogen::language::desired::desired_loop_test {
namespace {

using test::Codes;
using test::DesiredText;

TEST(DesiredLoop, HasAVariableAndInstances) {
  DesiredText at("for side in { left, ^base } { side.tip }");
  ASSERT_TRUE(at_loop(at.cursor));
  const LoopHead head = read_loop_head(at.cursor, Name::kNoLoop, "a frame");
  EXPECT_EQ(head.loop.variable.text, "side");
  ASSERT_EQ(head.loop.instances.size(), 2u);
  EXPECT_EQ(head.loop.instances[0].text, "left");
  EXPECT_EQ(head.loop.instances[1].text, "base");
  EXPECT_EQ(head.open.span.begin, 28u);
  EXPECT_TRUE(at_instance(at.cursor));
  EXPECT_TRUE(at.diagnostics.all().empty());
}

TEST(DesiredLoop, BeginsWithTheseWordsOnly) {
  for (const char* text : {"for", "for, in", "for -> in", "for in", "side in { left }"})
    EXPECT_FALSE(at_loop(DesiredText(text).cursor)) << text;
}

TEST(DesiredLoop, DoesNotNest) {
  DesiredText at("for side in { left } { side.tip }");
  EXPECT_THROW(read_loop_head(at.cursor, 0, "a frame"), SyntaxError);
  EXPECT_EQ(at.codes(), Codes{"nested-loop"});
}

TEST(DesiredLoop, IsNotEmpty) {
  DesiredText at("for side in { left } { }");
  EXPECT_THROW(read_loop_head(at.cursor, Name::kNoLoop, "a frame"), SyntaxError);
  EXPECT_EQ(at.diagnostics.all().front().message, "expected a frame in the loop, found '}'");
}

TEST(DesiredLoop, IsReadBehindAnErrorInItsInstances) {
  DesiredText at("for side in { left 3 } { side.tip }");
  EXPECT_EQ(read_loop_head(at.cursor, Name::kNoLoop, "a frame").loop.instances.size(), 1u);
  EXPECT_TRUE(at_instance(at.cursor));
  EXPECT_EQ(at.codes(), Codes{"unexpected-token"});
}

}  // namespace
}  // namespace robcogen::language::desired::desired_loop_test
