// Runs the server as a process.
#include "client.h"
#include "run_tool.h"

namespace robcogen::test::process_test {
namespace {

const std::string kBegin = frames({request(1, "initialize"), notification("initialized")});

TEST(Process, EndsWithTheStatusOfTheProtocol) {
  EXPECT_EQ(run_tool("language-server", kBegin + frames({request(2, "shutdown"), notification("exit")})).status, 0);
  EXPECT_EQ(run_tool("language-server --stdio", kBegin + frames({notification("exit")})).status, 1);
  EXPECT_EQ(run_tool("language-server", kBegin).status, 1);
  EXPECT_EQ(run_tool("language-server", "").status, 1);
  EXPECT_EQ(run_tool("language-server --stdi", "").status, 2);
}

TEST(Process, WritesNothingButTheProtocol) {
  const std::string text = contents(robot("hyl"));
  const Json item = {{"uri", file_uri(robot("hyl"))}, {"languageId", "kindsl"}, {"version", 1}, {"text", text}};
  const std::string input = kBegin + frames({notification("textDocument/didOpen", {{"textDocument", item}})}) +
                            frames({request(2, "shutdown"), notification("exit")});
  const Outcome run = run_tool("language-server", input);
  EXPECT_EQ(run.status, 0);
  EXPECT_EQ(run.errors, "");
  server::FrameReader reader;
  reader.feed(run.output);
  std::size_t used = 0, count = 0;
  while (const auto frame = reader.next()) {
    used += server::framed(frame->content).size();
    ++count;
  }
  EXPECT_EQ(used, run.output.size());
  EXPECT_EQ(count, 3U);
}

}  // namespace
}  // namespace robcogen::test::process_test
