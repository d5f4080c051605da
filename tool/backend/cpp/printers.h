// The printers behind `print`, one for each kind of file.
#pragma once

#include <string>

#include "backend/cpp/api.h"

namespace robcogen::backend::cpp {

// The folder of a library's files, from its name and its enclosing namespaces.
std::string folder(const Library& library);

// The path of a header in this folder, as the robot's files include it: `hyl/types.h`. A stem that equals that of the
// umbrella header (a robot called `robot` or `Model`; some file systems ignore case) gets a final '_'.
std::string header_path(const std::string& folder, const std::string& stem);
std::string umbrella_path(const std::string& folder);
// Files that no user includes: the declarations of all kernels, and the definitions of the functions over them.
std::string kernels_path(const std::string& folder);
std::string functions_path(const std::string& folder);
std::string kernel_path(const std::string& folder, const std::string& group);
std::string source_path(const std::string& folder, const std::string& group);

// The file stem, and the group, of the updates of a robot with parameters.
inline constexpr const char* kParameters = "parameters";
// The same for the sines and cosines of all joints.
inline constexpr const char* kTrigonometry = "trigonometry";

// The group of functions with which a robot has checks for collisions, and the file stem of these.
inline constexpr const char* kCollision = "collision";
inline constexpr const char* kCollisionCheck = "collision_check";

// Processor levels, named like the enumerators of robcogen::Level.
inline constexpr const char* kLevels[] = {"baseline", "avx2", "avx512"};

// The file stem of functions over many states, which are compiled for all levels. Each group has a file of bodies, and
// one file of their instantiations per level.
inline constexpr const char* kBatch = "batch";
// The files of the kernels for one processor level: several, which are compiled at once.
inline constexpr int kLevelParts = 2;
std::string level_path(const std::string& folder, const std::string& level, int part);
std::string batch_path(const std::string& folder, const std::string& group);
std::string batch_source_path(const std::string& folder, const std::string& group, const std::string& level);

// A check that rejects a runtime of another version.
std::string runtime_check(const Api& api);
// `#include` lines; the names have their quotes or angle brackets.
std::string includes(std::vector<std::string> names);

std::string print_model(const Api& api, const std::string& path);
std::string print_types(const Api& api, const std::string& path);
// Parts of types.h: the class templates of the sines and cosines of the joints, and of what joint_space_inertia_factor
// returns, if the robot has them.
std::string trigonometry_type(const Api& api);
std::string factor_type(const Api& api);
std::string print_parameters(const Api& api, const std::string& path);
std::string print_kernel_declarations(const Api& api, const std::string& path);
// The kernels of a group; or of `parameters`, the updates of a robot that has some; or of `trigonometry`.
std::string print_kernels(const Api& api, const std::string& group, const std::string& path);
std::string print_instantiations(const Api& api, const std::string& group, const std::string& path);
std::string explicit_instantiations(const Api& api, const std::string& kernel);
std::string instantiations(const Api& api, const std::string& group);
// Whether a group has kernels that are compiled for several processors. print_instantiations then prints the choice.
bool chooses_level(const Api& api, const std::string& group);
std::string print_choice(const Api& api, const std::string& group, const std::string& path);
std::vector<std::string> groups_with_levels(const Api& api);
std::string print_level(const Api& api, const std::string& level, int part, const std::string& path);
// The function that selects another level, for <name>/reflection.h.
std::string use_level(const Api& api);
std::string print_reflection(const Api& api, const std::string& path);
// Replaces print_reflection for libraries without a robot.
std::string print_factors(const Api& api, const std::string& path);
// Functions over many states: the interface, the choice of the bodies for a processor, and the bodies.
std::string print_batch(const Api& api, const std::string& path);
std::string print_batch_choice(const Api& api, const std::string& path);
std::string print_batch_bodies(const Api& api, const std::string& group, const std::string& path);
std::string print_batch_level(
    const Api& api,
    const std::string& group,
    const std::string& level,
    const std::string& path);
// Their declarations within the robot's namespace, for the table in <name>/reflection.h.
std::string batch_kernel_declarations(const Api& api);

// The reference of a header to the library's model, and its definition in the source of a group, if that has it.
std::string identity_reference(const Api& api, const std::string& header);
std::string identity_definition(const Api& api, const std::string& group);

// Checks that end early: robots with the group `collision`.
std::string print_collision_check(const Api& api, const std::string& path);

std::string print_umbrella(const Api& api, const std::string& path);
std::string print_definitions(const Api& api, const std::string& path);

// A number of the model; NaN if it depends on a parameter without default.
std::string model_number(double value);
std::vector<std::string> model_numbers(const std::vector<double>& values);
// The members of a robcogen::JointDrive, up to the last one that differs from the default.
std::vector<std::string> drive_numbers(const model::KinematicTree& tree, const model::Joint& joint);
// `robcogen::JointType::revolute`.
std::string joint_type(model::JointType type);

}  // namespace robcogen::backend::cpp
