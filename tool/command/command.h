// The subcommands: each declares its options on the application and returns what runs when it is chosen.
#pragma once

#include <CLI/CLI.hpp>
#include <functional>

#include "command/transforms.h"

namespace robcogen::command {

using Action = std::function<Status()>;

Action declare_generate(CLI::App& application);
Action declare_check(CLI::App& application);
Action declare_print(CLI::App& application);
Action declare_ops(CLI::App& application);
Action declare_eval(CLI::App& application);
Action declare_convert(CLI::App& application);

// The name of a function on the command line: `transforms.homogeneous.A_X_B`.
std::string dotted(const std::string& scope, const std::string& name);

// A function under that name.
struct NamedProgram {
  std::string name;
  symbolic::Program program;
  std::string method = {};                            // how it is computed, where there was a choice
  std::optional<symbolic::RoundingError> error = {};  // where it was measured
};

// All functions of a robot, or of a document of motions or transforms; overloads in the order of their arguments.
struct Programs {
  std::string kind;   // robot, model
  std::string model;  // its name
  std::string about;  // `3 joints, fixed base; …`
  std::vector<NamedProgram> list;
};

inline constexpr const char* kStrictHelp =
    "Warnings of the desired-transforms document, and of names and angles that may be accidents, are errors";

// Options that several subcommands share.
struct ModelOptions {
  std::string model;
  std::string desired;
  bool strict = false;
  import::UrdfOptions urdf;
  std::string error_format = "gnu";
  Steps steps;
  bool quiet = false;             // no warnings and notes
  bool lists_parameters = false;  // a note with the model's parameters; no option
  bool lanes = false;             // programs where equal limbs share lanes, if that is faster

  void declare(CLI::App& subcommand);
  // Loads the robot and reports diagnostics; nullopt when there was an error, such as that the robot
  // cannot have one of these groups.
  std::optional<Robot> load(const std::vector<std::string>& groups = {}) const;
  // The same for a document of motions or transforms.
  std::optional<Transforms> load_transforms() const;
  // Loads the one or the other, and traces these groups of it; empty: all. With `cached`, functions of a robot with
  // parameters read what follows from these alone from a cache, and the updates that compute it come last.
  std::optional<Programs> load_programs(const std::vector<std::string>& groups = {}, bool cached = false) const;

 private:
  Reading reading() const;
  void report_all(const Diagnostics& diagnostics) const;
};

// `--algorithms all`: every group that the robot and the language allow.
inline constexpr const char* kAllGroups = "all";
// Those that were asked for by their own names.
std::vector<std::string> named_groups(const std::vector<std::string>& asked);

// Groups of functions, none where the option is not given. Documents of motions and of transforms have one alone: a
// Failure when others were asked for.
void declare_groups(CLI::App& subcommand, std::vector<std::string>& groups, const std::string& description);
void require_groups_of_transforms(const std::vector<std::string>& asked);

ErrorFormat format_of(const std::string& name);
void declare_error_format(CLI::App& subcommand, std::string& format);
void declare_urdf_options(CLI::App& subcommand, import::UrdfOptions& options);
// A Failure when one of the options was given and the model is no URDF: its own document says these things.
void require_urdf(const std::filesystem::path& model, const import::UrdfOptions& options);

}  // namespace robcogen::command
