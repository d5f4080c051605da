// The kernels that a library compiles for double and float, as its declarations, its instantiations and its processor
// levels need them.
#pragma once

#include <string>
#include <vector>

#include "backend/cpp/api.h"

namespace robcogen::backend::cpp {

struct CompiledKernel {
  std::string name;
  bool is_core = false;  // in namespace `core`
  std::vector<KernelArray> parameters;
  const Callable* callable = nullptr;  // null: joint_trigonometry
};

// `core::f` or `f`, in namespace `kernel`.
std::string qualified(const CompiledKernel& kernel);

// The kernels of a group, or of `parameters` or `trigonometry`. A core precedes the kernel that calls it.
std::vector<CompiledKernel> compiled_kernels(const Api& api, const std::string& group);

// The functions of a group in their order; `parameters` and `trigonometry` are groups too.
std::vector<const Callable*> callables_of(const Api& api, const std::string& group);

// The same functions, preceded by those of right-hand sides that they call.
std::vector<const Callable*> kernels_of(const Api& api, const std::string& group);

// The parameters of joint_trigonometry.
std::vector<KernelArray> trigonometry_parameters(const Library& library);

// `template <class Scalar> HEAD(PARAMETERS)TAIL`, with HEAD `void name`. Unused parameters have no name.
std::string signature(const std::string& head, const std::vector<KernelArray>& parameters, const char* tail);

// `robcogen::Lanes<Scalar, 4>`.
std::string lanes(int width);
// The type of a parameter's elements.
std::string type_of(const KernelArray& parameter);

}  // namespace robcogen::backend::cpp
