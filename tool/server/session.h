// A session with an editor: messages in, messages out (Language Server Protocol 3.17, over JSON-RPC 2.0).
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "server/json.h"
#include "server/workspace.h"

namespace robcogen::server {

// Error codes of the protocol.
enum class ErrorCode {
  parse_error = -32700,
  invalid_request = -32600,
  method_not_found = -32601,
  invalid_params = -32602,
  internal_error = -32603,
  server_not_initialized = -32002,
  request_failed = -32803,
};

// Thrown if a request cannot be answered.
struct RequestError {
  ErrorCode code;
  std::string message;
};

class Session {
 public:
  // `import_folders` are searched for imported documents before those that the editor names.
  explicit Session(const std::vector<std::filesystem::path>& import_folders = {});

  // Returns the messages that answer the content of a frame. `is_message` is set to whether it was a message at all.
  std::vector<Json> receive(std::string_view content, bool& is_message);
  // Returns the answer to a broken header.
  static Json fault(const std::string& what);

  // True after `exit`. If there was no `shutdown` before it, the exit status of the process is 1.
  bool is_over() const { return is_over_; }
  bool was_shut_down() const { return state_ == State::shut_down; }

 private:
  enum class State { starting, running, shut_down };
  State state_ = State::starting;
  bool is_over_ = false;
  Workspace workspace_;
  std::vector<std::filesystem::path> import_folders_;     // from the command line
  std::vector<std::filesystem::path> workspace_folders_;  // open in the editor
  Json settings_;                                         // last settings that name import folders
  bool gives_settings_ = false;                           // whether the editor can be asked for its settings
  int questions_ = 0;                                     // number of such requests; the last one counts

  std::vector<Json> handle(const Json& message);
  Json answer(const std::string& method, const Json& parameters);
  Json initialize(const Json& parameters);
  std::vector<Json> notice(const std::string& method, const Json& parameters);
  std::vector<Json> change(const Json& parameters);
  void set_folders();
  std::vector<Json> change_settings(const Json& settings);
  std::vector<Json> ask_settings();
  std::vector<Json> answered(const Json& id, const Json& result);
  std::vector<Json> change_folders(const Json& event);
};

}  // namespace robcogen::server
