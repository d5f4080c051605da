#include "page.h"

#include <fmt/format.h>

#include <algorithm>
#include <sstream>
#include <stdexcept>

#include "comparison.h"

namespace robcogen::bench {

namespace {

using Row = std::vector<std::string>;

// The cells of a line `| a | b |`; empty for any other line.
Row cells(const std::string& line) {
  Row row;
  if (line.empty() || line[0] != '|') return row;
  for (std::size_t at = 1, end; (end = line.find('|', at)) != std::string::npos; at = end + 1) {
    const std::size_t first = line.find_first_not_of(' ', at), last = line.find_last_not_of(' ', end - 1);
    row.push_back(first < end ? line.substr(first, last - first + 1) : "");
  }
  return row;
}

bool is_comparison_head(const Row& row) {
  return row.size() > 3 && row[0] == "robot, DoF" && row[1].empty() && row[2] == "ns" && row[3] != "given trig";
}

double number(const std::string& cell) {
  std::size_t end = 0;
  double value = 0;
  try {
    value = std::stod(cell, &end);
  } catch (const std::logic_error&) {
  }
  if (end != cell.size() || value <= 0) throw std::runtime_error(fmt::format("'{}' is not a positive number", cell));
  return value;
}

// Reads a cell such as `Quadruped, 6 + 12` or `Iiwa14, 7`.
Results robot(const std::string& cell) {
  const std::size_t comma = cell.rfind(", "), plus = cell.rfind("6 + ");
  if (comma == std::string::npos) throw std::runtime_error(fmt::format("'{}' has no degrees of freedom", cell));
  Results results;
  results.robot = cell.substr(0, comma);
  results.floating_base = plus != std::string::npos && plus > comma;
  results.joints = static_cast<int>(number(cell.substr(results.floating_base ? plus + 4 : comma + 2)));
  return results;
}

std::string quantity_of(const std::string& cell) {
  const auto found = std::find_if(
      kQuantities.begin(), kQuantities.end(), [&](const std::string& quantity) { return title(quantity) == cell; });
  if (found == kQuantities.end()) throw std::runtime_error(fmt::format("'{}' is not a quantity", cell));
  return *found;
}

void add(const Row& head, const Row& row, Results& results) {
  if (row.size() != head.size()) throw std::runtime_error(fmt::format("a row of {} cells", row.size()));
  const std::string quantity = quantity_of(row[1]);
  const double own = number(row[2]);
  results.functions.push_back({quantity, quantity, {own, own, own}, {}});
  results.compared[quantity] = quantity;
  for (std::size_t i = 3; i < row.size(); ++i) {
    if (row[i] == "-") continue;
    const double time = own * number(row[i]);
    results.peer_times.push_back({head[i], quantity, {time, time, time}});
  }
}

// Adds a cell such as `13.0 (8.0; 2.6)`.
void add(const std::string& quantity, const std::string& cell, Results& results) {
  std::string ratios = cell;
  std::replace_if(
      ratios.begin(), ratios.end(), [](char c) { return c == '(' || c == ')' || c == ';'; }, ' ');
  std::istringstream numbers(ratios);
  std::string text;
  numbers >> text;
  const double own = number(text);
  results.functions.push_back({quantity, quantity, {own, own, own}, {}});
  results.compared[quantity] = quantity;
  for (const std::string& peer : results.peers) {
    if (!(numbers >> text)) throw std::runtime_error(fmt::format("'{}' has too few ratios", cell));
    const double time = own * number(text);
    results.peer_times.push_back({peer, quantity, {time, time, time}});
  }
}

}  // namespace

std::vector<Results> read_generators(const std::string& page, const std::vector<std::string>& peers) {
  std::vector<Results> robots;
  std::istringstream lines(page);
  std::string line;
  Row head;
  while (std::getline(lines, line)) {
    const Row row = cells(line);
    if (head.empty() && row.size() > 1 && row[0] == "robot, DoF" && row[1] == title("inverse_dynamics")) {
      head = row;
      std::getline(lines, line);  // of dashes
    } else if (!head.empty()) {
      if (row.size() != head.size() || row[0] == "geometric mean") break;
      robots.push_back(robot(row[0]));
      robots.back().peers = peers;
      for (std::size_t i = 1; i < row.size(); ++i) add(quantity_of(head[i]), row[i], robots.back());
    }
  }
  if (robots.empty()) throw std::runtime_error("no table 'robot, DoF | inverse dynamics | …' of times and ratios");
  return robots;
}

std::vector<Results> read_page(const std::string& page) {
  std::vector<Results> robots;
  std::istringstream lines(page);
  std::string line;
  Row head;
  while (std::getline(lines, line)) {
    const Row row = cells(line);
    if (is_comparison_head(row)) {
      head = row;
      robots.clear();
      std::getline(lines, line);  // of dashes
    } else if (row.empty()) {
      if (!robots.empty()) head.clear();
    } else if (!head.empty()) {
      if (!row[0].empty()) {
        robots.push_back(robot(row[0]));
        robots.back().peers.assign(head.begin() + 3, head.end());
      }
      if (robots.empty()) throw std::runtime_error("a row without a robot");
      add(head, row, robots.back());
    }
  }
  if (robots.empty()) throw std::runtime_error("no table 'robot, DoF | | ns | …' of times and ratios");
  std::erase_if(robots, [](const Results& results) { return results.peer_times.empty(); });
  return robots;
}

}  // namespace robcogen::bench
