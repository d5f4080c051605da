#include "comparison.h"

#include <algorithm>
#include <cmath>
#include <iterator>

namespace robcogen::bench {

namespace {

const Function* find_function(const Results& results, const std::string& name) {
  const auto found = std::find_if(
      results.functions.begin(), results.functions.end(), [&](const Function& f) { return f.name == name; });
  return found == results.functions.end() ? nullptr : &*found;
}

ChartPoint point(const Results& results, const Time& time) {
  return {results.robot, degrees_of_freedom(results), results.floating_base, time.median};
}

}  // namespace

int degrees_of_freedom(const Results& results) {
  return results.joints + (results.floating_base ? 6 : 0);
}

std::string title(const std::string& quantity) {
  if (quantity == "jacobian") return "Jacobian";
  std::string result = quantity;
  std::replace(result.begin(), result.end(), '_', ' ');
  return result;
}

std::vector<Comparison> comparisons(const Results& results) {
  std::vector<Comparison> all;
  for (const std::string& quantity : kQuantities) {
    const auto name = results.compared.find(quantity);
    const Function* function = name == results.compared.end() ? nullptr : find_function(results, name->second);
    if (function == nullptr) continue;
    Comparison comparison{quantity, function->name, function->time, {}};
    for (const std::string& peer : results.peers) {
      for (const PeerTime& p : results.peer_times) {
        if (p.peer != peer || p.quantity != quantity) continue;
        comparison.peers.push_back({peer, p.time, p.time.median / function->time.median});
      }
    }
    all.push_back(comparison);
  }
  return all;
}

std::vector<std::string> all_peers(const std::vector<Results>& robots) {
  std::vector<std::string> peers;
  for (const Results& results : robots) {
    auto at = peers.begin();
    for (const std::string& peer : results.peers) {
      const auto known = std::find(peers.begin(), peers.end(), peer);
      at = std::next(known == peers.end() ? peers.insert(at, peer) : known);
    }
  }
  return peers;
}

std::vector<Mean> geometric_means(const std::vector<Results>& robots) {
  std::vector<Mean> means;
  for (const std::string& peer : all_peers(robots)) {
    for (const std::string& quantity : kQuantities) {
      double logarithms = 0;
      int count = 0;
      for (const Results& results : robots) {
        for (const Comparison& comparison : comparisons(results)) {
          if (comparison.quantity != quantity) continue;
          for (const Ratio& r : comparison.peers) {
            if (r.peer != peer) continue;
            logarithms += std::log(r.ratio);
            ++count;
          }
        }
      }
      if (count > 0) means.push_back({peer, quantity, std::exp(logarithms / count), count});
    }
  }
  return means;
}

std::vector<ChartPanel> chart_panels(const std::vector<Results>& robots) {
  std::vector<ChartPanel> panels;
  for (const char* quantity : {"inverse_dynamics", "forward_dynamics", "inertia_matrix"}) {
    std::vector<ChartSeries> series = {{"RobCoGen", {}}};
    for (const std::string& peer : all_peers(robots)) series.push_back({peer, {}});
    for (const Results& results : robots) {
      for (const Comparison& comparison : comparisons(results)) {
        if (comparison.quantity != quantity) continue;
        series.front().points.push_back(point(results, comparison.time));
        for (const Ratio& r : comparison.peers) {
          const auto its =
              std::find_if(series.begin(), series.end(), [&](const ChartSeries& s) { return s.name == r.peer; });
          its->points.push_back(point(results, r.time));
        }
      }
    }
    panels.push_back({title(quantity), series});
  }
  return panels;
}

}  // namespace robcogen::bench
