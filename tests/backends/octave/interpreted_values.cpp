// interpreted_values MODEL DESIRED NAME STATES FOLDER: what the interpreter makes of a robot, also of one with
// parameters.
#include <algorithm>

#include "command/pipeline.h"
#include "functions.h"
#include "pass/passes.h"
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

std::vector<Call> calls(const backend::Library& library) {
  std::vector<Call> result;
  for (const backend::Function& function : library.functions) {
    result.push_back(shape(library, function));
    result.back().evaluate = evaluate(function.program);
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
  if (arguments.size() != 6) return 2;
  Diagnostics diagnostics;
  const auto robot = command::load_robot(arguments[1], {arguments[2], false, {}}, diagnostics);
  if (!robot) return 1;
  // Without passes: these change what the functions compute by rounding only.
  const backend::Library library = command::library(*robot, {arguments[3], ""}, algorithm::groups(), {});
  return octave::write_values(octave::calls(library), arguments, 4);
}
