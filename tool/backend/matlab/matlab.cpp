#include "backend/matlab/matlab.h"

#include <algorithm>
#include <map>
#include <set>

#include "backend/matlab/dialect.h"
#include "backend/matlab/printers.h"

namespace robcogen::backend::matlab {
namespace {

// The longest name that MATLAB tells from others.
constexpr std::size_t kLongestName = 63;

// Names of one package. Files of names that differ by case alone would be one file on some systems.
struct PackageNames {
  NameScope names = NameScope(is_reserved);
  std::set<std::string> lower;

  std::string claim(const std::string& wanted) {
    while (true) {
      std::string name = names.claim(shortened(wanted, kLongestName - 3, is_reserved));
      std::string key = name;
      for (char& c : key)
        if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
      if (lower.insert(key).second) return name;
    }
  }
};

std::vector<Callable> callables(const Library& library) {
  std::vector<Callable> result;
  std::map<std::pair<std::string, std::string>, std::size_t> known;
  std::map<std::string, PackageNames> packages;
  for (const std::string name : {"contents", "model", "parameters"}) packages[""].claim(name);
  for (const Function& f : library.functions) {
    const auto [place, is_new] = known.insert({{f.scope, f.name}, result.size()});
    if (is_new) result.push_back({f.scope, packages[f.scope].claim(f.name), {}});
    result[place->second].overloads.push_back(&f);
  }
  for (Callable& callable : result) {
    std::stable_sort(callable.overloads.begin(), callable.overloads.end(), [](const Function* a, const Function* b) {
      return a->program.inputs.size() < b->program.inputs.size();
    });
  }
  return result;
}

// `+a/+hyl/`, scopes below it.
std::string package(const Library& library, const std::string& scope) {
  std::string path;
  for (const std::string& names : {library.enclosing, library.name, scope}) {
    std::string rest = names;
    while (!rest.empty()) {
      const std::size_t end = std::min(rest.find("::"), rest.size());
      path += "+" + identifier(rest.substr(0, end), is_reserved) + "/";
      rest.erase(0, std::min(end + 2, rest.size()));
    }
  }
  return path;
}

}  // namespace

std::vector<OutputFile> print(const Library& library) {
  const std::vector<Callable> all = callables(library);
  const std::string top = package(library, "");
  std::vector<OutputFile> files = {{top + "Contents.m", print_contents(library, all)}};
  if (library.has_robot()) files.push_back({top + "model.m", print_model(library)});
  if (!library.parameters.empty()) files.push_back({top + "parameters.m", print_parameters(library)});
  for (const Callable& callable : all)
    files.push_back({package(library, callable.scope) + callable.name + ".m", print_function(library, callable)});
  if (library.primitives == PrimitiveConvention::none) return files;
  for (const Callable& callable : all)
    if (callable.scope == "transforms::homogeneous")
      files.push_back(
          {package(library, "transforms::product") + callable.name + ".m", print_product(library, callable)});
  return files;
}

}  // namespace robcogen::backend::matlab
