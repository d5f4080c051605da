// The life cycle of a session, and mistakes that an editor may make.
#include "client.h"
#include "run_tool.h"

namespace robcogen::test::session_test {
namespace {

int error_code(const Json& answer) {
  return answer.contains("error") ? answer["error"]["code"].get<int>() : 0;
}

TEST(Session, BeginsAndEnds) {
  const Transcript transcript = served(frames(
      {request(1, "textDocument/hover"), request(2, "initialize"), notification("initialized"),
       request(3, "initialize"), request(4, "no/such"), request(5, "shutdown"), request(6, "textDocument/hover"),
       notification("exit"), request(7, "shutdown")}));
  ASSERT_EQ(transcript.answers.size(), 6U) << "nothing follows 'exit'";
  const std::vector<int> errors = {-32002, 0, -32600, -32601, 0, -32600};
  for (std::size_t i = 0; i < errors.size(); ++i) {
    EXPECT_EQ(transcript.answers[i].at("id"), static_cast<int>(i + 1));
    EXPECT_EQ(error_code(transcript.answers[i]), errors[i]) << transcript.answers[i];
  }
  EXPECT_TRUE(transcript.answers[4].at("result").is_null());
  EXPECT_TRUE(transcript.ended_well);
}

TEST(Session, ThatEndsWithoutShutdownDoesNotEndWell) {
  EXPECT_FALSE(served(frames({request(1, "initialize"), notification("exit")})).ended_well);
  EXPECT_FALSE(served(frames({request(1, "initialize")})).ended_well);
  EXPECT_FALSE(served("").ended_well);
  EXPECT_TRUE(served(frames({request(1, "initialize"), request(2, "shutdown")})).ended_well);
}

TEST(Session, TakesUtf8WhereItIsOffered) {
  EXPECT_EQ(Client({}, true).capabilities.at("positionEncoding"), "utf-8");
  EXPECT_EQ(Client({}, false).capabilities.at("positionEncoding"), "utf-16");
}

TEST(Session, NotificationsItDoesNotKnowAreIgnored) {
  Client client;
  client.tell("$/cancelRequest", {{"id", 7}});
  client.tell("$/setTrace", {{"value", "off"}});
  client.tell("workspace/didChangeConfiguration", {{"settings", nullptr}});
  client.tell("no/such/thing");
  EXPECT_TRUE(client.others.empty());
}

TEST(Session, SurvivesMessagesOfAnyShape) {
  const std::vector<Json> odd = {
      nullptr,
      3,
      "text",
      Json::array(),
      Json::object(),
      {{"id", 1}},
      {{"method", 3}},
      {{"id", nullptr}, {"method", "x"}},
      {{"method", "textDocument/didOpen"}},
      {{"method", "textDocument/didOpen"}, {"params", 3}},
      {{"method", "textDocument/didChange"}, {"params", {{"textDocument", nullptr}}}},
      notification("textDocument/didChange", {{"textDocument", {{"uri", 3}}}}),
      notification("textDocument/didClose", Json::array()),
      request(9, "textDocument/codeAction", Json::array()),
      request(9, "textDocument/codeAction", {{"textDocument", {{"uri", "file:///x.kindsl"}}}})};
  std::vector<Json> messages = {request(1, "initialize")};
  messages.insert(messages.end(), odd.begin(), odd.end());
  messages.push_back(request(2, "shutdown"));
  const Transcript transcript = served(frames(messages));
  EXPECT_EQ(transcript.answers.back().at("id"), 2);
  EXPECT_TRUE(transcript.ended_well);
}

TEST(Session, ChangesOfUnknownFilesAreIgnoredWithAWarning) {
  Client client;
  client.texts["file:///a.kindsl"] = "";
  client.change("file:///a.kindsl", "Robot");
  ASSERT_EQ(client.others.size(), 1U);
  EXPECT_EQ(client.others[0].at("method"), "window/logMessage");
  EXPECT_TRUE(client.diagnostics.empty());
  client.close("file:///a.kindsl");
  EXPECT_TRUE(client.diagnostics.empty());
}

// Editors send range changes only if the server asks for them; a range change that arrives all the same is understood.
TEST(Session, ChangesOfRangesAreUnderstood) {
  Client client({}, false);
  client.open("file:///a.dtdsl", "// \U0001F916 Robbot\n");
  EXPECT_EQ(client.codes("file:///a.dtdsl").size(), 1U);
  const Json range = {{"start", {{"line", 0}, {"character", 0}}}, {"end", {{"line", 0}, {"character", 6}}}};
  client.tell(
      "textDocument/didChange", {{"textDocument", {{"uri", "file:///a.dtdsl"}, {"version", 2}}},
                                 {"contentChanges", Json::array({{{"range", range}, {"text", ""}}})}});
  const Json& d = client.diagnostics.at("file:///a.dtdsl").at(0);
  EXPECT_EQ(d.at("code"), "unexpected-token");
  EXPECT_NE(d.at("message").get<std::string>().find("did you mean 'Robot'?"), std::string::npos) << d;
}

constexpr const char* kPartInFolder =
    "Part Leg {\n    root hip via HAA\n    link hip { children {} }\n"
    "    r_joint HAA { ref_frame { translation = (0.0, 0.0, 0.0)  rotation = (0.0, 0.0, 0.0) } }\n}\n";
constexpr const char* kImporter =
    "import \"leg.kindsl\"\nRobot Biped { RobotBase trunk { children { Leg left() } } }\n";

// Parts in folders that the command line or the editor names. Relative folders are relative to the workspace.
TEST(Session, ImportsFromFolders) {
  const Scratch scratch("import-folders");
  for (const char* folder : {"of_command", "of_editor"}) {
    std::filesystem::create_directory(scratch.path / folder);
    write_text(scratch.path / folder / (std::string(folder) + ".kindsl"), kPartInFolder);
  }
  const std::string uri = file_uri(scratch.path / "biped.kindsl");
  const auto told = [&](const std::string& import, const Json& options) {
    server::Session session({scratch.path / "of_command"});
    bool is_message = false;
    const Json item = {
        {"uri", uri},
        {"text", "import \"" + import + ".kindsl\"\nRobot Biped { RobotBase trunk { children { Leg left() } } }\n"}};
    session.receive(
        server::text_of(request(
            1, "initialize",
            {{"rootUri", file_uri(scratch.path)},
             {"initializationOptions", options},
             {"capabilities", Json::object()}})),
        is_message);
    return session.receive(server::text_of(notification("textDocument/didOpen", {{"textDocument", item}})), is_message)
        .at(0)
        .at("params")
        .at("diagnostics")
        .dump();
  };
  const std::string missing = "unknown-file";
  EXPECT_EQ(told("of_command", Json::object()).find(missing), std::string::npos);
  EXPECT_NE(told("of_editor", Json::object()).find(missing), std::string::npos);
  EXPECT_EQ(told("of_editor", {{"importFolders", {"of_editor"}}}).find(missing), std::string::npos);
  EXPECT_EQ(
      told("of_editor", {{"importFolders", {(scratch.path / "of_editor").string()}}}).find(missing), std::string::npos);
  // Options of the wrong type are ignored.
  for (const Json& wrong : {Json({{"importFolders", "of_editor"}}), Json({{"importFolders", {1}}}), Json(3)})
    EXPECT_NE(told("of_editor", wrong).find(missing), std::string::npos);
}

// Folders are added and removed while documents are open. Settings about anything else are ignored.
TEST(Session, FollowsSettingsAndFolders) {
  const Scratch scratch("settings");
  std::filesystem::create_directory(scratch.path / "parts");
  write_text(scratch.path / "parts" / "leg.kindsl", kPartInFolder);
  const std::string uri = file_uri(scratch.path / "biped.kindsl");
  Client client(scratch.path);
  client.open(uri, kImporter);
  const auto is_found = [&] { return client.diagnostics.at(uri).dump().find("unknown-file") == std::string::npos; };
  const auto set = [&](const Json& settings) {
    client.tell("workspace/didChangeConfiguration", {{"settings", settings}});
  };
  EXPECT_FALSE(is_found());
  set({{"robcogen", {{"path", "robcogen"}, {"importFolders", {"parts"}}}}});
  EXPECT_TRUE(is_found());
  for (const Json& other :
       {Json(nullptr), Json::object(), Json({{"importFolders", 3}}), Json({{"clangd", {{"a", 1}}}})})
    set(other);
  EXPECT_TRUE(is_found());
  const Json folder = {{"uri", file_uri(scratch.path)}, {"name", "robots"}};
  client.tell("workspace/didChangeWorkspaceFolders", {{"event", {{"added", Json::array()}, {"removed", {folder}}}}});
  EXPECT_FALSE(is_found());
  client.tell("workspace/didChangeWorkspaceFolders", {{"event", {{"added", {folder}}, {"removed", Json::array()}}}});
  EXPECT_TRUE(is_found());
  set({{"importFolders", Json::array()}});
  EXPECT_FALSE(is_found());
  EXPECT_TRUE(client.capabilities.at("workspace").at("workspaceFolders").at("changeNotifications").get<bool>());
}

// An editor that sends its settings when asked: at the beginning, and after they have changed.
TEST(Session, AsksForSettings) {
  const Scratch scratch("asked-settings");
  std::filesystem::create_directory(scratch.path / "parts");
  write_text(scratch.path / "parts" / "leg.kindsl", kPartInFolder);
  const std::string uri = file_uri(scratch.path / "biped.kindsl");
  server::Session session;
  const auto tell = [&](const Json& message) {
    bool is_message = false;
    return session.receive(server::text_of(message), is_message);
  };
  const auto respond = [&](const Json& id, const Json& result) {
    return tell({{"jsonrpc", "2.0"}, {"id", id}, {"result", result}});
  };
  tell(request(
      1, "initialize",
      {{"rootUri", file_uri(scratch.path)}, {"capabilities", {{"workspace", {{"configuration", true}}}}}}));
  const std::vector<Json> first = tell(notification("initialized"));
  ASSERT_EQ(first.size(), 1U);
  EXPECT_EQ(first[0].at("method"), "workspace/configuration");
  EXPECT_EQ(first[0].at("params").dump(), R"({"items":[{"section":"robcogen"}]})");
  const auto is_found = [](const std::vector<Json>& published) {
    return published.at(0).at("params").at("diagnostics").dump().find("unknown-file") == std::string::npos;
  };
  EXPECT_FALSE(is_found(tell(
      notification("textDocument/didOpen", {{"textDocument", {{"uri", uri}, {"version", 1}, {"text", kImporter}}}}))));
  EXPECT_TRUE(is_found(respond(first[0].at("id"), {{{"path", "robcogen"}, {"importFolders", {"parts"}}}})));

  const std::vector<Json> second = tell(notification("workspace/didChangeConfiguration", {{"settings", nullptr}}));
  ASSERT_EQ(second.size(), 1U);
  EXPECT_NE(second[0].at("id"), first[0].at("id"));
  // Results of other shapes are ignored, and so are answers to any question but the last one.
  for (const Json& other : {Json(nullptr), Json::array(), Json::array({nullptr}), Json("parts")})
    EXPECT_TRUE(respond(second[0].at("id"), other).empty()) << other;
  const Json none = Json::array({Json({{"importFolders", Json::array()}})});
  for (const Json& id : {first[0].at("id"), Json(1), Json(nullptr)}) EXPECT_TRUE(respond(id, none).empty()) << id;
  EXPECT_FALSE(is_found(respond(second[0].at("id"), none)));
}

TEST(Session, DoesNotAskAnEditorThatGivesNoSettings) {
  for (const Json& workspace : {Json(nullptr), Json::object(), Json({{"configuration", false}}), Json(3)}) {
    const std::vector<Json> answers =
        served(
            frames(
                {request(1, "initialize", {{"capabilities", {{"workspace", workspace}}}}), notification("initialized"),
                 notification("workspace/didChangeConfiguration", {{"settings", nullptr}}), request(2, "shutdown"),
                 notification("exit")}))
            .answers;
    EXPECT_EQ(answers.size(), 2U) << workspace;
  }
}

}  // namespace
}  // namespace robcogen::test::session_test
