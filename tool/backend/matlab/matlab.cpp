#include "backend/matlab/matlab.h"

#include <algorithm>
#include <map>
#include <set>

#include "backend/matlab/dialect.h"
#include "backend/matlab/printers.h"

namespace robcogen::backend::matlab {
namespace {

// MATLAB ignores the characters of a name beyond this length.
constexpr std::size_t kLongestName = 63;

// More specific names for functions whose own names are those of built-in functions.
const std::map<std::string, std::string>& renamed() {
  static const std::map<std::string, std::string> names = {{"inverse", "inverse_H"}};
  return names;
}

// The names of one package. Files whose names differ only by case would be one file on some systems.
struct PackageNames {
  NameScope names = NameScope(is_reserved_file);
  std::set<std::string> lower;

  std::string claim(const std::string& wanted) {
    while (true) {
      std::string name = names.claim(shortened(wanted, kLongestName - 3, is_reserved_file));
      std::string key = name;
      for (char& c : key)
        if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
      if (lower.insert(key).second) return name;
    }
  }
};

// The functions under names that are legal in MATLAB.
std::vector<OverloadedFunction> named_functions(const Library& library) {
  std::vector<OverloadedFunction> result = overloaded_functions(library);
  std::map<std::string, PackageNames> taken;
  for (const std::string name : {"contents", "model", "parameters"}) taken[""].claim(name);
  for (OverloadedFunction& overloaded : result) {
    const auto other = overloaded.scope == "inertia_factor" ? renamed().find(overloaded.name) : renamed().end();
    overloaded.name = taken[overloaded.scope].claim(other == renamed().end() ? overloaded.name : other->second);
  }
  return result;
}

// `+a/+hyl/`, followed by the scopes.
std::string package(const Library& library, const std::string& scope) {
  std::string path;
  for (const std::string& name : packages(library, scope)) path += "+" + name + "/";
  return path;
}

}  // namespace

std::vector<std::string> packages(const Library& library, const std::string& scope) {
  std::vector<std::string> result;
  for (const std::string& names : {library.enclosing, library.name, scope}) {
    std::string rest = names;
    while (!rest.empty()) {
      const std::size_t end = std::min(rest.find("::"), rest.size());
      result.push_back(identifier(rest.substr(0, end), is_reserved_file));
      rest.erase(0, std::min(end + 2, rest.size()));
    }
  }
  return result;
}

std::vector<OutputFile> print(const Library& library) {
  const std::vector<OverloadedFunction> all = named_functions(library);
  const std::string top = package(library, "");
  std::vector<OutputFile> files = {{top + "Contents.m", print_contents(library, all)}};
  if (library.has_robot()) files.push_back({top + "model.m", print_model(library)});
  if (!library.parameters().empty()) files.push_back({top + "parameters.m", print_parameters(library)});
  for (const OverloadedFunction& overloaded : all)
    files.push_back({package(library, overloaded.scope) + overloaded.name + ".m", print_function(library, overloaded)});
  if (library.primitives == PrimitiveConvention::none) return files;
  for (const OverloadedFunction& overloaded : all)
    if (overloaded.longest().product)
      files.push_back(
          {package(library, "transforms::product") + overloaded.name + ".m", print_product(library, overloaded)});
  return files;
}

}  // namespace robcogen::backend::matlab
