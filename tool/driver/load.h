// From files to models.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "driver/changes.h"
#include "import/parts.h"
#include "import/urdf.h"
#include "model/coordinate_transforms.h"
#include "model/kinematic_tree.h"
#include "support/diagnostics.h"
#include "symbolic/derivative.h"

namespace robcogen::driver {

// A function, by the name that `ops` prints, and the inputs by which it is to be differentiated. The function may be a
// derivative that is asked for too. Without inputs: all functions (derivatives.h).
struct Derivative {
  std::string function;
  std::vector<std::string> inputs;
  symbolic::DerivativeForm form = symbolic::DerivativeForm::matrix;

  bool is_all() const { return inputs.empty(); }
};

struct Robot {
  model::KinematicTree tree;
  model::DesiredTransforms desired;
  std::vector<Derivative> derivatives = {};
};

// The transforms that a list asks for, or all that the document names.
struct Transforms {
  model::CoordinateTransforms document;
  std::vector<Derivative> derivatives = {};
};

// A robot, or coordinate transforms without one, as loaded from documents.
struct Model {
  std::variant<Robot, Transforms> content;
  // Everything that the document says, in a form that does not depend on its layout; empty unless
  // LoadOptions::prints_canonical.
  std::string canonical = {};
  std::filesystem::path file = {};               // as given
  std::vector<std::filesystem::path> read = {};  // every file that was read

  const Robot* robot() const { return std::get_if<Robot>(&content); }
  const Transforms* transforms() const { return std::get_if<Transforms>(&content); }
  const std::vector<Derivative>& derivatives() const;
  // The name in the document.
  const std::string& name() const;
  const std::vector<model::Parameter>& parameters() const;
};

struct LoadOptions {
  std::optional<std::filesystem::path> desired = {};  // nullopt: the default list
  bool strict = false;                                // see promote_strict_warnings
  import::UrdfOptions urdf = {};                      // for robots in URDF; what others have, for them too
  std::optional<std::filesystem::path> srdf = {};     // pairs of links of a URDF that are not checked for collisions
  std::string robot = {};                             // which one of a scene in MJCF: see MjcfOptions
  ChangeOptions changes = {};                         // of robots
  bool lists_parameters = false;                      // adds a note with the model's parameters
  std::vector<std::filesystem::path> import_folders = {};  // searched for parts of robots, after that of the document
  bool may_be_library = false;                             // imports and parts without a robot are accepted
  std::vector<std::string> groups = {};      // asked for by name: one that the robot cannot have is an error
  std::vector<Derivative> derivatives = {};  // checked when they are traced
  // Replace the contact frames of the list: `fr_foot`, `fr_foot:point`, `fr_sole:surface`.
  std::vector<std::string> contacts = {};
  // Further functions, fused of others (fused_functions.h): `control = bias_forces + joint_space_inertia`.
  std::vector<std::string> functions = {};
  // Replace the inverse kinematics of the list: `fr_base:fr_tool`, with `:point`, `:axis`, `:swivel` or `:given=J7`,
  // then `:tolerance=1e-3`.
  std::vector<std::string> inverses = {};
  // Functions of frames are made for these only (import/frame_patterns.h): `fr_foot`, `*_foot`. Empty: for all.
  std::vector<std::string> frames = {};
  bool lists_absent_groups = false;   // adds a note for each group that the robot cannot have
  import::OpenTexts open_texts = {};  // of documents, lists and imported documents; not of files that MJCF includes
  bool prints_canonical = true;       // false saves a third of the time
};

// Loads a file in its language (documents.h). Without a list, a document of motions yields each motion and its inverse.
// Returns nullopt if an error was reported.
std::optional<Model> load(const std::filesystem::path& file, const LoadOptions& options, Diagnostics& diagnostics);

// Reports the chains of inverse kinematics that have no closed form.
void check_closed_forms(const Robot& robot, Diagnostics& diagnostics);

// The robot document of the file, in which parts are replaced by their content, and the files that were read for them.
// Returns nullopt if an error was reported.
std::optional<import::RobotDocument> load_robot_document(
    const std::filesystem::path& file,
    const LoadOptions& options,
    Diagnostics& diagnostics);

// The frames of a document of motions or of transforms, and the paths between them. Returns nullopt if an error was
// reported.
std::optional<model::RigidMotions> load_motions_of(
    const std::filesystem::path& file,
    Diagnostics& diagnostics,
    const import::OpenTexts& open_texts = {});

// The pairs of frames that the list of the options asks for; without a list, each motion and its inverse. Returns
// nullopt if an error was reported.
std::optional<std::vector<model::FrameNames>> load_pairs(
    const model::RigidMotions& motions,
    const LoadOptions& options,
    Diagnostics& diagnostics);

// Turns warnings into errors: those about desired-transforms documents that the original tool refused, and those about
// names and angles that may be accidents.
void promote_strict_warnings(Diagnostics& diagnostics);

}  // namespace robcogen::driver
