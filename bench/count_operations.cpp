// Keeps operation counts from rising.
//
//     count_operations check  <file> <generator> <groups> <further groups> <robot>=<document>[@<contacts>] …
//     count_operations update <file> <generator> <groups> <further groups> <robot>=<document>[@<contacts>] …
//
// `check` counts the functions of these robots again and compares with the file. Exit status 1, with a line for each
// change: numbers rose, or functions are gone; 77: none of this, but numbers fell or functions are new. `update` writes
// the file. `groups` are the groups of functions, separated by commas; further groups are counted for the robots that
// have them, functions of contacts for those with contact frames, and fused functions of the list next to a document.
// Exit status 2: usage, input or output.
#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

#include "counts.h"
#include "machine.h"

namespace robcogen::bench {
namespace {

constexpr int kWorse = 1, kWrong = 2, kOther = 77;
constexpr char kContactsFollow = '@';

struct Robot {
  std::string name, document, contacts;
};

struct Arguments {
  bool update = false;
  std::string file, generator, groups, further_groups;
  std::vector<Robot> robots;
};

Arguments read_arguments(const std::vector<std::string>& words) {
  const std::string usage =
      "usage: count_operations check|update <file> <generator> <groups> <further groups> "
      "<robot>=<document>[@<contacts>] ...";
  if (words.size() < 6 || (words[0] != "check" && words[0] != "update")) throw std::runtime_error(usage);
  Arguments arguments = {words[0] == "update", words[1], words[2], words[3], words[4], {}};
  for (std::size_t i = 5; i < words.size(); ++i) {
    // A folder may have the sign in its name.
    const std::size_t equals = words[i].find('='), folder = words[i].rfind('/');
    const std::size_t sign = words[i].find(kContactsFollow, folder == std::string::npos ? 0 : folder);
    if (equals == std::string::npos) throw std::runtime_error(usage);
    const bool has_contacts = sign != std::string::npos;
    arguments.robots.push_back(
        {words[i].substr(0, equals), words[i].substr(equals + 1, has_contacts ? sign - equals - 1 : sign),
         has_contacts ? words[i].substr(sign + 1) : ""});
  }
  return arguments;
}

std::vector<std::string> split(const std::string& list) {
  std::vector<std::string> parts;
  std::istringstream stream(list);
  for (std::string part; std::getline(stream, part, ',');) parts.push_back(part);
  return parts;
}

bool has(const std::vector<Counted>& functions, const std::string& name) {
  return std::any_of(functions.begin(), functions.end(), [&](const Counted& f) { return f.first == name; });
}

Counts count(const Arguments& arguments) {
  Counts counts;
  for (const auto& [robot, document, contacts] : arguments.robots) {
    const std::string generator = quoted(arguments.generator), model = quoted(document);
    const auto command_of = [&](const std::string& groups, const std::string& options = "") {
      return fmt::format("{} ops --json{} --algorithms {} -- {}", generator, options, quoted(groups), model);
    };
    const std::optional<std::string> output = output_of(command_of(arguments.groups));
    if (!output) throw std::runtime_error(command_of(arguments.groups) + " failed");
    std::vector<Counted>& functions = counts[robot];
    functions = read_operations(*output);
    // Messages about groups that this robot lacks are not shown. Functions that are in all outputs, such as the update
    // of parameters, are taken from the first one.
    const auto add = [&](const std::string& command) {
      if (const auto further = output_of(command + " 2>/dev/null"))
        for (Counted& counted : read_operations(*further))
          if (!has(functions, counted.first)) functions.push_back(std::move(counted));
    };
    for (const std::string& group : split(arguments.further_groups)) add(command_of(group));
    const std::filesystem::path list = std::filesystem::path(document).replace_extension("dtdsl");
    if (std::filesystem::exists(list)) add(command_of("fused", " --desired " + quoted(list.string())));
    if (!contacts.empty())
      add(command_of(
          "contacts,constrained_forward_dynamics_derivatives,operational_space", " --contacts " + quoted(contacts)));
  }
  return counts;
}

Counts read(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  if (!file) throw std::runtime_error("cannot read " + path);
  return read_counts({std::istreambuf_iterator<char>(file), {}});
}

// The counts of robots whose models are not given are kept.
int update(const Arguments& arguments) {
  Counts counts = read(arguments.file);
  for (auto& [robot, functions] : count(arguments)) counts[robot] = std::move(functions);
  std::ofstream file(arguments.file, std::ios::binary);
  file << counts_text(counts);
  file.close();
  if (!file) throw std::runtime_error("cannot write " + arguments.file);
  fmt::print("written: {}\n", arguments.file);
  return 0;
}

int check(const Arguments& arguments) {
  Counts before = read(arguments.file);
  Changes all;
  for (const auto& [robot, functions] : count(arguments)) {
    const Changes found = changes(robot, before[robot], functions);
    all.worse.insert(all.worse.end(), found.worse.begin(), found.worse.end());
    all.other.insert(all.other.end(), found.other.begin(), found.other.end());
  }
  constexpr const char* kHow = "run cmake --build <build folder> --target update_counts, and commit bench/counts.json.";
  if (!all.worse.empty()) {
    fmt::print("{}\nOperation counts rose. Where that is meant, {}\n", fmt::join(all.worse, "\n"), kHow);
    return kWorse;
  }
  if (!all.other.empty()) {
    fmt::print("{}\nOperation counts fell, or are new. To keep them so, {}\n", fmt::join(all.other, "\n"), kHow);
    return kOther;
  }
  return 0;
}

}  // namespace
}  // namespace robcogen::bench

int main(int argc, char** argv) {
  try {
    const auto arguments = robcogen::bench::read_arguments({argv + 1, argv + argc});
    return arguments.update ? robcogen::bench::update(arguments) : robcogen::bench::check(arguments);
  } catch (const std::exception& e) {
    fmt::print(stderr, "count_operations: {}\n", e.what());
    return robcogen::bench::kWrong;
  }
}
