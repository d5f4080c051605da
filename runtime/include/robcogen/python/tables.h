// Tables that describe the functions, parameters and model of a generated library to its Python module.
#pragma once

#include "robcogen/batch.h"
#include "robcogen/python/arrays.h"

namespace robcogen::python {

template <class Scalar>
using Kernel = void (*)(const Scalar* const* in, Scalar* const* out);
template <class Scalar>
using Batch = void (*)(
    std::ptrdiff_t n,
    const Scalar* parameters,
    const batch::Strided<const Scalar>* in,
    const batch::Strided<Scalar>* out);

// An overload, which takes the first `inputs` arguments.
struct Variant {
  int inputs;
  Kernel<double> in_double;
  Kernel<float> in_float;
  Batch<double> batch_in_double;  // or nullptr
  Batch<float> batch_in_float;
};

struct Function {
  const char* scope;  // `transforms.homogeneous`, or empty
  const char* name;
  const char* documentation;
  std::vector<Argument> arguments;
  int required;
  std::vector<Argument> results;
  std::vector<Variant> variants;  // fewest inputs first
};

// The parameters of the library; all pointers are null if there are none.
struct ParameterTable {
  std::vector<const char*> names;
  std::vector<double> defaults;  // NaN: no default
  void* (*make)(const double* values);
  void (*destroy)(void* caches);
  const double* (*in_double)(const void* caches);
  const float* (*in_float)(const void* caches);
};

struct LimbElement {
  const char* own;
  int index;
};

// An instance of a part in the document (robcogen/limb.h).
struct Limb {
  const char* name;
  const char* part;
  int first_link;
  std::vector<LimbElement> links, joints, frames;
};

struct Module {
  const char* name;
  const char* documentation;
  std::vector<Function> functions;
  ParameterTable parameters;
  std::vector<const char*> joints, positions, links, frames;  // positions: the elements of q
  std::vector<int> parents;                                   // by link; -1: the base
  std::vector<double> lower, upper, velocity, effort;
  std::vector<Limb> limbs = {};
};

}  // namespace robcogen::python
