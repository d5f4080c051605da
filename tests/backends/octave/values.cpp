// values MODEL DESIRED NAME PRIMITIVES STATES FOLDER: writes the results of a library's functions. If CALLS is the
// calls header of a compiled library, the library evaluates the functions that it has, and the interpreter the others.
#ifdef CALLS
#include CALLS
#endif

#include <algorithm>

#include "algorithm/catalogue/catalogue.h"
#include "functions.h"
#include "symbolic/interpret.h"

namespace robcogen::octave {
namespace {

Evaluate evaluate(const symbolic::Program& program) {
  return [&program](const double* const* in, double* const* out) {
    symbolic::Arrays<double> inputs;
    for (std::size_t i = 0; i < program.inputs.size(); ++i)
      inputs[program.inputs[i].name].assign(in[i], in[i] + program.inputs[i].elements.size());
    const symbolic::Arrays<double> results = symbolic::interpret<double>(program, inputs);
    for (std::size_t i = 0; i < program.outputs.size(); ++i) {
      const std::vector<double>& values = results.at(program.outputs[i].name);
      std::copy(values.begin(), values.end(), out[i]);
    }
  };
}

#ifndef CALLS
const std::vector<Call> kCalls;
#endif

bool is_compiled(const std::string& function) {
  return std::any_of(kCalls.begin(), kCalls.end(), [&](const Call& call) { return call.function == function; });
}

std::vector<Call> calls(const backend::Library& library) {
  std::vector<Call> result = kCalls;
  for (const backend::Function& function : library.functions) {
    if (is_compiled(shape(library, function).function)) continue;
    result.push_back(shape(library, function));
    result.back().evaluate = evaluate(function.program);
    if (auto product = shape_of_product(library, function)) {
      product->evaluate = result.back().evaluate;
      result.push_back(std::move(*product));
    }
    if (!may_omit_gravity(library, function)) continue;
    result.push_back(result.back());
    result.back().omits_gravity = true;
  }
  return result;
}

}  // namespace
}  // namespace robcogen::octave

int main(int argc, char** argv) {
  using namespace robcogen;
  const std::vector<std::string> arguments(argv, argv + argc);
  if (arguments.size() < 7) return 2;
  // No passes are run; they change results by rounding only.
  const auto library = octave::load(
      arguments[1], arguments[2], arguments[3], arguments[4], algorithm::groups(), {{}, 0},
      {arguments.begin() + 7, arguments.end()});
  return library ? octave::write_values(octave::calls(*library), arguments, 5) : 1;
}
