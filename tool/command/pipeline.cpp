#include "command/pipeline.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <map>

#include "algorithm/catalogue/model_numbers.h"
#include "algorithm/formulation/congruent_limbs.h"
#include "algorithm/kinematics/primitive_product.h"
#include "command/accurate_functions.h"
#include "command/model_data.h"
#include "command/parameter_list.h"
#include "export/kinematics.h"
#include "import/kinematics.h"
#include "import/names.h"
#include "language/common/content.h"
#include "model/plausibility.h"
#include "pass/pack_lanes.h"
#include "pass/passes.h"
#include "pass/split_angles.h"
#include "pass/split_parameters.h"
#include "support/files.h"
#include "support/parallel.h"

namespace robcogen::command {
namespace {

// A function of the library's own machinery.
backend::Function function_of(const char* group, symbolic::Program program, std::vector<std::string> summary) {
  backend::Function function;
  function.group = group;
  function.name = function.kernel = program.name;
  function.summary = std::move(summary);
  function.program = std::move(program);
  return function;
}

int frame_index(const std::vector<model::Frame>& frames, const model::Frame& wanted) {
  const auto place =
      std::find_if(frames.begin(), frames.end(), [&](const model::Frame& frame) { return frame.name == wanted.name; });
  return place == frames.end() ? -1 : static_cast<int>(place - frames.begin());
}

// What the robot language cannot say, for the canonical text.
std::string limits_text(const model::KinematicTree& tree) {
  std::string text;
  for (const model::Joint& joint : tree.joints) {
    const model::JointLimits& l = joint.limits;
    if (l == model::JointLimits()) continue;
    text += fmt::format(
        "{} {} {} {} {}\n", joint.name, print_double(l.lower), print_double(l.upper), print_double(l.velocity),
        print_double(l.effort));
  }
  return text;
}

// The tree and its canonical text.
std::optional<Robot> load_model(
    const std::filesystem::path& model,
    const import::UrdfOptions& options,
    Diagnostics& diagnostics) {
  const std::shared_ptr<const Source> source = read_source(model);
  Robot robot;
  if (is_urdf(model)) {
    std::optional<model::KinematicTree> tree = import::urdf(source, options, diagnostics);
    if (!tree) return std::nullopt;
    robot.canonical = language::kinematics::print(exporting::kinematics_document(*tree)) + limits_text(*tree);
    robot.tree = std::move(*tree);
    return robot;
  }
  language::kinematics::Document document = language::kinematics::parse(source, diagnostics);
  if (diagnostics.has_errors()) return std::nullopt;
  std::optional<model::KinematicTree> tree = import::kinematic_tree(document, diagnostics);
  if (!tree) return std::nullopt;
  robot.canonical = language::kinematics::print(language::kinematics::without_comments(std::move(document)));
  robot.tree = std::move(*tree);
  return robot;
}

// A Failure for binary files and for UTF-16: their every second byte would be an error of its own.
void require_text(const Source& source) {
  const std::size_t at = source.text().find('\0');
  if (at == std::string_view::npos) return;
  const LineColumn place = source.locate(at);
  throw Failure{
      wrong_input, fmt::format(
                       "{}:{}:{}: error: not a text file: byte {} is zero [not-text]\nhint: documents are UTF-8",
                       source.name(), place.line, place.column, at + 1)};
}

}  // namespace

std::shared_ptr<const Source> read_source(const std::filesystem::path& path) {
  // What is not a file, such as a pipe, can be read once only.
  static std::map<std::filesystem::path, std::shared_ptr<const Source>> streams;
  std::error_code fault;
  const bool is_stream = path == "-" || !std::filesystem::is_regular_file(path, fault);
  if (const auto known = streams.find(path); is_stream && known != streams.end()) return known->second;
  std::string error;
  std::optional<std::string> text = read_file(path, error);
  if (!text) throw Failure{wrong_usage, error};
  auto source = std::make_shared<const Source>(path == "-" ? "<standard input>" : path.string(), std::move(*text));
  require_text(*source);
  if (is_stream) streams.insert({path, source});
  return source;
}

bool is_urdf(const std::filesystem::path& model) {
  if (model.extension() == ".urdf") return true;
  std::error_code no_such_file;
  if (model != "-" && !std::filesystem::exists(model, no_such_file)) return false;
  return language::content_of(read_source(model)->text()) == language::Content::urdf;
}

std::optional<Robot> load_robot(const std::filesystem::path& model, const Reading& reading, Diagnostics& diagnostics) {
  std::optional<Robot> robot = load_model(model, reading.urdf, diagnostics);
  if (!robot) return std::nullopt;
  if (reading.strict) promote_strict_warnings(diagnostics);
  const auto is_missing = [&](const std::string& group) { return !algorithm::is_available(robot->tree, group); };
  if (std::any_of(reading.groups.begin(), reading.groups.end(), is_missing)) {
    diagnostics.promote_warnings(model::inertia_defect_codes());
    return std::nullopt;
  }
  if (diagnostics.has_errors()) return std::nullopt;
  robot->model = model;
  robot->read.push_back(model);
  if (reading.lists_parameters) list_parameters(robot->tree.parameters, diagnostics);
  if (!reading.desired) {
    robot->desired = model::default_desired(robot->tree);
    return robot;
  }
  const language::desired::Document list = language::desired::parse(read_source(*reading.desired), diagnostics);
  robot->read.push_back(*reading.desired);
  if (diagnostics.has_errors()) return std::nullopt;
  robot->desired = import::desired_transforms(list, robot->tree, diagnostics);
  if (reading.strict) promote_strict_warnings(diagnostics);
  if (diagnostics.has_errors()) return std::nullopt;
  return robot;
}

void promote_strict_warnings(Diagnostics& diagnostics) {
  diagnostics.promote_warnings(import::lenient_codes());
  diagnostics.promote_warnings(import::accident_codes());
}

void require_traceable(const Robot& robot) {
  if (robot.tree.dof() <= kMostJoints) return;
  throw Failure{
      wrong_input, fmt::format(
                       "{}: error: robot '{}' has {} joints; programs are made for at most {} [too-many-joints]",
                       robot.model.string(), robot.tree.name, robot.tree.dof(), kMostJoints)};
}

std::vector<std::string> all_steps() {
  std::vector<std::string> all = algorithm::choices();
  all.insert(all.end(), pass::names().begin(), pass::names().end());
  all.emplace_back(kLanesStep);
  return all;
}

SplitSteps split(const Steps& steps) {
  SplitSteps result;
  result.passes = steps.names;
  std::erase(result.passes, kLanesStep);  // of back ends
  result.formulation = algorithm::take_formulation(result.passes);
  result.formulation.effort = steps.effort;
  return result;
}

namespace {

// Computes equal limbs in lanes where the function gets faster by it and keeps its digits. `alike`: the same program
// with equal limbs that fold alike, where that is another one.
void bring_into_lanes(
    backend::Function& function,
    const model::KinematicTree& tree,
    const std::vector<algorithm::LimbsInLanes>& limbs,
    const std::optional<symbolic::Program>& alike,
    const symbolic::AccurateResults* results) {
  std::vector<pass::InputTuples> classes;
  for (const algorithm::LimbsInLanes& c : limbs) classes.push_back(algorithm::limb_inputs(tree, c, function.program));
  pass::Packed packed = pass::pack_lanes(function.program, classes, alike);
  if (results && packed.program.has_lanes() && !results->are_kept_by(packed.program)) return;
  for (std::size_t c = 0; c < classes.size(); ++c)
    if (packed.in_lanes[c]) function.limbs_in_lanes.push_back(fmt::format("{}", fmt::join(limbs[c].names, ", ")));
  if (!function.limbs_in_lanes.empty()) function.in_lanes = std::move(packed.program);
}

// Functions, and for each the same program with equal limbs that fold alike, where that is another one.
struct Traced {
  std::vector<algorithm::RobotFunction> functions;
  std::vector<std::optional<symbolic::Program>> alike;
  std::vector<std::shared_ptr<const symbolic::AccurateResults>> results;
};

Traced trace(const Robot& robot, const std::vector<std::string>& groups, const Steps& steps, bool for_lanes) {
  require_traceable(robot);
  const SplitSteps choices = split(steps);
  algorithm::FormulationChoices formulations(robot.tree, choices.formulation);
  std::vector<std::vector<algorithm::RobotFunction>> of_groups(groups.size());
  for_each_index(groups.size(), [&](std::size_t g) {
    of_groups[g] = algorithm::functions(robot.tree, robot.desired, groups[g], formulations);
  });
  std::vector<std::vector<std::optional<symbolic::Program>>> alike_of_groups(groups.size());
  if (for_lanes && !algorithm::limbs_in_lanes(robot.tree).empty()) {
    auto for_congruent_limbs = algorithm::FormulationChoices::for_congruent_limbs(formulations);
    for_each_index(groups.size(), [&](std::size_t g) {
      alike_of_groups[g] = algorithm::congruent_programs(robot.tree, groups[g], for_congruent_limbs);
    });
  }
  Traced result;
  for (std::size_t g = 0; g < groups.size(); ++g) {
    alike_of_groups[g].resize(of_groups[g].size());
    std::move(alike_of_groups[g].begin(), alike_of_groups[g].end(), std::back_inserter(result.alike));
  }
  std::vector<AccurateFunction> list =
      accurate_functions(robot.tree, robot.desired, groups, std::move(of_groups), choices.formulation, choices.passes);
  for_each_index(list.size(), [&](std::size_t i) {
    if (!list[i].is_as_traced) result.alike[i].reset();
    if (result.alike[i]) result.alike[i] = pass::run(std::move(*result.alike[i]), choices.passes);
  });
  for (AccurateFunction& f : list) {
    result.functions.push_back(std::move(f.function));
    result.results.push_back(std::move(f.results));
  }
  return result;
}

}  // namespace

std::vector<algorithm::RobotFunction> trace(
    const Robot& robot,
    const std::vector<std::string>& groups,
    const Steps& steps) {
  return trace(robot, groups, steps, false).functions;
}

backend::PrimitiveConvention convention_of(Primitives primitives) {
  if (!primitives) return backend::PrimitiveConvention::none;
  return *primitives == model::MovedFramePosition::left ? backend::PrimitiveConvention::left
                                                        : backend::PrimitiveConvention::right;
}

void add_product(algorithm::PrimitiveProduct product, backend::Function& function) {
  for (const model::PrimitiveTransform& p : product.primitives)
    function.primitives.push_back({p.rotation, static_cast<int>(p.axis)});
  function.amounts = std::move(product.amounts);
}

namespace {

backend::Library library_of(
    const Robot& robot,
    const LibraryNames& names,
    const std::vector<std::string>& groups,
    std::vector<algorithm::RobotFunction> functions,
    Primitives primitives) {
  backend::Library result;
  result.name = names.name;
  result.enclosing = names.enclosing;
  result.robot = robot.tree.name;
  result.model_file = robot.model.filename().string();
  result.model_hash = hash_text(robot.canonical);
  result.generator_version = kVersion;
  result.floating_base = robot.tree.floating_base;
  result.groups = groups;
  result.primitives = convention_of(primitives);
  add_model(robot.tree, result);
  const std::vector<model::Frame> frames = robot.tree.frames();
  for (algorithm::RobotFunction& f : functions) {
    backend::Function function;
    function.group = std::move(f.group);
    function.scope = std::move(f.scope);
    function.name = std::move(f.name);
    function.kernel = f.program.name;
    function.summary = std::move(f.summary);
    function.columns = std::move(f.columns);
    function.left_frame = frame_index(frames, f.frames.left);
    function.right_frame = frame_index(frames, f.frames.right);
    function.program = std::move(f.program);
    function.method = std::move(f.method);
    function.error = f.error;
    if (primitives && function.scope == "transforms::homogeneous")
      add_product(algorithm::primitive_product(robot.tree, f.frames, *primitives), function);
    result.functions.push_back(std::move(function));
  }
  return result;
}

}  // namespace

backend::Library library(
    const Robot& robot,
    const LibraryNames& names,
    const std::vector<std::string>& groups,
    const Steps& steps,
    Primitives primitives) {
  return library_of(robot, names, groups, trace(robot, groups, steps), primitives);
}

namespace {

backend::Library split_library(
    const Robot& robot,
    const LibraryNames& names,
    const std::vector<std::string>& groups,
    const Steps& steps) {
  // Split before the passes, which put parameters and variables together in one sum.
  Steps choices{{}, steps.effort};
  std::vector<std::string> passes;
  for (const std::string& step : steps.names)
    (std::count(pass::names().begin(), pass::names().end(), step) == 0 ? choices.names : passes).push_back(step);
  backend::Library result = library(robot, names, groups, choices);
  std::vector<symbolic::Program> programs;
  for (backend::Function& function : result.functions) programs.push_back(std::move(function.program));
  std::vector<pass::Interfaces> interfaces;
  for (const backend::ParameterData& p : result.parameters) interfaces.push_back({p.is_kinematics, p.is_dynamics});
  pass::SplitPrograms split = pass::split_parameters(std::move(programs), interfaces);
  for_each_index(split.programs.size(), [&](std::size_t i) {
    result.functions[i].program = pass::run(std::move(split.programs[i]), passes);
  });
  const auto add_update = [&](symbolic::Program& program, const std::string& what) {
    result.updates.push_back(
        function_of("parameters", pass::run(std::move(program), passes), {"What follows from " + what + "."}));
  };
  add_update(split.kinematics, "kinematics parameters alone");
  add_update(split.dynamics, "dynamics parameters alone");
  add_update(split.both, "kinematics and dynamics parameters together");
  result.numbers.push_back(
      function_of("parameters", algorithm::model_numbers(robot.tree), {"The numbers of the model, a column each."}));
  return result;
}

}  // namespace

void split_angles(backend::Library& library) {
  std::vector<pass::WithLanes> programs;
  for (const backend::Function& function : library.functions)
    programs.push_back({function.program, function.in_lanes ? &*function.in_lanes : nullptr});
  std::vector<std::string> joints;
  for (const backend::JointData& joint : library.joints) joints.push_back(joint.name);
  pass::SplitAngles split = pass::split_angles(programs, joints);
  for (std::size_t i = 0; i < programs.size(); ++i) library.functions[i].parts = std::move(split.parts[i]);
  library.trigonometry = {
      split.angle_count, std::move(split.angles),
      function_of(
          "trigonometry", std::move(split.addition),
          {"Sines and cosines of all angles from those of the joints: of sums by the addition theorems."})};
}

backend::Library library_for_vectors(
    const Robot& robot,
    const LibraryNames& names,
    const std::vector<std::string>& groups,
    const Steps& steps) {
  const bool has_lanes = std::count(steps.names.begin(), steps.names.end(), kLanesStep) > 0;
  std::vector<std::optional<symbolic::Program>> alike;
  std::vector<std::shared_ptr<const symbolic::AccurateResults>> results;
  backend::Library result;
  if (robot.tree.parameters.empty()) {
    Traced traced = trace(robot, groups, steps, has_lanes);
    alike = std::move(traced.alike);
    results = std::move(traced.results);
    result = library_of(robot, names, groups, std::move(traced.functions), std::nullopt);
  } else {
    result = split_library(robot, names, groups, steps);
    alike.resize(result.functions.size());
    results.resize(result.functions.size());
  }
  if (!has_lanes) return result;
  const std::vector<algorithm::LimbsInLanes> limbs = algorithm::limbs_in_lanes(robot.tree);
  if (limbs.empty()) return result;
  for_each_index(result.functions.size(), [&](std::size_t i) {
    bring_into_lanes(result.functions[i], robot.tree, limbs, alike[i], results[i].get());
  });
  return result;
}

}  // namespace robcogen::command
