// Names of elements as identifiers of the model.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "import/xml/located.h"
#include "support/unique_names.h"

namespace robcogen::import::xml {

// Makes identifiers, and lists the names that become different ones.
class Namer {
 public:
  explicit Namer(Diagnostics& diagnostics) : diagnostics_(diagnostics) {}

  // Reports a name that is too long for a robot document.
  void check_length(const char* kind, const Name& name);

  // Returns the identifier of the wanted name. If it is taken, the suffix is added, and then a number. Reports a name
  // that an element of this kind has already.
  std::string element(
      const char* kind,
      const Name& name,
      const std::string& wanted,
      const std::string& suffix,
      UniqueNames& taken);

  // Adds a note that lists the names that were changed.
  void mention_changes();

 private:
  Diagnostics& diagnostics_;
  std::map<std::string, Place> declared_;
  std::vector<std::string> changes_;
  Place first_change_;
};

}  // namespace robcogen::import::xml
