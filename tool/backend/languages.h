// The languages that libraries can be printed in.
#pragma once

#include <string>
#include <vector>

#include "backend/library.h"

namespace robcogen::backend {

struct Language {
  std::string name;                      // as on the command line
  std::vector<std::string> groups = {};  // which it offers; empty: all
  Features features = {};
  bool takes_transforms = false;  // prints libraries with no robot: inputs of role `variables`
  std::vector<OutputFile> (*print)(const Library& library) = nullptr;
};

// The C++ of a library is compiled by the build and comes first.
const std::vector<Language>& languages();

}  // namespace robcogen::backend
