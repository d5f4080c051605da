// The printers behind `print`: each makes the text of one kind of file.
#pragma once

#include <string>

#include "backend/cpp/api.h"

namespace robcogen::backend::cpp {

// The folder of a library's files, under its name and its enclosing namespaces.
std::string folder(const Library& library);

// Path of a header in this folder, as the robot's files include it: `hyl/types.h`. Where the stem is that of the
// umbrella header (a robot called `robot` or `Model`; not all file systems know case), it gets a final '_'.
std::string header_path(const std::string& folder, const std::string& stem);
std::string umbrella_path(const std::string& folder);
// The files that no user includes: the declarations of all kernels, and the definitions of the functions over them.
std::string kernels_path(const std::string& folder);
std::string functions_path(const std::string& folder);
std::string kernel_path(const std::string& folder, const std::string& group);
std::string source_path(const std::string& folder, const std::string& group);

// The file stem, and the group, of the updates of robots with parameters.
inline constexpr const char* kParameters = "parameters";
// The same of sines and cosines of all joints.
inline constexpr const char* kTrigonometry = "trigonometry";

// Processor levels, by the enumerators of robcogen::Level.
inline constexpr const char* kLevels[] = {"baseline", "avx2", "avx512"};

// The file stem of functions over many states, which are compiled for all levels: bodies of a group, and their
// instantiations for one of them.
inline constexpr const char* kBatch = "batch";
// Of kernels for one processor.
std::string level_path(const std::string& folder, const std::string& level);
std::string batch_path(const std::string& folder, const std::string& group);
std::string batch_source_path(const std::string& folder, const std::string& group, const std::string& level);

// Refuses a runtime of another version.
std::string runtime_check(const Api& api);
// `#include` lines; names with their quotes or angle brackets.
std::string includes(std::vector<std::string> names);

std::string print_model(const Api& api, const std::string& path);
std::string print_types(const Api& api, const std::string& path);
// Of types.h: the class templates of sines and cosines of the joints and of what joint_space_inertia_factor returns,
// where the robot has them.
std::string trigonometry_type(const Api& api);
std::string factor_type(const Api& api);
std::string print_parameters(const Api& api, const std::string& path);
std::string print_kernel_declarations(const Api& api, const std::string& path);
// Of a group; or `parameters`: the updates of a robot that has some; or `trigonometry`.
std::string print_kernels(const Api& api, const std::string& group, const std::string& path);
std::string print_instantiations(const Api& api, const std::string& group, const std::string& path);
std::string explicit_instantiations(const Api& api, const std::string& kernel);
std::string instantiations(const Api& api, const std::string& group);
// Whether a group has kernels that are compiled for several processors; print_instantiations then prints the choice.
bool chooses_level(const Api& api, const std::string& group);
std::string print_choice(const Api& api, const std::string& group, const std::string& path);
std::vector<std::string> groups_with_levels(const Api& api);
std::string print_level(const Api& api, const std::string& level, const std::string& path);
// The function that chooses another level, for <name>/reflection.h.
std::string use_level(const Api& api);
std::string print_reflection(const Api& api, const std::string& path);
// Replaces print_reflection for libraries without a robot.
std::string print_factors(const Api& api, const std::string& path);
// Functions over many states: the interface, the choice of a processor's bodies, the bodies.
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
std::string print_umbrella(const Api& api, const std::string& path);
std::string print_definitions(const Api& api, const std::string& path);

// A number of the model; none where it depends on a parameter without default.
std::string model_number(double value);
// The elements of a robcogen::JointDrive, as far as the last one that is not the default.
std::vector<std::string> drive_numbers(const DriveData& drive);
// `robcogen::JointType::revolute`.
std::string joint_type(JointType type);

}  // namespace robcogen::backend::cpp
