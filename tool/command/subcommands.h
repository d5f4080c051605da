// The subcommands and their options. The command line (command_line.h) fills in the options; each subcommand is a
// function of them.
#pragma once

#include <string>
#include <vector>

#include "command/model_options.h"
#include "command/status.h"

namespace robcogen::command {

struct GenerateOptions {
  ModelOptions model;
  std::string output;
  driver::LibraryNames names;
  std::vector<std::string> groups;  // empty: the default groups, as far as a language offers them
  std::vector<std::string> languages = {"cpp"};
  std::string primitives;  // convention; empty: no products
  std::string depfile, depfile_target, stamp;
  bool has_batches = false;
  std::vector<std::string> processors;  // levels that kernels of one state are compiled for
  bool has_single_precision = false;
  bool is_double_only = false;  // the default, which may be stated
  std::string compatibility;    // `robcogen`: also the headers of the first RobCoGen; empty: none
  std::string include_path;     // folder of these headers
  std::string vamp;             // the frame of the end effector: also a header for VAMP; empty: none
  bool checks_c = false;        // also what the self-check of the library in C needs
  bool list_outputs = false;
};
// Without a name, the code is named after the file of the model.
Status generate(GenerateOptions options);

struct CheckOptions {
  std::vector<std::string> files;
  std::vector<std::filesystem::path> import_folders;
  FormatOptions format;
  bool strict = false;
  bool lists_kinematics = false;  // prints how chains are inverted
  Rendering messages;
};
Status check(const CheckOptions& options);

struct PrintOptions {
  ModelOptions model;
  std::string program;
  bool expand = false;    // replace parts by their content
  bool original = false;  // refuse what the first RobCoGen does not read
};
Status print(const PrintOptions& options);

struct OpsOptions {
  ModelOptions model;
  std::vector<std::string> groups;
  bool has_lanes = false;  // programs where congruent limbs share lanes, if that is faster
  bool json = false;
};
Status ops(const OpsOptions& options);

struct EvalOptions {
  ModelOptions model;
  std::string function;
};
Status eval(const EvalOptions& options);

// The options of pictures of a robot.
struct ViewOptions {
  ModelOptions model;
  std::string output, depfile;
  std::vector<std::string> q, parameters;  // values in order, `0.1`, or by name, `KFE=0.1`
  double azimuth = -60, elevation = 20;    // of the viewer, degrees
  bool pattern = false;                    // also draw the pattern of the joint-space inertia matrix
  bool plain = false;                      // draw links, joint axes and the base only
  bool without_shapes = false;             // no visual and collision shapes on the page
};
Status draw(const ViewOptions& options);
Status view(const ViewOptions& options);

struct ConvertOptions {
  std::string from, to;
  std::string desired;
  std::string position = "right";
  bool strict = false;
  std::vector<std::filesystem::path> import_folders;
  FormatOptions format;
  Rendering messages;
};
Status convert(const ConvertOptions& options);

// Serves over standard input and output. Imported documents are also searched in these folders. Returns wrong_input if
// the editor ends the session without `shutdown`.
Status language_server(const std::vector<std::filesystem::path>& import_folders);

}  // namespace robcogen::command
