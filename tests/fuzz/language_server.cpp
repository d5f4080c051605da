// The language server: the text is sent to it as an editor's stream, and as documents that an editor changes.
#include <algorithm>
#include <array>

#include "server/serve.h"
#include "server/session.h"
#include "survives_printing.h"

namespace {

using robcogen::server::Json;

// Sends the text as a stream of frames, after a session has begun: the server must answer the request that follows.
void as_a_stream(const std::string& text) {
  namespace server = robcogen::server;
  const Json begin = {{"jsonrpc", "2.0"}, {"id", 1}, {"method", "initialize"}, {"params", Json::object()}};
  const auto framed = [](const Json& message) {
    const std::string content = server::text_of(message);
    return "Content-Length: " + std::to_string(content.size()) + "\r\n\r\n" + content;
  };
  const std::string bytes = framed(begin) + text;
  std::size_t at = 0, written = 0;
  server::serve(
      [&](char* target, std::size_t size) {
        const std::size_t count = std::min({size, std::size_t{997}, bytes.size() - at});
        bytes.copy(target, count, at);
        at += count;
        return count;
      },
      [&](std::string_view answer) { written += answer.size(); });
  robcogen::fuzz::require(written > 0, "no answer", text);
}

// Strings in JSON are UTF-8.
std::string as_utf8(const std::string& text) {
  return Json::parse(robcogen::server::text_of(text)).get<std::string>();
}

class Editor {
 public:
  Editor() { send("initialize", Json::object(), true); }

  void open(const std::string& uri, const std::string& text) {
    send("textDocument/didOpen", {{"textDocument", {{"uri", uri}, {"version", 1}, {"text", text}}}}, false);
  }
  void change(const std::string& uri, const std::string& text) {
    send(
        "textDocument/didChange",
        {{"textDocument", {{"uri", uri}, {"version", 2}}}, {"contentChanges", Json::array({{{"text", text}}})}}, false);
  }
  // Sends every request that the server answers, for a position in the document.
  void ask_everything(const std::string& uri, std::size_t line, std::size_t character) {
    const Json at = {{"line", line}, {"character", character}};
    for (const char* method : kMethods)
      send(
          method,
          {{"textDocument", {{"uri", uri}}},
           {"position", at},
           {"range", {{"start", {{"line", 0}, {"character", 0}}}, {"end", at}}},
           {"context", {{"diagnostics", Json::array()}, {"includeDeclaration", true}}},
           {"options", {{"tabSize", 4}, {"insertSpaces", true}}},
           {"newName", "renamed"}},
          true);
  }

 private:
  static constexpr std::array kMethods = {
      "textDocument/codeAction",
      "textDocument/completion",
      "textDocument/formatting",
      "textDocument/inlayHint",
      "textDocument/semanticTokens/full",
      "textDocument/definition",
      "textDocument/documentHighlight",
      "textDocument/documentSymbol",
      "textDocument/foldingRange",
      "textDocument/hover",
      "textDocument/prepareRename",
      "textDocument/references",
      "textDocument/rename"};
  robcogen::server::Session session_;

  void send(const char* method, const Json& parameters, bool is_request) {
    Json message = {{"jsonrpc", "2.0"}, {"method", method}, {"params", parameters}};
    if (is_request) message["id"] = 1;
    bool is_message = false;
    for (const Json& answer : session_.receive(robcogen::server::text_of(message), is_message)) {
      const bool is_fault = answer.contains("error") && answer["error"]["code"] == -32603;
      robcogen::fuzz::require(!is_fault, "an internal fault", answer.dump());
    }
  }
};

void as_documents(const std::string& text) {
  Editor editor;
  const std::string robot = "file:///fuzz/robot.kindsl", list = "file:///fuzz/robot.dtdsl";
  const std::size_t half = text.size() / 2;
  editor.open(robot, text);
  editor.open(list, text);
  for (const char* uri : {robot.c_str(), list.c_str()}) editor.ask_everything(uri, half % 100, half % 40);
  editor.change(robot, as_utf8(text.substr(0, half)));
  editor.change(robot, as_utf8(text.substr(half)));
  for (const char* uri : {robot.c_str(), list.c_str()}) editor.ask_everything(uri, half % 7, half % 11);
  for (const char* uri : {"file:///fuzz/a.motdsl", "file:///fuzz/a.ctdsl", "file:///fuzz/a.urdf"}) {
    editor.open(uri, text);
    editor.ask_everything(uri, half % 10, half % 20);
  }
}

}  // namespace

// NOLINTNEXTLINE(readability-identifier-naming): libFuzzer calls it
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string text(reinterpret_cast<const char*>(data), size);
  as_a_stream(text);
  as_documents(as_utf8(text));
  return 0;
}
