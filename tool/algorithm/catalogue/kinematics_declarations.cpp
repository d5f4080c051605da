// Functions of each desired pair of frames. Several scopes may have functions of the same name: the names of their
// programs differ.
#include <string>

#include "algorithm/catalogue/arrays.h"
#include "algorithm/kinematics/kinematics.h"
#include "algorithm/kinematics/path.h"

namespace robcogen::algorithm {

template <>
TransformForm of_scope(const std::string& scope) {
  return scope == "transforms::homogeneous" ? TransformForm::homogeneous
         : scope == "transforms::motion"    ? TransformForm::spatial_motion
                                            : TransformForm::spatial_force;
}

template <>
JacobianReference of_scope(const std::string& scope) {
  return scope == "jacobians::in_target" ? JacobianReference::in_target
         : scope == "jacobians::spatial" ? JacobianReference::spatial
                                         : JacobianReference::in_left;
}

namespace catalogue {
namespace {

// The path is found in the motions of the robot, which are the same for all functions.
symbolic::Program transform(const Tracing& t) {
  return transform_along(
      t.tree, path_between(t.tree, t.choices.motions(), t.frames), of_scope<TransformForm>(t.scope), t.name);
}

std::vector<std::string> poses_of_frames(const Subject& s) {
  const std::string base = s.tree.frames().front().name;
  std::vector<std::string> functions;
  for (const model::Frame& frame : model::link_and_user_frames(s.tree))
    functions.push_back(
        is_floating(s) ? "world.X_" + frame.name : "transforms.homogeneous." + base + "_X_" + frame.name);
  return functions;
}

template <Role role>
symbolic::Program bias_in_left(const Tracing& t) {
  return bias_from_forces(t.tree, t.frames, BiasAxes::of_left, role, t.name, t.loads, t.choice.formulation);
}

bool is_seen_from_fixed_base(const Subject& s) {
  return is_fixed(s) && s.tree.link_of(s.frames.left) == 0;
}

std::optional<symbolic::Program> poses_in_world(const Tracing& t) {
  if (is_fixed(t)) return std::nullopt;
  return world_transforms(t.tree, model::link_and_user_frames(t.tree), t.name);
}

Array jacobian(Role role) {
  return {"J", role, rows<6>, chain};
}

}  // namespace

Declarations kinematics_declarations() {
  return {
      {"transforms",
       {{.scope = "transforms::homogeneous",
         .name = "{A}_X_{B}",
         .of = Of::transform_pair,
         .summary = {"4 x 4 homogeneous transform: maps coordinates in {B} to coordinates in {A}."},
         .signature = {{q}, {{"X", Role::homogeneous, rows<4>, rows<4>}}},
         .program = {transform}},
        {.scope = "transforms::motion",
         .name = "{A}_X_{B}",
         .of = Of::transform_pair,
         .summary = {"6 x 6 transform of spatial motion vectors, angular first: maps coordinates in {B} to coordinates "
                     "in {A}."},
         .signature = {{q}, {{"X", Role::spatial_motion, rows<6>, rows<6>}}},
         .program = {transform}},
        {.scope = "transforms::force",
         .name = "{A}_X_{B}",
         .of = Of::transform_pair,
         .summary =
             {"6 x 6 transform of spatial force vectors, moment first: maps coordinates in {B} to coordinates in {A}."},
         .signature = {{q}, {{"X", Role::spatial_force, rows<6>, rows<6>}}},
         .program = {transform}}}},
      {"jacobians",
       {{.scope = "jacobians",
         .name = "{A}_J_{B}",
         .of = Of::jacobian_pair,
         .summary = {"Geometric Jacobian: angular velocity of {B} and velocity of its origin, with respect to {A} and "
                     "in its axes; angular rows first (Siciliano et al. 2009, ch. 3)."},
         .signature = {{q}, {jacobian(Role::jacobian)}},
         .program = {by<geometric_jacobian>}}}},
      {"all_frames",
       {{.name = "all_frames",
         .exists = [](const Subject& s) { return model::link_and_user_frames(s.tree).size() > 1; },
         .summary = {"Poses of all frames, 4 x 4: {floating?world_X_frame, for a base with a pose.}"
                     "{fixed?base_X_frame, which map coordinates in a frame to coordinates in that of the base.}"},
         .parts = poses_of_frames,
         .together = poses_in_world}}},
      {"jacobian_references",
       {{.scope = "jacobians::in_target",
         .name = "{A}_J_{B}",
         .of = Of::jacobian_pair,
         .summary =
             {"Geometric Jacobian: angular velocity of {B} and velocity of its origin, with respect to {A}, in axes of "
              "{B}; angular rows first."},
         .signature = {{q}, {jacobian(Role::jacobian_in_target)}},
         .program = {by<geometric_jacobian>}},
        {.scope = "jacobians::spatial",
         .name = "{A}_J_{B}",
         .of = Of::jacobian_pair,
         .summary = {"Spatial Jacobian: twist of {B} with respect to {A}, in coordinates of {A}: angular velocity, "
                     "then velocity of the point of {B} that is at the origin of {A}; angular rows first (Featherstone "
                     "2008, ch. 2)."},
         .signature = {{q}, {jacobian(Role::spatial_jacobian)}},
         .program = {by<geometric_jacobian>}}}},
      {"jacobians_with_base",
       {{.scope = "jacobians::with_base",
         .name = "{A}_J_{B}",
         .of = Of::base_pair,
         .summary = {"Jacobian with base columns: angular velocity of {B} and velocity of its origin in an inertial "
                     "frame, in axes of {A}; angular rows first. "
                     "{floating? 6 x (6 + n): for the velocity (base twist in base coordinates, angular first; qd).}"
                     "{fixed? 6 x n, all joints in the order of the model.}"},
         .signature = {{q}, {matrix("J", rows<6>, velocities)}},
         .program = {by<jacobian_with_base>}},
        {.scope = "jacobians::with_base",
         .name = "{A}_bias_{B}",
         .of = Of::base_pair,
         .summary = {"Bias of {B}: its angular acceleration (rad/s^2) and the acceleration of its origin (m/s^2) in an "
                     "inertial frame, minus its Jacobian with base columns times (spatial base acceleration, qdd), in "
                     "axes of {A}."},
         .signature = {{q, qd, base_velocity}, {value("a", rows<6>)}},
         .program = {by<jacobian_with_base_bias>},
         .from_bias_forces = FromBiasForces{nullptr, bias_in_left<Role::value>}}}},
      {"jacobian_derivatives",
       {{.scope = "jacobians",
         .name = "{A}_Jd_{B}",
         .of = Of::jacobian_pair,
         .summary = {"Time derivative of the geometric Jacobian {A}_J_{B}, angular rows first."},
         .signature = {{q, qd}, {{"Jd", Role::jacobian_derivative, rows<6>, chain}}},
         .program = {by<jacobian_derivative>}},
        {.scope = "jacobians",
         .name = "{A}_Jd_qd_{B}",
         .of = Of::jacobian_pair,
         .summary =
             {"Time derivative of {A}_J_{B} times the joint velocities: the angular acceleration (rad/s^2) of {B} and "
              "the acceleration (m/s^2) of its origin minus {A}_J_{B} qdd, with respect to {A} and in its axes."},
         .signature = {{q, qd}, {{"a", Role::frame_bias_acceleration, rows<6>}}},
         .program = {by<jacobian_derivative_times_velocity>},
         .from_bias_forces = FromBiasForces{is_seen_from_fixed_base, bias_in_left<Role::frame_bias_acceleration>}}}},
      {"velocities",
       {{.scope = "velocities",
         .name = "{A}_V_{B}",
         .of = Of::jacobian_pair,
         .summary = {"Twist of {B} with respect to {A}, in coordinates of {A}: angular velocity (rad/s), then velocity "
                     "(m/s) of the point of {B} that is at the origin of {A}."},
         .signature = {{q, qd}, {{"V", Role::frame_velocity, rows<6>}}},
         .program = {by<frame_velocity>}}}},
      {"accelerations",
       {{.scope = "accelerations",
         .name = "{A}_A_{B}",
         .of = Of::jacobian_pair,
         .summary = {"Spatial acceleration of {B} with respect to {A}: the time derivative (rad/s^2, m/s^2) of its "
                     "twist in coordinates of {A}, angular first (Featherstone 2008, ch. 2)."},
         .signature = {{q, qd, qdd}, {{"A", Role::frame_acceleration, rows<6>}}},
         .program = {by<frame_acceleration>}}}}};
}

}  // namespace catalogue
}  // namespace robcogen::algorithm
