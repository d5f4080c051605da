#include "server/session.h"

#include <fmt/format.h>

#include <exception>
#include <system_error>

#include "driver/library.h"
#include "server/answers.h"
#include "server/uri.h"

namespace robcogen::server {
namespace {

// The section of our settings among the settings of an editor.
constexpr const char* kSection = "robcogen";

// The id of a request to the editor.
std::string question(int number) {
  return fmt::format("robcogen.settings.{}", number);
}

Json error_response(const Json& id, ErrorCode code, const std::string& message) {
  return {{"jsonrpc", "2.0"}, {"id", id}, {"error", {{"code", static_cast<int>(code)}, {"message", message}}}};
}

Json warning(const std::string& message) {
  return {{"jsonrpc", "2.0"}, {"method", "window/logMessage"}, {"params", {{"type", 2}, {"message", message}}}};
}

std::vector<std::filesystem::path> folders_of(const Json& parameters) {
  std::vector<std::filesystem::path> folders;
  const Json& list = member(parameters, "workspaceFolders");
  if (list.is_array())
    for (const Json& folder : list)
      if (member(folder, "uri").is_string()) folders.push_back(path_of(folder["uri"].get<std::string>()));
  if (folders.empty() && member(parameters, "rootUri").is_string())
    folders.push_back(path_of(parameters["rootUri"].get<std::string>()));
  return folders;
}

// Returns the folders of the setting `importFolders`; a relative folder is relative to each workspace folder.
std::vector<std::filesystem::path> import_folders_of(
    const Json& settings,
    const std::vector<std::filesystem::path>& workspace_folders) {
  std::vector<std::filesystem::path> folders;
  const Json& list = member(settings, "importFolders");
  for (const Json& name : list.is_array() ? list : Json::array()) {
    if (!name.is_string()) continue;
    const std::filesystem::path folder(name.get<std::string>());
    if (folder.is_absolute()) folders.push_back(folder.lexically_normal());
    if (folder.is_relative())
      for (const std::filesystem::path& of : workspace_folders) folders.push_back((of / folder).lexically_normal());
  }
  return folders;
}

// Uses utf-8 if the editor offers it, because it needs no counting.
PositionEncoding encoding_of(const Json& parameters) {
  const Json& offered = member(member(member(parameters, "capabilities"), "general"), "positionEncodings");
  for (const Json& name : offered.is_array() ? offered : Json::array())
    if (name == "utf-8") return PositionEncoding::utf8;
  return PositionEncoding::utf16;
}

// Returns the text after the changes, each of which replaces the whole text or a range.
std::string changed(const OpenDocument& document, const Json& changes, PositionEncoding encoding) {
  std::string text(document.source->text());
  for (const Json& change : changes) {
    std::string inserted = change.at("text").get<std::string>();
    if (!change.contains("range")) {
      text = std::move(inserted);
      continue;
    }
    const Positions positions(std::make_shared<const Source>("", text), encoding);
    const Span span = positions.span(change["range"]);
    text.replace(span.begin, span.end - span.begin, inserted);
  }
  return text;
}

}  // namespace

Json Session::fault(const std::string& what) {
  return error_response(nullptr, ErrorCode::parse_error, what);
}

Session::Session(const std::vector<std::filesystem::path>& import_folders) {
  std::error_code ignored;
  for (const std::filesystem::path& folder : import_folders)
    import_folders_.push_back(std::filesystem::absolute(folder, ignored).lexically_normal());
}

void Session::set_folders() {
  workspace_.robots().set_folders(workspace_folders_);
  std::vector<std::filesystem::path> folders = import_folders_;
  for (std::filesystem::path& folder : import_folders_of(settings_, workspace_folders_))
    folders.push_back(std::move(folder));
  workspace_.documents().import_folders = std::move(folders);
}

// Editors send their settings directly or under the name of the server; some send settings of other servers, or none.
std::vector<Json> Session::change_settings(const Json& settings) {
  const Json& named = member(settings, kSection);
  const Json& ours = named.is_object() ? named : settings;
  if (!member(ours, "importFolders").is_array()) return {};
  settings_ = ours;
  set_folders();
  workspace_.forget_all();
  return workspace_.publish("");
}

std::vector<Json> Session::ask_settings() {
  if (!gives_settings_) return {};
  return {
      {{"jsonrpc", "2.0"},
       {"id", question(++questions_)},
       {"method", "workspace/configuration"},
       {"params", {{"items", {{{"section", kSection}}}}}}}};
}

// Answers to earlier questions are outdated and are ignored.
std::vector<Json> Session::answered(const Json& id, const Json& result) {
  const bool is_last = questions_ > 0 && id == question(questions_);
  return is_last && result.is_array() && !result.empty() ? change_settings(result.front()) : std::vector<Json>();
}

std::vector<Json> Session::change_folders(const Json& event) {
  for (const std::filesystem::path& removed : folders_of({{"workspaceFolders", member(event, "removed")}}))
    std::erase(workspace_folders_, removed);
  for (std::filesystem::path& added : folders_of({{"workspaceFolders", member(event, "added")}}))
    workspace_folders_.push_back(std::move(added));
  set_folders();
  workspace_.forget_all();
  return workspace_.publish("");
}

Json Session::initialize(const Json& parameters) {
  if (state_ != State::starting) throw RequestError{ErrorCode::invalid_request, "the session is already initialized"};
  state_ = State::running;
  workspace_.encoding = encoding_of(parameters);
  workspace_folders_ = folders_of(parameters);
  settings_ = member(parameters, "initializationOptions");
  gives_settings_ = member(member(member(parameters, "capabilities"), "workspace"), "configuration") == true;
  set_folders();
  Json capabilities = capabilities_of_answers();
  capabilities["positionEncoding"] = workspace_.encoding == PositionEncoding::utf8 ? "utf-8" : "utf-16";
  capabilities["workspace"]["workspaceFolders"] = {{"supported", true}, {"changeNotifications", true}};
  capabilities["textDocumentSync"] = {{"openClose", true}, {"change", 1}, {"save", true}};
  return {
      {"capabilities", std::move(capabilities)}, {"serverInfo", {{"name", "robcogen"}, {"version", driver::kVersion}}}};
}

Json Session::answer(const std::string& method, const Json& parameters) {
  if (method == "initialize") return initialize(parameters);
  if (state_ == State::starting)
    throw RequestError{ErrorCode::server_not_initialized, "the first request must be 'initialize'"};
  if (state_ == State::shut_down)
    throw RequestError{ErrorCode::invalid_request, "the session was shut down: only 'exit' may follow"};
  if (method == "shutdown") {
    state_ = State::shut_down;
    return nullptr;
  }
  const Answer* found = find_answer(method);
  if (found == nullptr) throw RequestError{ErrorCode::method_not_found, fmt::format("no method '{}'", method)};
  return (*found)(workspace_, parameters);
}

std::vector<Json> Session::change(const Json& parameters) {
  const Json& named = parameters.at("textDocument");
  const auto uri = named.at("uri").get<std::string>();
  const OpenDocument* open = workspace_.documents().find(uri);
  if (open == nullptr) return {warning(fmt::format("'{}' is not open: its changes are ignored", uri))};
  const Json& version = member(named, "version");
  std::string text = changed(*open, parameters.at("contentChanges"), workspace_.encoding);
  open = workspace_.documents().change(
      uri, version.is_number_integer() ? version.get<std::int64_t>() : open->version + 1, std::move(text));
  workspace_.forget(open->path);
  return workspace_.publish(uri);
}

// Unknown notifications are ignored, as the protocol demands.
std::vector<Json> Session::notice(const std::string& method, const Json& parameters) {
  if (method == "exit") {
    is_over_ = true;
    return {};
  }
  if (state_ != State::running) return {};
  if (method == "textDocument/didChange") return change(parameters);
  if (method == "textDocument/didOpen") {
    const Json& item = parameters.at("textDocument");
    const auto uri = item.at("uri").get<std::string>();
    workspace_.documents().open(
        uri, item.value("languageId", ""), item.value("version", std::int64_t{0}), item.at("text").get<std::string>());
    workspace_.forget_all();
    return workspace_.publish(uri);
  }
  if (method == "textDocument/didClose") {
    workspace_.documents().close(parameters.at("textDocument").at("uri").get<std::string>());
    workspace_.forget_all();
    return workspace_.publish("");
  }
  if (method == "initialized") return ask_settings();
  if (method == "workspace/didChangeConfiguration") {
    const Json& settings = member(parameters, "settings");
    return settings.is_null() ? ask_settings() : change_settings(settings);
  }
  if (method == "workspace/didChangeWorkspaceFolders") return change_folders(parameters.at("event"));
  if (method == "textDocument/didSave" || method == "workspace/didChangeWatchedFiles") {
    workspace_.forget_all();
    return workspace_.publish("");
  }
  return {};
}

std::vector<Json> Session::handle(const Json& message) {
  const Json& method = member(message, "method");
  const Json& id = member(message, "id");
  if (!method.is_string()) {
    const bool is_response = message.is_object() && (message.contains("result") || message.contains("error"));
    if (is_response) return state_ == State::running ? answered(id, member(message, "result")) : std::vector<Json>();
    return {error_response(id, ErrorCode::invalid_request, "not a request: it has no method")};
  }
  if (!message.contains("id")) {
    try {
      return notice(method.get<std::string>(), member(message, "params"));
    } catch (const Json::exception& wrong) {
      return {warning(fmt::format("'{}' was ignored: {}", method.get<std::string>(), wrong.what()))};
    }
  }
  try {
    return {{{"jsonrpc", "2.0"}, {"id", id}, {"result", answer(method.get<std::string>(), member(message, "params"))}}};
  } catch (const RequestError& error) {
    return {error_response(id, error.code, error.message)};
  } catch (const Json::exception& wrong) {
    return {error_response(id, ErrorCode::invalid_params, wrong.what())};
  } catch (const std::exception& fault) {
    return {error_response(id, ErrorCode::internal_error, fault.what())};
  }
}

std::vector<Json> Session::receive(std::string_view content, bool& is_message) {
  const Json message = Json::parse(content, nullptr, false);
  is_message = !message.is_discarded();
  if (!is_message) return {fault("the content is not JSON")};
  try {
    return handle(message);
  } catch (const std::exception& fault) {
    return {warning(fmt::format("internal fault: {}", fault.what()))};
  }
}

}  // namespace robcogen::server
