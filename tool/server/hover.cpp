// Hover texts: what a name or a number means, with values of the robot at q = 0 or where its loops are assembled.
#include <fmt/format.h>

#include <utility>

#include "server/analysis.h"
#include "server/features.h"
#include "server/hover_texts.h"
#include "server/lookup.h"
#include "server/values.h"
#include "support/files.h"

namespace robcogen::server {
namespace {

// Returns the robots that may contain a symbol: the robot of the document or of the list, or else the robots that use
// the document's parts.
std::vector<model::KinematicTree> trees_for(Workspace& workspace, Lookup& lookup) {
  std::vector<model::KinematicTree> trees;
  const auto add = [&](const std::filesystem::path& path) {
    if (std::optional<model::KinematicTree> tree = tree_of(workspace, path)) trees.push_back(std::move(*tree));
  };
  const Parsed* of_list = lookup.names.model_of(*lookup.document);
  add(of_list != nullptr ? of_list->path : lookup.document->path);
  if (!trees.empty() || lookup.document->robot() == nullptr || lookup.document->robot()->has_robot()) return trees;
  for (const auto& [uri, open] : workspace.documents().all())
    if (workspace.analysis(open).read.contains(lookup.document->path)) add(open.path);
  return trees;
}

// Returns the whole word at the place.
std::string word_at_place(const Lookup& lookup) {
  for (const language::Token& token : lookup.document->tokens.tokens)
    if (token.kind == language::Token::Kind::identifier && token.span.begin <= lookup.offset &&
        lookup.offset <= token.span.end)
      return std::string(token.text);
  return "";
}

class NameText {
 public:
  NameText(Workspace& workspace, Lookup& lookup) : lookup_(lookup), trees_(trees_for(workspace, lookup)) {
    const Parsed* of_list = lookup.names.model_of(*lookup.document);
    motions_ = motions_in((of_list != nullptr ? of_list : lookup.document)->path, workspace.documents());
  }

  // Returns the hover text; empty if nothing is known.
  std::string operator()() {
    const std::string word = word_at_place(lookup_);
    for (const model::KinematicTree& tree : trees_)
      if (std::string text = of_word(tree, word); !text.empty()) return text + uses();
    if (lookup_.at_place == nullptr) return "";
    if (std::string text = motions_ ? of_motions(lookup_.at_place->symbol) : ""; !text.empty()) return text + uses();
    for (const model::KinematicTree& tree : trees_)
      if (std::string text = of_declaration(tree); !text.empty()) return text;
    return fmt::format("**{}** `{}`", describe(lookup_.at_place->symbol.kind), lookup_.at_place->symbol.name) + uses();
  }

 private:
  Lookup& lookup_;
  std::vector<model::KinematicTree> trees_;
  std::optional<model::RigidMotions> motions_;

  std::string of_motions(const Symbol& symbol) const {
    if (symbol.kind == NameKind::frame) return text_of_frame(*motions_, symbol.name);
    if (symbol.kind != NameKind::parameter) return "";
    for (const model::Parameter& p : motions_->parameters)
      if (p.name == symbol.name) return text_of(p);
    return fmt::format("**variable** `{}`\n", symbol.name);
  }

  std::string uses() {
    if (lookup_.at_place == nullptr || lookup_.at_place->symbol.kind != NameKind::parameter) return "";
    std::size_t count = 0;
    for (const Occurrence& o : lookup_.occurrences) count += o.symbol == lookup_.at_place->symbol ? 1 : 0;
    return fmt::format("\n- {} use{} in this document", count, count == 1 ? "" : "s");
  }

  // Describes the word as a name in the whole robot.
  std::string of_word(const model::KinematicTree& tree, const std::string& word) const {
    const RobotText text(tree);
    const bool is_list = lookup_.document->desired() != nullptr;
    if (lookup_.at_place != nullptr && !lookup_.at_place->symbol.scope.empty() && !is_list) return "";
    const NameKind kind = lookup_.at_place != nullptr ? lookup_.at_place->symbol.kind : NameKind::frame;
    if (!is_list && lookup_.at_place == nullptr) return "";
    if (is_list || kind == NameKind::frame) {
      if (const auto frame = tree.find_frame(word)) return text.frame(*frame);
    } else if (kind == NameKind::link) {
      if (const auto link = tree.find_link(word)) return text.link(*link);
    } else if (kind == NameKind::joint) {
      if (const auto joint = tree.find_joint(word)) return text.joint(*joint);
    } else if (kind == NameKind::loop) {
      for (std::size_t l = 0; l < tree.loops.size(); ++l)
        if (tree.loops[l].name == word) return text.loop(l);
    } else if (kind == NameKind::parameter) {
      for (const model::Parameter& p : tree.parameters)
        if (p.name == word) return text_of(p);
    }
    return "";
  }

  // Describes a name declared in a part, by its first instance in the robot, or the coordinates of a joint with
  // several.
  std::string of_declaration(const model::KinematicTree& tree) const {
    const RobotText text(tree);
    const Symbol& symbol = lookup_.at_place->symbol;
    const Parsed* declares = lookup_.documents(symbol.document);
    if (declares == nullptr) return "";
    const auto is_declared_at = [&](const Place& place) {
      const Place written = written_at(place);
      if (!written.source || written.source->name() != symbol.document.string()) return false;
      for (const Occurrence& o : declared(*declares, symbol))
        if (o.span.begin >= written.span.begin && o.span.begin < written.span.end) return true;
      return false;
    };
    if (symbol.kind == NameKind::link) {
      for (std::size_t l = 0; l < tree.links.size(); ++l)
        if (!tree.links[l].is_virtual && !tree.links[l].is_repeated && is_declared_at(tree.links[l].place))
          return text.link(static_cast<int>(l));
    } else if (symbol.kind == NameKind::loop) {
      for (std::size_t l = 0; l < tree.loops.size(); ++l)
        if (is_declared_at(tree.loops[l].place)) return text.loop(l);
    } else if (symbol.kind == NameKind::joint) {
      std::string all;
      for (std::size_t j = 0; j < tree.joints.size(); ++j) {
        if (!tree.joints[j].is_first() || !is_declared_at(tree.joints[j].place)) continue;
        if (!all.empty() && symbol.scope != "") break;
        all += (all.empty() ? "" : "\n\n") + text.joint(static_cast<int>(j));
      }
      return all;
    } else if (symbol.kind == NameKind::frame) {
      for (const model::UserFrame& frame : tree.user_frames)
        if (is_declared_at(frame.place))
          if (const auto found = tree.find_frame(frame.name)) return text.frame(*found);
    }
    return "";
  }

  std::vector<Occurrence> declared(const Parsed& document, const Symbol& symbol) const {
    std::vector<Occurrence> result;
    for (Occurrence& o : lookup_.names.occurrences(document))
      if (o.is_declaration && o.symbol == symbol) result.push_back(std::move(o));
    return result;
  }
};

}  // namespace

std::optional<model::KinematicTree> tree_of(Workspace& workspace, const std::filesystem::path& path) {
  if (const OpenDocument* open = workspace.documents().find(path)) {
    const Analysis& analysis = workspace.analysis(*open);
    if (analysis.model && analysis.model->robot() != nullptr) return analysis.model->robot()->tree;
    return std::nullopt;
  }
  const std::optional<driver::Language> language = driver::language_of_suffix(path);
  if (!language || !driver::is_robot(*language)) return std::nullopt;
  std::string fault;
  std::optional<std::string> text = read_file(path, fault);
  if (!text) return std::nullopt;
  const OpenDocument file = {"", path, *language, 0, std::make_shared<const Source>(path.string(), std::move(*text))};
  const auto analysis = analyse(file, workspace.documents(), workspace.robots());
  if (!analysis->model || analysis->model->robot() == nullptr) return std::nullopt;
  return analysis->model->robot()->tree;
}

Json hover(Workspace& workspace, const Json& parameters) {
  Lookup lookup(workspace, parameters);
  if (lookup.document == nullptr) return nullptr;
  std::string text;
  Span span = {lookup.offset, lookup.offset};
  for (const Value& value : values_in(*lookup.document)) {
    if (value.span.begin > lookup.offset || lookup.offset > value.span.end) continue;
    text = describe(value, *lookup.document);
    span = value.span;
  }
  if (lookup.at_place != nullptr || text.empty()) {
    const std::string of_name = NameText(workspace, lookup)();
    if (!of_name.empty()) {
      text = of_name;
      if (lookup.at_place != nullptr) span = lookup.at_place->span;
    }
  }
  if (text.empty()) return nullptr;
  return {{"contents", {{"kind", "markdown"}, {"value", text}}}, {"range", lookup.here().json(span)}};
}

}  // namespace robcogen::server
