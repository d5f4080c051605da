#include "import/drive.h"

#include <fmt/format.h>

#include "import/magnitudes.h"

namespace robcogen::import {

namespace kinematics = language::kinematics;
using language::ExpressionPtr;

namespace {

class DriveDescriber {
 public:
  DriveDescriber(QuantityReader& reader, Diagnostics& diagnostics, model::DescribedJoint& described)
      : reader_(reader), diagnostics_(diagnostics), described_(described) {}

  void describe(const kinematics::Drive& drive) {
    model::DrivePlaces& places = described_.drive_places;
    model::Drive& values = described_.drive;
    read(drive.damping, values.damping, places.damping);
    read(drive.friction, values.friction, places.friction);
    read(drive.friction_velocity, values.friction_velocity, places.friction_velocity);
    read(drive.armature, values.armature, places.armature);
    read(drive.stiffness, values.stiffness, places.stiffness);
    read(drive.rest, values.rest, places.rest);
    if (drive.rest) check_angle(*drive.rest, values.rest);
  }

  void describe(const kinematics::Rotor& rotor) {
    model::DrivePlaces& places = described_.drive_places;
    model::Rotor& values = described_.drive.rotor.emplace();
    places.rotor = reader_.place(rotor.span);
    read(rotor.inertia, values.inertia, places.rotor_inertia);
    read(rotor.ratio, values.ratio, places.rotor_ratio);
    if (rotor.axis) {
      values.axis.emplace();
      for (std::size_t i = 0; i < 3; ++i) read((*rotor.axis)[i], (*values.axis)[i], places.rotor_axis);
    }
    if (!rotor.carrier) return;
    described_.rotor_carrier = rotor.carrier->text;
    places.rotor_carrier = reader_.place(rotor.carrier->span);
  }

  void describe(const kinematics::Elasticity& given) {
    model::DescribedElasticity& spring = described_.elasticity.emplace();
    spring.place = reader_.place(given.span);
    read(given.stiffness, spring.stiffness, spring.stiffness_place);
    read(given.damping, spring.damping, spring.damping_place);
  }

  void describe(const kinematics::Limits& limits) {
    model::DrivePlaces& places = described_.drive_places;
    if (limits.position) {
      const auto& [lower, upper] = *limits.position;
      read_limit(lower, described_.limits.lower, places.position_limits);
      read_limit(upper, described_.limits.upper, places.position_limits);
      check_angle(*lower, model::Quantity(Number(described_.limits.lower)));
      check_angle(*upper, model::Quantity(Number(described_.limits.upper)));
    }
    read_limit(limits.velocity, described_.limits.velocity, places.velocity_limit);
    read_limit(limits.effort, described_.limits.effort, places.effort_limit);
  }

  void describe_assembled(const ExpressionPtr& position) {
    double& value = described_.assembled.emplace();
    read_constant(position, "'assembled'", value, described_.assembled_place);
    check_angle(*position, model::Quantity(Number(value)));
  }

 private:
  QuantityReader& reader_;
  Diagnostics& diagnostics_;
  model::DescribedJoint& described_;

  // A screw may turn any number of times.
  void check_angle(const language::Expression& expression, const model::Quantity& position) {
    if (described_.type == model::JointType::revolute) reader_.check_angle(expression, position, kTurnsOfJoint);
  }

  void read(const ExpressionPtr& expression, model::Quantity& value, Place& place) {
    if (!expression) return;
    value = reader_.read(*expression, model::ParameterKind::inertial);
    place = reader_.place(*expression);
  }

  void read_limit(const ExpressionPtr& expression, double& limit, Place& place) {
    if (!expression) return;
    read_constant(expression, "a limit", limit, place);
    limit = model::bounded(limit);
  }

  void read_constant(const ExpressionPtr& expression, const char* what, double& constant, Place& place) {
    model::Quantity value;
    read(expression, value, place);
    if (value.is_constant()) {
      constant = value.number().value();
      return;
    }
    const bool is_limit = what == std::string("a limit");
    diagnostics_
        .error(
            is_limit ? "limit-with-parameter" : "assembled-with-parameter", place,
            fmt::format("{} of joint '{}' depends on a parameter", what, described_.name))
        .hint = is_limit ? "limits are constants: write a number" : "write a number";
  }
};

}  // namespace

void describe_drive(
    const kinematics::DriveAndLimits& given,
    QuantityReader& reader,
    Diagnostics& diagnostics,
    model::DescribedJoint& described) {
  DriveDescriber describer(reader, diagnostics, described);
  describer.describe(given.drive);
  if (given.rotor) describer.describe(*given.rotor);
  if (given.elasticity) describer.describe(*given.elasticity);
  describer.describe(given.limits);
  if (given.assembled) describer.describe_assembled(given.assembled);
}

}  // namespace robcogen::import
