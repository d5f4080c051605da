// Frames that arrive in pieces, and broken frames.
#include "client.h"

namespace robcogen::test::framing_test {
namespace {

std::vector<Json> greeting() {
  return {request(1, "initialize"), notification("initialized"), request(2, "shutdown"), notification("exit")};
}

TEST(Framing, IsTheOneOfTheProtocol) {
  EXPECT_EQ(server::framed("{}"), "Content-Length: 2\r\n\r\n{}");
  EXPECT_EQ(server::framed("\"\xc3\xa9\""), "Content-Length: 4\r\n\r\n\"\xc3\xa9\"");  // the length counts bytes
}

TEST(Framing, PiecesOfAnySize) {
  const std::string bytes = frames(greeting());
  const std::vector<Json> whole = served(bytes).answers;
  ASSERT_EQ(whole.size(), 2U);
  for (std::size_t piece = 1; piece < 70; ++piece) {
    const Transcript transcript = served(bytes, piece);
    EXPECT_EQ(transcript.answers, whole) << piece;
    EXPECT_TRUE(transcript.ended_well);
  }
}

TEST(Framing, FieldsInAnyCaseAndOrder) {
  const std::string content = server::text_of(request(1, "initialize"));
  const std::string type = "Content-Type: application/vscode-jsonrpc; charset=utf-8\r\n";
  for (const char* name : {"Content-Length: ", "content-length:", "CONTENT-LENGTH:  "}) {
    const std::string length = name + std::to_string(content.size()) + "\r\n";
    for (const std::string& header : {length + type, type + length}) {
      const Transcript transcript = served(header + "\r\n" + content);
      ASSERT_EQ(transcript.answers.size(), 1U) << header;
      EXPECT_TRUE(transcript.answers[0].contains("result")) << header;
    }
  }
}

// The server answers each broken piece with one error without an id, and then answers the messages after it.
TEST(Framing, GoesOnAfterBrokenFrames) {
  const std::string before = frames({request(1, "initialize")}), after = frames({request(2, "shutdown")});
  const std::vector<std::string> broken = {
      "Content-Length: twelve\r\n\r\n{}",
      "Content-Length: -1\r\n\r\n",
      "Content-Length: 12345678901234567890123\r\n\r\n",
      "Content-Length: 999999999999\r\n\r\n",
      "Content-Type: text\r\n\r\nsome text ",
      "Content-Length: 7\r\n\r\nnot it ",
      "Content-Length: 2\r\n\r\n{]",
      "Content-Length: 0\r\n\r\n",
      std::string("Content-Length: 3\r\n\r\n\0\x01\xff", 24),
      "Content-Length: 999\r\nwithout an empty line " + std::string(5000, '.') + "\r\n",
      std::string(100000, 'x'),
      "{\"jsonrpc\": \"2.0\"}\r\n\r\n"};
  for (const std::string& piece : broken) {
    for (const std::size_t size : {std::size_t{1}, std::size_t{1000}, std::size_t{1} << 20}) {
      const Transcript transcript = served(before + piece + after, size);
      ASSERT_EQ(transcript.answers.size(), 3U) << piece.substr(0, 60);
      EXPECT_EQ(transcript.answers[1].at("error").at("code"), -32700) << piece.substr(0, 60);
      EXPECT_EQ(transcript.answers[1].at("id"), nullptr);
      EXPECT_EQ(transcript.answers[2].at("id"), 2) << piece.substr(0, 60);
    }
  }
}

// If a frame's length is too large, the beginning of the next frame is swallowed, and the rest is read again.
TEST(Framing, ALengthThatIsTooLargeLosesOneMessage) {
  const std::string bytes = frames({request(1, "initialize")}) + "Content-Length: 30\r\n\r\n{}" +
                            frames({request(2, "shutdown"), request(3, "shutdown")});
  const Transcript transcript = served(bytes);
  ASSERT_EQ(transcript.answers.size(), 4U);
  EXPECT_EQ(transcript.answers[2].at("id"), 2);
  EXPECT_EQ(transcript.answers[3].at("id"), 3);
}

}  // namespace
}  // namespace robcogen::test::framing_test
