// The options of several subcommands about the model, and how it is loaded.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "driver/driver.h"
#include "driver/find_function.h"
#include "model/unlike_limbs.h"
#include "support/diagnostics.h"

namespace robcogen::command {

using driver::dotted;

// A program and the name of its function.
struct NamedProgram {
  std::string name;
  symbolic::Program program;
  std::string method = {};                            // how it is computed, if several methods were considered
  std::optional<symbolic::RoundingError> error = {};  // if it was measured
  std::vector<std::string> limbs_in_lanes = {};       // a text for each class of limbs that share lanes
  std::string without_lanes = {};                     // why congruent limbs share none
};

// All functions of a robot, or of a document of motions or transforms; overloads in the order of their arguments.
struct Programs {
  std::string kind;   // robot, model
  std::string model;  // its name
  std::string about;  // `3 joints, fixed base; …`
  std::vector<NamedProgram> list;
  std::vector<std::filesystem::path> read = {};  // files
  std::vector<model::UnlikeLimbs> unlike_limbs = {};
};

// Options that say how a robot is read. Most apply to robots in other formats than the robot document.
struct FormatOptions {
  import::UrdfOptions urdf;
  std::string robot;  // which one of a scene in MJCF; empty: the only one
  driver::ChangeOptions changes;
};

struct ModelOptions {
  std::string file;
  std::string desired;
  std::vector<std::string> contacts;   // for robots
  std::vector<std::string> inverses;   // for robots
  std::vector<std::string> frames;     // for robots: names or patterns
  std::vector<std::string> functions;  // for robots: `name = function + function`
  std::string srdf;                    // for robots in URDF: pairs of links without collision checks
  bool strict = false;
  FormatOptions format;
  std::vector<std::filesystem::path> import_folders;
  Rendering messages;
  driver::Steps steps;
  std::vector<std::string> derivatives, gradients, tangents;  // `function:input,…`
  bool quiet = false;                                         // prints no warnings and notes
  bool lists_parameters = false;  // adds a note with the model's parameters; not an option itself

  bool asks_for_derivatives() const { return !derivatives.empty() || !gradients.empty() || !tangents.empty(); }

  // Loads the model and reports diagnostics. Returns nullopt if there was an error, for example because a robot cannot
  // have one of these groups.
  std::optional<driver::Model> load(const std::vector<std::string>& groups = {}) const;
  // The same; `diagnostics` receives what was reported.
  std::optional<driver::Model> load(const std::vector<std::string>& groups, Diagnostics& diagnostics) const;
  // Loads the model, and makes the programs of these groups of a robot (empty: all), for a language with these
  // features. With lanes, the programs are those in lanes where there are any; updates of cached parameters come last.
  std::optional<Programs> load_programs(
      const std::vector<std::string>& groups = {},
      const backend::Features& features = {}) const;
};

// `--algorithms all`: every group that the robot and the language allow, except `collision`.
inline constexpr const char* kAllGroups = "all";
// The groups that were named one by one; empty for kAllGroups.
std::vector<std::string> named_groups(const std::vector<std::string>& asked);

// Documents of motions and of transforms have a single group: throws a Failure if others were asked for.
void require_groups_of_transforms(const std::vector<std::string>& asked);

// Reports a warning for each folder of imports that does not exist.
void report_missing_folders(const std::vector<std::filesystem::path>& folders, const Rendering& messages);

// Throws a Failure if one of the options was given and the model is in a format that it does not apply to: other
// documents say these things themselves.
void require_format(const std::filesystem::path& model, const FormatOptions& options);

}  // namespace robcogen::command
