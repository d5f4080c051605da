#include "counts.h"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <stdexcept>

namespace robcogen::bench {

const std::vector<std::string> kCounted = {"mul", "add", "div", "sqrt", "sincos", "instructions", "critical_path"};

namespace {

const std::vector<long>* find(const std::vector<Counted>& functions, const std::string& name) {
  const auto found =
      std::find_if(functions.begin(), functions.end(), [&](const Counted& f) { return f.first == name; });
  return found == functions.end() ? nullptr : &found->second;
}

}  // namespace

std::vector<Counted> read_operations(const std::string& json) {
  const nlohmann::json report = nlohmann::json::parse(json);
  std::vector<Counted> functions;
  for (const nlohmann::json& f : report.at("functions")) {
    std::vector<long> numbers;
    for (const std::string& what : kCounted) numbers.push_back(f.at(what).get<long>());
    functions.emplace_back(f.at("name").get<std::string>(), numbers);
  }
  return functions;
}

std::string counts_text(const Counts& counts) {
  std::string robots;
  for (const auto& [robot, functions] : counts) {
    std::string lines;
    for (const auto& [name, numbers] : functions) {
      lines += fmt::format(
          "{}      {}: [{}]", lines.empty() ? "" : ",\n", nlohmann::json(name).dump(), fmt::join(numbers, ", "));
    }
    robots += fmt::format("{}    {}: {{\n{}\n    }}", robots.empty() ? "" : ",\n", nlohmann::json(robot).dump(), lines);
  }
  return fmt::format(
      "{{\n  \"columns\": {},\n  \"robots\": {{\n{}\n  }}\n}}\n", nlohmann::json(kCounted).dump(), robots);
}

Counts read_counts(const std::string& text) {
  const nlohmann::ordered_json file = nlohmann::ordered_json::parse(text);
  if (file.at("columns").get<std::vector<std::string>>() != kCounted)
    throw std::runtime_error(fmt::format("the columns are not {}", fmt::join(kCounted, ", ")));
  Counts counts;
  for (const auto& [robot, functions] : file.at("robots").items()) {
    for (const auto& [name, numbers] : functions.items()) {
      counts[robot].emplace_back(name, numbers.get<std::vector<long>>());
      if (counts[robot].back().second.size() != kCounted.size())
        throw std::runtime_error(fmt::format("{}, {}: not a number for each column", robot, name));
    }
  }
  return counts;
}

Changes changes(const std::string& robot, const std::vector<Counted>& before, const std::vector<Counted>& now) {
  Changes result;
  for (const auto& [name, numbers] : now) {
    const std::vector<long>* old = find(before, name);
    if (old == nullptr) result.other.push_back(fmt::format("{}, {}: new", robot, name));
    for (std::size_t i = 0; old != nullptr && i < numbers.size(); ++i) {
      if (numbers[i] == (*old)[i]) continue;
      (numbers[i] > (*old)[i] ? result.worse : result.other)
          .push_back(fmt::format("{}, {}: {} {} -> {}", robot, name, kCounted[i], (*old)[i], numbers[i]));
    }
  }
  for (const auto& [name, numbers] : before) {
    if (find(now, name) == nullptr) result.worse.push_back(fmt::format("{}, {}: gone", robot, name));
  }
  return result;
}

}  // namespace robcogen::bench
