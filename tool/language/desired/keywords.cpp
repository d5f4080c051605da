#include "language/desired/keywords.h"

#include <algorithm>

namespace robcogen::language::desired {

const std::vector<std::string>& keywords() {
  static const std::vector<std::string> words = {"Robot", "Model",      "Frames", "Transforms", "Jacobians",  "base",
                                                 "left",  "left_frame", "target", "right",      "right_frame"};
  return words;
}

bool is_keyword(const std::string& word) {
  return std::find(keywords().begin(), keywords().end(), word) != keywords().end();
}

}  // namespace robcogen::language::desired
