#include <exception>
#include <iostream>
#include <sstream>

#include "libraries.h"

namespace robcogen::peers {

namespace {

// Captures the output to the C++ streams during its lifetime: libraries print messages about a URDF.
class Quiet {
 public:
  Quiet() : out_(std::cout.rdbuf(heard_.rdbuf())), err_(std::cerr.rdbuf(heard_.rdbuf())) {}
  ~Quiet() {
    std::cout.rdbuf(out_);
    std::cerr.rdbuf(err_);
  }
  Quiet(const Quiet&) = delete;
  Quiet& operator=(const Quiet&) = delete;

  std::string heard() const { return heard_.str(); }

 private:
  std::ostringstream heard_;
  std::streambuf* out_;
  std::streambuf* err_;
};

Candidate candidate(const std::string& library, Load* load, const Subject& subject) {
  Candidate result;
  result.library = library;
  result.installed = load != nullptr;
  if (!result.installed) {
    result.reason = "not installed";
    return result;
  }
  const Quiet quiet;
  try {
    result.peer = load(subject);
  } catch (const std::exception& e) {
    result.reason = e.what();
    if (!quiet.heard().empty()) result.reason += "; it says:\n" + quiet.heard();
  }
  return result;
}

}  // namespace

std::vector<Candidate> load(const Subject& subject) {
  const std::pair<const char*, Load*> libraries[] = {{"KDL", load_kdl_tree}, {"KDL chain", load_kdl_chain},
                                                     {"DART", load_dart},    {"MuJoCo", load_mujoco},
                                                     {"RBDL", load_rbdl},    {"Pinocchio", load_pinocchio}};
  std::vector<Candidate> candidates;
  for (const auto& [name, load] : libraries) candidates.push_back(candidate(name, load, subject));
  return candidates;
}

}  // namespace robcogen::peers
