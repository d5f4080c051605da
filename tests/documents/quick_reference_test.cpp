// runtime/QUICK.md lists the functions of the catalogue.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <map>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "algorithm/catalogue/catalogue.h"
#include "driver/load.h"
#include "markdown.h"

namespace robcogen::test::quick_reference_test {
namespace {

using algorithm::Declaration;
using algorithm::Declared;

// A robot of this project, with three contacts.
driver::Robot robot(const std::string& name) {
  const std::filesystem::path folder = source_folder() / "robots" / name;
  driver::LoadOptions options;
  options.desired = folder / (name + ".dtdsl");
  Diagnostics diagnostics;
  const std::optional<driver::Model> model = driver::load(folder / (name + ".kindsl"), options, diagnostics);
  if (!model) throw std::runtime_error(diagnostics.render());
  driver::Robot result = *model->robot();
  result.desired.contacts.clear();
  const auto frames = result.tree.frames();
  for (auto frame = frames.rbegin(); frame != frames.rend() && result.desired.contacts.size() < 3; ++frame)
    result.desired.contacts.push_back({*frame, false});
  return result;
}

// The functions of a group that the robot has, which take a while to find.
const std::vector<Declared>& functions_of(const std::string& group, const driver::Robot& robot) {
  static std::map<std::pair<std::string, const driver::Robot*>, std::vector<Declared>> known;
  const auto [place, is_new] = known.try_emplace({group, &robot});
  if (is_new) place->second = algorithm::declared(robot.tree, robot.desired, group);
  return place->second;
}

// The function of this row that has the most inputs.
std::optional<Declared> function_of(const Declaration& row, const driver::Robot& robot) {
  std::optional<Declared> result;
  for (const Declared& function : functions_of(row.group, robot))
    if (function.is == &row && (!result || result->name == function.name)) result.emplace(function);
  return result;
}

// What a number is that robots have: the first count that all of them agree with; empty if there is none.
std::string size(const std::vector<const driver::Robot*>& robots, const std::vector<int>& numbers) {
  using Count = std::pair<const char*, int (*)(const driver::Robot&)>;
  static const std::vector<Count> counts = {
      {"1", [](const driver::Robot&) { return 1; }},
      {"2", [](const driver::Robot&) { return 2; }},
      {"3", [](const driver::Robot&) { return 3; }},
      {"4", [](const driver::Robot&) { return 4; }},
      {"6", [](const driver::Robot&) { return 6; }},
      {"7", [](const driver::Robot&) { return 7; }},
      {"n", [](const driver::Robot& r) { return r.tree.dof(); }},
      {"(6 + n)", [](const driver::Robot& r) { return 6 + r.tree.dof(); }},
      {"joints", [](const driver::Robot& r) { return static_cast<int>(r.tree.joints.size()); }},
      {"c", [](const driver::Robot& r) { return 3 * static_cast<int>(r.desired.contacts.size()); }},
      {"(n + c)",
       [](const driver::Robot& r) { return r.tree.dof() + 3 * static_cast<int>(r.desired.contacts.size()); }},
      {"(6 + n + c)",
       [](const driver::Robot& r) { return 6 + r.tree.dof() + 3 * static_cast<int>(r.desired.contacts.size()); }},
      {"10 L", [](const driver::Robot& r) {
         return 10 * (static_cast<int>(r.tree.links.size()) - (r.tree.floating_base ? 0 : 1));
       }}};
  for (const auto& [name, count] : counts) {
    bool fits = true;
    for (std::size_t k = 0; k < robots.size(); ++k) fits = fits && count(*robots[k]) == numbers[k];
    if (fits) return name;
  }
  return "…";
}

std::string replaced(std::string text, const std::string& what, const std::string& by) {
  if (what.empty()) return text;
  for (std::size_t at = text.find(what); at != std::string::npos; at = text.find(what, at + by.size()))
    text.replace(at, what.size(), by);
  return text;
}

// `n x n`, or `n` of a vector; nothing of a single number.
std::string shape(
    const std::vector<const driver::Robot*>& robots,
    const std::vector<symbolic::Program>& outlines,
    std::size_t k) {
  std::vector<int> rows, columns;
  for (const symbolic::Program& outline : outlines) {
    rows.push_back(outline.outputs[k].rows);
    columns.push_back(outline.outputs[k].columns);
  }
  const bool is_chain = symbolic::is_jacobian(outlines.front().outputs[k].role);
  const std::string height = size(robots, rows), width = is_chain ? "k" : size(robots, columns);
  const bool is_single = width == "1" && height == "1";
  const std::string text = is_single ? "" : width == "1" ? " " + height : " " + height + " x " + width;
  return width == "1" ? replaced(replaced(text, "(", ""), ")", "") : text;
}

std::string table_row(const Declaration& row, const std::vector<const driver::Robot*>& robots) {
  std::vector<symbolic::Program> outlines;
  for (const driver::Robot* robot : robots) outlines.push_back(algorithm::outline(*function_of(row, *robot)));
  const Declared function = *function_of(row, *robots.front());
  const bool has_overloads = row.signature.overloads != algorithm::Overloads::none;
  std::string arguments;
  for (const symbolic::InputArray& input : outlines.front().inputs) {
    const bool is_optional = (input.role == symbolic::Role::gravity && !function.subject.tree.floating_base) ||
                             input.role == symbolic::Role::link_wrenches;
    const std::string text = (arguments.empty() ? "" : ", ") + input.name;
    arguments += has_overloads && is_optional ? "[" + text + "]" : text;
  }
  std::string results;
  for (std::size_t k = 0; k < outlines.front().outputs.size(); ++k)
    results += (k == 0 ? "" : ", ") + outlines.front().outputs[k].name + shape(robots, outlines, k);
  std::string name = row.scope[0] == '\0' ? row.name : std::string(row.scope) + "::" + row.name;
  name = replaced(replaced(name, "{A}", "A"), "{B}", "B");
  std::string summary = algorithm::described(function).summary.front();
  summary =
      replaced(replaced(summary, function.subject.frames.right.name, "B"), function.subject.frames.left.name, "A");
  summary.resize(
      std::min({summary.find(": "), summary.find(" ("), summary.find("; "), summary.find(". "), summary.size()}));
  if (!summary.empty() && summary.back() == '.') summary.pop_back();
  return "| `" + name + "(" + arguments + ")` | " + results + " | " + summary + " |\n";
}

std::string table(const std::vector<driver::Robot>& robots, std::vector<const Declaration*>& seen) {
  std::string text, group;
  for (const Declaration& row : algorithm::declarations()) {
    std::vector<const driver::Robot*> with;
    for (const driver::Robot& robot : robots)
      if (function_of(row, robot)) with.push_back(&robot);
    if (with.empty() || std::find(seen.begin(), seen.end(), &row) != seen.end()) continue;
    if (row.group != group) text += "| **" + (group = row.group) + "** | | |\n";
    text += table_row(row, with);
  }
  for (const Declaration& row : algorithm::declarations())
    for (const driver::Robot& robot : robots)
      if (function_of(row, robot)) seen.push_back(&row);
  return "| call | results | what |\n| --- | --- | --- |\n" + text;
}

TEST(Listing, TheQuickReferenceIsThatOfTheCatalogue) {
  const std::vector<driver::Robot> fixed = {robot("hyl"), robot("puma560"), robot("iiwa14")};
  const std::vector<driver::Robot> floating = {robot("quadruped"), robot("humanoid")};
  const std::vector<driver::Robot> mechanisms = {robot("five_bar"), robot("gripper"), robot("ankle")};
  std::vector<const Declaration*> seen, of_floating;
  std::vector<std::string> tables = {table(fixed, seen), table(floating, of_floating)};
  seen.insert(seen.end(), of_floating.begin(), of_floating.end());
  tables.push_back(table(mechanisms, seen));

  const std::filesystem::path path = source_folder() / "runtime" / "QUICK.md";
  const std::string page = read_text(path);
  const std::string mark = "<!-- Printed from the catalogue. The target update_documents writes it anew. -->\n";
  std::string wanted;
  std::size_t end = 0;
  for (const std::string& printed : tables) {
    const std::size_t begin = page.find(mark, end);
    ASSERT_NE(begin, std::string::npos) << "runtime/QUICK.md has not three marks";
    wanted += page.substr(end, begin - end) + mark + printed;
    end = page.find("\n\n", begin + mark.size());
    end = end == std::string::npos ? page.size() : end + 1;
  }
  wanted += page.substr(end);
  if (std::getenv("ROBCOGEN_UPDATE_DOCUMENTS")) {
    std::ofstream(path, std::ios::binary) << wanted;
    return;
  }
  EXPECT_EQ(page, wanted) << "runtime/QUICK.md is not what the catalogue says: build the target update_documents, look "
                             "at the difference, and commit it";
}

}  // namespace
}  // namespace robcogen::test::quick_reference_test
