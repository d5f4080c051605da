#include "backend/c/c.h"

#include <functional>

#include "backend/c/printers.h"
#include "support/concat.h"
#include "support/parallel.h"

namespace robcogen::backend::c {
namespace {

// Names that model.h has, without the prefix.
constexpr std::string_view kOthers =
    "cache cachef update updatef default_parameters default_parametersf dof frame_names joint_effort joint_lower "
    "joint_names joint_upper joint_velocity limb limb_element limbs link_count link_names parameter_count "
    "parameter_names parameters parametersf position_names positions restrict";

// Behind the prefix every name is free. Those of single precision give way: they are the younger ones.
std::vector<Callable> callables(const Library& library) {
  NameScope scope(is_free, words(kOthers));
  std::vector<Callable> result;
  for (const std::vector<Function>* list : {&library.functions, &library.updates})
    for (const Function& f : *list)
      result.push_back({&f, scope.claim(f.kernel), {}, !library.updates.empty() && f.group != kParametersGroup});
  const std::string start = flat(library.enclosing, library.name) + "_";
  for (Callable& c : result) c.name_in_float = start + scope.claim(c.name + "f");
  for (Callable& c : result) c.name = start + c.name;
  return result;
}

struct File {
  std::string path;
  std::function<std::string(const Names&)> text;
};

// First the one that includes all headers.
std::vector<File> files(const std::string& prefix, const std::vector<std::string>& groups) {
  const std::string folder = prefix + "_c", path = folder + "/";
  std::string includes = "#include \"" + path + "model.h\"\n";
  for (const std::string& group : groups) includes += "#include \"" + path + group + ".h\"\n";
  const auto umbrella = [=](const Names& n) { return header(n, folder + ".h", "all functions", includes); };
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

std::string prefix(const std::string& name, const std::string& enclosing) {
  return flat(enclosing, name);
}

std::vector<std::string> outputs(const std::string& prefix, const std::vector<std::string>& groups) {
  std::vector<std::string> paths;
  for (const File& file : files(prefix, groups)) paths.push_back(file.path);
  return paths;
}

Names names(const Library& library) {
  std::vector<std::string> parameters;
  for (const ParameterData& p : library.parameters) parameters.push_back(p.name);
  const std::string prefix = flat(library.enclosing, library.name);
  return {library, prefix, prefix + "_c", callables(library), members(parameters)};
}

std::vector<OutputFile> print(const Library& library) {
  std::vector<std::string> groups = library.groups;
  if (library.has_robot()) groups.insert(groups.begin(), kParametersGroup);
  const Names names = c::names(library);
  const std::vector<File> list = files(names.prefix, groups);
  std::vector<OutputFile> result(list.size());
  for_each_index(list.size(), [&](std::size_t i) { result[i] = {list[i].path, list[i].text(names)}; });
  return result;
}

}  // namespace robcogen::backend::c
