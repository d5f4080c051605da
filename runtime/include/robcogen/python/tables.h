// Tables that describe the functions, parameters and model of a generated library to its Python module. They are
// constants that need no code when the module is loaded, and little time to compile.
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

// An overload, which takes the first `inputs` arguments. What the library does not have is null.
struct Variant {
  int inputs;
  Kernel<double> in_double;
  Kernel<float> in_float;
  Batch<double> batch_in_double;
  Batch<float> batch_in_float;
};

struct Function {
  const char* scope;  // `transforms.homogeneous`, or empty
  const char* name;
  const char* documentation;
  List<Argument> arguments;
  int required;
  List<Argument> results;
  List<Variant> variants;  // fewest inputs first
};

// The parameters of the library; all pointers are null if there are none.
struct ParameterTable {
  List<const char*> names;
  List<double> defaults;  // NaN: no default
  void* (*make)(const double* values);
  void (*destroy)(void* caches);
  const double* (*in_double)(const void* caches);
  const float* (*in_float)(const void* caches);  // or nullptr
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
  List<LimbElement> links, joints, frames;
};

struct Module {
  const char* name;
  const char* documentation;
  List<Function> functions;
  ParameterTable parameters;
  List<const char*> joints, positions, links, frames;  // positions: the elements of q
  List<int> parents;                                   // by link; -1: the base
  List<double> lower, upper, velocity, effort;
  List<Limb> limbs = {};
};

}  // namespace robcogen::python
