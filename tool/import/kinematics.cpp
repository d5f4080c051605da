#include "import/kinematics.h"

#include "import/couplings.h"
#include "import/drive.h"
#include "import/parameters.h"

namespace robcogen::import {

namespace kinematics = language::kinematics;
using language::Expression;
using model::ParameterKind;
using model::Quantity;

namespace {

// Every expression of the document.
std::vector<const Expression*> expressions_of(const kinematics::Document& document) {
  std::vector<const Expression*> all;
  const auto add = [&](const language::ExpressionPtr& e) { all.push_back(e.get()); };
  const auto add_placement = [&](const kinematics::Placement& p) {
    for (const auto& e : p.translation) add(e);
    for (const auto& e : p.rotation) add(e);
  };
  for (const kinematics::Link& link : document.links) {
    if (link.inertia) {
      const kinematics::Inertia& i = *link.inertia;
      add(i.mass);
      for (const auto& e : i.com) add(e);
      for (const auto& e : {i.ix, i.iy, i.iz, i.ixy, i.ixz, i.iyz}) add(e);
    }
    for (const kinematics::Frame& frame : link.frames) add_placement(frame.placement);
  }
  for (const kinematics::Joint& joint : document.joints) {
    add_placement(joint.placement);
    for (const language::ExpressionPtr& e : expressions_of_drive(joint)) add(e);
  }
  for (const kinematics::Coupling& coupling : document.couplings) add(coupling.value);
  return all;
}

class Describer {
 public:
  Describer(const kinematics::Document& document, Diagnostics& diagnostics)
      : document_(document), diagnostics_(diagnostics), reader_(document.source, diagnostics) {
    for (const Expression* expression : expressions_of(document)) reader_.declare_names_in(*expression);
  }

  model::Description describe() {
    model::Description description;
    description.name = document_.robot.text;
    description.place = place(document_.robot.span);
    for (const kinematics::Link& link : document_.links) {
      if (link.is_base) {
        description.base = describe(link);
        description.floating_base = link.floating;
      } else {
        description.links.push_back(describe(link));
      }
    }
    for (const kinematics::Joint& joint : document_.joints) description.joints.push_back(describe(joint));
    description.couplings = read_couplings(document_, reader_, diagnostics_);
    description.parameters = reader_.parameters();
    reader_.report_accidents();
    return description;
  }

 private:
  Place place(const Span& span) const { return {document_.source, span}; }

  std::array<Quantity, 3> read(const kinematics::Vector& v, ParameterKind kind) {
    // In this order, which determines the order of the parameters.
    const Quantity x = reader_.read(*v[0], kind), y = reader_.read(*v[1], kind), z = reader_.read(*v[2], kind);
    return {x, y, z};
  }

  model::Placement read(const kinematics::Placement& placement) {
    const auto translation = read(placement.translation, ParameterKind::length);
    return {translation, read(placement.rotation, ParameterKind::angle)};
  }

  model::Inertia read(const kinematics::Inertia& inertia) {
    const auto value = [&](const language::ExpressionPtr& e) { return reader_.read(*e, ParameterKind::inertial); };
    model::Inertia result;
    result.mass = value(inertia.mass);
    result.com = read(inertia.com, ParameterKind::inertial);
    result.ixx = value(inertia.ix), result.iyy = value(inertia.iy), result.izz = value(inertia.iz);
    result.ixy = value(inertia.ixy), result.ixz = value(inertia.ixz), result.iyz = value(inertia.iyz);
    return result;
  }

  model::DescribedLink describe(const kinematics::Link& link) {
    model::DescribedLink result;
    result.name = link.name.text;
    result.place = place(link.name.span);
    result.id = link.id;
    result.id_place = place(link.id_span);
    if (link.inertia) {
      result.inertia = read(*link.inertia);
      result.inertia_place = place(link.inertia->span);
      result.mass_place = place(link.inertia->mass->span);
      if (const auto& reference = link.inertia->reference) {
        result.reference_frame = reference->text;
        result.reference_place = place(reference->span);
      }
    }
    for (const kinematics::Child& child : link.children) {
      result.children.push_back({child.link.text, child.joint.text, place(child.link.span), place(child.joint.span)});
    }
    for (const kinematics::Frame& frame : link.frames) {
      result.frames.push_back({frame.name.text, read(frame.placement), place(frame.name.span)});
    }
    return result;
  }

  model::DescribedJoint describe(const kinematics::Joint& joint) {
    const bool revolute = joint.type == kinematics::Joint::Type::revolute;
    model::DescribedJoint result = {
        joint.name.text, place(joint.name.span), revolute ? model::JointType::revolute : model::JointType::prismatic,
        read(joint.placement)};
    describe_drive(joint, reader_, diagnostics_, result);
    return result;
  }

  const kinematics::Document& document_;
  Diagnostics& diagnostics_;
  QuantityReader reader_;
};

}  // namespace

model::Description describe(const kinematics::Document& document, Diagnostics& diagnostics) {
  return Describer(document, diagnostics).describe();
}

std::optional<model::KinematicTree> kinematic_tree(const kinematics::Document& document, Diagnostics& diagnostics) {
  const std::size_t errors_before = diagnostics.error_count();
  const model::Description description = describe(document, diagnostics);
  auto tree = model::build(description, diagnostics);
  if (diagnostics.error_count() > errors_before) return std::nullopt;
  return tree;
}

}  // namespace robcogen::import
