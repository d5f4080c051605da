#include "backend/c/c.h"

#include <functional>

#include "backend/c/printers.h"
#include "support/parallel.h"

namespace robcogen::backend::c {
namespace {

// In front of model.h, and in front of all headers.
constexpr const char* kModel = "model";

// Names that model.h has, without the prefix.
constexpr std::string_view kOthers =
    "cache cachef update updatef default_parameters default_parametersf dof frame_names joint_effort joint_lower "
    "joint_names joint_upper joint_velocity limb limb_element limbs link_count link_names parameter_count "
    "parameter_names parameters parametersf position_names positions restrict";

bool is_free(const std::string&) {
  return false;
}

// Those of the library; a robot's parameters in front.
std::vector<std::string> groups_of(const Library& library) {
  std::vector<std::string> groups = library.groups;
  if (library.has_robot()) groups.insert(groups.begin(), kParametersGroup);
  return groups;
}

std::string print_umbrella(const Names& names) {
  std::string includes = "#include \"" + names.folder + "/" + kModel + ".h\"\n";
  for (const std::string& group : groups_of(names.library))
    includes += "#include \"" + names.folder + "/" + group + ".h\"\n";
  return header(names, names.folder + ".h", "all functions", includes);
}

}  // namespace

std::string prefix(const std::string& name, const std::string& enclosing) {
  std::string result = enclosing.empty() ? name : enclosing + "::" + name;
  for (std::size_t at = result.find("::"); at != std::string::npos; at = result.find("::")) result.replace(at, 2, "_");
  return result;
}

std::vector<std::string> outputs(const std::string& prefix, const std::vector<std::string>& groups) {
  const std::string folder = prefix + "_c", path = folder + "/";
  std::vector<std::string> files = {path + folder + ".h", path + kModel + ".h", path + kModel + ".c"};
  for (const std::string& group : groups)
    for (const char* end : {".h", ".c", "_f.c"}) files.push_back(path + group + end);
  return files;
}

// Names of single precision give way: they are the younger ones.
std::vector<Callable> callables(const Library& library) {
  NameScope scope(is_free, words(kOthers));
  std::vector<Callable> result;
  const std::string start = prefix(library.name, library.enclosing) + "_";
  for (const std::vector<Function>* list : {&library.functions, &library.updates})
    for (const Function& f : *list) result.push_back({&f, scope.claim(f.kernel), {}});
  for (Callable& c : result) c.name_in_float = start + scope.claim(c.name + "f");
  for (Callable& c : result) c.name = start + c.name;
  return result;
}

Names names(const Library& library) {
  std::vector<std::string> parameters;
  for (const ParameterData& p : library.parameters) parameters.push_back(p.name);
  const std::string name = prefix(library.name, library.enclosing);
  return {library, name, name + "_c", callables(library), members(parameters)};
}

std::vector<OutputFile> print(const Library& library) {
  const Names names = c::names(library);
  std::vector<std::function<std::string()>> texts = {
      [&] { return print_umbrella(names); }, [&] { return print_model_header(names); },
      [&] { return print_model(names); }};
  const std::vector<std::string> groups = groups_of(library);
  for (const std::string& group : groups) {
    texts.emplace_back([&names, group] { return print_header(names, group); });
    for (const Precision& precision : kPrecisions)
      texts.emplace_back([&names, group, &precision] { return print_functions(names, group, precision); });
  }
  std::vector<OutputFile> files;
  for (const std::string& path : outputs(names.prefix, groups)) files.push_back({path, {}});
  for_each_index(files.size(), [&](std::size_t i) { files[i].text = texts[i](); });
  return files;
}

}  // namespace robcogen::backend::c
