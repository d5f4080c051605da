#include "backend/common/overloads.h"

#include <algorithm>
#include <map>

#include "backend/common/columns.h"

namespace robcogen::backend {

std::vector<OverloadedFunction> overloaded_functions(const Library& library) {
  std::vector<OverloadedFunction> result;
  std::map<std::pair<std::string, std::string>, std::size_t> known;
  for (const Function& f : library.functions) {
    const auto [place, is_new] = known.insert({{f.scope, f.name}, result.size()});
    if (is_new) result.push_back({f.scope, f.name, {}});
    result[place->second].overloads.push_back(&f);
  }
  for (OverloadedFunction& overloaded : result) {
    std::stable_sort(
        overloaded.overloads.begin(), overloaded.overloads.end(),
        [](const Function* a, const Function* b) { return a->program.inputs.size() < b->program.inputs.size(); });
  }
  return result;
}

std::vector<std::string> scopes(const std::vector<OverloadedFunction>& functions) {
  std::vector<std::string> known;
  for (const OverloadedFunction& overloaded : functions) {
    for (std::size_t end = 0; end < overloaded.scope.size();) {
      end = std::min(overloaded.scope.find('.', end + 1), overloaded.scope.size());
      const std::string scope = overloaded.scope.substr(0, end);
      if (std::find(known.begin(), known.end(), scope) == known.end()) known.push_back(scope);
    }
  }
  return known;
}

std::size_t required_inputs(const Library& library, const OverloadedFunction& overloaded) {
  const std::vector<symbolic::InputArray>& inputs = overloaded.overloads.front()->program.inputs;
  const bool has_default =
      !library.tree.floating_base && !inputs.empty() && inputs.back().role == symbolic::Role::gravity;
  return inputs.size() - (has_default ? 1 : 0);
}

std::vector<std::string> summary(const OverloadedFunction& overloaded) {
  std::vector<std::string> lines = overloaded.overloads.front()->summary;
  for (const Function* f : overloaded.overloads)
    std::erase_if(lines, [&](const std::string& line) {
      return std::find(f->summary.begin(), f->summary.end(), line) == f->summary.end();
    });
  if (const std::string& method = overloaded.overloads.front()->method; !method.empty()) lines.push_back(method);
  return lines;
}

std::string describe_operations(const Library& library, const Function& function) {
  const symbolic::Cost c = count(library, function);
  return "Operations: " + std::to_string(c.mul) + " multiplications, " + std::to_string(c.add) + " additions, " +
         std::to_string(c.div) + " divisions, " + (c.sqrt ? std::to_string(c.sqrt) + " square roots, " : "") +
         std::to_string(c.sincos) + " sine and cosine pairs.";
}

}  // namespace robcogen::backend
