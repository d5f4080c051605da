// What may stand at a place: words of the block, and names of what the place refers to.
#include <algorithm>

#include "language/kinematics/document.h"
#include "server/context.h"
#include "server/features.h"
#include "server/lookup.h"
#include "server/vocabulary.h"

namespace robcogen::server {
namespace {

namespace kinematics = language::kinematics;

// Kinds of the protocol.
enum ItemKind {
  function_item = 3,
  field_item = 5,
  variable_item = 6,
  class_item = 7,
  module_item = 9,
  keyword_item = 14
};

class Completion {
 public:
  Completion(Workspace& workspace, Lookup& lookup)
      : workspace_(workspace),
        lookup_(lookup),
        context_(context_at(lookup.document->tokens, lookup.offset)),
        declared_(declared_around(lookup.document->tokens, context_)) {}

  Json run() {
    if (is_in_comment()) return items_;
    switch (lookup_.document->language) {
      case driver::Language::robot:
        robot();
        break;
      case driver::Language::desired:
        list();
        break;
      case driver::Language::motions:
        frames_of_motions();
        break;
      case driver::Language::transforms:
        frames_of_transforms();
        break;
      default:
        break;
    }
    return std::move(items_);
  }

 private:
  Workspace& workspace_;
  Lookup& lookup_;
  const Context context_;
  const DeclaredNames declared_;
  Json items_ = Json::array();
  std::set<std::string> known_;

  bool is_in_comment() const {
    const auto& comments = lookup_.document->tokens.comments;
    return std::any_of(comments.begin(), comments.end(), [&](const language::Comment& c) {
      return c.span.begin < lookup_.offset && lookup_.offset <= c.span.end;
    });
  }

  void add(std::string_view label, ItemKind kind, const std::string& detail) {
    if (label.empty() || !known_.insert(std::string(label)).second) return;
    items_.push_back({{"label", label}, {"kind", static_cast<int>(kind)}, {"detail", detail}});
  }
  void words(std::string_view block) {
    for (const std::string_view word : words_of_block(lookup_.document->language, block)) add(word, keyword_item, "");
  }
  void word(std::string_view word) { add(word, keyword_item, ""); }

  void expression() {
    for (const Occurrence& o : lookup_.occurrences)
      if (o.symbol.kind == NameKind::parameter && o.symbol.document == lookup_.document->path)
        add(o.symbol.name, variable_item, "parameter");
    std::set<std::string> words(kFunctions.begin(), kFunctions.end());
    words.insert({std::string(kPi), "pi"});
    for (const std::string& keyword : keywords(lookup_.document->language)) words.insert(keyword);
    for (const language::Token& token : lookup_.document->tokens.tokens)
      if (token.span.begin < lookup_.offset && lookup_.offset <= token.span.end) words.insert(std::string(token.text));
    for (const std::string& name : parameter_names(lookup_.document->tokens, words))
      add(name, variable_item, "parameter");
    add(kPi, variable_item, "the constant");
    for (const std::string_view function : kFunctions) add(function, function_item, "");
  }

  // ---- Robots.

  void links() {
    // Those without a parent first: one of them is meant.
    for (const bool is_carried : {false, true})
      for (const std::string& link : declared_.links)
        if (declared_.carried.contains(link) == is_carried)
          add(link, class_item, is_carried ? "link, has a parent" : "link");
  }
  void joints() {
    for (const bool is_used : {false, true})
      for (const std::string& joint : declared_.joints)
        if (declared_.used.contains(joint) == is_used) add(joint, function_item, is_used ? "joint, is used" : "joint");
  }
  void joints_of_all() {
    joints();
    if (const auto tree = tree_of(workspace_, lookup_.document->path))
      for (const model::Joint& joint : tree->joints) add(joint.name, function_item, "joint");
  }
  void parts() {
    for (const auto& [name, scope] : lookup_.names.known_parts(*lookup_.document)) add(name, module_item, "part");
  }

  bool is_in_expression() const {
    if (context_.open_parentheses > 0) return true;
    static const std::set<std::string_view> operators = {"=", "+", "-", "*", "/", "(", ","};
    return !context_.before.empty() && operators.contains(context_.before.back().text);
  }

  void robot() {
    const std::string& block = context_.block();
    if (context_.follows("via")) return joints();
    if (context_.follows("root")) return links();
    if (context_.word_before("=") == "carrier") return links();
    if (context_.word_before("=") == "ref_frame") return frames_of_link();
    if (context_.follows("link") || context_.follows("RobotBase") || context_.follows("Robot")) return;
    if (block == "couplings") {
      if (context_.before.empty()) words(block);
      joints_of_all();
      if (is_in_expression()) expression();
      return;
    }
    if (block == "independent") return joints_of_all();
    if (block == "loop" && context_.word_before("=") == "type") {
      for (const std::string_view type : language::kinematics::kLoopTypes) word(type);
      return;
    }
    if (block == "loop" && (context_.word_before("=") == "frames" || context_.follows("~"))) return frames_of_robot();
    if (is_in_expression()) return expression();
    if (block == "children") return children();
    if (block == "sense") return joints_of_part();
    if (context_.blocks.size() == 1 && (block == "Part" || block == "Robot") && !context_.before.empty() &&
        context_.before.size() < 3)
      return;  // the name of an element
    words(block);
  }

  void children() {
    if (!context_.before.empty()) {
      const language::Token& last = context_.before.back();
      const bool is_joint = context_.before.size() > 1 && context_.before[context_.before.size() - 2].text == "via";
      if (last.text == ")" || last.text == "at") {
        for (const char* after : {"at", "mirrored", "keep"}) word(after);
      } else if (last.text == "mirrored") {
        for (const char* axis : {"x", "y", "z"}) word(axis);
        return;
      } else if (last.kind == language::Token::Kind::identifier && !is_joint) {
        word("via");
        word("at");
        return;
      }
    }
    links();
    parts();
  }

  // `mirrored y same sense { HAA }` of the part that stands before.
  void joints_of_part() {
    const auto& tokens = lookup_.document->tokens;
    const auto& parts = lookup_.names.known_parts(*lookup_.document);
    std::string name;
    for (const language::Token& token : tokens.tokens) {
      if (token.span.begin >= lookup_.offset) break;
      if (parts.contains(std::string(token.text)) || declares_part(token)) name = token.text;
    }
    if (const auto found = parts.find(name); found != parts.end() && found->second.document->urdf() == nullptr)
      for (const kinematics::Joint& joint : found->second.body().joints) add(joint.name.text, function_item, "joint");
    for (const std::string& joint : declared_in_part(tokens, name).joints) add(joint, function_item, "joint");
  }
  bool declares_part(const language::Token& name) const {
    const auto& tokens = lookup_.document->tokens.tokens;
    for (std::size_t i = 1; i < tokens.size(); ++i)
      if (tokens[i - 1].text == "Part" && tokens[i].text == name.text) return true;
    return false;
  }

  void frames_of_robot() {
    for (const auto& [link, frames] : declared_.frames)
      for (const std::string& frame : frames) add(frame, field_item, "frame");
    if (const auto tree = tree_of(workspace_, lookup_.document->path))
      for (const model::Frame& frame : tree->frames()) add(frame.name, field_item, "frame");
  }
  void frames_of_link() {
    for (const Context::Block& block : context_.blocks) {
      const auto frames = declared_.frames.find(block.name);
      if ((block.word != "link" && block.word != "RobotBase") || frames == declared_.frames.end()) continue;
      for (const std::string& frame : frames->second) add(frame, field_item, "frame");
    }
  }

  // ---- Lists of desired transforms.

  void frames_of_model() {
    const Parsed* model = lookup_.names.model_of(*lookup_.document);
    for (const auto& name : lookup_.document->desired()->frames) add(name.text, field_item, "frame of the list");
    if (model == nullptr) return;
    if (const auto tree = tree_of(workspace_, model->path)) {
      for (const model::Frame& frame : tree->frames()) add(frame.name, field_item, "frame");
      return;
    }
    for (const Occurrence& o : lookup_.names.occurrences(*model))
      if (o.symbol.kind == NameKind::frame) add(o.symbol.name, field_item, "frame");
  }

  void list() {
    const std::string& block = context_.block();
    if (block.empty()) {
      if (context_.follows("Robot") || context_.follows("Model")) return;
      return words("");
    }
    if (block == "Frames") {
      words(block);
      frames_of_model();
      // What is listed is known.
      for (const auto& name : lookup_.document->desired()->frames)
        items_.erase(
            std::remove_if(items_.begin(), items_.end(), [&](const Json& item) { return item["label"] == name.text; }),
            items_.end());
      return;
    }
    if (!context_.follows("=")) words(block);
    frames_of_model();
  }

  // ---- Motions and transforms.

  void known_frames() {
    for (const Occurrence& o : lookup_.occurrences)
      if (o.symbol.kind == NameKind::frame) add(o.symbol.name, field_item, "frame");
  }
  void frames_of_motions() {
    if (context_.word_before("=") == "Convention") return words("Convention");
    if (context_.open_parentheses > 0) return expression();
    const bool is_arrow = context_.follows("->");
    const auto& before = context_.before;
    const auto has = [&](std::string_view text) {
      return std::any_of(before.begin(), before.end(), [&](const auto& token) { return token.text == text; });
    };
    if (!context_.block().empty()) return known_frames();
    if (!is_arrow && has(":")) words(":");
    if (!has("Convention")) words("");
    if (has("Convention") || is_arrow) known_frames();
  }
  void frames_of_transforms() {
    const std::string_view convention = context_.word_before("=");
    if (convention == "MovedFramePos" || convention == "TransformedFramePos") return words(convention);
    if (context_.open_parentheses > 0) return expression();
    if (!context_.block().empty() || context_.follows("{")) return known_frames();
    const auto& before = context_.before;
    const bool is_product =
        std::any_of(before.begin(), before.end(), [](const auto& token) { return token.text == "="; });
    words(is_product ? "=" : "");
  }
};

}  // namespace

Json completion(Workspace& workspace, const Json& parameters) {
  Lookup lookup(workspace, parameters);
  if (lookup.document == nullptr || std::holds_alternative<std::monostate>(lookup.document->document))
    return Json::array();
  return Completion(workspace, lookup).run();
}

}  // namespace robcogen::server
