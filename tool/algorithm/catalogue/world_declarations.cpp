// Functions in the world: of each desired frame, and of the whole robot. Their scope says in which axes.
#include <string>
#include <utility>
#include <vector>

#include "algorithm/catalogue/arrays.h"
#include "algorithm/dynamics/dynamics.h"
#include "algorithm/dynamics/world_frames.h"

namespace robcogen::algorithm {

template <>
Axes of_scope(const std::string& scope) {
  return scope == "world::in_target" ? Axes::of_frame : Axes::of_world;
}

template <>
CentroidalAxes of_scope(const std::string& scope) {
  return scope == "world" ? CentroidalAxes::of_world : CentroidalAxes::of_base;
}

namespace catalogue {
namespace {

constexpr const char* kWorldColumns =
    "{floating? Columns: base twist in base coordinates, angular first; qd.}"
    "{fixed? Columns: joints in the order of the model.}";
#define RATES "angular velocity (rad/s), then velocity of its origin (m/s)"
#define ACCELERATIONS "angular acceleration (rad/s^2), then acceleration of its origin (m/s^2)"

symbolic::Program bias_in_world(const Tracing& t) {
  return bias_from_forces(t.tree, t.frames, BiasAxes::of_world, Role::value, t.name, t.loads, t.choice.formulation);
}

symbolic::Program bias_in_frame(const Tracing& t) {
  return bias_from_forces(t.tree, t.frames, BiasAxes::of_frame, Role::value, t.name, t.loads, t.choice.formulation);
}

// The pose of the base is an input of functions in axes of the world.
std::vector<Declaration> motions(bool in_target) {
  const char* const scope = in_target ? "world::in_target" : "world";
  const auto motion = [&](const char* name, std::vector<const char*> summary, Signature signature, auto trace) {
    if (in_target) std::erase_if(signature.inputs, [](const Array& array) { return array.role == Role::base_pose; });
    return Declaration{
        .scope = scope,
        .name = name,
        .of = Of::moving_frame,
        .summary = std::move(summary),
        .signature = std::move(signature),
        .program = {trace}};
  };
#define IN_AXES(before, after) in_target ? before "in axes of {B}" after : before "in axes of the world" after
  Declaration bias = motion(
      "bias_{B}",
      {IN_AXES(
          "Bias of {B}, ",
          ": its acceleration minus its Jacobian in the world times {accelerations}: " ACCELERATIONS ".")},
      {{q, qd, base_pose, base_velocity}, {value("a", rows<6>)}}, by<world_bias>);
  bias.from_bias_forces = {nullptr, in_target ? bias_in_frame : bias_in_world};
  return {
      motion(
          "velocity_{B}", {IN_AXES("Velocity of {B} in the world, ", ": " RATES ".")},
          {{q, qd, base_pose, base_velocity}, {value("v", rows<6>)}}, by<world_velocity>),
      motion(
          "acceleration_{B}",
          {IN_AXES(
              "Acceleration of {B} in the world, ",
              ": " ACCELERATIONS ". Gravity is not included.{floating?  `base_acceleration` is spatial.}")},
          {{q, qd, qdd, base_pose, base_velocity, base_acceleration}, {value("a", rows<6>)}}, by<world_acceleration>),
      motion(
          "J_{B}",
          {IN_AXES(
               "Jacobian{floating?  with base columns}: the velocity of {B} in the world, ",
               ": " RATES "; angular rows first."),
           kWorldColumns},
          {{q, base_pose}, {matrix("J", rows<6>, velocities)}}, by<world_jacobian>),
      std::move(bias)};
}

}  // namespace

Declarations world_declarations() {
  Declarations list = {
      {"world",
       {{.scope = "world",
         .name = "X_{B}",
         .of = Of::placed_frame,
         .summary = {"Pose of {B} in the world: world_X_{B}, 4 x 4."},
         .signature = {{q, base_pose}, {matrix("X", rows<4>, rows<4>)}},
         .program = {by<world_transform>}},
        {.scope = "world",
         .name = "position_{B}",
         .of = Of::placed_frame,
         .summary = {"Origin of {B} in the world (m)."},
         .signature = {{q, base_pose}, {{"p", Role::position, rows<3>}}},
         .program = {by<world_position>}}}}};
  for (const bool in_target : {false, true})
    for (Declaration& row : motions(in_target)) list.front().rows.push_back(std::move(row));
  const Declarations of_robot = {
      {"world_centroidal",
       {{.scope = "world",
         .name = "center_of_mass",
         .summary = {"Centre of mass of {what moves} in the world (m)."},
         .signature = {{q, base_pose}, {{"com", Role::position, rows<3>}}},
         .program = {by<center_of_mass>},
         .joins_frames = true},
        {.scope = "world",
         .name = "center_of_mass_velocity",
         .summary = {"Velocity (m/s) of the centre of mass of {what moves} in axes of the world."},
         .signature = {{q, qd, base_pose, base_velocity}, {value("v", rows<3>)}},
         .program = {by<center_of_mass_velocity>},
         .joins_frames = true},
        {.scope = "world",
         .name = "center_of_mass_jacobian",
         .summary =
             {"Velocity (m/s) of the centre of mass of {what moves} in axes of the world: 3 rows.", kWorldColumns},
         .signature = {{q, base_pose}, {matrix("J", rows<3>, velocities)}},
         .program = {by<center_of_mass_jacobian>},
         .joins_frames = true},
        {.scope = "world",
         .name = "centroidal_momentum",
         .summary = {"Momentum of {what moves} about the centre of mass, in axes of the world: angular (N m s), then "
                     "linear (N s)."},
         .signature = {{q, qd, base_pose, base_velocity}, {value("h", rows<6>)}},
         .program = {by<centroidal_momentum>},
         .joins_frames = true},
        {.scope = "world",
         .name = "centroidal_momentum_matrix",
         .summary =
             {"Momentum of {what moves} about the centre of mass, in axes of the world: 3 rows of angular momentum (N "
              "m s), 3 of linear momentum (N s) (Orin, Goswami, Lee 2013).",
              kWorldColumns},
         .signature = {{q, base_pose}, {matrix("A", rows<6>, velocities)}},
         .program = {by<centroidal_momentum_matrix>},
         .joins_frames = true},
        {.scope = "world",
         .name = "centroidal_momentum_bias",
         .summary = {"Bias of the centroidal momentum: the rate of angular (N m) and linear (N) momentum minus the "
                     "centroidal momentum matrix in axes of the world times {accelerations}, which is the time "
                     "derivative of the matrix times the velocities (Wensing and Orin 2016)."},
         .signature = {{q, qd, base_pose, base_velocity}, {value("bias", rows<6>)}},
         .program = {by<centroidal_momentum_bias>},
         .joins_frames = true}}}};
  list.insert(list.end(), of_robot.begin(), of_robot.end());
  return list;
}

}  // namespace catalogue
}  // namespace robcogen::algorithm
