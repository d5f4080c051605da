#include "peer_benchmarks.h"

#include <benchmark/benchmark.h>

namespace robcogen::bench {

namespace {

void append_line(std::string& text, const std::string& line) {
  if (!text.empty()) text += '\n';
  text += line;
}

// Adds the benchmark of a peer, with the same loop as for the generated functions plus a virtual call of about 2 ns.
void add(peers::Peer& peer, const Computed& ours, std::size_t states) {
  const std::string title = peer.name() + "/" + name(ours.quantity);
  benchmark::RegisterBenchmark(
      title.c_str(), [&peer, quantity = ours.quantity, function = ours.function, states](benchmark::State& state) {
        std::size_t next = 0;
        for (auto _ : state) {
          peer.run(quantity, next);
          benchmark::ClobberMemory();
          next = next + 1 == states ? 0 : next + 1;
        }
        state.SetLabel(function);
      });
}

}  // namespace

void add_peer_benchmarks(
    const std::vector<peers::Candidate>& candidates,
    const std::vector<Computed>& computed,
    std::size_t states) {
  std::string present, absent;
  for (const peers::Candidate& candidate : candidates) {
    if (candidate.peer == nullptr) {
      append_line(absent, candidate.library + ": " + candidate.reason);
      continue;
    }
    append_line(present, candidate.peer->name());
    for (const Computed& ours : computed) {
      if (candidate.peer->has(ours.quantity)) add(*candidate.peer, ours, states);
    }
  }
  benchmark::AddCustomContext("peers", present);
  benchmark::AddCustomContext("absent", absent);
}

}  // namespace robcogen::bench
