// What several subcommands ask of a model, and how they load it.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "driver/driver.h"
#include "driver/find_function.h"
#include "support/diagnostics.h"

namespace robcogen::command {

using driver::dotted;

// A function under that name.
struct NamedProgram {
  std::string name;
  symbolic::Program program;
  std::string method = {};                            // the method, when several were considered
  std::optional<symbolic::RoundingError> error = {};  // when it was measured
};

// All functions of a robot, or of a document of motions or transforms; overloads in the order of their arguments.
struct Programs {
  std::string kind;   // robot, model
  std::string model;  // its name
  std::string about;  // `3 joints, fixed base; …`
  std::vector<NamedProgram> list;
};

struct ModelOptions {
  std::string file;
  std::string desired;
  std::vector<std::string> contacts;  // of robots
  bool strict = false;
  import::UrdfOptions urdf;
  std::vector<std::filesystem::path> import_folders;
  ErrorFormat error_format = ErrorFormat::gnu;
  driver::Steps steps;
  std::vector<std::string> derivatives;  // `function:input,…`
  bool quiet = false;                    // no warnings and notes
  bool lists_parameters = false;         // a note with the model's parameters; no option

  // Loads the model and reports diagnostics; nullopt when there was an error, such as that a robot cannot have one of
  // these groups.
  std::optional<driver::Model> load(const std::vector<std::string>& groups = {}) const;
  // The same; `diagnostics` has what was reported.
  std::optional<driver::Model> load(const std::vector<std::string>& groups, Diagnostics& diagnostics) const;
  // Loads the model, and makes the programs of these groups of a robot, empty: all, for a language with these features:
  // with lanes, those in lanes where there are any; updates of cached parameters come last.
  std::optional<Programs> load_programs(
      const std::vector<std::string>& groups = {},
      const backend::Features& features = {}) const;
};

// `--algorithms all`: every group that the robot and the language allow.
inline constexpr const char* kAllGroups = "all";
// The groups that were named one by one.
std::vector<std::string> named_groups(const std::vector<std::string>& asked);

// Documents of motions and of transforms have one group alone: a Failure when others were asked for.
void require_groups_of_transforms(const std::vector<std::string>& asked);

// A Failure when one of the options was given and the model is not a URDF: its own document says these things.
void require_urdf(const std::filesystem::path& model, const import::UrdfOptions& options);

}  // namespace robcogen::command
