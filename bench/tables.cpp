#include "tables.h"

#include <fmt/format.h>

#include <algorithm>

#include "comparison.h"

namespace robcogen::bench {

namespace {

// The names and widths of the columns of kCounts.
struct Column {
  const char* title;
  int width;
};
const std::vector<Column> kColumns = {{"mul", 6},    {"add", 6},   {"div", 4}, {"sqrt", 5},
                                      {"sincos", 7}, {"instr", 6}, {"path", 5}};

const std::string kNone = "-";

std::string number(std::optional<double> value, int digits) {
  return value ? fmt::format("{:.{}f}", *value, digits) : kNone;
}

std::string median_of(const std::optional<Time>& time) {
  return time ? number(time->median, 1) : kNone;
}

std::string peer_heading(const std::vector<std::string>& peers) {
  std::string line = fmt::format("{:<22} {:<18} {:>10}", "robot, DoF", "quantity", "RobCoGen");
  for (const std::string& peer : peers) line += fmt::format(" {:>18}", peer);
  return line + "\n";
}

std::string cell(const std::vector<Ratio>& ratios, const std::string& peer) {
  for (const Ratio& r : ratios) {
    if (r.peer == peer) return fmt::format(" {:>9.1f} {:>7.1f}x", r.time.median, r.ratio);
  }
  return fmt::format(" {:>18}", "-");
}

std::string compared_rows(const Results& results, const std::vector<std::string>& peers) {
  std::string rows;
  for (const Comparison& comparison : comparisons(results)) {
    const std::string robot =
        rows.empty() ? fmt::format("{}, {}", results.robot, degrees_of_freedom(results)) : std::string();
    rows += fmt::format("{:<22} {:<18} {:>10.1f}", robot, title(comparison.quantity), comparison.time.median);
    for (const std::string& peer : peers) rows += cell(comparison.peers, peer);
    rows += "\n";
  }
  return rows;
}

std::string mean_rows(const std::vector<Mean>& means, const std::vector<std::string>& peers) {
  std::string rows;
  for (const std::string& quantity : kQuantities) {
    std::string row = fmt::format(
        "{:<22} {:<18} {:>10}", rows.empty() ? "geometric mean" : "", title(quantity), rows.empty() ? "(robots)" : "");
    bool any = false;
    for (const std::string& peer : peers) {
      const auto mean = std::find_if(
          means.begin(), means.end(), [&](const Mean& m) { return m.peer == peer && m.quantity == quantity; });
      any = any || mean != means.end();
      row += mean == means.end() ? fmt::format(" {:>18}", "-")
                                 : fmt::format(" {:>9} {:>7.1f}x", fmt::format("({})", mean->robots), mean->ratio);
    }
    if (any) rows += row + "\n";
  }
  return rows;
}

// One line for each library and reason, with the robots unless it applies to all of them.
std::string absent_rows(const std::vector<Results>& robots) {
  std::vector<Absence> absences;
  std::vector<std::size_t> counts;
  std::vector<std::string> names;
  for (const Results& results : robots) {
    for (const Absence& absence : results.absent) {
      const auto known = std::find_if(absences.begin(), absences.end(), [&](const Absence& other) {
        return other.library == absence.library && other.reason == absence.reason;
      });
      const auto index = static_cast<std::size_t>(known - absences.begin());
      if (known == absences.end()) {
        absences.push_back(absence);
        counts.push_back(0);
        names.emplace_back();
      }
      names[index] += (counts[index]++ == 0 ? "" : ", ") + results.robot;
    }
  }
  std::string rows;
  for (std::size_t i = 0; i < absences.size(); ++i) {
    rows += fmt::format("not measured: {}: {}", absences[i].library, absences[i].reason);
    if (counts[i] < robots.size()) rows += fmt::format(" ({})", names[i]);
    rows += "\n";
  }
  return rows;
}

}  // namespace

std::string function_heading() {
  std::string line = fmt::format("{:<44} {:>9} {:>10} {:>9}", "function", "ns", "given trig", "batch");
  for (const Column& column : kColumns) line += fmt::format(" {:>{}}", column.title, column.width);
  return line + fmt::format(" {:>6} {:>7} {:>6} {:>7}\n", "bound", "cycles", "ratio", "bytes");
}

std::string function_rows(const Results& results) {
  std::string rows = fmt::format("{}, {} degrees of freedom", results.robot, degrees_of_freedom(results));
  if (results.compile_seconds) rows += fmt::format("; compiled in {:.1f} s", *results.compile_seconds);
  if (results.gigahertz > 0) rows += fmt::format("; {:.2f} GHz", results.gigahertz);
  rows += "\n";
  for (const Function& f : results.functions) {
    rows += fmt::format(
        "  {:<42} {:>9.1f} {:>10} {:>9}", f.name, f.time.median, median_of(f.given_trig), median_of(f.batch));
    for (std::size_t i = 0; i < kCounts.size(); ++i) {
      // A benchmark leaves out zeros; the benchmark of a kernel without counts has no counters.
      const auto count = f.counts.find(kCounts[i]);
      const std::string text = f.counts.empty() ? "-" : std::to_string(count == f.counts.end() ? 0 : count->second);
      rows += fmt::format(" {:>{}}", text, kColumns[i].width);
    }
    const std::optional<double> bound = least_cycles(f), measured = cycles(results, f);
    const auto size = results.bytes.find(f.kernel);
    rows += fmt::format(
        " {:>6} {:>7} {:>6} {:>7}\n", number(bound, 0), number(measured, 0),
        bound && measured && *bound > 0 ? number(*measured / *bound, 2) : kNone,
        size == results.bytes.end() ? kNone : std::to_string(size->second));
  }
  return rows;
}

std::string comparison_table(const std::vector<Results>& robots) {
  const std::vector<std::string> peers = all_peers(robots);
  std::string table;
  if (!peers.empty()) {
    table = peer_heading(peers);
    for (const Results& results : robots) table += compared_rows(results, peers);
    table += mean_rows(geometric_means(robots), peers);
  }
  return table + absent_rows(robots);
}

}  // namespace robcogen::bench
