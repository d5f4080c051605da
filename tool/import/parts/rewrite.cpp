#include "import/parts/rewrite.h"

#include <fmt/format.h>

#include <utility>

#include "import/parts/assembly.h"
#include "import/parts/terms.h"
#include "language/kinematics/expressions.h"

namespace robcogen::import::parts {
namespace {

using Kind = Expression::Kind;
using kinematics::Body;
using kinematics::Name;

bool is_declared(const Expression& e) {
  return !e.group.empty() || e.is_parameter || e.default_value.has_value();
}

class Rewriter {
 public:
  Rewriter(
      std::size_t shift,
      const Meanings& meanings,
      const std::shared_ptr<const Source>& source,
      Diagnostics& diagnostics)
      : shift_(shift), meanings_(meanings), source_(source), diagnostics_(diagnostics) {}

  void rewrite(Body& body) {
    for (kinematics::Link& link : body.links) rewrite(link);
    for (kinematics::Joint& joint : body.joints) {
      shift(joint.name);
      shift(joint.span);
      shift(joint.placement.span);
      for (kinematics::Coordinate& coordinate : joint.coordinates) shift(coordinate.word);
      for (kinematics::Rotor* rotor : rotors_of(joint)) {
        shift(rotor->span);
        if (rotor->carrier) shift(*rotor->carrier);
      }
      if (joint.elasticity) shift(joint.elasticity->span);
      for (kinematics::Coordinate& coordinate : joint.coordinates)
        if (coordinate.elasticity) shift(coordinate.elasticity->span);
      visit_joint(joint, [&](ExpressionPtr& e) { e = rewritten(e); });
    }
    for (kinematics::LoopJoint& loop : body.loop_joints) {
      for (Name* name : {&loop.name, &loop.frames[0], &loop.frames[1], &loop.type}) shift(*name);
      if (loop.distance) loop.distance = rewritten(loop.distance);
    }
    for (kinematics::Actuator& actuator : body.actuators)
      for (Name* name : {&actuator.name, &actuator.frames[0], &actuator.frames[1]}) shift(*name);
    for (Name& joint : body.independents) shift(joint);
    for (kinematics::Tendon& tendon : body.tendons) {
      shift(tendon.name);
      for (ExpressionPtr* e : {&tendon.stiffness, &tendon.damping, &tendon.rest})
        if (*e) *e = rewritten(*e);
    }
    is_coupling_ = true;
    for (kinematics::Tendon& tendon : body.tendons) tendon.length = rewritten(tendon.length);
    for (kinematics::Coupling& coupling : body.couplings) {
      shift(coupling.joint);
      coupling.value = rewritten(coupling.value);
    }
    for (kinematics::Loop& loop : body.loops) {
      shift(loop.variable);
      for (Name& instance : loop.instances) shift(instance);
    }
  }

 private:
  std::size_t shift_;
  const Meanings& meanings_;
  const std::shared_ptr<const Source>& source_;
  Diagnostics& diagnostics_;
  bool is_coupling_ = false;  // or the length of a tendon: names are joints, too

  Span shifted(const Span& span) const { return {span.begin + shift_, span.end + shift_}; }
  void shift(Span& span) const { span = shifted(span); }
  void shift(Name& name) const { shift(name.span); }

  void rewrite(kinematics::Link& link) {
    shift(link.name);
    shift(link.id_span);
    shift(link.span);
    if (link.inertia) {
      shift(link.inertia->span);
      if (link.inertia->reference) shift(*link.inertia->reference);
    }
    for (kinematics::Child& child : link.children) {
      shift(child.link);
      shift(child.joint);
    }
    for (kinematics::Frame& frame : link.frames) {
      shift(frame.name);
      shift(frame.placement.span);
    }
    for (kinematics::Instance& instance : link.instances) rewrite(instance);
    visit_link(link, [&](ExpressionPtr& e) { e = rewritten(e); });
  }

  void rewrite(kinematics::Instance& instance) const {
    shift(instance.part);
    shift(instance.name);
    for (kinematics::Argument& argument : instance.arguments) shift(argument.name);
    if (instance.placement) shift(instance.placement->span);
    if (instance.mirror) {
      shift(instance.mirror->span);
      for (Name& joint : instance.mirror->joints) shift(joint);
    }
    if (instance.keep) shift(*instance.keep);
  }

  // Expressions in which nothing but the place changed are not folded.
  ExpressionPtr rewritten(const ExpressionPtr& e) const {
    const bool has_name = e->kind == Kind::name || e->kind == Kind::pi;
    if (has_name && e->group.empty()) {
      const auto value = meanings_.values.find(e->name);
      if (value != meanings_.values.end()) {
        require_plain(*e);
        return at(value->second, shifted(e->span));
      }
      if (e->kind == Kind::name) require_meaning(*e);
    }
    Expression result = *e;
    shift(result.span);
    if (e->left) result.left = rewritten(e->left);
    if (e->right) result.right = rewritten(e->right);
    if (!has_argument(*e)) return std::make_shared<const Expression>(std::move(result));
    return at(with_operands(result, result.left, result.right), result.span);
  }

  bool has_argument(const Expression& e) const {
    for (const ExpressionPtr& operand : {e.left, e.right}) {
      if (!operand) continue;
      if (operand->group.empty() && (operand->kind == Kind::name || operand->kind == Kind::pi) &&
          meanings_.values.contains(operand->name))
        return true;
      if (has_argument(*operand)) return true;
    }
    return false;
  }

  static ExpressionPtr at(const ExpressionPtr& e, const Span& span) {
    Expression result = *e;
    result.span = span;
    return std::make_shared<const Expression>(std::move(result));
  }

  // Otherwise it would be unclear whether the part's parameter or one of the robot is meant.
  void require_plain(const Expression& e) const {
    if (meanings_.part.empty() || !is_declared(e)) return;
    const std::string text = (e.is_parameter ? "p:" : "") + e.name + (e.default_value ? "[…]" : "");
    diagnostics_
        .error(
            "parameter-of-part", {source_, shifted(e.span)},
            fmt::format(
                "'{}' declares a parameter of the robot, but '{}' is a parameter of part '{}'", text, e.name,
                meanings_.part))
        .hint = e.default_value ? fmt::format(
                                      "write '{0}', and a default value where the part declares it: 'Part {1}({0}[…])'",
                                      e.name, meanings_.part)
                                : fmt::format("write '{}', or choose another name", e.name);
  }

  void require_meaning(const Expression& e) const {
    if (meanings_.part.empty() || is_declared(e)) return;
    const bool is_unit = e.name == "rad" || e.name == "m";
    if (is_coupling_ && (is_unit || meanings_.joints.contains(e.name))) return;
    std::vector<std::string> known;
    for (const auto& [name, value] : meanings_.values) known.push_back(name);
    if (is_coupling_) known.insert(known.end(), meanings_.joints.begin(), meanings_.joints.end());
    diagnostics_
        .error(
            "unknown-parameter", {source_, shifted(e.span)},
            fmt::format(
                "part '{}' has no parameter{} '{}'", meanings_.part, is_coupling_ ? " and no joint" : "", e.name))
        .hint = did_you_mean(e.name, known);
  }
};

void add_names(const Expression& e, std::set<std::string>& names) {
  if (e.kind == Kind::name) names.insert(e.name);
  if (e.left) add_names(*e.left, names);
  if (e.right) add_names(*e.right, names);
}

}  // namespace

Body rewritten(
    Body body,
    std::size_t shift,
    const Meanings& meanings,
    const std::shared_ptr<const Source>& source,
    Diagnostics& diagnostics) {
  Rewriter(shift, meanings, source, diagnostics).rewrite(body);
  return body;
}

std::set<std::string> parameters_of(const Body& body) {
  std::set<std::string> names;
  visit_body(body, [&](const ExpressionPtr& e) { add_names(*e, names); });
  for (const kinematics::Joint& joint : body.joints)
    for (const std::string& name : coordinate_names(joint)) names.erase(name);
  return names;
}

}  // namespace robcogen::import::parts
