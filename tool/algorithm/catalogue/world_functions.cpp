#include <functional>
#include <set>

#include "algorithm/catalogue/groups.h"
#include "algorithm/dynamics/dynamics.h"
#include "algorithm/dynamics/world_frames.h"
#include "support/parallel.h"

namespace robcogen::algorithm {

using model::Frame;
using model::KinematicTree;

namespace {

const char* const kBaseColumns = "Columns: base twist in base coordinates, angular first; qd.";
const char* const kJointColumns = "Columns: joints in the order of the model.";
const char* const kRates = "angular velocity (rad/s), then velocity of its origin (m/s)";
const char* const kAccelerations = "angular acceleration (rad/s^2), then acceleration of its origin (m/s^2)";

// Each frame of these pairs once, except the frame of the base itself, whose pose is an argument.
std::vector<Frame> frames_of(
    const KinematicTree& tree,
    const std::vector<const std::vector<model::FramePair>*>& lists) {
  std::vector<Frame> frames;
  std::set<std::string> seen = {tree.frames().front().name};
  for (const std::vector<model::FramePair>* pairs : lists)
    for (const model::FramePair& pair : *pairs)
      for (const Frame& frame : {pair.left, pair.right})
        if (seen.insert(frame.name).second) frames.push_back(frame);
  return frames;
}

// The frames whose positions are computed, and those that move.
struct WorldFrames {
  WorldFrames(const KinematicTree& tree, const model::DesiredTransforms& desired) {
    std::vector<model::FramePair> contacts;
    for (const model::ContactFrame& contact : desired.contacts) contacts.push_back({contact.frame, contact.frame});
    placed = frames_of(tree, {&desired.transforms, &desired.jacobians, &contacts});
    moving = frames_of(tree, {&desired.jacobians, &contacts});
    if (!tree.floating_base) std::erase_if(moving, [&](const Frame& frame) { return tree.link_of(frame) == 0; });
  }

  std::vector<Frame> placed, moving;
};

// A function of one frame: `<what>_<frame>`.
struct Kind {
  std::string what;
  bool is_in_target;
  bool is_of_moving;
  std::function<std::vector<std::string>(const std::string& frame)> summary;
  std::function<symbolic::Program(const Frame& frame, const std::string& name)> build;
};

std::vector<Kind> kinds(const KinematicTree& tree) {
  std::vector<Kind> list = {
      {"X", false, false,
       [](const std::string& frame) {
         return std::vector<std::string>{"Pose of " + frame + " in the world: world_X_" + frame + ", 4 x 4."};
       },
       [&](const Frame& frame, const std::string& name) { return world_transform(tree, frame, name); }},
      {"position", false, false,
       [](const std::string& frame) { return std::vector<std::string>{"Origin of " + frame + " in the world (m)."}; },
       [&](const Frame& frame, const std::string& name) { return world_position(tree, frame, name); }}};
  const bool floats = tree.floating_base;
  const std::string columns = floats ? kBaseColumns : kJointColumns;
  const std::string of_base = floats ? " `base_acceleration` is spatial." : "";
  const std::string jacobian = floats ? "Jacobian with base columns" : "Jacobian";
  const std::string rates = floats ? "(spatial base acceleration, qdd)" : "qdd";
  for (const Axes axes : {Axes::of_world, Axes::of_frame}) {
    const bool in_target = axes == Axes::of_frame;
    const auto add = [&](const std::string& what, const auto& summary, const auto& build) {
      list.push_back(
          {what, in_target, true,
           [=](const std::string& frame) {
             return summary(frame, "in axes of " + (in_target ? frame : std::string("the world")));
           },
           [&tree, axes, build](const Frame& frame, const std::string& name) {
             return build(tree, frame, axes, name);
           }});
    };
    using Summary = std::vector<std::string>;
    add(
        "velocity",
        [](const std::string& frame, const std::string& in_axes) {
          return Summary{"Velocity of " + frame + " in the world, " + in_axes + ": " + kRates + "."};
        },
        world_velocity);
    add(
        "acceleration",
        [of_base](const std::string& frame, const std::string& in_axes) {
          return Summary{
              "Acceleration of " + frame + " in the world, " + in_axes + ": " + kAccelerations +
              ". Gravity is not included." + of_base};
        },
        world_acceleration);
    add(
        "J",
        [columns, jacobian](const std::string& frame, const std::string& in_axes) {
          return Summary{
              jacobian + ": the velocity of " + frame + " in the world, " + in_axes + ": " + kRates +
                  "; angular rows first.",
              columns};
        },
        world_jacobian);
    add(
        "bias",
        [rates](const std::string& frame, const std::string& in_axes) {
          return Summary{
              "Bias of " + frame + ", " + in_axes + ": its acceleration minus its Jacobian in the world times " +
              rates + ": " + kAccelerations + "."};
        },
        world_bias);
  }
  return list;
}

}  // namespace

std::vector<RobotFunction> world_functions(const KinematicTree& tree, const model::DesiredTransforms& desired) {
  const WorldFrames frames(tree, desired);
  const Frame base = tree.frames().front();
  struct Item {
    const Kind* kind;
    const Frame* frame;
  };
  std::vector<Item> items;
  const std::vector<Kind> all = kinds(tree);
  for (const Kind& kind : all)
    for (const Frame& frame : kind.is_of_moving ? frames.moving : frames.placed) items.push_back({&kind, &frame});
  std::vector<RobotFunction> list(items.size());
  for_each_index(items.size(), [&](std::size_t k) {
    const auto& [kind, frame] = items[k];
    const std::string name = kind->what + "_" + frame->name;
    list[k] = {
        "world",
        kind->is_in_target ? "world::in_target" : "world",
        name,
        kind->summary(frame->name),
        {},
        {base, *frame},
        kind->build(*frame, (kind->is_in_target ? "world_in_target_" : "in_world_") + name)};
  });
  return list;
}

std::vector<RobotFunction> world_centroidal_functions(const KinematicTree& tree, FormulationChoices& choices) {
  const RepresentativeLinks& like = choices.representative_of_model();
  const auto axes = CentroidalAxes::of_world;
  const std::string moves = tree.floating_base ? "the robot" : "the moving links";
  const std::string columns = tree.floating_base ? kBaseColumns : kJointColumns;
  const std::string velocity = tree.floating_base ? "(spatial base acceleration, qdd)" : "qdd";
  const auto function = [](const std::string& name, std::vector<std::string> summary, const auto& build) {
    return RobotFunction{"world_centroidal", "world", name, std::move(summary), {}, {}, build("in_world_" + name)};
  };
  using Name = const std::string&;
  return {
      function(
          "center_of_mass", {"Centre of mass of " + moves + " in the world (m)."},
          [&](Name name) { return center_of_mass(tree, name, like, axes); }),
      function(
          "center_of_mass_velocity", {"Velocity (m/s) of the centre of mass of " + moves + " in axes of the world."},
          [&](Name name) { return center_of_mass_velocity(tree, name, like); }),
      function(
          "center_of_mass_jacobian",
          {"Velocity (m/s) of the centre of mass of " + moves + " in axes of the world: 3 rows.", columns},
          [&](Name name) { return center_of_mass_jacobian(tree, name, like, axes); }),
      function(
          "centroidal_momentum",
          {"Momentum of " + moves +
           " about the centre of mass, in axes of the world: angular (N m s), then linear "
           "(N s)."},
          [&](Name name) { return centroidal_momentum(tree, name, like); }),
      function(
          "centroidal_momentum_matrix",
          {"Momentum of " + moves +
               " about the centre of mass, in axes of the world: 3 rows of angular momentum (N m s), 3 of linear "
               "momentum (N s) (Orin, Goswami, Lee 2013).",
           columns},
          [&](Name name) { return centroidal_momentum_matrix(tree, name, like, axes); }),
      function(
          "centroidal_momentum_bias",
          {"Bias of the centroidal momentum: the rate of angular (N m) and linear (N) momentum minus the centroidal "
           "momentum matrix in axes of the world times " +
           velocity + ", which is the time derivative of the matrix times the velocities (Wensing and Orin 2016)."},
          [&](Name name) { return centroidal_momentum_bias(tree, name, like, axes); })};
}

}  // namespace robcogen::algorithm
