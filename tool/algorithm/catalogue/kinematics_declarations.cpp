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

InverseKinematicsSize size_of(const Subject& s) {
  return inverse_kinematics_size(s.tree, s.frames, s.task);
}
bool is_inverted(const Subject& s) {
  return size_of(s).branches > 0;
}
bool has_signs(const Subject& s) {
  return size_of(s).signs > 0;
}
bool is_of_point(const Subject& s) {
  return s.task.kind == model::InverseTask::Kind::point;
}
bool is_of_pose(const Subject& s) {
  return !is_of_point(s);
}
int branches(const Subject& s) {
  return size_of(s).branches;
}
int signs(const Subject& s) {
  return size_of(s).signs;
}
int inverted_joints(const Subject& s) {
  return size_of(s).joints;
}

bool is_by_swivel(const Subject& s) {
  return s.task.by_swivel;
}
bool has_swivel(const Subject& s) {
  return is_by_swivel(s) && is_inverted(s);
}

constexpr Array swivel = value("swivel", rows<1>, is_by_swivel);
constexpr Array target_pose{"X", Role::homogeneous, rows<16>, nullptr, is_of_pose};
constexpr Array target_point{"p", Role::position, rows<3>, nullptr, is_of_point};
constexpr Array reference{"reference", Role::joint_reference, positions};

constexpr Array residual(const char* name, Size rows) {
  return {name, Role::residual, rows};
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
      {"inverse_kinematics",
       {{.scope = "inverse_kinematics",
         .name = "{A}_X_{B}",
         .of = Of::inverse_pair,
         .exists = is_inverted,
         .summary =
             {"Joint positions for {target of inverse}, in all branches: a column each. Rows: {chain}; sin_q of a "
              "prismatic joint is its position (m), and its cos_q is 0. `misfit` (rad, m) is 0 but for rounding in a "
              "branch that exists, and otherwise says by how much it misses; its positions are then the nearest of "
              "their "
              "equations. `determinant` is {determinant of inverse}. Joints without effect take the positions "
              "`reference`.",
              "{steps of inverse}"},
         .signature =
             {{target_pose, target_point, swivel, reference},
              {matrix("sin_q", inverted_joints, branches), matrix("cos_q", inverted_joints, branches),
               residual("misfit", branches), residual("determinant", branches)}},
         .program = {by<inverse_kinematics>}},
        {.scope = "inverse_kinematics::branch",
         .name = "{A}_X_{B}",
         .of = Of::inverse_pair,
         .exists = has_signs,
         .summary =
             {"Joint positions for {target of inverse}, in the branch with these signs (1 or -1), which "
              "inverse_kinematics::configuration returns; `misfit` and `determinant` as in all branches. Other joints "
              "keep the positions `reference`, which joints without effect take too."},
         .signature =
             {{target_pose, target_point, swivel, value("signs", signs), reference},
              {{"q", Role::joint_position, positions}, residual("misfit", rows<1>), residual("determinant", rows<1>)}},
         .program = {by<inverse_kinematics_branch>}},
        {.scope = "inverse_kinematics::configuration",
         .name = "{A}_X_{B}",
         .of = Of::inverse_pair,
         .exists = has_signs,
         .summary = {"The signs (1 or -1) of the branch of inverse_kinematics in which the joints are."},
         .signature = {{q}, {value("signs", signs)}},
         .program = {by<inverse_kinematics_configuration>}},
        {.scope = "inverse_kinematics::redundancy",
         .name = "{A}_X_{B}",
         .of = Of::inverse_pair,
         .exists = has_swivel,
         .summary = {"The swivel angle (rad): how far the plane of shoulder, elbow and wrist is turned about the line "
                     "from shoulder to wrist. It is undefined where this line is parallel to the first axis."},
         .signature = {{q}, {value("swivel", rows<1>)}},
         .program = {by<inverse_kinematics_redundancy>}}}},
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
