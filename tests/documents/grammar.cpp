#include "grammar.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <stdexcept>

namespace robcogen::test {

namespace {

using NodePtr = std::shared_ptr<const Node>;
using language::Token;

constexpr int kMaxRepetitions = 3;  // in derivations, of a part that may repeat without limit

bool is_token(const std::string& name) {
  return name == "ID" || name == "NAME" || name == "NUMBER" || name == "INTEGER" || name == "STRING";
}

bool is_word(const std::string& text) {
  return std::isalpha(static_cast<unsigned char>(text[0])) || text[0] == '_';
}

NodePtr node(Node::Kind kind, std::vector<NodePtr> of) {
  if (of.size() == 1) return of[0];
  return std::make_shared<const Node>(Node{kind, "", std::move(of)});
}

class Reader {
 public:
  explicit Reader(const std::string& text) : text_(text) {}

  bool at_end() {
    skip_blanks();
    return at_ >= text_.size();
  }

  std::string rule_name() {
    std::string name = word();
    expect("::=");
    return name;
  }

  NodePtr choice() {
    std::vector<NodePtr> of = {any_order()};
    while (accept('|')) of.push_back(any_order());
    return node(Node::Kind::choice, of);
  }

 private:
  const std::string& text_;
  std::size_t at_ = 0;

  void skip_blanks() {
    while (at_ < text_.size() && std::isspace(static_cast<unsigned char>(text_[at_]))) ++at_;
  }
  char peek() {
    skip_blanks();
    return at_ < text_.size() ? text_[at_] : '\0';
  }
  bool accept(char c) {
    if (peek() != c) return false;
    ++at_;
    return true;
  }
  void expect(const std::string& symbol) {
    skip_blanks();
    if (text_.compare(at_, symbol.size(), symbol) != 0)
      throw std::runtime_error("expected " + symbol + " at: " + text_.substr(at_, 40));
    at_ += symbol.size();
  }
  std::string word() {
    skip_blanks();
    const std::size_t begin = at_;
    while (at_ < text_.size() && std::isalnum(static_cast<unsigned char>(text_[at_]))) ++at_;
    if (at_ == begin) throw std::runtime_error("expected a name at: " + text_.substr(at_, 40));
    return text_.substr(begin, at_ - begin);
  }

  bool at_rule() {
    const std::size_t begin = at_;
    bool result = false;
    if (std::isalpha(static_cast<unsigned char>(peek()))) {
      word();
      skip_blanks();
      result = text_.compare(at_, 3, "::=") == 0;
    }
    at_ = begin;
    return result;
  }

  NodePtr any_order() {
    std::vector<NodePtr> of = {sequence()};
    while (accept('&')) of.push_back(sequence());
    return node(Node::Kind::any_order, of);
  }

  NodePtr sequence() {
    std::vector<NodePtr> of;
    while (peek() == '\'' || peek() == '"' || peek() == '(' ||
           (std::isalpha(static_cast<unsigned char>(peek())) && !at_rule()))
      of.push_back(repetition());
    if (of.empty()) throw std::runtime_error("nothing to match at: " + text_.substr(at_, 40));
    return node(Node::Kind::sequence, of);
  }

  NodePtr repetition() {
    NodePtr inner = primary();
    const char c = peek();
    if (c != '?' && c != '*' && c != '+') return inner;
    ++at_;
    return std::make_shared<const Node>(
        Node{Node::Kind::repeat, "", {inner}, c == '+' ? 1 : 0, c == '?' ? 1 : 1 << 20});
  }

  NodePtr primary() {
    if (accept('(')) {
      NodePtr inner = choice();
      expect(")");
      return inner;
    }
    const char quote = peek();
    if (quote != '\'' && quote != '"') return std::make_shared<const Node>(Node{Node::Kind::name, word(), {}});
    const std::size_t end = text_.find(quote, ++at_);
    if (end == std::string::npos) throw std::runtime_error("a word does not end");
    Node literal{Node::Kind::literal, text_.substr(at_, end - at_), {}};
    literal.is_reserved = quote == '\'';
    at_ = end + 1;
    return std::make_shared<const Node>(std::move(literal));
  }
};

class Deriver {
 public:
  Deriver(const std::map<std::string, NodePtr>& rules, std::mt19937& random, int deepest)
      : rules_(rules), random_(random), deepest_(deepest) {}

  void derive(const Node& node, int depth) {
    switch (node.kind) {
      case Node::Kind::literal:
        return put(node.text);
      case Node::Kind::name:
        return is_token(node.text) ? put(token(node.text)) : derive(*rules_.at(node.text), depth + 1);
      case Node::Kind::sequence:
        for (const NodePtr& part : node.of) derive(*part, depth);
        return;
      case Node::Kind::choice:
        return derive(*node.of[depth > deepest_ ? 0 : below(node.of.size())], depth);
      case Node::Kind::any_order: {
        std::vector<NodePtr> parts = node.of;
        std::shuffle(parts.begin(), parts.end(), random_);
        for (const NodePtr& part : parts) derive(*part, depth);
        return;
      }
      case Node::Kind::repeat: {
        const int most = depth > deepest_ ? node.least : std::min(node.most, kMaxRepetitions);
        const int count = node.least + static_cast<int>(below(static_cast<std::size_t>(most - node.least) + 1));
        for (int i = 0; i < count; ++i) derive(*node.of[0], depth);
      }
    }
  }

  std::string text;

 private:
  const std::map<std::string, NodePtr>& rules_;
  std::mt19937& random_;
  int deepest_;
  bool is_after_point_ = false;

  std::size_t below(std::size_t count) { return random_() % count; }

  // No blank separates the point of `group.name` from its neighbours.
  void put(const std::string& token) {
    const bool is_point = token == ".";
    if (!text.empty() && !is_point && !is_after_point_) text += below(12) == 0 ? "\n" : " ";
    text += token;
    is_after_point_ = is_point;
  }

  std::string token(const std::string& name) {
    static const std::array kNames = {"arm", "fr_foot", "a1", "Leg", "^link", "^Model", "_x", "e3x"};
    static const std::array kNumbers = {"1", "0.5", ".25", "2.", "1e-3", "4.0E+2", "0"};
    if (name == "ID") return kNames[below(kNames.size())];
    if (name == "NAME") return kNames[below(4)];
    if (name == "STRING") return "\"leg 1.kindsl\"";
    if (name == "INTEGER") return std::to_string(below(100));
    return kNumbers[below(kNumbers.size())];
  }
};

// Finds the positions at which a match of a node that begins at a given position can end.
class Matcher {
 public:
  Matcher(
      const std::map<std::string, NodePtr>& rules,
      const std::vector<Token>& tokens,
      const std::set<std::string>& keywords)
      : rules_(rules), tokens_(tokens), keywords_(keywords) {}

  std::set<std::size_t> ends(const Node& node, std::size_t at) {
    const auto [known, is_new] = known_.insert({{&node, at}, {}});
    if (is_new) known->second = find(node, at);
    return known_[{&node, at}];
  }

 private:
  using Ends = std::set<std::size_t>;

  const std::map<std::string, NodePtr>& rules_;
  const std::vector<Token>& tokens_;
  const std::set<std::string>& keywords_;
  std::map<std::pair<const Node*, std::size_t>, Ends> known_;

  Ends find(const Node& node, std::size_t at) {
    switch (node.kind) {
      case Node::Kind::literal:
        return is_literal(tokens_[at], node.text) ? Ends{at + 1} : Ends{};
      case Node::Kind::name:
        if (is_token(node.text)) return fits(tokens_[at], node.text) ? Ends{at + 1} : Ends{};
        return ends(*rules_.at(node.text), at);
      case Node::Kind::sequence: {
        Ends now = {at};
        for (const NodePtr& part : node.of) now = after(now, *part);
        return now;
      }
      case Node::Kind::choice: {
        Ends all;
        for (const NodePtr& part : node.of) all.merge(ends(*part, at));
        return all;
      }
      case Node::Kind::any_order:
        return in_any_order(node.of, at);
      case Node::Kind::repeat: {
        Ends all, now = {at};
        if (node.least == 0) all = now;
        for (int i = 1; i <= node.most && !now.empty(); ++i) {
          Ends next = after(now, *node.of[0]);
          for (const std::size_t end : all) next.erase(end);
          now = next;
          all.insert(now.begin(), now.end());
        }
        return all;
      }
    }
    return {};
  }

  Ends after(const Ends& places, const Node& part) {
    Ends all;
    for (const std::size_t at : places) all.merge(ends(part, at));
    return all;
  }

  // Matches the parts in any order; parts that may be empty are left out when nothing else fits.
  Ends in_any_order(const std::vector<NodePtr>& parts, std::size_t at) {
    if (parts.empty()) return {at};
    Ends all;
    bool all_may_be_empty = true;
    for (std::size_t i = 0; i < parts.size(); ++i) {
      Ends next = ends(*parts[i], at);
      all_may_be_empty &= next.erase(at) > 0;
      std::vector<NodePtr> others = parts;
      others.erase(others.begin() + static_cast<std::ptrdiff_t>(i));
      for (const std::size_t end : next) all.merge(in_any_order(others, end));
    }
    if (all_may_be_empty) all.insert(at);
    return all;
  }

  static bool is_literal(const Token& token, const std::string& text) {
    const bool is_text = token.kind == Token::Kind::identifier || token.kind == Token::Kind::symbol;
    return is_text && !token.escaped && token.text == text;
  }

  bool fits(const Token& token, const std::string& name) const {
    if (name == "ID" && token.escaped) return true;
    if (name == "ID" || name == "NAME")
      return token.kind == Token::Kind::identifier && !token.escaped && !keywords_.contains(std::string(token.text));
    if (name == "STRING") return token.kind == Token::Kind::string;
    return token.kind == Token::Kind::number &&
           (name == "NUMBER" || token.text.find_first_not_of("0123456789") == std::string::npos);
  }
};

// Calls `use(node)` for a node and all its descendants.
template <class Use>
void walk(const Node& node, Use use) {
  use(node);
  for (const NodePtr& part : node.of) walk(*part, use);
}

}  // namespace

Grammar::Grammar(const std::string& text) {
  for (Reader reader(text); !reader.at_end();) {
    const std::string name = reader.rule_name();
    if (first_.empty()) first_ = name;
    rules_[name] = reader.choice();
  }
}

std::set<std::string> Grammar::words(const std::string& without) const {
  std::set<std::string> found, visited = {without};
  std::vector<std::string> left = {first_};
  while (!left.empty()) {
    const std::string rule = left.back();
    left.pop_back();
    if (!visited.insert(rule).second) continue;
    walk(*rules_.at(rule), [&](const Node& node) {
      if (node.kind == Node::Kind::literal && node.is_reserved && is_word(node.text)) found.insert(node.text);
      if (node.kind == Node::Kind::name && !is_token(node.text)) left.push_back(node.text);
    });
  }
  return found;
}

std::vector<std::string> Grammar::undefined() const {
  std::vector<std::string> found;
  for (const auto& [name, rule] : rules_)
    walk(*rule, [&](const Node& node) {
      if (node.kind == Node::Kind::name && !is_token(node.text) && !rules_.contains(node.text))
        found.push_back(node.text);
    });
  return found;
}

std::string Grammar::derive(std::mt19937& random, int deepest) const {
  Deriver deriver(rules_, random, deepest);
  deriver.derive(*rules_.at(first_), 0);
  return deriver.text + "\n";
}

bool Grammar::matches(const std::vector<Token>& tokens, const std::set<std::string>& keywords) const {
  return Matcher(rules_, tokens, keywords).ends(*rules_.at(first_), 0).contains(tokens.size() - 1);
}

}  // namespace robcogen::test
