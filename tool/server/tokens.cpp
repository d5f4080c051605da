// Semantic tokens: the meaning of each word of a document.
#include <algorithm>
#include <array>

#include "server/features.h"
#include "server/lookup.h"
#include "server/vocabulary.h"

namespace robcogen::server {
namespace {

using language::Token;

constexpr std::array kTokenTypes = {"keyword",  "number",    "comment",   "string", "class",   "method",
                                    "property", "parameter", "namespace", "type",   "function"};
enum TokenType { keyword, number, comment, string, link, joint, frame, parameter, instance, part, function };

TokenType type_of_name(NameKind kind) {
  switch (kind) {
    case NameKind::robot:
    case NameKind::part:
      return part;
    case NameKind::instance:
    case NameKind::group:
      return instance;
    case NameKind::link:
      return link;
    case NameKind::joint:
    case NameKind::loop:
      return joint;
    case NameKind::frame:
      return frame;
    case NameKind::parameter:
    case NameKind::constant:
      return parameter;
    case NameKind::transform:
      return function;
  }
  return parameter;
}

struct Marked {
  Span span;
  TokenType type;
};

class TokenMarker {
 public:
  explicit TokenMarker(const Lookup& lookup) : lookup_(lookup) {
    for (const std::string& word : keywords(lookup.document->language)) words_.insert(word);
    for (const std::string& word : contextual_words(lookup.document->language)) words_.insert(word);
  }

  std::vector<Marked> run() {
    for (const Occurrence& o : lookup_.occurrences) list_.push_back({o.span, type_of_name(o.symbol.kind)});
    std::size_t next = 0;  // first occurrence that ends after the beginning of the token
    const auto& occurrences = lookup_.occurrences;
    for (const Token& token : lookup_.document->tokens.tokens) {
      while (next < occurrences.size() && occurrences[next].span.end <= token.span.begin) ++next;
      const bool is_name = next < occurrences.size() && occurrences[next].span.begin < token.span.end;
      if (!is_name) mark(token);
    }
    for (const language::Comment& c : lookup_.document->tokens.comments) list_.push_back({c.span, comment});
    std::sort(list_.begin(), list_.end(), [](const Marked& a, const Marked& b) { return a.span.begin < b.span.begin; });
    return std::move(list_);
  }

 private:
  const Lookup& lookup_;
  std::set<std::string, std::less<>> words_;
  std::vector<Marked> list_;

  void mark(const Token& token) {
    if (token.kind == Token::Kind::number) list_.push_back({token.span, number});
    if (token.kind == Token::Kind::string) list_.push_back({token.span, string});
    if (token.kind != Token::Kind::identifier || token.escaped) return;
    if (std::find(kFunctions.begin(), kFunctions.end(), token.text) != kFunctions.end())
      list_.push_back({token.span, function});
    else if (token.text == kPi || token.text == "pi")
      list_.push_back({token.span, number});
    else if (words_.contains(token.text))
      list_.push_back({token.span, keyword});
  }
};

}  // namespace

Json semantic_token_types() {
  return kTokenTypes;
}

Json semantic_tokens(Workspace& workspace, const Json& parameters) {
  Lookup lookup(workspace, parameters);
  std::vector<std::size_t> data;
  if (lookup.document == nullptr) return {{"data", data}};
  const Positions& here = lookup.here();
  Position last;
  for (const Marked& marked : TokenMarker(lookup).run()) {
    // A token of the protocol is on one line, but comments may have several.
    std::size_t begin = marked.span.begin;
    while (begin < marked.span.end) {
      const Position at = here.position(begin);
      const std::size_t end = std::min(marked.span.end, here.line_end(at.line));
      if (end > begin) {
        const std::size_t length = here.position(end).character - at.character;
        const std::size_t start = at.line == last.line ? at.character - last.character : at.character;
        data.insert(data.end(), {at.line - last.line, start, length, static_cast<std::size_t>(marked.type), 0});
        last = at;
      }
      begin = at.line + 1 < here.line_count() ? here.offset(Position{at.line + 1, 0}) : marked.span.end;
    }
  }
  return {{"data", data}};
}

}  // namespace robcogen::server
