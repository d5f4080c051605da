#include "algorithm/catalogue/model_numbers.h"

#include <algorithm>

#include "algorithm/spatial/trace.h"

namespace robcogen::algorithm {
namespace {

using model::Quantity;
using symbolic::Role;

struct Column {
  Trace& trace;
  std::vector<Expression>& values;

  void add(const Quantity& q) { values.push_back(trace.lift(q)); }
  void add(const std::array<Quantity, 3>& q) {
    for (const Quantity& component : q) add(component);
  }
};

void add_link(Column column, const model::Link& link) {
  if (!link.inertia) {
    for (int i = 0; i < kNumbersOfLink; ++i) column.add(Quantity());
    return;
  }
  const model::RigidBodyInertia body = model::in_link_frame(*link.inertia);
  column.add(body.mass);
  if (!link.inertia->reference) {
    column.add(link.inertia->com);
  } else {
    for (const Quantity& moment : body.first_moment) column.add(body.mass.is_zero() ? Quantity() : moment / body.mass);
  }
  for (const Quantity* q : {&body.ixx, &body.iyy, &body.izz, &body.ixy, &body.ixz, &body.iyz}) column.add(*q);
}

void add_placement(Column column, const model::Placement& placement) {
  column.add(placement.translation);
  column.add(placement.rotation);
}

void add_drive(Column column, const model::Joint& joint) {
  const model::Drive& drive = joint.drive;
  for (const Quantity* q :
       {&drive.damping, &drive.friction, &drive.friction_velocity, &drive.armature, &drive.stiffness, &drive.rest})
    column.add(*q);
  column.add(drive.rotor ? drive.rotor->inertia : Quantity());
  column.add(drive.rotor ? drive.rotor->ratio : Quantity());
  column.add(drive.rotor ? model::rotor_axis(joint) : std::array<Quantity, 3>());
}

}  // namespace

symbolic::Program model_numbers(const model::KinematicTree& tree) {
  Trace trace(tree);
  std::vector<Expression> links, joints, frames;
  for (const model::Link& link : tree.links) {
    if (link.is_repeated) continue;
    trace.section(link.name, "link " + link.name);
    add_link({trace, links}, link);
  }
  const bool has_drives = tree.has_drives(), has_pitches = tree.has_pitches();
  for (const int j : model::independent_joints_first(tree)) {
    const model::Joint& joint = tree.joints[at(j)];
    trace.section(joint.name, "joint " + joint.name);
    // Components of a spherical joint have the placement of the first one.
    add_placement({trace, joints}, tree.joints[at(tree.first_component_of(j))].placement);
    if (has_drives) add_drive({trace, joints}, joint);
    if (has_pitches) Column{trace, joints}.add(joint.pitch);
  }
  for (const model::Frame& frame : tree.frames()) {
    trace.section(frame.name, "frame " + frame.name);
    add_placement({trace, frames}, tree.placement_of(frame));
  }
  const auto output = [&](const char* name, int rows, const std::vector<Expression>& values) {
    trace.output(name, Role::value, rows, static_cast<int>(values.size()) / rows, values);
  };
  output("links", kNumbersOfLink, links);
  output("joints", kNumbersOfPlacement + (has_drives ? kNumbersOfDrive : 0) + (has_pitches ? 1 : 0), joints);
  output("frames", kNumbersOfPlacement, frames);
  return trace.program("model_numbers");
}

symbolic::Program coupling_numbers(const model::KinematicTree& tree) {
  Trace trace(tree);
  const int rows = tree.dof() + 1;
  std::vector<Expression> values;
  for (const model::Coupling& coupling : tree.couplings) {
    const std::string& name = tree.joints[at(coupling.joint)].name;
    trace.section(name, "joint " + name);
    std::vector<Expression> column(at(rows));
    // NaN for a joint that follows others through a loop, and not by a sum.
    const Expression none = coupling.is_linear() ? Expression() : sqrt(trace.graph.constant(-1.0));
    if (!coupling.is_linear()) {
      for (const model::Coupling::Term& term : coupling.terms) column[at(tree.coordinate_of(term.joint))] = none;
      column.back() = none;
      values.insert(values.end(), column.begin(), column.end());
      continue;
    }
    for (const model::Coupling::Term& term : coupling.terms)
      column[at(tree.coordinate_of(term.joint))] = trace.lift(term.factor);
    column.back() = trace.lift(coupling.offset);
    values.insert(values.end(), column.begin(), column.end());
  }
  trace.output("couplings", Role::value, rows, static_cast<int>(tree.couplings.size()), values);
  return trace.program("coupling_numbers");
}

symbolic::Program tendon_numbers(const model::KinematicTree& tree) {
  Trace trace(tree);
  const std::vector<int> joints = model::independent_joints_first(tree);
  std::vector<Expression> values;
  for (const model::Tendon& tendon : tree.tendons) {
    trace.section(tendon.name, "tendon " + tendon.name);
    for (const int joint : joints) {
      const auto term = std::find_if(
          tendon.terms.begin(), tendon.terms.end(), [&](const model::Tendon::Term& t) { return t.joint == joint; });
      values.push_back(term == tendon.terms.end() ? Expression() : trace.lift(term->factor));
    }
    for (const Quantity* q : {&tendon.stiffness, &tendon.damping, &tendon.rest}) values.push_back(trace.lift(*q));
  }
  const int count = static_cast<int>(tree.tendons.size());
  trace.output("tendons", Role::value, static_cast<int>(joints.size()) + 3, count, values);
  return trace.program("tendon_numbers");
}

}  // namespace robcogen::algorithm
