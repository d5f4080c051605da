// Finds a single function of a model by the name that `ops` prints, ready to be evaluated.
#pragma once

#include "command/arguments.h"
#include "command/model_options.h"

namespace robcogen::command {

struct EvaluableFunction {
  Signature signature;
  symbolic::Program program;  // takes all arguments of the signature
};

// Throws a Failure with a hint if the model has no such function. A robot's function may be between frames that its
// list of desired transforms does not have. Traces only this function.
EvaluableFunction find_function(const driver::Model& model, const std::string& name, const driver::Steps& steps);

}  // namespace robcogen::command
