// The languages that libraries can be printed in.
#pragma once

#include <string>
#include <vector>

#include "backend/library.h"

namespace robcogen::backend {

struct Language {
  std::string name;                      // as on the command line
  std::vector<std::string> groups = {};  // the groups that it offers; empty: all
  Features features = {};
  bool takes_transforms = false;  // prints libraries without a robot, whose inputs have role `variables`
  std::vector<OutputFile> (*print)(const Library& library) = nullptr;
};

// C++ comes first, because the build compiles it.
const std::vector<Language>& languages();

}  // namespace robcogen::backend
