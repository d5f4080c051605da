#include "backend/languages.h"

#include "backend/c/c.h"
#include "backend/casadi/casadi.h"
#include "backend/cpp/cpp.h"
#include "backend/gpu/gpu.h"
#include "backend/javascript/javascript.h"
#include "backend/matlab/matlab.h"
#include "backend/maxima/maxima.h"
#include "backend/python/python.h"

namespace robcogen::backend {
namespace {

// The library in C, and the file through which CasADi loads it.
std::vector<OutputFile> print_c(const Library& library) {
  std::vector<OutputFile> files = c::print(library);
  files.push_back(casadi::print(library));
  return files;
}

}  // namespace

const std::vector<Language>& languages() {
  static const std::vector<Language> all = {
      {.name = "cpp",
       .features =
           {.caches_parameters = true,
            .has_lanes = true,
            .checks_collisions = true,
            .takes_sines = true,
            .column_loops = ColumnLoops::if_faster},
       .takes_transforms = true,
       .print = cpp::print},
      {.name = "c",
       .features = {.caches_parameters = true, .column_loops = ColumnLoops::if_long},
       .takes_transforms = true,
       .print = print_c},
      {.name = "matlab",
       .features = {.column_loops = ColumnLoops::if_long},
       .takes_transforms = true,
       .print = matlab::print},
      {.name = "maxima",
       .features = {.column_loops = ColumnLoops::if_long},
       .takes_transforms = true,
       .print = maxima::print},
      {.name = "gpu",
       .features = {.caches_parameters = true, .has_both = true, .column_loops = ColumnLoops::if_faster},
       .print = gpu::print},
      {.name = "python",
       .features = {.caches_parameters = true, .column_loops = ColumnLoops::if_faster},
       .takes_transforms = true,
       .print = python::print},
      {.name = "javascript",
       .features = {.column_loops = ColumnLoops::if_long},
       .takes_transforms = true,
       .print = javascript::print},
  };
  return all;
}

}  // namespace robcogen::backend
