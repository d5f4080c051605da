#include "backend/common/overloads.h"

#include <algorithm>
#include <map>

#include "backend/common/columns.h"

namespace robcogen::backend {

std::vector<Callable> callables(const Library& library) {
  std::vector<Callable> result;
  std::map<std::pair<std::string, std::string>, std::size_t> known;
  for (const Function& f : library.functions) {
    const auto [place, is_new] = known.insert({{f.scope, f.name}, result.size()});
    if (is_new) result.push_back({f.scope, f.name, {}});
    result[place->second].overloads.push_back(&f);
  }
  for (Callable& callable : result) {
    std::stable_sort(callable.overloads.begin(), callable.overloads.end(), [](const Function* a, const Function* b) {
      return a->program.inputs.size() < b->program.inputs.size();
    });
  }
  return result;
}

std::vector<std::string> scopes(const std::vector<Callable>& callables) {
  std::vector<std::string> known;
  for (const Callable& callable : callables) {
    for (std::size_t end = 0; end < callable.scope.size();) {
      end = std::min(callable.scope.find('.', end + 1), callable.scope.size());
      const std::string scope = callable.scope.substr(0, end);
      if (std::find(known.begin(), known.end(), scope) == known.end()) known.push_back(scope);
    }
  }
  return known;
}

std::size_t required_inputs(const Library& library, const Callable& callable) {
  const std::vector<symbolic::InputArray>& inputs = callable.overloads.front()->program.inputs;
  const bool has_default = !library.floating_base && !inputs.empty() && inputs.back().role == symbolic::Role::gravity;
  return inputs.size() - (has_default ? 1 : 0);
}

std::vector<std::string> summary(const Callable& callable) {
  std::vector<std::string> lines = callable.overloads.front()->summary;
  for (const Function* f : callable.overloads)
    std::erase_if(lines, [&](const std::string& line) {
      return std::find(f->summary.begin(), f->summary.end(), line) == f->summary.end();
    });
  if (const std::string& method = callable.overloads.front()->method; !method.empty()) lines.push_back(method);
  return lines;
}

std::string describe_operations(const Library& library, const Function& function) {
  const symbolic::Cost c = count(library, function);
  return "Operations: " + std::to_string(c.mul) + " multiplications, " + std::to_string(c.add) + " additions, " +
         std::to_string(c.div) + " divisions, " + (c.sqrt ? std::to_string(c.sqrt) + " square roots, " : "") +
         std::to_string(c.sincos) + " sine and cosine pairs.";
}

}  // namespace robcogen::backend
