#include "model/quantities.h"

#include <array>
#include <utility>
#include <vector>

#include "support/index.h"

namespace robcogen::model {
namespace {

using Visit = std::function<void(Quantity&)>;

void visit_all(std::array<Quantity, 3>& quantities, const Visit& visit) {
  for (Quantity& q : quantities) visit(q);
}

void visit_all(Placement& placement, const Visit& visit) {
  visit_all(placement.translation, visit);
  visit_all(placement.rotation, visit);
}

void visit_all(Inertia& inertia, const Visit& visit) {
  visit(inertia.mass);
  visit_all(inertia.com, visit);
  for (Quantity* q : {&inertia.ixx, &inertia.iyy, &inertia.izz, &inertia.ixy, &inertia.ixz, &inertia.iyz}) visit(*q);
  if (inertia.reference) visit_all(*inertia.reference, visit);
}

void visit_all(DescribedLink& link, const Visit& visit) {
  if (link.inertia) visit_all(*link.inertia, visit);
  for (DescribedFrame& frame : link.frames) visit_all(frame.placement, visit);
}

void visit_all(Drive& drive, const Visit& visit) {
  for (Quantity* q :
       {&drive.damping, &drive.friction, &drive.friction_velocity, &drive.armature, &drive.stiffness, &drive.rest})
    visit(*q);
  if (!drive.rotor) return;
  visit(drive.rotor->inertia);
  visit(drive.rotor->ratio);
  if (drive.rotor->axis) visit_all(*drive.rotor->axis, visit);
}

}  // namespace

void visit_quantities(Description& description, const Visit& visit) {
  visit_all(description.base, visit);
  for (DescribedLink& link : description.links) visit_all(link, visit);
  for (DescribedJoint& joint : description.joints) {
    visit_all(joint.placement, visit);
    visit_all(joint.drive, visit);
    visit(joint.pitch);
  }
  for (DescribedCoupling& coupling : description.couplings) {
    for (DescribedCoupling::Term& term : coupling.terms) visit(term.factor);
    visit(coupling.offset);
  }
  for (DescribedLoop& loop : description.loops) visit(loop.length);
  for (DescribedTendon& tendon : description.tendons) {
    for (DescribedCoupling::Term& term : tendon.terms) visit(term.factor);
    for (Quantity* q : {&tendon.stiffness, &tendon.damping, &tendon.rest}) visit(*q);
  }
}

Quantity with_parameters(const Quantity& q, const std::vector<Quantity>& values) {
  const auto left = [&] { return with_parameters(q.left(), values); };
  const auto right = [&] { return with_parameters(q.right(), values); };
  switch (q.op()) {
    case Quantity::Op::constant:
    case Quantity::Op::variable:
      break;
    case Quantity::Op::parameter:
      return values[at(q.index())];
    case Quantity::Op::negate:
      return -left();
    case Quantity::Op::add:
      return left() + right();
    case Quantity::Op::subtract:
      return left() - right();
    case Quantity::Op::multiply:
      return left() * right();
    case Quantity::Op::divide:
      return left() / right();
    case Quantity::Op::sine:
      return sin(left());
    case Quantity::Op::cosine:
      return cos(left());
    case Quantity::Op::tangent:
      return tan(left());
    case Quantity::Op::square_root:
      return sqrt(left());
  }
  return q;
}

void remove_unused_parameters(Description& description) {
  std::vector<bool> is_used(description.parameters.size());
  visit_quantities(description, [&](Quantity& q) {
    for (const int index : parameters_of(q)) is_used[at(index)] = true;
  });
  std::vector<Parameter> kept;
  std::vector<Quantity> renumbered;
  for (std::size_t i = 0; i < is_used.size(); ++i) {
    renumbered.push_back(Quantity::parameter(static_cast<int>(kept.size())));
    if (is_used[i]) kept.push_back(description.parameters[i]);
  }
  description.parameters = std::move(kept);
  visit_quantities(description, [&](Quantity& q) { q = with_parameters(q, renumbered); });
}

}  // namespace robcogen::model
