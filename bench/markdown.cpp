#include "markdown.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>

#include "comparison.h"

namespace robcogen::bench {

namespace {

std::string number(std::optional<double> value, int digits) {
  return value ? fmt::format("{:.{}f}", *value, digits) : "-";
}

std::optional<double> median_of(const std::optional<Time>& time) {
  return time ? std::optional(time->median) : std::nullopt;
}

std::string count(const Function& function, const std::string& what) {
  const auto found = function.counts.find(what);
  return found == function.counts.end() ? "0" : std::to_string(found->second);
}

// The name and degrees of freedom (`6 + 12` with a floating base), in the first row of a robot only.
std::string robot_cell(const Results& results, bool is_first) {
  return is_first ? fmt::format("{}, {}{}", results.robot, results.floating_base ? "6 + " : "", results.joints) : "";
}

std::string own_row(const Results& results, const Comparison& comparison, bool is_first) {
  const auto f = std::find_if(results.functions.begin(), results.functions.end(), [&](const Function& function) {
    return function.name == comparison.function;
  });
  const std::optional<double> bound = least_cycles(*f), measured = cycles(results, *f);
  const auto bytes = results.bytes.find(f->kernel);
  return fmt::format(
      "| {} | {} | {} | {} | {} | {} / {} / {} | {} | {} | {} | {} | {} | {} |\n", robot_cell(results, is_first),
      title(comparison.quantity), number(f->time.median, 1), number(median_of(f->given_trig), 1),
      number(median_of(f->batch), 1), count(*f, "mul"), count(*f, "add"), count(*f, "div"), count(*f, "instructions"),
      count(*f, "critical_path"), number(bound, 0),
      bound && measured && *bound > 0 ? number(*measured / *bound, 2) : "-",
      bytes == results.bytes.end() ? "-" : std::to_string(bytes->second),
      is_first ? number(results.compile_seconds, 1) : "");
}

std::string ratio_row(const std::vector<std::string>& peers, const std::string& robot, const Comparison& comparison) {
  std::string row = fmt::format("| {} | {} | {:.1f} |", robot, title(comparison.quantity), comparison.time.median);
  for (const std::string& peer : peers) {
    const auto ratio =
        std::find_if(comparison.peers.begin(), comparison.peers.end(), [&](const Ratio& r) { return r.peer == peer; });
    row += ratio == comparison.peers.end() ? " - |" : fmt::format(" {:.1f} |", ratio->ratio);
  }
  return row + "\n";
}

}  // namespace

std::string markdown(const std::vector<Results>& robots) {
  std::string own =
      "| robot, DoF | | ns | given trig | batch | mul / add / div | instr | path | bound | ratio | bytes | compiled, s "
      "|\n"
      "| --- | --- | --- | --- | --- | --- | --- | --- | --- | --- | --- | --- |\n";
  const std::vector<std::string> peers = all_peers(robots);
  std::string ratios = "| robot, DoF | | ns |", line = "| --- | --- | --- |";
  for (const std::string& peer : peers) {
    ratios += fmt::format(" {} |", peer);
    line += " --- |";
  }
  ratios += "\n" + line + "\n";
  for (const Results& results : robots) {
    bool is_first = true;
    for (const Comparison& comparison : comparisons(results)) {
      own += own_row(results, comparison, is_first);
      ratios += ratio_row(peers, robot_cell(results, is_first), comparison);
      is_first = false;
    }
  }
  return own + "\n" + ratios;
}

}  // namespace robcogen::bench
