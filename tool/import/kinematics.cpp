#include "import/kinematics.h"

#include <fmt/format.h>

#include <cmath>
#include <stdexcept>
#include <utility>

#include "import/couplings.h"
#include "import/drive.h"
#include "import/parameters.h"
#include "import/tendons.h"
#include "language/kinematics/expressions.h"
#include "model/elastic_joints.h"

namespace robcogen::import {

namespace kinematics = language::kinematics;
using language::Expression;
using model::ParameterKind;
using model::Quantity;

namespace {

class Describer {
 public:
  Describer(const kinematics::Document& document, Diagnostics& diagnostics)
      : document_(document), diagnostics_(diagnostics), reader_(document.source, diagnostics) {
    kinematics::visit_body(document, [&](const language::ExpressionPtr& e) { reader_.declare_names_in(*e); });
  }

  model::Description describe() {
    model::Description description;
    description.name = document_.robot.text;
    description.assembled_form = model::AssembledForm::item;
    description.place = place(document_.robot.span);
    for (const kinematics::Link& link : document_.links) {
      if (link.is_base) {
        description.base = describe(link);
        description.floating_base = link.floating;
      } else {
        description.links.push_back(describe(link));
      }
    }
    for (const kinematics::Joint& joint : document_.joints) {
      if (const auto compound = compound_type_of(joint.type))
        model::add_compound(describe(joint, *compound), description, diagnostics_);
      else
        description.joints.push_back(describe(joint));
    }
    model::add_motors(description, diagnostics_);
    description.couplings = read_couplings(document_, reader_, diagnostics_);
    for (const kinematics::LoopJoint& loop : document_.loop_joints) description.loops.push_back(describe(loop));
    for (const kinematics::Name& joint : document_.independents)
      description.independents.push_back({joint.text, place(joint.span)});
    for (const kinematics::Actuator& actuator : document_.actuators) {
      const auto& [from, to] = actuator.frames;
      description.actuators.push_back(
          {actuator.name.text, place(actuator.name.span), {from.text, to.text}, {place(from.span), place(to.span)}});
    }
    for (model::DescribedTendon& tendon : read_tendons(document_, reader_, diagnostics_))
      description.tendons.push_back(std::move(tendon));
    description.parameters = reader_.parameters();
    for (const kinematics::Limb& limb : document_.limbs) description.limbs.push_back(describe(limb));
    reader_.report_accidents();
    return description;
  }

 private:
  Place place(const Span& span) const { return {document_.source, span}; }

  model::DescribedLimb describe(const kinematics::Limb& limb) const {
    const auto elements = [](const std::vector<kinematics::Limb::Element>& from) {
      std::vector<model::DescribedLimb::Element> result;
      for (const auto& [own, name] : from) result.push_back({own, name});
      return result;
    };
    return {limb.name.text,       limb.part, limb.first_link, elements(limb.links), elements(limb.joints),
            elements(limb.frames)};
  }

  model::DescribedLoop describe(const kinematics::LoopJoint& loop) {
    model::DescribedLoop result;
    result.name = loop.name.text;
    result.place = place(loop.name.span);
    for (std::size_t e = 0; e < 2; ++e) {
      result.frames[e] = loop.frames[e].text;
      result.frame_places[e] = place(loop.frames[e].span);
    }
    result.type = model::LoopType::distance;
    for (std::size_t k = 0; k < model::kLoopTypes.size(); ++k)
      if (loop.type.text == model::kLoopTypes[k]) result.type = static_cast<model::LoopType>(k);
    if (loop.distance) result.length = reader_.read(*loop.distance, ParameterKind::length);
    result.takes_other_branch = loop.branch.text == "other";
    return result;
  }

  std::array<Quantity, 3> read(const kinematics::Vector& v, ParameterKind kind) {
    // Evaluation order matters: it determines the order of the parameters.
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
    model::DescribedJoint result = {
        joint.name.text, place(joint.name.span), type_of(joint.type), read(joint.placement)};
    if (joint.pitch) result.pitch = read_pitch(joint);
    describe_drive(joint, reader_, diagnostics_, result);
    return result;
  }

  model::DescribedCompound describe(const kinematics::Joint& joint, model::CompoundType type) {
    model::DescribedCompound result;
    result.name = joint.name.text;
    result.place = place(joint.name.span);
    result.type = type;
    result.placement = read(joint.placement);
    result.placement_place = place(joint.placement.span);
    for (const model::CompoundCoordinate& coordinate : model::coordinates_of(type)) {
      model::DescribedJoint& made = result.coordinates.emplace_back();
      made.name = model::coordinate_name(joint.name.text, coordinate);
      made.type = coordinate.type;
      for (const kinematics::Coordinate& c : joint.coordinates)
        if (c.word.text == coordinate.name) describe_drive(c, reader_, diagnostics_, made);
    }
    return result;
  }

  // Warns about a pitch that looks like millimetres.
  Quantity read_pitch(const kinematics::Joint& joint) {
    constexpr double kLikely = 1.0;  // m/rad: no screw is this steep
    const Quantity pitch = reader_.read(*joint.pitch, ParameterKind::length);
    if (pitch.is_constant() && std::abs(pitch.number().value()) > kLikely)
      diagnostics_
          .warning(
              "pitch-unit", place(joint.pitch->span),
              fmt::format("the pitch of joint '{}' is {} m/rad", joint.name.text, print_double(pitch.number().value())))
          .hint = "a screw with a lead of 10 mm per turn has 'pitch = 0.01 / (2.0 PI)'";
    return pitch;
  }

  const kinematics::Document& document_;
  Diagnostics& diagnostics_;
  QuantityReader reader_;
};

}  // namespace

model::JointType type_of(kinematics::Joint::Type type) {
  switch (type) {
    case kinematics::Joint::Type::revolute:
      break;
    case kinematics::Joint::Type::prismatic:
      return model::JointType::prismatic;
    case kinematics::Joint::Type::helical:
      return model::JointType::helical;
    case kinematics::Joint::Type::cylindrical:
    case kinematics::Joint::Type::universal:
    case kinematics::Joint::Type::planar:
      throw std::logic_error("a joint of several coordinates has several types");
    case kinematics::Joint::Type::spherical:
      return model::JointType::spherical;
  }
  return model::JointType::revolute;
}

std::optional<model::CompoundType> compound_type_of(kinematics::Joint::Type type) {
  switch (type) {
    case kinematics::Joint::Type::revolute:
    case kinematics::Joint::Type::prismatic:
    case kinematics::Joint::Type::helical:
    case kinematics::Joint::Type::spherical:
      break;
    case kinematics::Joint::Type::cylindrical:
      return model::CompoundType::cylindrical;
    case kinematics::Joint::Type::universal:
      return model::CompoundType::universal;
    case kinematics::Joint::Type::planar:
      return model::CompoundType::planar;
  }
  return std::nullopt;
}

model::Description describe(const kinematics::Document& document, Diagnostics& diagnostics) {
  return Describer(document, diagnostics).describe();
}

std::optional<model::KinematicTree> kinematic_tree(const kinematics::Document& document, Diagnostics& diagnostics) {
  return kinematic_tree(document, {}, diagnostics);
}

std::optional<model::KinematicTree> kinematic_tree(
    const kinematics::Document& document,
    const model::Changes& changes,
    Diagnostics& diagnostics) {
  const std::size_t errors_before = diagnostics.error_count();
  const model::Description description = describe(document, diagnostics);
  auto tree = model::build(description, changes, diagnostics);
  if (diagnostics.error_count() > errors_before) return std::nullopt;
  return tree;
}

}  // namespace robcogen::import
