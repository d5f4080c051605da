#include "server/context.h"

#include <algorithm>
#include <iterator>
#include <set>

namespace robcogen::server {
namespace {

using language::Token;

bool is_word_token(const Token& token) {
  return token.kind == Token::Kind::identifier;
}

// Returns the block that a brace opens, given the tokens before it in the enclosing block.
Context::Block opened(const std::vector<Token>& before, const Context& context) {
  static const std::set<std::string_view> alone = {"inertia_params", "inertia_properties",
                                                   "children",       "frames",
                                                   "ref_frame",      "couplings",
                                                   "loops",          "independent",
                                                   "tendons",        "elastic",
                                                   "actuators",      "friction",
                                                   "spring",         "rotor",
                                                   "limits",         "at",
                                                   "sense",          "Frames",
                                                   "Transforms",     "Jacobians",
                                                   "Contacts",       "InverseKinematics",
                                                   "Functions",      "slide",
                                                   "turn",           "turn_x",
                                                   "turn_z",         "slide_x",
                                                   "slide_y"};
  static const std::set<std::string_view> named = {"Robot",   "Part",         "RobotBase", "link",
                                                   "r_joint", "p_joint",      "h_joint",   "c_joint",
                                                   "u_joint", "planar_joint", "s_joint",   "Params"};
  const bool is_of_frames = context.block() == "frames";
  if (context.block() == "loops" && !before.empty()) return {"loop", std::string(before.back().text)};
  if (context.block() == "tendons" && !before.empty()) return {"tendon", std::string(before.back().text)};
  if (context.block() == "actuators" && !before.empty()) return {"actuator", std::string(before.back().text)};
  if (!before.empty() && !is_of_frames && alone.contains(before.back().text))
    return {std::string(before.back().text), ""};
  // A name, `floating`, or the parameters of a part may stand in between.
  for (auto token = before.rbegin(); token != before.rend(); ++token)
    if (named.contains(token->text) && token != before.rbegin() && !is_of_frames)
      return {std::string(token->text), std::string(std::prev(token)->text)};
  if (is_of_frames) return {"ref_frame", ""};
  if (before.empty() && !context.blocks.empty()) return context.blocks.back();  // the body of a loop
  return {before.empty() ? "" : std::string(before.back().text), ""};
}

bool is_joint_word(std::string_view word) {
  return word.ends_with("_joint") && word.size() > 6;
}

// `word` is `Robot` or `Part`, and `name` is the name of that body; any name if empty.
DeclaredNames declared_in(const language::TokenList& list, std::string_view word, const std::string& name) {
  DeclaredNames result;
  bool is_inside = false;
  std::string link;
  int depth = 0, frames_at = -1;  // number of open blocks; depth of `frames`
  for (std::size_t i = 0; i + 1 < list.tokens.size(); ++i) {
    const Token &token = list.tokens[i], &next = list.tokens[i + 1];
    if (token.text == "{") ++depth;
    if (token.text == "}" && --depth < frames_at) frames_at = -1;
    if (!is_word_token(token) || token.escaped) continue;
    const std::string named(next.text);
    if (token.text == "Robot" || token.text == "Part") {
      is_inside = token.text == word && (name.empty() || named == name);
      depth = 0;
      frames_at = -1;
    }
    if (!is_inside || (!is_word_token(next) && next.text != "{")) continue;
    if (token.text == "link" || token.text == "RobotBase") link = named;
    if (token.text == "link") result.links.push_back(named);
    if (is_joint_word(token.text) && is_word_token(next)) result.joints.push_back(named);
    if (token.text == "via") result.used.insert(named);
    if (next.text == "via") result.carried.insert(std::string(token.text));
    if (token.text == "frames" && next.text == "{") frames_at = depth + 1;
    if (frames_at == depth && next.text == "{" && token.text != "frames")
      result.frames[link].push_back(std::string(token.text));
  }
  return result;
}

}  // namespace

DeclaredNames declared_around(const language::TokenList& tokens, const Context& context) {
  const bool is_part = !context.blocks.empty() && context.blocks.front().word == "Part";
  return is_part ? declared_in(tokens, "Part", context.blocks.front().name) : declared_in(tokens, "Robot", "");
}

DeclaredNames declared_in_part(const language::TokenList& tokens, const std::string& part) {
  return declared_in(tokens, "Part", part);
}

std::vector<std::string> parameter_names(const language::TokenList& list, const std::set<std::string>& words) {
  static const std::set<std::string_view> operators = {"(", ",", "+", "-", "*", "/", "=", ":"};
  static const std::set<std::string_view> not_behind = {"carrier", "ref_frame", "base", "target",
                                                        "left",    "right",     "type", "frames"};
  static const std::set<std::string_view> units = {"rad", "m"};  // of couplings
  std::vector<std::string> result;
  std::set<std::string> known = words;
  int open = 0;
  for (std::size_t i = 2; i + 1 < list.tokens.size(); ++i) {
    const Token &token = list.tokens[i], &before = list.tokens[i - 1];
    if (before.text == "(") ++open;
    if (before.text == ")") --open;
    const bool is_operand =
        (open > 0 || before.text == "=") && (operators.contains(before.text) || before.kind == Token::Kind::number);
    if (!is_word_token(token) || !is_operand || not_behind.contains(list.tokens[i - 2].text)) continue;
    const bool is_factor =
        before.kind == Token::Kind::number || (before.text == "/" && units.contains(list.tokens[i - 2].text));
    if (is_factor && units.contains(token.text)) continue;
    if (list.tokens[i + 1].text == "=" || list.tokens[i + 1].text == "(") continue;
    if (known.insert(std::string(token.text)).second) result.push_back(std::string(token.text));
  }
  return result;
}

const std::string& Context::block() const {
  static const std::string none;
  return blocks.empty() ? none : blocks.back().word;
}

std::string_view Context::word_before(std::string_view text) const {
  if (before.size() < 2 || before.back().text != text) return "";
  return before[before.size() - 2].text;
}

Context context_at(const language::TokenList& tokens, std::size_t offset) {
  Context context;
  for (const Token& token : tokens.tokens) {
    if (token.kind == Token::Kind::end || token.span.begin >= offset) break;
    if (token.span.end >= offset && is_word_token(token)) break;  // being written
    if (token.kind == Token::Kind::symbol && token.text == "{") {
      context.blocks.push_back(opened(context.before, context));
      context.before.clear();
      context.open_parentheses = 0;
      continue;
    }
    if (token.kind == Token::Kind::symbol && token.text == "}") {
      if (!context.blocks.empty()) context.blocks.pop_back();
      context.before.clear();
      context.open_parentheses = 0;
      continue;
    }
    if (token.text == "(") ++context.open_parentheses;
    if (token.text == ")") --context.open_parentheses;
    context.before.push_back(token);
    // A statement is short; in an invalid document, the last tokens before the place are enough.
    if (context.before.size() > 64) context.before.erase(context.before.begin(), context.before.begin() + 32);
  }
  return context;
}

}  // namespace robcogen::server
