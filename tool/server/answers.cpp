#include "server/answers.h"

#include <map>

#include "server/features.h"

namespace robcogen::server {

const Answer* find_answer(const std::string& method) {
  static const std::map<std::string, Answer> answers = {
      {"textDocument/codeAction", &code_actions},
      {"textDocument/definition", &definition},
      {"textDocument/documentHighlight", &highlights},
      {"textDocument/documentSymbol", &document_symbols},
      {"textDocument/foldingRange", &folding_ranges},
      {"textDocument/hover", &hover},
      {"textDocument/prepareRename", &prepare_rename},
      {"textDocument/references", &references},
      {"textDocument/rename", &rename},
  };
  const auto found = answers.find(method);
  return found == answers.end() ? nullptr : &found->second;
}

Json capabilities_of_answers() {
  return {
      {"codeActionProvider", {{"codeActionKinds", {"quickfix"}}}},
      {"definitionProvider", true},
      {"documentHighlightProvider", true},
      {"documentSymbolProvider", true},
      {"foldingRangeProvider", true},
      {"hoverProvider", true},
      {"referencesProvider", true},
      {"renameProvider", {{"prepareProvider", true}}},
  };
}

}  // namespace robcogen::server
