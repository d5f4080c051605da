#include "server/answers.h"

#include <map>

#include "server/features.h"

namespace robcogen::server {

const Answer* find_answer(const std::string& method) {
  static const std::map<std::string, Answer> answers = {
      {"textDocument/codeAction", &code_actions},
  };
  const auto found = answers.find(method);
  return found == answers.end() ? nullptr : &found->second;
}

Json capabilities_of_answers() {
  return {
      {"codeActionProvider", {{"codeActionKinds", {"quickfix"}}}},
  };
}

}  // namespace robcogen::server
