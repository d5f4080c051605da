#include "server/collect_names.h"

#include <algorithm>
#include <utility>

#include "language/kinematics/expressions.h"

namespace robcogen::server {
namespace {

namespace kinematics = language::kinematics;
using language::Expression;
using language::ExpressionPtr;
using language::Token;

// Shared by all languages.
class Collector {
 public:
  Collector(const Parsed& document, Names& names) : document_(document), names_(names) {}

  std::vector<Occurrence> list;

 protected:
  const Parsed& document_;
  Names& names_;

  // Returns the span of the word without its '^'. Words that the parser invented have no place.
  Span word(const Span& span) const {
    const std::string_view text = document_.source->text();
    const bool is_escaped = span.begin < text.size() && text[span.begin] == '^';
    return {span.begin + (is_escaped ? 1 : 0), span.end};
  }

  void add(const Span& span, Symbol symbol, bool is_declaration = false) {
    const Span place = word(span);
    if (place.end > document_.source->text().size() || place.end <= place.begin) return;
    list.push_back({place, std::move(symbol), is_declaration});
  }
  template <class Name>
  void declare(const Name& name, NameKind kind, const std::string& scope = "") {
    if (!name.text.empty()) add(name.span, {document_.path, scope, kind, name.text}, true);
  }
  template <class Name>
  void use(const Name& name, NameKind kind, const std::string& scope = "") {
    if (!name.text.empty()) add(name.span, {document_.path, scope, kind, name.text});
  }
  void add_pieces(const Span& span, const std::vector<Names::Piece>& pieces) {
    const Span place = word(span);
    for (const Names::Piece& piece : pieces)
      add({place.begin + piece.span.begin, place.begin + piece.span.end}, piece.symbol);
  }

  // Finds the word `name` among the tokens of an expression, after skipping `skipped` words.
  std::optional<Span> word_in(const Span& span, const std::string& name, std::size_t skipped) const {
    const auto& tokens = document_.tokens.tokens;
    auto token = std::lower_bound(
        tokens.begin(), tokens.end(), span.begin, [](const Token& t, std::size_t at) { return t.span.begin < at; });
    for (; token != tokens.end() && token->span.begin < span.end; ++token) {
      if (token->kind != Token::Kind::identifier) continue;
      if (skipped > 0)
        --skipped;
      else if (token->text == name)
        return token->span;
    }
    return std::nullopt;
  }

  // Collects the pieces of `leg.foot` at the span: `leg` is an instance or a loop variable, which stands for each
  // instance of the loop, and `foot` is the name in their part.
  template <class Loops>
  void member(
      const Scope& scope,
      const Span& span,
      const std::string& instance,
      const std::string& name,
      const Loops& loops,
      int loop,
      bool is_frame) {
    const auto index = static_cast<std::size_t>(loop);
    const bool is_variable = loop >= 0 && index < loops.size() && loops[index].variable.text == instance;
    if (is_variable && loops[index].instances.empty()) return;
    const std::string& first = is_variable ? loops[index].instances.front().text : instance;
    if (const auto place = word_in(span, instance, 0); place && !is_variable)
      add(*place, {scope.document->path, scope.name(), NameKind::instance, instance});
    const std::optional<Scope> attached = names_.instance(scope, first);
    if (const auto place = word_in(span, name, 1); place && attached)
      add_pieces(*place, is_frame ? names_.frame(*attached, name) : names_.element(*attached, name));
  }
  // Collects the instances that the heads of loops list.
  template <class Loops>
  void instances_of(const Loops& loops, const Scope& scope) {
    for (const auto& loop : loops)
      for (const auto& instance : loop.instances)
        add(instance.span, {scope.document->path, scope.name(), NameKind::instance, instance.text});
  }

  // Visits every name in an expression: visit(expression, span of the name).
  template <class Visit>
  void visit_names(const ExpressionPtr& e, const Visit& visit) const {
    if (!e) return;
    if (e->kind == Expression::Kind::name) {
      const std::size_t skipped = (e->is_parameter ? 1 : 0) + (e->group.empty() ? 0 : 1);
      if (const auto span = word_in(e->span, e->name, skipped)) visit(*e, *span);
      return;
    }
    if (e->kind == Expression::Kind::constant) {
      const std::string_view text = document_.source->text().substr(e->span.begin, 1);
      if (const auto span = word_in(e->span, e->name, text == "<" ? 0 : 1)) visit(*e, *span);
      return;
    }
    visit_names(e->left, visit);
    visit_names(e->right, visit);
  }
};

class RobotCollector : public Collector {
 public:
  using Collector::Collector;

  void run(const kinematics::Document& robot) {
    for (const kinematics::Import& import : robot.imports)
      if (import.name) declare(*import.name, NameKind::part);
    for (const kinematics::Part& part : robot.parts) {
      declare(part.name, NameKind::part);
      scope_ = {&document_, &part};
      for (const kinematics::PartParameter& parameter : part.parameters) {
        declare(parameter.name, NameKind::parameter, part.name.text);
        expression(parameter.default_value);
      }
      for (const kinematics::Child& root : part.roots) child(root);
      body(part);
    }
    scope_ = {&document_, nullptr};
    declare(robot.robot, NameKind::robot);
    body(robot);
  }

 private:
  Scope scope_;

  std::string scope() const { return scope_.name(); }

  void child(const kinematics::Child& child) {
    use(child.link, NameKind::link, scope());
    use(child.joint, NameKind::joint, scope());
  }

  bool is_of_part(const std::string& parameter) const {
    if (scope_.part == nullptr) return false;
    const auto& known = scope_.part->parameters;
    return std::any_of(known.begin(), known.end(), [&](const auto& p) { return p.name.text == parameter; });
  }

  void named(const Expression& e, const Span& span) {
    const bool is_constant = e.kind == Expression::Kind::constant;
    const std::string of = is_of_part(e.name) ? scope() : "";
    add(span, {document_.path, is_constant ? "" : of, is_constant ? NameKind::constant : NameKind::parameter, e.name},
        e.default_value.has_value() || (is_constant && e.left));
  }
  void expression(const ExpressionPtr& e) {
    visit_names(e, [&](const Expression& name, const Span& span) { named(name, span); });
  }

  void body(const kinematics::Body& body) {
    for (const kinematics::Link& link : body.links) this->link(link);
    for (const kinematics::Joint& joint : body.joints) {
      declare(joint.name, NameKind::joint, scope());
      kinematics::visit_joint(joint, [&](const ExpressionPtr& e) { expression(e); });
      carrier(joint.rotor);
      for (const kinematics::Coordinate& coordinate : joint.coordinates) carrier(coordinate.rotor);
    }
    instances_of(body.loops, scope_);
    for (const kinematics::Coupling& coupling : body.couplings) this->coupling(coupling, body.loops);
    for (const kinematics::LoopJoint& loop : body.loop_joints) {
      declare(loop.name, NameKind::loop, scope());
      frames(loop.frames);
      if (loop.distance) expression(loop.distance);
    }
    for (const kinematics::Actuator& actuator : body.actuators) frames(actuator.frames);
    for (const kinematics::Tendon& tendon : body.tendons) {
      sum(tendon.length, body.loops, kinematics::Coupling::kNoLoop);
      for (const ExpressionPtr& e : {tendon.stiffness, tendon.damping, tendon.rest})
        if (e) expression(e);
    }
    for (const kinematics::Name& joint : body.independents) add_pieces(joint.span, names_.element(scope_, joint.text));
  }

  void frames(const std::array<kinematics::Name, 2>& frames) {
    for (const kinematics::Name& frame : frames) add_pieces(frame.span, names_.frame(scope_, frame.text));
  }

  void coupling(const kinematics::Coupling& coupling, const std::vector<kinematics::Loop>& loops) {
    if (coupling.instance.empty())
      add_pieces(coupling.joint.span, names_.element(scope_, coupling.joint.text));
    else
      member(scope_, coupling.joint.span, coupling.instance, coupling.joint.text, loops, coupling.loop, false);
    sum(coupling.value, loops, coupling.loop);
  }

  // A sum of joint positions: names are joints, parameters, or units.
  void sum(const ExpressionPtr& value, const std::vector<kinematics::Loop>& loops, int loop) {
    visit_names(value, [&](const Expression& e, const Span& span) {
      if (!e.group.empty()) return member(scope_, e.span, e.group, e.name, loops, loop, false);
      const auto pieces = names_.element(scope_, e.name);
      const bool is_joint = !pieces.empty() && !e.is_parameter && e.kind == Expression::Kind::name;
      const bool is_unit = (e.name == "rad" || e.name == "m") && !e.is_parameter && !is_of_part(e.name);
      if (is_joint)
        add_pieces(span, pieces);
      else if (!is_unit)
        named(e, span);
    });
  }

  void carrier(const std::optional<kinematics::Rotor>& rotor) {
    if (rotor && rotor->carrier) add_pieces(rotor->carrier->span, names_.element(scope_, rotor->carrier->text));
  }

  void link(const kinematics::Link& link) {
    declare(link.name, NameKind::link, scope());
    if (link.inertia && link.inertia->reference)
      add_pieces(link.inertia->reference->span, names_.frame(scope_, link.inertia->reference->text));
    for (const kinematics::Child& child : link.children) this->child(child);
    for (const kinematics::Frame& frame : link.frames) declare(frame.name, NameKind::frame, scope());
    kinematics::visit_link(link, [&](const ExpressionPtr& e) { expression(e); });
    for (const kinematics::Instance& instance : link.instances) this->instance(instance);
  }

  void instance(const kinematics::Instance& instance) {
    declare(instance.name, NameKind::instance, scope());
    const std::optional<Scope> attached = names_.part(document_, instance.part.text);
    const std::string known_as = alias(instance.part.text);
    if (!known_as.empty())
      add(instance.part.span, {document_.path, "", NameKind::part, known_as});
    else if (attached && attached->part != nullptr)
      add(instance.part.span, {attached->document->path, "", NameKind::part, instance.part.text});
    else if (attached)
      add(instance.part.span, {attached->document->path, "", NameKind::robot, instance.part.text});
    if (!attached) return;
    for (const kinematics::Argument& argument : instance.arguments)
      add(argument.name.span, {attached->document->path, attached->name(), NameKind::parameter, argument.name.text});
    if (!instance.mirror) return;
    for (const kinematics::Name& joint : instance.mirror->joints)
      add_pieces(joint.span, names_.element(*attached, joint.text));
  }

  // Returns the name if an import of this document assigns it, or else an empty string.
  std::string alias(const std::string& name) const {
    for (const kinematics::Import& import : document_.robot()->imports)
      if (import.name && import.name->text == name) return name;
    return "";
  }
};

// Documents of motions and of transforms.
class FramesCollector : public Collector {
 public:
  using Collector::Collector;

  template <class Document, class Statements>
  void run(const Document& document, const Statements& statements) {
    declare(document.header.model, NameKind::robot);
    for (const auto& name : document.header.frames.value_or(std::vector<language::Name>())) frame(name, true);
    for (const language::ParameterGroup& group : document.header.groups) {
      declare(group.name, NameKind::group);
      for (const language::Name& parameter : group.parameters) declare(parameter, NameKind::parameter, group.name.text);
    }
    statements(*this);
  }
  // `is_listed` tells that the name is in the list of frames. If there is no list, the first use of a frame declares
  // it.
  void frame(const language::Name& name, bool is_listed = false) {
    add(name.span, {document_.path, "", NameKind::frame, name.text}, known_.insert(name.text).second || is_listed);
  }
  void steps(const std::vector<language::AxisStep>& steps) {
    for (const language::AxisStep& step : steps) {
      visit_names(step.amount, [&](const Expression& e, const Span& span) {
        const bool is_constant = e.kind == Expression::Kind::constant;
        add(span, {document_.path, e.group, is_constant ? NameKind::constant : NameKind::parameter, e.name},
            e.default_value.has_value() || (is_constant && e.left));
        if (e.group.empty()) return;
        if (const auto group = word_in(e.span, e.group, e.is_parameter ? 1 : 0))
          add(*group, {document_.path, "", NameKind::group, e.group});
      });
    }
  }
  void user_name(const std::optional<language::Name>& name) {
    if (name) declare(*name, NameKind::transform);
  }

 private:
  std::set<std::string> known_;
};

class UrdfCollector : public Collector {
 public:
  using Collector::Collector;

  void run(const UrdfNames& urdf) {
    declare(urdf.robot, NameKind::robot);
    for (const UrdfLink& link : urdf.links) declare(link.name, NameKind::link);
    for (const UrdfJoint& joint : urdf.joints) {
      declare(joint.name, NameKind::joint);
      use(joint.parent, NameKind::link);
      use(joint.child, NameKind::link);
    }
    for (const UrdfName& name : urdf.uses) add_pieces(name.span, names_.element({&document_, nullptr}, name.text));
  }
};

class ListCollector : public Collector {
 public:
  using Collector::Collector;

  void run(const language::desired::Document& document) {
    model_ = names_.model_of(document_);
    if (model_ != nullptr && declares(document.robot.text))
      add(document.robot.span, {model_->path, "", NameKind::robot, document.robot.text});
    if (model_ != nullptr && model_->robot() != nullptr) instances_of(document.loops, {model_, nullptr});
    for (const auto& name : document.frames) frame(name, document.loops);
    for (const auto* pairs : {&document.transforms, &document.jacobians}) {
      for (const language::desired::Pair& pair : *pairs) {
        frame(pair.left, document.loops);
        frame(pair.right, document.loops);
      }
    }
    for (const language::desired::Inverse& inverse : document.inverses) {
      frame(inverse.pair.left, document.loops);
      frame(inverse.pair.right, document.loops);
    }
    for (const language::desired::Contact& contact : document.contacts) frame(contact.frame, document.loops);
  }

 private:
  const Parsed* model_ = nullptr;

  bool declares(const std::string& name) const {
    if (model_->urdf() != nullptr) return model_->urdf()->robot.text == name;
    if (model_->robot() != nullptr) return model_->robot()->robot.text == name;
    if (model_->motions() != nullptr) return model_->motions()->header.model.text == name;
    return model_->transforms() != nullptr && model_->transforms()->header.model.text == name;
  }

  void frame(const language::desired::Name& name, const std::vector<language::desired::Loop>& loops) {
    if (model_ == nullptr) return;
    if (!name.instance.empty()) {
      if (model_->robot() != nullptr)
        member({model_, nullptr}, name.span, name.instance, name.text, loops, name.loop, true);
      return;
    }
    if (model_->robot() != nullptr || model_->urdf() != nullptr)
      add_pieces(name.span, names_.frame({model_, nullptr}, name.text));
    else if (model_->motions() != nullptr || model_->transforms() != nullptr)
      add(name.span, {model_->path, "", NameKind::frame, name.text});
  }
};

}  // namespace

std::vector<Occurrence> collect_names(const Parsed& document, Names& names) {
  if (document.urdf() != nullptr) {
    UrdfCollector collector(document, names);
    collector.run(*document.urdf());
    return std::move(collector.list);
  }
  if (document.robot() != nullptr) {
    RobotCollector collector(document, names);
    collector.run(*document.robot());
    return std::move(collector.list);
  }
  if (document.desired() != nullptr) {
    ListCollector collector(document, names);
    collector.run(*document.desired());
    return std::move(collector.list);
  }
  FramesCollector collector(document, names);
  if (const auto* motions = document.motions()) {
    collector.run(*motions, [&](FramesCollector& c) {
      for (const language::motion::Motion& motion : motions->motions) {
        c.frame(motion.from);
        c.frame(motion.to);
        c.steps(motion.steps);
        c.user_name(motion.name);
      }
    });
  } else if (const auto* transforms = document.transforms()) {
    collector.run(*transforms, [&](FramesCollector& c) {
      for (const language::transforms::Transform& transform : transforms->transforms) {
        c.frame(transform.left);
        c.frame(transform.right);
        c.steps(transform.primitives);
        c.user_name(transform.name);
      }
    });
  }
  return std::move(collector.list);
}

}  // namespace robcogen::server
