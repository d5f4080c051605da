#include "backend/languages.h"

#include "backend/cpp/cpp.h"
#include "backend/matlab/matlab.h"
#include "backend/maxima/maxima.h"

namespace robcogen::backend {

const std::vector<Language>& languages() {
  static const std::vector<Language> all = {
      {"cpp", {}, false, cpp::print},
      {"matlab", {}, true, matlab::print},
      {"maxima", {}, true, maxima::print},
  };
  return all;
}

}  // namespace robcogen::backend
