// From files to models to libraries: the phases of the generator in their order. Every subcommand is a prefix of this.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "algorithm/catalogue/catalogue.h"
#include "algorithm/kinematics/primitive_product.h"
#include "backend/library.h"
#include "command/status.h"
#include "import/urdf.h"
#include "model/coordinate_transforms.h"
#include "model/kinematic_tree.h"
#include "support/diagnostics.h"

namespace robcogen::command {

inline constexpr const char* kVersion = ROBCOGEN_VERSION;

// A robot as loaded from its documents.
struct Robot {
  model::KinematicTree tree;
  model::DesiredTransforms desired;
  std::string canonical;                    // all that the model says, in one form whatever its layout was
  std::filesystem::path model;              // as given
  std::vector<std::filesystem::path> read;  // every file that was read
};

// The file's text as a source; a Failure when it cannot be read.
std::shared_ptr<const Source> read_source(const std::filesystem::path& path);

// How a robot is read from its documents.
struct Reading {
  std::optional<std::filesystem::path> desired;  // the default list, when there is none
  bool strict = false;                           // see promote_strict_warnings
  import::UrdfOptions urdf;                      // for models in URDF
  bool lists_parameters = false;                 // a note with the model's parameters
  std::vector<std::string> groups = {};          // asked for by name: one that the robot cannot have is an error
};

// By the ending `.urdf`, or by content: a URDF may be called otherwise.
bool is_urdf(const std::filesystem::path& model);

// nullopt when an error was reported.
std::optional<Robot> load_robot(const std::filesystem::path& model, const Reading& reading, Diagnostics& diagnostics);

// Makes errors of the warnings that the original tool refused in desired-transforms documents, and of those about
// names and angles that may be accidents.
void promote_strict_warnings(Diagnostics& diagnostics);

// Straight-line programs for more joints than this help nobody: the inertia matrix alone has a million elements. Checks
// and prints of documents know no such bound.
inline constexpr int kMostJoints = 1000;

// A Failure when the robot has more than kMostJoints.
void require_traceable(const Robot& robot);

// What can be switched off one by one on the way from a model to its programs: the choices of a formulation, then the
// passes.
std::vector<std::string> all_steps();

// Those that are taken, and how hard to look for what is cheap: the search for link frames may trace that many times
// the statements of effort 1; 0 leaves it out.
struct Steps {
  std::vector<std::string> names = all_steps();
  int effort = 1;
};

// The same, by what takes them: tracing, then the passes.
struct SplitSteps {
  algorithm::Formulation formulation;
  std::vector<std::string> passes;
};
SplitSteps split(const Steps& steps);

// The step that computes equal limbs in the lanes of vectors, in languages that have vectors. It comes last.
inline constexpr const char* kLanesStep = "lanes";

// All functions of these groups, by these steps; without lanes. The robot must be traceable.
std::vector<algorithm::RobotFunction> trace(
    const Robot& robot,
    const std::vector<std::string>& groups,
    const Steps& steps);

// Whether transforms come as products of primitives too, and of which convention.
using Primitives = std::optional<model::MovedFramePosition>;

backend::PrimitiveConvention convention_of(Primitives primitives);
void add_product(algorithm::PrimitiveProduct product, backend::Function& function);

struct LibraryNames {
  std::string name;       // folder and namespace
  std::string enclosing;  // namespace around it, or empty
};

// What the back ends print.
backend::Library library(
    const Robot& robot,
    const LibraryNames& names,
    const std::vector<std::string>& groups,
    const Steps& steps,
    Primitives primitives = std::nullopt);

// The same, where the functions of a robot with parameters read what follows from these from a cache.
backend::Library library_for_vectors(
    const Robot& robot,
    const LibraryNames& names,
    const std::vector<std::string>& groups,
    const Steps& steps);

// Parts the programs of a robot at its sines and cosines.
void split_angles(backend::Library& library);

}  // namespace robcogen::command
