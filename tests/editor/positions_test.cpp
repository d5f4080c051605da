// Positions, compared with the code units into which the standard library converts the text.
#include "server/positions.h"

#include <gtest/gtest.h>

#include <codecvt>
#include <locale>
#include <random>

namespace robcogen::server::positions_test {
namespace {

std::u16string units_of(const std::string& text) {
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wdeprecated-declarations"
  return std::wstring_convert<std::codecvt_utf8_utf16<char16_t>, char16_t>().from_bytes(text);
#pragma GCC diagnostic pop
}

Positions positions_in(const std::string& text, PositionEncoding encoding = PositionEncoding::utf16) {
  return {std::make_shared<const Source>("test", text), encoding};
}

TEST(Positions, CharactersBeyondTheFirstPlaneAreTwo) {
  const std::string text = "a // \U0001F916 \xc3\xa9 b\nc";
  const Positions utf16 = positions_in(text), utf8 = positions_in(text, PositionEncoding::utf8);
  EXPECT_EQ(utf16.position(text.find('b')).character, 10U);
  EXPECT_EQ(utf8.position(text.find('b')).character, 13U);
  EXPECT_EQ(utf16.offset(Position{0, 10}), text.find('b'));
  EXPECT_EQ(utf8.offset(Position{0, 13}), text.find('b'));
  EXPECT_EQ(utf16.offset(Position{0, 6}), 5U) << "inside of a pair: where the character begins";
}

TEST(Positions, OfRandomTexts) {
  std::mt19937 dice(7);
  const std::vector<std::string> pieces = {"a", " ", "{", "\xc3\xa9", "\xe2\x82\xac", "\U0001F916", "\n", "\r\n"};
  for (int round = 0; round < 100; ++round) {
    std::string text;
    std::vector<std::size_t> begins;
    std::vector<std::pair<std::size_t, std::size_t>> expected;  // line and code unit of each piece
    std::size_t line = 0, line_begin = 0;
    for (int i = 0; i < 1000; ++i) {
      const std::string& piece = pieces[dice() % (round % 2 == 0 ? pieces.size() : 6)];
      begins.push_back(text.size());
      expected.emplace_back(line, units_of(text.substr(line_begin)).size());
      text += piece;
      if (piece.back() == '\n') {
        ++line;
        line_begin = text.size();
      }
    }
    const Positions positions = positions_in(text);
    for (std::size_t i = 0; i < begins.size(); ++i) {
      const Position p = positions.position(begins[i]);
      ASSERT_EQ(p.line, expected[i].first);
      ASSERT_EQ(p.character, expected[i].second) << "piece " << i << " of round " << round;
      ASSERT_EQ(positions.offset(p), begins[i]);
    }
  }
}

TEST(Positions, BeyondTheTextAreItsEnds) {
  const Positions positions = positions_in("ab\ncd");
  EXPECT_EQ(positions.offset(Position{0, 99}), 2U);
  EXPECT_EQ(positions.offset(Position{1, 99}), 5U);
  EXPECT_EQ(positions.offset(Position{99, 0}), 5U);
  EXPECT_EQ(positions.offset(Json{{"line", -1}, {"character", -1}}), 5U);
}

}  // namespace
}  // namespace robcogen::server::positions_test
