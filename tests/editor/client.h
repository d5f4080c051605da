// An editor that talks to the server in memory.
#pragma once

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <functional>
#include <iterator>
#include <map>
#include <string>
#include <vector>

#include "server/framing.h"
#include "server/serve.h"
#include "server/session.h"

namespace robcogen::test {

using server::Json;

inline std::string contents(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

inline std::string file_uri(const std::filesystem::path& path) {
  return "file://" + path.string();
}

inline Json request(int id, const std::string& method, const Json& parameters = Json::object()) {
  return {{"jsonrpc", "2.0"}, {"id", id}, {"method", method}, {"params", parameters}};
}

inline Json notification(const std::string& method, const Json& parameters = Json::object()) {
  return {{"jsonrpc", "2.0"}, {"method", method}, {"params", parameters}};
}

inline std::string frames(const std::vector<Json>& messages) {
  std::string bytes;
  for (const Json& message : messages) bytes += server::framed(server::text_of(message));
  return bytes;
}

struct Transcript {
  std::vector<Json> answers;
  bool ended_well = false;
};

// Runs the server on these bytes, which arrive in pieces of size `piece`.
inline Transcript served(const std::string& bytes, std::size_t piece = 1 << 20) {
  std::size_t at = 0;
  std::string output;
  Transcript transcript;
  transcript.ended_well = server::serve(
      [&](char* target, std::size_t size) {
        const std::size_t count = std::min({size, piece, bytes.size() - at});
        bytes.copy(target, count, at);
        at += count;
        return count;
      },
      [&](std::string_view written) { output += written; });
  server::FrameReader reader;
  reader.feed(output);
  while (const auto frame = reader.next()) {
    EXPECT_EQ(frame->fault, "");
    transcript.answers.push_back(Json::parse(frame->content));
  }
  return transcript;
}

// An initialised session, with UTF-8 positions by default.
class Client {
 public:
  explicit Client(const std::filesystem::path& folder = {}, bool utf8 = true) {
    Json parameters = {{"capabilities", Json::object()}};
    if (utf8) parameters["capabilities"]["general"]["positionEncodings"] = {"utf-16", "utf-8"};
    if (!folder.empty()) parameters["rootUri"] = file_uri(folder);
    capabilities = ask("initialize", parameters).at("capabilities");
    tell("initialized");
  }

  // Returns the result, or null with `error` set.
  Json ask(const std::string& method, const Json& parameters) {
    error = nullptr;
    const std::vector<Json> answers = send(request(++id_, method, parameters));
    EXPECT_EQ(answers.size(), 1U);
    EXPECT_EQ(answers.at(0).at("id"), id_);
    if (answers[0].contains("error")) {
      error = answers[0]["error"];
      return nullptr;
    }
    return answers[0].at("result");
  }
  // Asks about a position in a document.
  Json ask_at(
      const std::string& method,
      const std::string& uri,
      const std::string& word,
      Json parameters = Json::object()) {
    parameters["textDocument"] = {{"uri", uri}};
    parameters["position"] = position(uri, word);
    return ask(method, parameters);
  }
  Json ask_about(const std::string& method, const std::string& uri, Json parameters = Json::object()) {
    parameters["textDocument"] = {{"uri", uri}};
    return ask(method, parameters);
  }

  void tell(const std::string& method, const Json& parameters = Json::object()) {
    for (const Json& message : send(notification(method, parameters))) keep(message);
  }
  void open(const std::string& uri, const std::string& text, const std::string& language = "") {
    texts[uri] = text;
    const Json item = {{"uri", uri}, {"languageId", language}, {"version", ++version_}, {"text", text}};
    tell("textDocument/didOpen", {{"textDocument", item}});
  }
  void change(const std::string& uri, const std::string& text) {
    texts[uri] = text;
    tell(
        "textDocument/didChange", {{"textDocument", {{"uri", uri}, {"version", ++version_}}},
                                   {"contentChanges", Json::array({{{"text", text}}})}});
  }
  void close(const std::string& uri) { tell("textDocument/didClose", {{"textDocument", {{"uri", uri}}}}); }

  // The position of the first occurrence of the word, in which a bar may mark the exact place: `li|nk`.
  Json position(const std::string& uri, std::string word) const {
    const std::string& text = texts.at(uri);
    const std::size_t mark = word.find('|');
    if (mark != std::string::npos) word.erase(mark, 1);
    const std::size_t found = text.find(word);
    EXPECT_NE(found, std::string::npos) << word;
    const std::size_t at = found + (mark == std::string::npos ? 0 : mark);
    const auto line = std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(at), '\n');
    const std::size_t begin = at == 0 ? std::string::npos : text.rfind('\n', at - 1);
    return {{"line", line}, {"character", at - (begin == std::string::npos ? 0 : begin + 1)}};
  }

  std::vector<std::string> codes(const std::string& uri) const {
    std::vector<std::string> result;
    const auto found = diagnostics.find(uri);
    if (found == diagnostics.end()) return result;
    for (const Json& d : found->second) result.push_back(d.value("code", ""));
    return result;
  }

  Json capabilities;
  Json error;
  std::map<std::string, Json> diagnostics;  // latest of each document
  std::vector<Json> others;                 // notifications other than diagnostics
  std::map<std::string, std::string> texts;

 private:
  server::Session session_;
  int id_ = 0, version_ = 0;

  std::vector<Json> send(const Json& message) {
    bool is_message = false;
    return session_.receive(server::text_of(message), is_message);
  }
  void keep(const Json& message) {
    if (message.at("method") == "textDocument/publishDiagnostics")
      diagnostics[message["params"]["uri"]] = message["params"]["diagnostics"];
    else
      others.push_back(message);
  }
};

// Applies changes in the form of the protocol, with positions counted in bytes.
inline std::string edited(const std::string& text, const Json& edits) {
  std::vector<std::size_t> lines = {0};
  for (std::size_t i = 0; i < text.size(); ++i)
    if (text[i] == '\n') lines.push_back(i + 1);
  const auto offset = [&](const Json& p) {
    const auto line = p.at("line").get<std::size_t>();
    return line < lines.size() ? lines[line] + p.at("character").get<std::size_t>() : text.size();
  };
  std::map<std::size_t, std::pair<std::size_t, std::string>> changes;
  for (const Json& edit : edits) {
    const std::size_t begin = offset(edit.at("range").at("start")), end = offset(edit.at("range").at("end"));
    EXPECT_TRUE(changes.insert({begin, {end, edit.at("newText").get<std::string>()}}).second) << edit;
  }
  std::string result;
  std::size_t at = 0;
  for (const auto& [begin, change] : changes) {
    EXPECT_LE(at, begin) << "edits overlap";
    result += text.substr(at, begin - at) + change.second;
    at = change.first;
  }
  return result + text.substr(at);
}

}  // namespace robcogen::test
