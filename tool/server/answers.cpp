#include "server/answers.h"

#include <map>

#include "server/features.h"

namespace robcogen::server {

const Answer* find_answer(const std::string& method) {
  static const std::map<std::string, Answer> answers = {
      {"textDocument/codeAction", &code_actions},
      {"textDocument/completion", &completion},
      {"textDocument/definition", &definition},
      {"textDocument/documentHighlight", &highlights},
      {"textDocument/documentSymbol", &document_symbols},
      {"textDocument/foldingRange", &folding_ranges},
      {"textDocument/formatting", &formatting},
      {"textDocument/hover", &hover},
      {"textDocument/inlayHint", &inlay_hints},
      {"textDocument/prepareRename", &prepare_rename},
      {"textDocument/references", &references},
      {"textDocument/rename", &rename},
      {"textDocument/semanticTokens/full", &semantic_tokens},
  };
  const auto found = answers.find(method);
  return found == answers.end() ? nullptr : &found->second;
}

Json capabilities_of_answers() {
  return {
      {"codeActionProvider", {{"codeActionKinds", {"quickfix"}}}},
      {"completionProvider", {{"triggerCharacters", {"=", "{", "."}}}},
      {"definitionProvider", true},
      {"documentFormattingProvider", true},
      {"documentHighlightProvider", true},
      {"documentSymbolProvider", true},
      {"foldingRangeProvider", true},
      {"hoverProvider", true},
      {"inlayHintProvider", true},
      {"referencesProvider", true},
      {"renameProvider", {{"prepareProvider", true}}},
      {"semanticTokensProvider",
       {{"legend", {{"tokenTypes", semantic_token_types()}, {"tokenModifiers", Json::array()}}}, {"full", true}}},
  };
}

}  // namespace robcogen::server
