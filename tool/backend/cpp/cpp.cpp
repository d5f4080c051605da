#include "backend/cpp/cpp.h"

#include <algorithm>

#include "backend/common/planned_file.h"
#include "backend/cpp/layout.h"
#include "backend/cpp/printers.h"

namespace robcogen::backend::cpp {
namespace {

std::string lower_case(std::string text) {
  for (char& c : text)
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  return text;
}

// The name of the robot that this folder belongs to.
std::string name_of(const std::string& folder) {
  return folder.substr(folder.rfind('/') + 1);
}

}  // namespace

std::string folder(const std::string& name, const std::string& enclosing) {
  return scoped(enclosing, name, "/");
}

std::string folder(const Library& library) {
  return folder(library.name, library.enclosing);
}

std::string umbrella_path(const std::string& folder) {
  return folder + "/" + name_of(folder) + ".h";
}

std::string header_path(const std::string& folder, const std::string& stem) {
  return folder + "/" + stem + (lower_case(name_of(folder)) == stem ? "_" : "") + ".h";
}

std::string kernels_path(const std::string& folder) {
  return folder + "/detail/kernels.h";
}

std::string functions_path(const std::string& folder) {
  return folder + "/detail/functions.inc";
}

std::string kernel_path(const std::string& folder, const std::string& group) {
  return folder + "/kernel/" + group + ".h";
}
std::string source_path(const std::string& folder, const std::string& group) {
  return folder + "/" + group + ".cpp";
}

std::string level_path(const std::string& folder, const std::string& level, int part) {
  return folder + "/kernels_" + level + "_" + std::to_string(part) + ".cpp";
}

std::string batch_path(const std::string& folder, const std::string& group) {
  return folder + "/batch/" + group + ".h";
}

std::string batch_source_path(const std::string& folder, const std::string& group, const std::string& level) {
  return folder + "/batch/" + group + "_" + level + ".cpp";
}

std::string runtime_check(const Api& api) {
  const std::string message = api.library->name + " was generated for another runtime of robcogen: generate it again";
  return call("static_assert", {"robcogen::kAbi == 1", quoted(message)}, 0);
}

std::string includes(std::vector<std::string> names) {
  std::sort(names.begin(), names.end());
  std::string result;
  for (const std::string& name : names) result += "#include " + name + "\n";
  return result;
}

namespace {

// All files, in the order in which they are listed.
std::vector<PlannedFile<Api>> files(
    const std::string& folder,
    const std::vector<std::string>& groups,
    bool has_robot,
    bool has_batches,
    const std::vector<std::string>& levels) {
  std::vector<PlannedFile<Api>> list;
  const auto add = [&](const std::string& path, const auto& printer, const auto&... arguments) {
    list.push_back({path, [=](const Api& api) { return printer(api, arguments..., path); }});
  };
  const auto add_kernels = [&](const std::string& group) {
    add(kernel_path(folder, group), print_kernels, group);
    add(source_path(folder, group), print_instantiations, group);
  };
  add(header_path(folder, "model"), print_model);
  add(header_path(folder, "types"), print_types);
  if (has_robot) add(header_path(folder, kParameters), print_parameters);
  add(header_path(folder, "reflection"), has_robot ? print_reflection : print_factors);
  add(umbrella_path(folder), print_umbrella);
  add(kernels_path(folder), print_kernel_declarations);
  add(functions_path(folder), print_definitions);
  if (has_robot)
    for (const char* group : {kParameters, kTrigonometry}) add_kernels(group);
  for (const std::string& group : groups) add_kernels(group);
  if (has_robot && std::find(groups.begin(), groups.end(), kCollision) != groups.end())
    add(header_path(folder, kCollisionCheck), print_collision_check);
  for (const std::string& level : levels)
    for (int part = 1; part <= kLevelParts; ++part) add(level_path(folder, level, part), print_level, level, part);
  if (!has_batches) return list;
  add(header_path(folder, kBatch), print_batch);
  add(source_path(folder, kBatch), print_batch_choice);
  for (const std::string& group : groups) {
    add(batch_path(folder, group), print_batch_bodies, group);
    for (const char* level : kLevels) add(batch_source_path(folder, group, level), print_batch_level, group, level);
  }
  return list;
}

}  // namespace

std::vector<std::string> outputs(
    const std::string& folder,
    const std::vector<std::string>& groups,
    bool has_robot,
    bool has_batches,
    const std::vector<std::string>& levels) {
  return paths(files(folder, groups, has_robot, has_batches, levels));
}

std::vector<OutputFile> print(const Library& library) {
  const bool has_robot = library.has_robot();
  return backend::print(
      files(folder(library), library.groups, has_robot, library.has_batches, library.levels), api(library));
}

}  // namespace robcogen::backend::cpp
