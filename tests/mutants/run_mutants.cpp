// Runs the tests of each mutant and reports which mutants survive.
//
//     run_mutants TABLE DIR [NUMBER...]
//
// DIR has the test programs with mutants in them, `mutants_<program>`. First all of them run without a mutant: they
// must pass, or their results on mutants have no meaning. Exits with 1 when one survives.
#include <sys/wait.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <iostream>
#include <mutex>
#include <set>
#include <stdexcept>
#include <thread>

#include "table.h"

namespace {

using robcogen::mutants::Killer;
using robcogen::mutants::Mutant;

enum class Verdict { passed, failed, endless };

// Beyond this a mutant hangs, which is found too.
constexpr int kSeconds = 300;

Verdict run(const std::string& dir, const Killer& killer, int mutant) {
  const std::string command = "ROBCOGEN_MUTANT=" + std::to_string(mutant) + " timeout " + std::to_string(kSeconds) +
                              " '" + dir + "/mutants_" + killer.program + "' --gtest_fail_fast --gtest_filter='" +
                              killer.filter + "' > /dev/null 2>&1";
  const int status = std::system(command.c_str());
  const int code = WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  constexpr int kTimedOut = 124;
  return code == 0 ? Verdict::passed : code == kTimedOut ? Verdict::endless : Verdict::failed;
}

class Campaign {
 public:
  Campaign(std::string dir, std::vector<Mutant> mutants) : dir_(std::move(dir)), mutants_(std::move(mutants)) {}

  bool tests_pass() {
    std::set<std::pair<std::string, std::string>> killers;
    for (const Mutant& m : mutants_)
      for (const Killer& k : m.killers) killers.emplace(k.program, k.filter);
    bool all = true;
    for (const auto& [program, filter] : killers) {
      if (run(dir_, {program, filter}, 0) == Verdict::passed) continue;
      std::printf("%s %s fails without a mutant\n", program.c_str(), filter.c_str());
      all = false;
    }
    return all;
  }

  int survivors() {
    std::vector<std::thread> threads;
    for (unsigned t = std::max(1U, std::thread::hardware_concurrency()); t > 0; --t)
      threads.emplace_back([this] {
        for (std::size_t i = next_++; i < mutants_.size(); i = next_++) judge(mutants_[i]);
      });
    for (std::thread& thread : threads) thread.join();
    return survivors_;
  }

 private:
  std::string dir_;
  std::vector<Mutant> mutants_;
  std::atomic<std::size_t> next_ = 0;
  std::mutex mutex_;
  int survivors_ = 0;

  void judge(const Mutant& m) {
    const auto start = std::chrono::steady_clock::now();
    std::string result = "SURVIVES";
    for (const Killer& killer : m.killers) {
      const Verdict verdict = run(dir_, killer, m.number);
      if (verdict == Verdict::passed) continue;
      result = (verdict == Verdict::failed ? "killed by " : "hangs in ") + killer.program;
      break;
    }
    const std::chrono::duration<double> time = std::chrono::steady_clock::now() - start;
    const std::lock_guard<std::mutex> lock(mutex_);
    if (result == "SURVIVES") ++survivors_;
    std::printf(
        "%3d %-40s %5.1f s  %s: '%s' -> '%s'\n", m.number, result.c_str(), time.count(), m.file.c_str(),
        m.original.c_str(), m.mutated.c_str());
    std::fflush(stdout);
  }
};

}  // namespace

int main(int argc, char** argv) {
  if (argc < 3) {
    std::cerr << "usage: run_mutants TABLE DIR [NUMBER...]\n";
    return 2;
  }
  try {
    std::vector<Mutant> mutants = robcogen::mutants::read_table(argv[1]);
    if (argc > 3) {
      const std::set<std::string> wanted(argv + 3, argv + argc);
      std::erase_if(mutants, [&](const Mutant& m) { return wanted.count(std::to_string(m.number)) == 0; });
    }
    const std::size_t count = mutants.size();
    Campaign campaign(argv[2], std::move(mutants));
    if (!campaign.tests_pass()) return 1;
    const int survivors = campaign.survivors();
    std::printf("%zu mutants, %d survive\n", count, survivors);
    return survivors == 0 ? 0 : 1;
  } catch (const std::exception& e) {
    std::cerr << e.what() << '\n';
    return 2;
  }
}
