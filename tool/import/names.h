// Names of a document that may have become parameters or variables by accident: units, a misspelt constant, the tail
// of a number, a slip of the pen.
#pragma once

#include <map>
#include <set>
#include <string>
#include <vector>

#include "language/common/expression.h"
#include "support/diagnostics.h"

namespace robcogen::import {

// The uses of all names of a document. A name that is declared (in a group, by a default, as `p:name`) or escaped
// (`^kg`) is meant.
class NameUses {
 public:
  // `what` is what the name is taken for: `parameter`, `variable`.
  void use(const language::Expression& name, const std::string& what, const Place& place);
  // Of `2.0 a` and `2.0a`: the product by juxtaposition of a number and a name, used already.
  void multiply_by_number(const language::Expression& product, const Place& place);
  void declare(const std::string& name, const Place& place);

  // Warns of units, of spellings of the constant PI, of numbers that run into names, and of names used once that are
  // nearly those of others.
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

// Whether one name is the other with a letter too many, too few, another or exchanged with its neighbour, inside of a
// word: `lenght` and `length`, but not `m1` and `m2`, `offset_x` and `offset_y`, `mass_LF` and `mass_LH`.
bool differ_by_slip(const std::string& a, const std::string& b);

// The codes of the warnings above, and of angles that look like degrees: a strict reading makes them errors.
const std::vector<std::string>& accident_codes();

}  // namespace robcogen::import
