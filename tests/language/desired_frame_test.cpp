// Names of frames, with and without an instance of a part.
#include "language/desired/parse_frame.h"

#include "desired_cursor.h"

namespace robcogen::language::desired::desired_frame_test {
namespace {

using test::DesiredText;

TEST(DesiredFrame, StandsAloneOrInAnInstance) {
  DesiredText at("foot leg.foot left.foot ^left");
  const Name alone = read_frame(at.cursor, Name::kNoLoop);
  EXPECT_EQ(alone.text, "foot");
  EXPECT_EQ(alone.instance, "");
  EXPECT_EQ(alone.loop, Name::kNoLoop);
  const Name scoped = read_frame(at.cursor, 2);
  EXPECT_EQ(scoped.text, "foot");
  EXPECT_EQ(scoped.instance, "leg");
  EXPECT_EQ(scoped.loop, 2);
  EXPECT_EQ(scoped.span.begin, 5u);
  EXPECT_EQ(scoped.span.end, 13u);
  EXPECT_EQ(scoped.instance_span.end, 8u);
  EXPECT_EQ(read_frame(at.cursor, Name::kNoLoop).instance, "left");
  EXPECT_EQ(read_frame(at.cursor, Name::kNoLoop).text, "left");
  EXPECT_TRUE(at.cursor.at_end());
  EXPECT_TRUE(at.diagnostics.all().empty());
}

TEST(DesiredFrame, IsNotAKeyword) {
  for (const char* text : {"left", "base", "leg.base", "3"}) {
    DesiredText at(text);
    EXPECT_THROW(read_frame(at.cursor, Name::kNoLoop), SyntaxError) << text;
    EXPECT_EQ(at.codes().size(), 1u) << text;
  }
}

TEST(DesiredFrame, MayBeCalledAsASection) {
  DesiredText at("Contacts, Contacts {");
  EXPECT_TRUE(at_section_word(at.cursor));
  EXPECT_FALSE(at_section(at.cursor));
  EXPECT_EQ(read_frame(at.cursor, Name::kNoLoop).text, "Contacts");
  at.cursor.take();
  EXPECT_TRUE(at_section(at.cursor));
}

}  // namespace
}  // namespace robcogen::language::desired::desired_frame_test
