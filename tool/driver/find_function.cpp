#include "driver/find_function.h"

#include <fmt/format.h>

#include <utility>

#include "algorithm/catalogue/find.h"
#include "algorithm/catalogue/fused.h"
#include "driver/failure.h"

namespace robcogen::driver {

using algorithm::Declared;

std::vector<Declared> find_functions(const Robot& robot, const std::string& name) {
  for (std::vector<Declared>& function : algorithm::fused_functions(robot.tree, robot.desired))
    if (function.front().name == name) return std::move(function);
  return algorithm::find_function(robot.tree, robot.desired, name);
}

std::vector<std::string> function_names(const Robot& robot) {
  std::vector<std::string> names;
  for (const std::string& group : algorithm::groups())
    for (const Declared& f : algorithm::declared(robot.tree, robot.desired, group))
      names.push_back(dotted(f.is->scope, f.name));
  return names;
}

void refuse_function(
    const std::string& owner,
    const std::filesystem::path& model,
    const std::string& name,
    const std::vector<std::string>& names) {
  const std::string guess = did_you_mean(name, names);
  throw Failure{
      wrong_usage, with_hint(
                       fmt::format("robcogen: error: {} has no function '{}' [unknown-function]", owner, name),
                       guess.empty() ? fmt::format("'robcogen ops {}' lists them", model.string()) : guess)};
}

}  // namespace robcogen::driver
