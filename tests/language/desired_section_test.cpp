// Sections: what they add to the document and where they end.
#include "language/desired/parse_section.h"

#include <tuple>

#include "desired_cursor.h"

namespace robcogen::language::desired::desired_section_test {
namespace {

using test::Codes;
using test::DesiredText;

Document read(DesiredText& at) {
  Document document;
  const Token word = at.cursor.take();
  read_section(at.cursor, word, document);
  return document;
}

TEST(DesiredSection, AddsToItsList) {
  for (const auto& [text, frames, transforms, jacobians, contacts] :
       {std::tuple("Frames { A, B }", 2u, 0u, 0u, 0u),
        {"Transforms { A <- B A -> B A <- C }", 0u, 3u, 0u, 0u},
        {"Jacobians { base = A target = B }", 0u, 0u, 1u, 0u},
        {"Contacts { A, surface B }", 0u, 0u, 0u, 2u},
        {"InverseKinematics { A <- B point }", 0u, 0u, 0u, 0u}}) {
    DesiredText at(text);
    const Document document = read(at);
    EXPECT_EQ(document.frames.size(), frames) << text;
    EXPECT_EQ(document.transforms.size(), transforms) << text;
    EXPECT_EQ(document.jacobians.size(), jacobians) << text;
    EXPECT_EQ(document.contacts.size(), contacts) << text;
    EXPECT_EQ(document.inverses.size(), std::string(text).starts_with("Inverse") ? 1u : 0u) << text;
    EXPECT_TRUE(at.cursor.at_end()) << text;
    EXPECT_TRUE(at.diagnostics.all().empty()) << text;
  }
}

TEST(DesiredSection, FunctionsHaveParts) {
  DesiredText at("Functions { control = a + b.c.d  + transforms::motion::A_X_B other = ^Frames + e }");
  const Document document = read(at);
  EXPECT_TRUE(at.diagnostics.all().empty());
  ASSERT_EQ(document.functions.size(), 2u);
  EXPECT_EQ(document.functions[0].name.text, "control");
  std::vector<std::string> parts;
  for (const Function& f : document.functions)
    for (const Name& part : f.parts) parts.push_back(part.text);
  EXPECT_EQ(parts, (std::vector<std::string>{"a", "b.c.d", "transforms.motion.A_X_B", "Frames", "e"}));
}

// An element knows its loop; elements before and after a loop belong to none.
TEST(DesiredSection, KnowsTheLoopsOfItsElements) {
  DesiredText at("Transforms { A <- B  for s in { x } { A <- s.B }  C <- D  for s in { y } { A <- s.B  s.A <- B } }");
  const Document document = read(at);
  std::vector<int> loops;
  for (const Pair& pair : document.transforms) loops.push_back(loop_of(pair));
  EXPECT_EQ(loops, (std::vector<int>{Name::kNoLoop, 0, Name::kNoLoop, 1, 1}));
  ASSERT_EQ(document.loops.size(), 2u);
  EXPECT_EQ(document.loops[1].instances[0].text, "y");
}

TEST(DesiredSection, EndsBeforeTheNextOne) {
  for (const char* text : {"Frames { A Contacts { B }", "Transforms { A <- B Contacts { B }"}) {
    DesiredText at(text);
    EXPECT_THROW(read(at), SyntaxError) << text;
    EXPECT_TRUE(at_section(at.cursor)) << text;
    EXPECT_EQ(at.codes(), Codes{"missing-brace"}) << text;
  }
}

TEST(DesiredSection, ReadsPairsBehindAnError) {
  DesiredText at("Transforms {\n A B\n B <- C\n}");
  const Document document = read(at);
  ASSERT_EQ(document.transforms.size(), 1u);
  EXPECT_EQ(document.transforms[0].left.text, "B");
  EXPECT_EQ(at.codes().size(), 1u);
}

}  // namespace
}  // namespace robcogen::language::desired::desired_section_test
