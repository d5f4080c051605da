// What a name or a number is, in numbers of the robot at q = 0.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "server/features.h"
#include "server/lookup.h"
#include "server/mechanics.h"
#include "server/values.h"
#include "support/files.h"

namespace robcogen::server {
namespace {

// Six digits, and 0 for what is rounding.
std::string text_of_number(double value) {
  if (std::isnan(value)) return "?";
  return fmt::format("{:.6g}", std::abs(value) < 1e-12 ? 0.0 : value);
}

std::string text_of_vector(const Vector3& v) {
  return fmt::format("({}, {}, {})", text_of_number(v[0]), text_of_number(v[1]), text_of_number(v[2]));
}

std::string text_of_degrees(const Vector3& radians) {
  constexpr double kDegrees = 180.0 / std::numbers::pi;
  return text_of_vector({radians[0] * kDegrees, radians[1] * kDegrees, radians[2] * kDegrees});
}

// Lines of a hover text about an element of a robot.
class RobotText {
 public:
  explicit RobotText(const model::KinematicTree& tree) : tree_(tree), resting_(tree) {}

  std::string link(int l) const {
    const model::Link& link = tree_.links[static_cast<std::size_t>(l)];
    std::string text = fmt::format("**link** `{}`", link.name);
    if (link.parent_joint >= 0) {
      // Between the components of a spherical joint its child is repeated.
      int parent = link.parent_joint;
      while (tree_.links[static_cast<std::size_t>(tree_.joints[static_cast<std::size_t>(parent)].parent)].is_repeated)
        parent = tree_.parent_joint_of(parent);
      const model::Joint& joint = tree_.joints[static_cast<std::size_t>(parent)];
      text += fmt::format(
          ", child of `{}` via `{}`", tree_.links[static_cast<std::size_t>(joint.parent)].name, joint.declared_name());
    } else {
      text += tree_.floating_base ? ", the floating base" : ", the base";
    }
    if (link.inertia) {
      text += fmt::format("\n\n- mass {} kg", text_of_number(resting_.mass(l)));
      text += fmt::format("\n- centre of mass {} m, in the link frame", text_of_vector(resting_.com(l)));
      text += fmt::format(
          "\n- principal moments {} kg m², about the centre of mass", text_of_vector(resting_.principal_moments(l)));
    } else {
      text += "\n\n- massless";
    }
    const Carried& carried = resting_.carried(l);
    if (carried.mass != 0.0 && !link.child_joints.empty())
      text += fmt::format(
          "\n- with all it carries: {} kg, centre of mass {} m in the base at q = 0", text_of_number(carried.mass),
          text_of_vector(carried.com));
    return text + unknown_parameters();
  }

  std::string joint(int j) const {
    const model::Joint& joint = tree_.joints[static_cast<std::size_t>(j)];
    const char* type = joint.type == model::JointType::revolute    ? "revolute"
                       : joint.type == model::JointType::prismatic ? "prismatic"
                       : joint.type == model::JointType::helical   ? "helical"
                                                                   : "spherical";
    const bool turns = model::turns(joint.type);
    std::string text = fmt::format(
        "**{} joint** `{}`, from `{}` to `{}`\n\n", type, joint.declared_name(),
        tree_.links[static_cast<std::size_t>(joint.parent)].name,
        tree_.links[static_cast<std::size_t>(joint.child)].name);
    text += joint.type == model::JointType::spherical
                ? "- turns in any way about the origin of its frame"
                : fmt::format("- axis {} in the base at q = 0", text_of_vector(resting_.axis(j)));
    if (joint.type == model::JointType::helical)
      text += fmt::format("\n- pitch {} m/rad", text_of_number(resting_.value(joint.pitch)));
    const model::JointLimits& limits = joint.limits;
    if (std::isfinite(limits.lower) || std::isfinite(limits.upper))
      text += fmt::format(
          "\n- limits {} to {} {}", text_of_number(limits.lower), text_of_number(limits.upper), turns ? "rad" : "m");
    if (std::isfinite(limits.velocity))
      text += fmt::format("\n- velocity up to {} {}", text_of_number(limits.velocity), turns ? "rad/s" : "m/s");
    if (std::isfinite(limits.effort))
      text += fmt::format("\n- effort up to {} {}", text_of_number(limits.effort), turns ? "N m" : "N");
    if (tree_.coupling_of(j) != nullptr)
      text += tree_.coupling_of(j)->is_linear() ? "\n- coupled to other joints: no coordinate of its own"
                                                : "\n- follows through a loop: no coordinate of its own";
    return text + unknown_parameters();
  }

  std::string loop(std::size_t l) const {
    const model::LoopJoint& loop = tree_.loops[l];
    std::string text =
        fmt::format("**loop** `{}`, {}", loop.name, model::kLoopTypes[static_cast<std::size_t>(loop.type)]);
    if (loop.type == model::LoopType::distance)
      text += fmt::format(" {} m", text_of_number(resting_.value(loop.length)));
    const char* separator = "\n\n- frame";
    for (const model::LoopEnd& end : loop.ends) {
      const std::string& link = tree_.links[static_cast<std::size_t>(end.link)].name;
      text += fmt::format("{} `{}` of link `{}`", std::exchange(separator, " and"), end.frame, link);
    }
    for (const model::Closure& closure : tree_.closures) {
      if (std::find(closure.loops.begin(), closure.loops.end(), static_cast<int>(l)) == closure.loops.end()) continue;
      for (const int j : closure.dependents)
        text += fmt::format("\n- `{}` follows", tree_.joints[static_cast<std::size_t>(j)].declared_name());
    }
    return text + unknown_parameters();
  }

  std::string frame(const model::Frame& frame) const {
    const BasePose pose = resting_.frame(frame);
    const std::string& link = tree_.links[static_cast<std::size_t>(tree_.link_of(frame))].name;
    return fmt::format(
               "**frame** `{}` of link `{}`\n\n- origin {} m in the base at q = 0\n- rotation {}° about x, y', z''",
               frame.name, link, text_of_vector(pose.translation), text_of_degrees(angles_of(pose))) +
           unknown_parameters();
  }

  std::string parameter(const model::Parameter& p) const {
    const char* kind = p.kind == model::ParameterKind::length  ? "a length (m)"
                       : p.kind == model::ParameterKind::angle ? "an angle (rad)"
                       : p.kind == model::ParameterKind::ratio ? "a ratio"
                                                               : "of dynamics";
    return fmt::format(
        "**parameter** `{}`, {}{}\n\n- default {}", p.name, kind, p.is_in_masses_too ? ", in mass properties too" : "",
        p.default_value ? print_double(*p.default_value) : "none");
  }

 private:
  const model::KinematicTree& tree_;
  RestingRobot resting_;

  std::string unknown_parameters() const {
    for (const model::Parameter& p : tree_.parameters)
      if (!p.default_value) return "\n- ? depends on parameters without a default";
    return "";
  }
};

// The robots that may tell about a symbol: that of the document, of the list's, or those that use its part.
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

// The whole word that holds the place.
std::string word_at_place(const Lookup& lookup) {
  for (const language::Token& token : lookup.document->tokens.tokens)
    if (token.kind == language::Token::Kind::identifier && token.span.begin <= lookup.offset &&
        lookup.offset <= token.span.end)
      return std::string(token.text);
  return "";
}

class NameText {
 public:
  NameText(Workspace& workspace, Lookup& lookup) : lookup_(lookup), trees_(trees_for(workspace, lookup)) {}

  // Empty where nothing is known.
  std::string operator()() {
    const std::string word = word_at_place(lookup_);
    for (const model::KinematicTree& tree : trees_)
      if (std::string text = of_word(tree, word); !text.empty()) return text + uses();
    if (lookup_.at_place == nullptr) return "";
    for (const model::KinematicTree& tree : trees_)
      if (std::string text = of_declaration(tree); !text.empty()) return text;
    return fmt::format("**{}** `{}`", describe(lookup_.at_place->symbol.kind), lookup_.at_place->symbol.name) + uses();
  }

 private:
  Lookup& lookup_;
  std::vector<model::KinematicTree> trees_;

  std::string uses() {
    if (lookup_.at_place == nullptr || lookup_.at_place->symbol.kind != NameKind::parameter) return "";
    std::size_t count = 0;
    for (const Occurrence& o : lookup_.occurrences) count += o.symbol == lookup_.at_place->symbol ? 1 : 0;
    return fmt::format("\n- {} use{} in this document", count, count == 1 ? "" : "s");
  }

  // The word as a name of the whole robot.
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
        if (p.name == word) return text.parameter(p);
    }
    return "";
  }

  // In a part: its first instance in the robot, and the coordinates of a joint with several.
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
