#include "command/command_line.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <charconv>
#include <cmath>
#include <memory>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "backend/languages.h"
#include "command/completions.h"
#include "command/description.h"
#include "command/manual.h"
#include "command/output.h"
#include "command/subcommands.h"
#include "support/diagnostics.h"

namespace robcogen::command {
namespace {

bool is_option(const std::string& argument) {
  return argument.size() > 1 && argument.front() == '-';
}

std::vector<std::string> subcommand_names(const CLI::App& application) {
  std::vector<std::string> names;
  for (const CLI::App* subcommand : application.get_subcommands(nullptr)) names.push_back(subcommand->get_name());
  return names;
}

std::vector<std::string> option_names(const CLI::App& subcommand) {
  std::vector<std::string> names;
  for (const CLI::Option* option : subcommand.get_options())
    for (const std::string& name : option->get_lnames()) names.push_back("--" + name);
  return names;
}

std::string command_of(const CLI::App& application) {
  const std::vector<CLI::App*> chosen = application.get_subcommands();
  return chosen.empty() ? "robcogen" : "robcogen " + chosen.front()->get_name();
}

std::string unknown_subcommand(const CLI::App& application, const std::string& word) {
  const std::vector<std::string> names = subcommand_names(application);
  return with_hint(
      fmt::format("'{}' is not a subcommand; those are {}", word, fmt::join(names, ", ")), did_you_mean(word, names));
}

// `--strct`, or `--strct=3`.
std::string unknown_option(const CLI::App& application, const std::string& argument) {
  const std::vector<CLI::App*> chosen = application.get_subcommands();
  const std::string name = argument.substr(0, argument.find('='));
  return with_hint(
      fmt::format("'{}' is not an option of {}", name, command_of(application)),
      did_you_mean(name, option_names(chosen.empty() ? application : *chosen.front())));
}

// Explains the fault by the first of the unparsed words that does; empty if there is none.
std::string explain_leftover(const CLI::App& application) {
  const std::vector<CLI::App*> chosen = application.get_subcommands();
  const std::vector<std::string> left = (chosen.empty() ? application : *chosen.front()).remaining();
  for (const std::string& argument : left)
    if (is_option(argument)) return unknown_option(application, argument);
  if (left.empty()) return "";
  if (chosen.empty()) return unknown_subcommand(application, left.front());
  return fmt::format("{} takes no further argument '{}'", command_of(application), left.front());
}

std::string explain(const CLI::App& application, const CLI::ParseError& fault) {
  std::string message;
  const auto code = static_cast<CLI::ExitCodes>(fault.get_exit_code());
  if (code == CLI::ExitCodes::ExtrasError || code == CLI::ExitCodes::RequiredError)
    message = explain_leftover(application);
  if (message.empty()) message = fault.what();
  return fmt::format("robcogen: error: {}\nTry '{} --help'.", message, command_of(application));
}

// ---- Options that several subcommands share.

// Accepts a value of an option that is one of these words.
CLI::Validator one_of(std::vector<std::string> words) {
  const std::string description = fmt::format("{{{}}}", fmt::join(words, ","));
  const auto check = [words = std::move(words)](const std::string& word) -> std::string {
    if (std::find(words.begin(), words.end(), word) != words.end()) return "";
    return with_hint(fmt::format("'{}' is not one of {}", word, fmt::join(words, ", ")), did_you_mean(word, words));
  };
  return {check, description};
}

// Accepts integers; CLI::Range says nothing about fractions.
CLI::Validator whole_number() {
  const auto check = [](const std::string& word) -> std::string {
    const std::size_t digits = word.find_first_not_of("+-") == 1 ? 1 : 0;
    const bool is_whole = word.size() > digits && word.find_first_not_of("0123456789", digits) == std::string::npos;
    return is_whole ? "" : fmt::format("'{}' is not a whole number", word);
  };
  return {check, ""};
}

// Accepts finite numbers above zero; CLI::PositiveNumber accepts `inf`.
CLI::Validator positive_number() {
  const auto check = [](const std::string& word) -> std::string {
    double value = 0;
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
    const bool is_number =
        error == std::errc() && end == word.data() + word.size() && std::isfinite(value) && value > 0;
    return is_number ? "" : fmt::format("'{}' is not a positive number", word);
  };
  return {check, ""};
}

constexpr const char* kStrictHelp =
    "Treat warnings about the desired-transforms document, and about suspicious names and angles, as errors";
constexpr const char* kForDevelopers = "For developers of the generator";

void declare_messages(CLI::App& subcommand, Rendering& messages) {
  subcommand
      .add_option_function<std::string>(
          "--error-format",
          [&messages](const std::string& name) {
            messages.format = name == "msvc" ? ErrorFormat::msvc : ErrorFormat::gnu;
          },
          "Format of the positions in messages: gnu or msvc")
      ->check(one_of({"gnu", "msvc"}));
  subcommand.add_flag(
      "--verbose{false}", messages.folds_notes, "Show every note, where the same one applies to several places");
}

void declare_import_folders(CLI::App& subcommand, std::vector<std::filesystem::path>& folders) {
  subcommand
      .add_option(
          "-I,--import-folder", folders,
          "Folder to search for imported documents, after the folder of the importing document, and for meshes and "
          "models that documents name")
      ->allow_extra_args(false);
}

void declare_format_options(CLI::App& subcommand, FormatOptions& format) {
  import::UrdfOptions& options = format.urdf;
  subcommand.add_flag("--floating-base", options.floating_base, "URDF: the root link floats");
  subcommand.add_flag(
      "--snap-angles", options.snap_angles,
      "URDF, SDF: angles within 1e-6 of a multiple of PI/12 become that multiple");
  subcommand.add_flag(
      "--free-mimic-joints", options.free_mimic_joints,
      "URDF, MJCF, SDF: coupled joints are read as independent joints; loops of MJCF are left open");
  subcommand.add_flag(
      "--passive-forces", options.passive_forces, "URDF: damping and friction of joints are part of the dynamics");
  subcommand
      .add_option(
          "--friction-velocity", options.friction_velocity,
          "URDF: the friction of passive forces is smooth, friction times qd / sqrt(qd^2 + VELOCITY^2), in rad/s or "
          "m/s")
      ->check(positive_number())
      ->type_name("VELOCITY");
  subcommand.add_flag(
      "--allow-implausible", options.allow_implausible, "URDF: negative masses and inertias are warnings, not errors");
  subcommand.add_option(
      "--robot", format.robot, "The robot, if the file has several. MJCF: its first body; SDF: its model");
  subcommand
      .add_option(
          "--lock", format.changes.locks,
          "Joints at a constant position (rad, m), which are removed from the robot, and parameters with a constant "
          "value: 'elbow = 0.3', 'hand_* = 0  wrist = PI/2', for a spherical joint 'ball = (1, 0, 0, 0)'")
      ->allow_extra_args(false)
      ->type_name("'JOINT = POSITION'");
  subcommand
      .add_option(
          "--keep", format.changes.kept,
          "The only joints that remain, by name or pattern: all others are locked, at zero or where --lock puts them")
      ->delimiter(',')
      ->allow_extra_args(false);
}

// `view` and `draw` have an option of this name with values.
void declare_parameters(CLI::App& subcommand, FormatOptions& format) {
  subcommand
      .add_option(
          "--parameters", format.changes.parameters,
          "Quantities that become parameters, with their values as defaults: a comma-separated list of LINK.inertia, "
          "LINK.mass, FRAME.placement, JOINT.rotor, …, in which names may be patterns, such as '*.inertia'")
      ->delimiter(',')
      ->allow_extra_args(false);
}

void declare_groups(CLI::App& subcommand, std::vector<std::string>& groups, const std::string& description) {
  std::vector<std::string> names = algorithm::groups();
  names.emplace_back(kAllGroups);
  subcommand.add_option("--algorithms", groups, description)->delimiter(',')->check(one_of(names));
}

constexpr const char* kNoSteps = "none";

std::vector<std::string> words_for_steps() {
  std::vector<std::string> words = driver::all_steps();
  words.emplace_back(kNoSteps);
  return words;
}

std::vector<std::string> chosen_steps(const std::vector<std::string>& words) {
  if (std::count(words.begin(), words.end(), kNoSteps) == 0) return words;
  if (words.size() > 1) throw CLI::ValidationError("--passes", "'none' excludes other steps");
  return {};
}

CLI::Option* declare_model(CLI::App& subcommand, ModelOptions& model) {
  CLI::Option* file = subcommand.add_option(
      "model", model.file, "Robot (.kindsl, .urdf, .sdf or MJCF), motions (.motdsl) or transforms (.ctdsl)");
  file->required();
  subcommand.add_option("--desired", model.desired, "Desired transforms and Jacobians (.dtdsl)");
  subcommand
      .add_option(
          "--contacts", model.contacts,
          "Frames in contact with a fixed environment, for the functions of contacts: a comma-separated list of FRAME "
          "or FRAME:point (three rows) and FRAME:surface (six)")
      ->delimiter(',')
      ->allow_extra_args(false);
  subcommand
      .add_option(
          "--inverse-kinematics", model.inverses,
          "Chains whose inverse kinematics is made in closed form: a comma-separated list of LEFT:RIGHT for the pose "
          "of "
          "frame RIGHT in frame LEFT, LEFT:RIGHT:point for the position of its origin, LEFT:RIGHT:axis for that and "
          "its "
          "z axis, or LEFT:RIGHT:given=JOINT or LEFT:RIGHT:swivel for a pose with a joint, or the swivel angle of an "
          "arm "
          "of seven joints, as an argument; then :tolerance=1e-3 if axes are slightly off, as those of calibrated arms")
      ->delimiter(',')
      ->allow_extra_args(false);
  subcommand
      .add_option(
          "--frames", model.frames,
          "Frames for which functions of frames (transforms, Jacobians, world, …) are made, instead of those at "
          "which limbs end: a comma-separated list of names, or of patterns with * and ?, such as '*_foot'; '*' is "
          "all. With --desired, those of its pairs that have these frames")
      ->delimiter(',')
      ->allow_extra_args(false);
  subcommand
      .add_option(
          "--function", model.functions,
          "Further functions of a robot, each with the results of several functions in one call: 'NAME = FUNCTION + "
          "FUNCTION', such as 'control = joint_space_inertia + bias_forces'")
      ->allow_extra_args(false);
  subcommand.add_option(
      "--srdf", model.srdf,
      "SRDF with the pairs of links of a URDF that are not checked for collisions; default those that a joint "
      "connects");
  subcommand.add_flag("--strict", model.strict, kStrictHelp);
  subcommand
      .add_option_function<std::vector<std::string>>(
          "--passes", [&model](const std::vector<std::string>& names) { model.steps.names = chosen_steps(names); },
          "Optimisation steps: a comma-separated list, or none")
      ->delimiter(',')
      ->allow_extra_args(false)
      ->check(one_of(words_for_steps()))
      ->group(kForDevelopers);
  subcommand
      .add_option(
          "--effort", model.steps.effort,
          "Effort of the search for link frames that make the dynamics cheaper: 0 skips it, 1 takes two seconds for "
          "forty joints, n takes n times as long")
      ->check(whole_number())
      ->check(CLI::Range(0, 1000));
  subcommand.add_option(
      "--derivatives", model.derivatives,
      "Functions to differentiate, and their inputs: function:input or function:input,input, such as "
      "inverse_dynamics:q,qd; or all: every function by its arguments, except those that are named too");
  subcommand.add_option(
      "--gradients", model.gradients,
      "The same, for the gradient of a weighted sum of the function's results instead of matrices");
  subcommand.add_option(
      "--tangents", model.tangents, "The same, for the rates of the function's results at given rates of these inputs");
  declare_import_folders(subcommand, model.import_folders);
  declare_format_options(subcommand, model.format);
  declare_messages(subcommand, model.messages);
  return file;
}

// ---- The subcommands.

using Action = std::function<Status()>;

std::vector<std::string> language_names() {
  std::vector<std::string> names;
  for (const backend::Language& language : backend::languages()) names.push_back(language.name);
  return names;
}

Action declare_generate(CLI::App& application) {
  CLI::App* subcommand =
      application.add_subcommand("generate", "Generates the library of a robot or of coordinate transforms");
  auto options = std::make_shared<GenerateOptions>();
  declare_model(*subcommand, options->model)->required(false);
  declare_parameters(*subcommand, options->model.format);
  options->model.lists_parameters = true;
  subcommand->add_option("-o,--output", options->output, "Folder for the generated files");
  subcommand->add_option("--name", options->names.name, "Folder and namespace of the code; default: the stem of MODEL");
  subcommand->add_option(
      "--namespace", options->names.enclosing, "Enclosing namespace, a::b; files go to the folder a/b/NAME");
  const std::string default_groups = fmt::format("{}", fmt::join(algorithm::default_groups(), ", "));
  declare_groups(*subcommand, options->groups, "Groups of functions to generate; default " + default_groups);
  subcommand->add_flag(
      "--batch", options->has_batches,
      "cpp: also a batch version of each function, for many states at once, compiled for several processors; robots "
      "only");
  subcommand
      ->add_option(
          "--processors", options->processors,
          "cpp: processors to compile functions for; a program chooses one of them when it starts; default baseline; "
          "robots only")
      ->delimiter(',')
      ->check(one_of({"baseline", "avx2", "avx512"}));
  CLI::Option* single = subcommand->add_flag(
      "--single-precision", options->has_single_precision,
      "cpp: all functions also in single precision (namespace f32), which doubles the code to compile");
  subcommand->add_flag("--double-only", options->is_double_only, "cpp: no functions in single precision: the default")
      ->excludes(single);
  subcommand
      ->add_option(
          "--compatibility", options->compatibility,
          "cpp: robcogen: also the headers of the first RobCoGen, in the namespace of --namespace, by default "
          "iit::ROBOT; robots only")
      ->check(one_of({"robcogen"}));
  subcommand->add_option(
      "--include-path", options->include_path,
      "Folder of the headers of --compatibility; default iit/robots/NAME in small letters");
  subcommand->add_option(
      "--vamp", options->vamp,
      "cpp: also vamp/robots/NAME.hh for the motion planner VAMP, with the end effector in this frame; adds the groups "
      "collision and transforms; robots only");
  subcommand->add_flag(
      "--c-selfcheck", options->checks_c,
      "c: also what the self-check of the library needs, in DIR/c/selfcheck; robots only");
  subcommand->add_option("--language", options->languages, "Target languages; default cpp. Others go to DIR/<language>")
      ->delimiter(',')
      ->check(one_of(language_names()));
  subcommand
      ->add_option(
          "--primitives", options->primitives,
          "matlab, maxima, javascript: transforms also as products of Rx, Tx, … that you provide; left or right: the "
          "position of the moved frame")
      ->check(one_of({"left", "right"}));
  subcommand->add_option("--depfile", options->depfile, "Dependency file to write, with the files that were read");
  subcommand->add_option(
      "--depfile-target", options->depfile_target, "Target of the dependency file; default the stamp");
  subcommand->add_option("--stamp", options->stamp, "File to touch when all files are written");
  subcommand->add_flag("--list-outputs", options->list_outputs, "Print the names of the generated files, and stop");
  return [options] { return generate(*options); };
}

Action declare_check(CLI::App& application) {
  CLI::App* subcommand = application.add_subcommand("check", "Reads documents and reports what is wrong with them");
  auto options = std::make_shared<CheckOptions>();
  subcommand->add_option("files", options->files, "Documents (.kindsl, .urdf, .sdf, MJCF, .motdsl, .ctdsl, .dtdsl)")
      ->required();
  subcommand->add_flag("--strict", options->strict, kStrictHelp);
  subcommand->add_flag(
      "--kinematics", options->lists_kinematics,
      "Prints how the inverse kinematics of each chain is solved in closed form, or why there is none: of the chains "
      "of "
      "the list, or from the base to each link without children and each user frame");
  declare_import_folders(*subcommand, options->import_folders);
  declare_format_options(*subcommand, options->format);
  declare_parameters(*subcommand, options->format);
  declare_messages(*subcommand, options->messages);
  return [options] { return check(*options); };
}

Action declare_print(CLI::App& application) {
  CLI::App* subcommand =
      application.add_subcommand("print", "Prints a document in canonical form, or a model's program as text");
  auto options = std::make_shared<PrintOptions>();
  declare_model(*subcommand, options->model);
  declare_parameters(*subcommand, options->model.format);
  subcommand->add_option("--program", options->program, "Print this program of the model (e.g. inverse_dynamics)");
  subcommand->add_flag("--expand", options->expand, "Expand the parts, and print the plain document (robots)");
  subcommand->add_flag(
      "--original", options->original, "Report what the first RobCoGen does not read as an error (robots)");
  return [options] { return print(*options); };
}

Action declare_ops(CLI::App& application) {
  CLI::App* subcommand = application.add_subcommand("ops", "Counts the operations of a model's functions");
  auto options = std::make_shared<OpsOptions>();
  declare_model(*subcommand, options->model);
  declare_parameters(*subcommand, options->model.format);
  declare_groups(*subcommand, options->groups, "Groups of functions to count; default all");
  subcommand->add_flag(
      "--lanes", options->has_lanes, "Put congruent limbs in the lanes of vectors, where that is faster");
  subcommand->add_flag("--json", options->json, "Print JSON");
  return [options] { return ops(*options); };
}

Action declare_eval(CLI::App& application) {
  CLI::App* subcommand = application.add_subcommand("eval", "Evaluates a function of a model: JSON in, JSON out");
  auto options = std::make_shared<EvalOptions>();
  options->model.steps = {{}, 0};  // the plain program: tracing is faster than choosing a formulation
  declare_model(*subcommand, options->model);
  subcommand
      ->add_option(
          "function", options->function,
          "A name that `robcogen ops` lists, or, of a robot, a transform or Jacobian between any two frames. --desired "
          "selects other transforms of motions")
      ->required();
  declare_parameters(*subcommand, options->model.format);
  subcommand->add_flag("--quiet", options->model.quiet, "Print only errors of the model, no warnings and notes");
  subcommand->footer(
      "Reads the arguments of a state as a JSON object from standard input, or those of many states: objects one\n"
      "after the other, such as one per line, or one array of objects. Writes a line of results, a JSON object, for "
      "each.\n"
      "Stops at the first state with an error, which names its line; results of earlier states have been written by "
      "then.\n"
      "Without --passes and --effort the plain program is evaluated, without optimisation.");
  return [options] { return eval(*options); };
}

Action declare_convert(CLI::App& application) {
  CLI::App* subcommand = application.add_subcommand("convert", "Writes a model in another language");
  auto options = std::make_shared<ConvertOptions>();
  subcommand->add_option("from", options->from, "Robot (.kindsl, .urdf, .sdf, MJCF) or motions (.motdsl)")->required();
  subcommand
      ->add_option(
          "to", options->to,
          "File to write; its extension selects the language: .kindsl, .urdf, .motdsl, or .ctdsl for coordinate "
          "transforms")
      ->required();
  subcommand->add_option("--desired", options->desired, "List (.dtdsl) of the transforms to write to a .ctdsl");
  subcommand->add_option("--position", options->position, "Position of the moved frame in a .ctdsl: left or right")
      ->check(one_of({"left", "right"}));
  subcommand->add_flag("--strict", options->strict, kStrictHelp);
  declare_import_folders(*subcommand, options->import_folders);
  declare_format_options(*subcommand, options->format);
  declare_parameters(*subcommand, options->format);
  declare_messages(*subcommand, options->messages);
  return [options] { return convert(*options); };
}

Action declare_language_server(CLI::App& application) {
  CLI::App* subcommand = application.add_subcommand(
      "language-server", "Serves editors over standard input and output: messages, names, completion");
  subcommand->add_flag_callback(
      "--stdio", [] {}, "Use standard input and output, which is the default");
  subcommand->footer(
      "Speaks the Language Server Protocol. An editor starts it; tool/editors/ has the configuration of several "
      "editors.");
  const auto folders = std::make_shared<std::vector<std::filesystem::path>>();
  declare_import_folders(*subcommand, *folders);
  return [folders] { return language_server(*folders); };
}

void declare_picture(CLI::App& subcommand, ViewOptions& options, const std::string& file) {
  declare_model(subcommand, options.model);
  subcommand.add_option("-o,--output", options.output, file);
  subcommand
      .add_option(
          "--parameters", options.parameters,
          "Values of parameters, by name: length=0.3,mass=2; default those of the document")
      ->delimiter(',');
  subcommand
      .add_option(
          "--q", options.q,
          "Positions of the joints (rad, m): 0.1,0.2 in the order of the model, or by name: KFE=0.2; default zero, or "
          "the closest limit")
      ->delimiter(',');
  subcommand.add_option("--depfile", options.depfile, "Dependency file to write, with the files that were read");
}

Action declare_view(CLI::App& application) {
  CLI::App* subcommand = application.add_subcommand("view", "Writes an HTML page that shows a robot and moves it");
  auto options = std::make_shared<ViewOptions>();
  declare_picture(*subcommand, *options, "HTML file to write");
  subcommand->add_flag(
      "--without-shapes", options->without_shapes,
      "Leave out the visual and collision shapes of a URDF, and do not read its meshes");
  return [options] { return view(*options); };
}

Action declare_draw(CLI::App& application) {
  CLI::App* subcommand = application.add_subcommand("draw", "Draws a robot as SVG");
  auto options = std::make_shared<ViewOptions>();
  declare_picture(*subcommand, *options, "SVG file to write");
  subcommand->add_option("--azimuth", options->azimuth, "Azimuth of the viewer, in degrees from x to y; default -60")
      ->check(CLI::Range(-360.0, 360.0));
  subcommand->add_option("--elevation", options->elevation, "Elevation of the viewer, in degrees towards z; default 20")
      ->check(CLI::Range(-90.0, 90.0));
  CLI::Option* pattern = subcommand->add_flag(
      "--pattern", options->pattern, "Also draw which elements of the joint-space inertia matrix are zero");
  subcommand->add_flag("--plain", options->plain, "A small picture of links, joint axes and the base only")
      ->excludes(pattern);
  return [options] { return draw(*options); };
}

}  // namespace

std::function<Status()> parse_command_line(int argc, char** argv) {
  CLI::App application("Generates kinematics and dynamics code for articulated robots.", "robcogen");
  application.set_version_flag("--version", fmt::format("robcogen {}", driver::kVersion));
  application.require_subcommand(1);
  const std::vector<std::pair<const char*, Action>> actions = {
      {"generate", declare_generate(application)},
      {"check", declare_check(application)},
      {"print", declare_print(application)},
      {"ops", declare_ops(application)},
      {"eval", declare_eval(application)},
      {"convert", declare_convert(application)},
      {"draw", declare_draw(application)},
      {"view", declare_view(application)},
      {"language-server", declare_language_server(application)}};
  std::string shell;
  CLI::App* const completing =
      application.add_subcommand("completions", "Prints a script that completes command lines");
  completing->add_option("shell", shell, "bash, zsh or fish")->required()->check(one_of(shells()));
  CLI::App* const describing = application.add_subcommand("manual", "Prints the manual page of this program");
  add_examples(application);
  try {
    application.parse(argc, argv);
  } catch (const CLI::Success& answer) {  // --help, --version
    std::ostringstream text;
    application.exit(answer, text, text);
    return [text = text.str()] {
      write_output(text);
      return ok;
    };
  } catch (const CLI::ParseError& fault) {
    throw Failure{wrong_usage, explain(application, fault)};
  }
  if (completing->parsed() || describing->parsed()) {
    const ProgramDescription program = describe(application);
    return [text = describing->parsed() ? manual(program) : completions(program, shell)] {
      write_output(text);
      return ok;
    };
  }
  for (const auto& [name, action] : actions)
    if (application.got_subcommand(name)) return action;
  throw Failure{wrong_usage, "robcogen: error: no subcommand"};
}

}  // namespace robcogen::command
