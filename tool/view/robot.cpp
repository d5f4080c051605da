#include "view/robot.h"

#include <algorithm>
#include <map>

#include "algorithm/catalogue/model_numbers.h"
#include "algorithm/kinematics/frame_poses.h"
#include "driver/driver.h"
#include "model/elements.h"
#include "model/plausibility.h"
#include "support/index.h"
#include "symbolic/interpret.h"

namespace robcogen::view {
namespace {

using algorithm::kNumbersOfLink;
using symbolic::Role;

constexpr const char* kFramePoses = "frame_poses";

// The groups whose functions are shown. Without pairs of frames, the group of transforms has functions of joints that
// follow others.
std::vector<std::string> groups_of(const model::KinematicTree& tree, Purpose purpose) {
  std::vector<std::string> groups = {driver::kTransformsGroup};
  if (purpose == Purpose::page)
    for (const char* group : {"bias_forces", "forward_dynamics"})
      if (algorithm::is_available(tree, group)) groups.emplace_back(group);
  return groups;
}

// The model with its base held.
driver::Model held(const driver::Model& model) {
  driver::Model result = model;
  driver::Robot robot = *model.robot();
  robot.tree.floating_base = false;
  robot.tree.inertia_defects = model::inertia_defects(robot.tree);
  robot.desired = {};
  robot.derivatives.clear();
  result.content = std::move(robot);
  return result;
}

bool is_shown(const backend::Function& f) {
  return f.name == "gravity_forces" || f.name == "forward_dynamics" || f.name == "joint_positions" ||
         f.name == "close_loops";
}

backend::Function function_of(const std::string& name, symbolic::Program program, const std::string& what) {
  backend::Function f;
  f.group = f.name = f.kernel = name;
  f.summary = {what};
  f.program = std::move(program);
  return f;
}

std::vector<ViewedFrame> frames_of(const model::KinematicTree& tree) {
  std::map<int, int> joints;
  for (const int j : model::independent_joints_first(tree)) joints.emplace(j, static_cast<int>(joints.size()));
  std::vector<ViewedFrame> result;
  int users = 0;
  for (const model::Frame& frame : tree.frames()) {
    ViewedFrame viewed = {ViewedFrame::Kind::link, frame.name, frame.index, tree.link_of(frame)};
    if (frame.kind == model::Frame::Kind::joint) {
      viewed.kind = ViewedFrame::Kind::joint;
      viewed.index = joints.at(frame.index);
    } else if (frame.kind == model::Frame::Kind::user) {
      viewed.kind = ViewedFrame::Kind::user;
      viewed.index = users++;
    }
    result.push_back(std::move(viewed));
  }
  return result;
}

symbolic::Arrays<double> arguments(
    const symbolic::Program& program,
    const std::vector<double>& q,
    const std::vector<double>& parameters) {
  symbolic::Arrays<double> inputs;
  for (const symbolic::InputArray& input : program.inputs)
    inputs[input.name] = input.role == Role::parameters ? parameters : q;
  return inputs;
}

}  // namespace

bool ViewedRobot::has_function(const std::string& name) const {
  return std::any_of(
      library.functions.begin(), library.functions.end(), [&](const backend::Function& f) { return f.name == name; });
}

ViewedRobot viewed(const driver::Model& model, Purpose purpose) {
  driver::require_traceable(model);
  const driver::Model robot = held(model);
  const model::KinematicTree& tree = robot.robot()->tree;
  driver::LibraryOptions options = {.names = {"robot"}, .groups = groups_of(tree, purpose)};
  options.steps.effort = 0;  // a picture should appear at once
  ViewedRobot result;
  result.library = driver::library(robot, options);
  std::vector<backend::Function>& functions = result.library.functions;
  std::erase_if(functions, [](const backend::Function& f) { return !is_shown(f); });
  functions.push_back(function_of(
      kFramePoses, algorithm::frame_poses(tree, kFramePoses),
      "Axes x, y, z and origins (m) of all frames in the base: a column for each."));
  if (!tree.parameters.empty())
    functions.push_back(
        function_of("numbers", algorithm::model_numbers(tree), "The numbers of links, joints and frames."));
  result.frames = frames_of(tree);
  for (const model::LoopJoint& loop : tree.loops) {
    const auto place = [&](const model::LoopEnd& end) { return at(model::place_of_frame(tree, end.frame)); };
    result.loops.push_back({loop.name, {place(loop.ends[0]), place(loop.ends[1])}});
  }
  result.floats = model.robot()->tree.floating_base;
  return result;
}

Posture posture(const ViewedRobot& robot, const std::vector<double>& q, const std::vector<double>& parameters) {
  const std::vector<backend::Function>& functions = robot.library.functions;
  Posture result;
  const auto placed = std::find_if(
      functions.begin(), functions.end(), [](const backend::Function& f) { return f.name == kFramePoses; });
  const auto poses = symbolic::interpret<double>(placed->program, arguments(placed->program, q, parameters));
  const double* placed_frame = poses.at("poses").data();
  for (std::size_t f = 0; f < robot.frames.size(); ++f, placed_frame += 12) {
    Pose pose{};
    for (std::size_t k = 0; k < 12; ++k) pose[k % 3][k / 3] = placed_frame[k];
    pose[3][3] = 1;
    result.frames.push_back(pose);
  }
  const model::KinematicTree& tree = robot.library.tree;
  std::vector<model::MassProperties> links;
  for (std::size_t l = 0; l < at(tree.link_count()); ++l)
    links.push_back(model::mass_properties(tree.links[l], model::DefaultValues(tree.parameters)));
  for (const backend::Function& f : functions) {
    if (f.name != "numbers") continue;
    const auto results = symbolic::interpret<double>(f.program, arguments(f.program, q, parameters));
    for (std::size_t l = 0; l < links.size(); ++l) {
      const double* column = results.at("links").data() + l * kNumbersOfLink;
      links[l].mass = column[0];
      links[l].com = {column[1], column[2], column[3]};
    }
  }
  for (std::size_t l = 0; l < links.size(); ++l) {
    const Pose& pose = result.frames[l];
    std::array<double, 3> centre{};
    for (std::size_t i = 0; i < 3; ++i)
      centre[i] =
          pose[i][3] + pose[i][0] * links[l].com[0] + pose[i][1] * links[l].com[1] + pose[i][2] * links[l].com[2];
    result.masses.push_back(links[l].mass);
    result.centres.push_back(centre);
  }
  return result;
}

}  // namespace robcogen::view
