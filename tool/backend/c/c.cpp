#include "backend/c/c.h"

#include "backend/c/printers.h"
#include "backend/common/planned_file.h"
#include "support/concat.h"
#include "support/words.h"

namespace robcogen::backend::c {
namespace {

// The names in model.h, without the prefix.
constexpr std::string_view kOthers =
    "cache cachef update updatef default_parameters default_parametersf dof frame_names joint_effort joint_lower "
    "joint_names joint_upper joint_velocity limb limb_element limbs link_count link_names parameter_count "
    "parameter_names parameters parametersf position_names positions restrict";

using File = PlannedFile<Names>;

// The file that includes all headers comes first.
std::vector<File> files(const std::string& prefix, const std::vector<std::string>& groups) {
  const std::string folder = prefix + "_c", path = folder + "/";
  std::string includes = "#include \"" + path + "model.h\"\n";
  for (const std::string& group : groups) includes += "#include \"" + path + group + ".h\"\n";
  const auto umbrella = [=](const Names& n) {
    return header(n, folder + ".h", "all functions", includes + "\n" + identity_reference(n));
  };
  std::vector<File> list = {
      {path + folder + ".h", umbrella}, {path + "model.h", print_model_header}, {path + "model.c", print_model}};
  for (const std::string& group : groups) {
    list.push_back({path + group + ".h", [group](const Names& n) { return print_header(n, group); }});
    for (const Precision& p : kPrecisions)
      list.push_back({path + group + p.file_end, [group, &p](const Names& n) { return print_functions(n, group, p); }});
  }
  return list;
}

}  // namespace

std::vector<std::string> outputs(const std::string& prefix, const std::vector<std::string>& groups) {
  return paths(files(prefix, groups));
}

// With the prefix, no name is reserved. In a clash, the single-precision name gives way, because the double-precision
// names are older.
Names names(const Library& library) {
  const std::string prefix = flat(library.enclosing, library.name);
  return names(library, prefix, prefix + "_c");
}

Names names(const Library& library, const std::string& prefix, const std::string& folder) {
  const std::string start = prefix + "_";
  Names result{library, prefix, folder, {}};
  NameScope scope(is_free, words(kOthers));
  for (const std::vector<Function>* list : {&library.functions, &library.updates})
    for (const Function& f : *list)
      result.functions.push_back(
          {&f, scope.claim(f.kernel), {}, list == &library.functions && !library.updates.empty()});
  for (NamedFunction& c : result.functions) c.name_in_float = start + scope.claim(c.name + "f");
  for (NamedFunction& c : result.functions) c.name = start + c.name;
  return result;
}

std::string Names::in(const Precision& precision, std::string text) const {
  text = replaced(text, "@", prefix);
  return replaced(replaced(text, "%", precision.scalar), "$", precision.suffix);
}

std::vector<OutputFile> print(const Library& library) {
  std::vector<std::string> groups = library.groups;
  if (library.has_robot()) groups.insert(groups.begin(), kParametersGroup);
  const Names names = c::names(library);
  return backend::print(files(names.prefix, groups), names);
}

}  // namespace robcogen::backend::c
