// What a file says and nothing reads, counted by name.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "support/diagnostics.h"

namespace robcogen::import::xml {

struct Finding {
  const char* code = "";
  std::string message, hint;
  Place place;
};

// Findings in the order in which they were added, once for each key.
class Findings {
 public:
  void add(const std::string& key, Finding finding);

  // Warns about each, with the number of times it was added.
  void report(Diagnostics& diagnostics) const;

 private:
  struct Counted {
    Finding finding;
    int count = 0;
  };
  std::vector<Counted> findings_;
  std::map<std::string, std::size_t> indices_;  // by key
};

}  // namespace robcogen::import::xml
