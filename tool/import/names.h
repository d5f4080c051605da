// Names of a document that may be parameters or variables by accident: units, a misspelt constant, letters at the end
// of a number, or a misspelt name.
#pragma once

#include <map>
#include <set>
#include <string>
#include <vector>

#include "language/common/expression.h"
#include "support/diagnostics.h"

namespace robcogen::import {

// The uses of all names of a document. A name that is declared (in a group, by a default value, as `p:name`) or escaped
// (`^kg`) is intended.
class NameUses {
 public:
  // Records a use. `what` is the meaning of the name: `parameter` or `variable`.
  void use(const language::Expression& name, const std::string& what, const Place& place);
  // Records a product `2.0 a` or `2.0a`, whose name was passed to use().
  void multiply_by_number(const language::Expression& product, const Place& place);
  void declare(const std::string& name, const Place& place);

  // Warns about units, about spellings of the constant PI, about numbers that run into names, and about names used once
  // that are similar to others.
  void report(Diagnostics& diagnostics) const;

 private:
  struct Name {
    std::string what;
    Place first;
    int count = 0;
    int after_number = 0;  // uses by juxtaposition
    bool is_meant = false;
    Place run_in;      // the first product without a blank
    std::string text;  // of that product
    std::string number;
  };

  bool report_accident(const std::string& text, const Name& name, Diagnostics& diagnostics) const;
  void report_similar(const std::string& text, const Name& name, Diagnostics& diagnostics) const;

  std::map<std::string, Name> names_;
};

// Whether two names differ by one letter inside a word: inserted, missing, replaced, or exchanged with its neighbour.
// `lenght` and `length` do, but not `m1` and `m2`, `offset_x` and `offset_y`, or `mass_LF` and `mass_LH`.
bool differ_by_slip(const std::string& a, const std::string& b);

// The codes of the warnings above, and of angles that look like degrees. They are errors under --strict.
const std::vector<std::string>& accident_codes();

}  // namespace robcogen::import
