#include "language/kinematics/original.h"

#include <fmt/format.h>

namespace robcogen::language::kinematics {
namespace {

using Kind = Expression::Kind;

// Whether this is PI or a parameter, with or without a sign.
bool is_plain_name(const Expression& e) {
  if (e.kind == Kind::negate) return is_plain_name(*e.left);
  const bool is_qualified = !e.group.empty() || e.is_parameter || e.default_value;
  return e.kind == Kind::pi || (e.kind == Kind::name && !is_qualified);
}

// Whether this is a number, a name, a number times a name, or a name divided by a number.
bool is_plain(const Expression& e) {
  if (e.kind == Kind::number || is_plain_name(e)) return true;
  if (e.kind == Kind::negate) return is_plain(*e.left);
  if (e.kind == Kind::multiply) return e.left->kind == Kind::number && is_plain_name(*e.right);
  return e.kind == Kind::divide && is_plain_name(*e.left) && e.right->kind == Kind::number;
}

class Judge {
 public:
  Judge(const Document& document, Diagnostics& diagnostics) : document_(document), diagnostics_(diagnostics) {}

  bool run() {
    for (const Import& i : document_.imports) refuse(i.span, "'import'");
    for (const Part& part : document_.parts) refuse(part.name.span, "'Part'");
    if (document_.joints.empty()) refuse(document_.robot.span, "a robot without joints");
    for (const Link& link : document_.links) judge(link);
    for (const Joint& joint : document_.joints) judge(joint);
    if (!document_.couplings.empty()) refuse(document_.couplings.front().joint.span, "'couplings'");
    if (!document_.loop_joints.empty()) refuse(document_.loop_joints.front().name.span, "'loops'");
    if (!document_.independents.empty()) refuse(document_.independents.front().span, "'independent'");
    if (!document_.actuators.empty()) refuse(document_.actuators.front().name.span, "'actuators'");
    if (!document_.tendons.empty()) refuse(document_.tendons.front().name.span, "'tendons'");
    return is_original_;
  }

 private:
  const Document& document_;
  Diagnostics& diagnostics_;
  bool is_original_ = true;

  void refuse(Span span, const std::string& what) {
    diagnostics_.error(
        "not-original", {document_.source, span}, fmt::format("the first RobCoGen does not read {}", what));
    is_original_ = false;
  }

  void judge(const ExpressionPtr& e) {
    if (!is_plain(*e)) refuse(e->span, fmt::format("the expression '{}'", language::print(*e)));
  }

  void judge(const Vector& v) {
    for (const ExpressionPtr& e : v) judge(e);
  }

  void judge(const Placement& placement) {
    judge(placement.translation);
    judge(placement.rotation);
  }

  void judge(const Link& link) {
    if (!link.inertia) {
      if (!link.is_base) refuse(link.name.span, fmt::format("link '{}' without 'inertia_params'", link.name.text));
    } else {
      const Inertia& i = *link.inertia;
      judge(i.mass);
      judge(i.com);
      for (const ExpressionPtr& e : {i.ix, i.iy, i.iz, i.ixy, i.ixz, i.iyz}) judge(e);
    }
    for (const Frame& frame : link.frames) judge(frame.placement);
    for (const Instance& i : link.instances) refuse(i.part.span, "a part that is attached to a link");
  }

  void judge(const Joint& joint) {
    if (joint.type != Joint::Type::revolute && joint.type != Joint::Type::prismatic)
      refuse(joint.name.span, fmt::format("'{}' ('{}')", word_of(joint.type), joint.name.text));
    judge(joint.placement);
    const auto refuse_clause = [&](const char* word, const ExpressionPtr& e) {
      if (e) refuse(e->span, fmt::format("'{}' of joint '{}'", word, joint.name.text));
    };
    refuse_clause("damping", joint.drive.damping);
    refuse_clause("friction", joint.drive.friction);
    refuse_clause("armature", joint.drive.armature);
    refuse_clause("spring", joint.drive.stiffness);
    if (joint.elasticity) refuse(joint.elasticity->span, fmt::format("'elastic' of joint '{}'", joint.name.text));
    if (joint.rotor) refuse(joint.rotor->span, fmt::format("'rotor' of joint '{}'", joint.name.text));
    const Limits& limits = joint.limits;
    const ExpressionPtr& first = limits.position ? (*limits.position)[0] : limits.velocity;
    refuse_clause("limits", first ? first : limits.effort);
    refuse_clause("assembled", joint.assembled);
  }
};

}  // namespace

bool is_original(const Document& document, Diagnostics& diagnostics) {
  return Judge(document, diagnostics).run();
}

}  // namespace robcogen::language::kinematics
