#include "backend/cpp/names.h"

namespace robcogen::backend::cpp {

bool is_reserved_namespace(const std::string& name) {
  return name == "std" || name == "Eigen" || name == "robcogen" || is_reserved(name) || c_family::is_global(name);
}

}  // namespace robcogen::backend::cpp
