#include "report_json.h"

#include <nlohmann/json.hpp>

#include "comparison.h"

namespace robcogen::bench {

namespace {

using Json = nlohmann::ordered_json;  // members in the order in which they are written

Json time_json(const Time& time) {
  return {{"median", time.median}, {"min", time.least}, {"max", time.most}};
}

Json machine_json(const Setup& setup, const std::vector<Results>& robots) {
  Json machine;
  machine["processor"] = setup.processor;
  if (!robots.empty()) {
    machine["processors"] = robots.front().processors;
    machine["megahertz"] = robots.front().megahertz;
    machine["frequency_scaling"] = robots.front().frequency_scaling;
  }
  machine["pinned_to_processor"] = setup.pinned_to ? Json(*setup.pinned_to) : Json(nullptr);
  return machine;
}

Json method_json(const Setup& setup, const std::vector<Results>& robots) {
  return {
      {"states", robots.empty() ? 0 : robots.front().states},
      {"repetitions", setup.repetitions},
      {"order", "repetitions of all functions and peers of a robot at random"},
      {"min_time_of_a_repetition_s", setup.min_time}};
}

Json units_json() {
  return {
      {"time", "ns of processor time for one call"},
      {"given_trig", "ns for one call that takes sines and cosines"},
      {"batch", "ns for one state, in calls for many"},
      {"bound_cycles", "the greater of critical path and half the instructions"},
      {"gigahertz", "from a chain of additions, in the same run"},
      {"compile_time", "s of processor time for all sources of the library but those of functions over many states"},
      {"bytes", "compiled kernel"},
      {"counts",
       "operations of one call; instructions: mul and add, fused where one feeds the other; critical_path: "
       "cycles"},
      {"ratio", "median time of the peer / median time of the generated code"}};
}

Json function_json(const Results& results, const Function& function) {
  Json json = {{"name", function.name}, {"kernel", function.kernel}, {"time", time_json(function.time)}};
  if (!function.counts.empty()) {
    for (const std::string& count : kCounts) {
      const auto found = function.counts.find(count);
      json["counts"][count] = found == function.counts.end() ? 0 : found->second;
    }
  }
  if (function.given_trig) json["given_trig"] = time_json(*function.given_trig);
  if (function.batch) json["batch"] = time_json(*function.batch);
  if (const auto bound = least_cycles(function)) json["bound_cycles"] = *bound;
  if (const auto measured = cycles(results, function)) json["cycles_given_trig"] = *measured;
  const auto size = results.bytes.find(function.kernel);
  if (size != results.bytes.end()) json["bytes"] = size->second;
  return json;
}

Json comparison_json(const Comparison& comparison) {
  Json json = {
      {"quantity", comparison.quantity},
      {"function", comparison.function},
      {"time", time_json(comparison.time)},
      {"peers", Json::array()}};
  for (const Ratio& r : comparison.peers) {
    json["peers"].push_back({{"peer", r.peer}, {"time", time_json(r.time)}, {"ratio", r.ratio}});
  }
  return json;
}

Json robot_json(const Results& results) {
  Json json = {{"robot", results.robot}, {"joints", results.joints}, {"floating_base", results.floating_base}};
  if (results.gigahertz > 0) json["gigahertz"] = results.gigahertz;
  if (results.compile_seconds) json["compile_time"] = *results.compile_seconds;
  for (const char* list : {"functions", "comparisons", "absent"}) json[list] = Json::array();
  for (const Function& f : results.functions) json["functions"].push_back(function_json(results, f));
  for (const Comparison& c : comparisons(results)) json["comparisons"].push_back(comparison_json(c));
  for (const Absence& a : results.absent) json["absent"].push_back({{"library", a.library}, {"reason", a.reason}});
  return json;
}

}  // namespace

std::string report_json(const Setup& setup, const std::vector<Results>& robots) {
  Json report = {{"machine", machine_json(setup, robots)}, {"compiler", setup.compiler}, {"flags", setup.flags},
                 {"method", method_json(setup, robots)},   {"units", units_json()},      {"robots", Json::array()},
                 {"geometric_means", Json::array()}};
  for (const Results& results : robots) report["robots"].push_back(robot_json(results));
  for (const Mean& m : geometric_means(robots)) {
    report["geometric_means"].push_back(
        {{"peer", m.peer}, {"quantity", m.quantity}, {"ratio", m.ratio}, {"robots", m.robots}});
  }
  return report.dump(2) + "\n";
}

}  // namespace robcogen::bench
