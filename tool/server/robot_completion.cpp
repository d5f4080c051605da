// Completion in robots and parts.
#include "language/kinematics/document.h"
#include "server/completion.h"
#include "server/features.h"
#include "server/vocabulary.h"

namespace robcogen::server {
namespace {

namespace kinematics = language::kinematics;

class RobotCompletion {
 public:
  RobotCompletion(Workspace& workspace, Lookup& lookup, const Context& context, CompletionItems& items)
      : workspace_(workspace),
        lookup_(lookup),
        context_(context),
        declared_(declared_around(lookup.document->tokens, context)),
        items_(items) {}

  void run() {
    const std::string& block = context_.block();
    if (context_.follows("via")) return joints();
    if (context_.follows("root")) return links();
    if (context_.word_before("=") == "carrier") return links();
    if (context_.word_before("=") == "ref_frame") return frames_of_link();
    if (context_.follows("link") || context_.follows("RobotBase") || context_.follows("Robot")) return;
    if (block == "couplings") {
      if (context_.before.empty()) items_.add_words(driver::Language::robot, block);
      joints_of_all();
      if (is_in_expression()) items_.add_expression(lookup_);
      return;
    }
    if (block == "independent") return joints_of_all();
    if (block == "tendon" && is_in_expression()) {
      joints_of_all();
      return items_.add_expression(lookup_);
    }
    if (block == "loop" && context_.word_before("=") == "type") {
      for (const std::string_view type : language::kinematics::kLoopTypes) items_.add_word(type);
      return;
    }
    if (block == "loop" && (context_.word_before("=") == "frames" || context_.follows("~"))) return frames_of_robot();
    if (is_in_expression()) return items_.add_expression(lookup_);
    if (block == "children") return children();
    if (block == "sense") return joints_of_part();
    if (context_.blocks.size() == 1 && (block == "Part" || block == "Robot") && !context_.before.empty() &&
        context_.before.size() < 3)
      return;  // the name of an element
    items_.add_words(driver::Language::robot, block);
  }

 private:
  Workspace& workspace_;
  Lookup& lookup_;
  const Context& context_;
  const DeclaredNames declared_;
  CompletionItems& items_;

  void links() {
    // Links without a parent come first, because one of them is probably meant.
    for (const bool is_carried : {false, true})
      for (const std::string& link : declared_.links)
        if (declared_.carried.contains(link) == is_carried)
          items_.add(link, class_item, is_carried ? "link, has a parent" : "link");
  }
  void joints() {
    for (const bool is_used : {false, true})
      for (const std::string& joint : declared_.joints)
        if (declared_.used.contains(joint) == is_used)
          items_.add(joint, function_item, is_used ? "joint, is used" : "joint");
  }
  void joints_of_all() {
    joints();
    if (const auto tree = tree_of(workspace_, lookup_.document->path))
      for (const model::Joint& joint : tree->joints) items_.add(joint.name, function_item, "joint");
  }
  void parts() {
    for (const auto& [name, scope] : lookup_.names.known_parts(*lookup_.document))
      items_.add(name, module_item, "part");
  }

  bool is_in_expression() const {
    if (context_.open_parentheses > 0) return true;
    static const std::set<std::string_view> operators = {"=", "+", "-", "*", "/", "(", ","};
    return !context_.before.empty() && operators.contains(context_.before.back().text);
  }

  void children() {
    if (!context_.before.empty()) {
      const language::Token& last = context_.before.back();
      const bool is_joint = context_.before.size() > 1 && context_.before[context_.before.size() - 2].text == "via";
      if (last.text == ")" || last.text == "at") {
        for (const char* after : {"at", "mirrored", "keep"}) items_.add_word(after);
      } else if (last.text == "mirrored") {
        for (const char* axis : {"x", "y", "z"}) items_.add_word(axis);
        return;
      } else if (last.kind == language::Token::Kind::identifier && !is_joint) {
        items_.add_word("via");
        items_.add_word("at");
        return;
      }
    }
    links();
    parts();
  }

  // Adds the joints of the part that is attached by the statement: `mirrored y same sense { HAA }`.
  void joints_of_part() {
    const auto& tokens = lookup_.document->tokens;
    const auto& parts = lookup_.names.known_parts(*lookup_.document);
    std::string name;
    for (const language::Token& token : tokens.tokens) {
      if (token.span.begin >= lookup_.offset) break;
      if (parts.contains(std::string(token.text)) || declares_part(token)) name = token.text;
    }
    if (const auto found = parts.find(name); found != parts.end() && found->second.document->urdf() == nullptr)
      for (const kinematics::Joint& joint : found->second.body().joints)
        items_.add(joint.name.text, function_item, "joint");
    for (const std::string& joint : declared_in_part(tokens, name).joints) items_.add(joint, function_item, "joint");
  }
  bool declares_part(const language::Token& name) const {
    const auto& tokens = lookup_.document->tokens.tokens;
    for (std::size_t i = 1; i < tokens.size(); ++i)
      if (tokens[i - 1].text == "Part" && tokens[i].text == name.text) return true;
    return false;
  }

  void frames_of_robot() {
    for (const auto& [link, frames] : declared_.frames)
      for (const std::string& frame : frames) items_.add(frame, field_item, "frame");
    if (const auto tree = tree_of(workspace_, lookup_.document->path))
      for (const model::Frame& frame : tree->frames()) items_.add(frame.name, field_item, "frame");
  }
  void frames_of_link() {
    for (const Context::Block& block : context_.blocks) {
      const auto frames = declared_.frames.find(block.name);
      if ((block.word != "link" && block.word != "RobotBase") || frames == declared_.frames.end()) continue;
      for (const std::string& frame : frames->second) items_.add(frame, field_item, "frame");
    }
  }
};

}  // namespace

void complete_robot(Workspace& workspace, Lookup& lookup, const Context& context, CompletionItems& items) {
  RobotCompletion(workspace, lookup, context, items).run();
}

}  // namespace robcogen::server
