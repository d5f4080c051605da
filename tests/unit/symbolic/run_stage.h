// Runs a stage of a program by the interpreter.
#pragma once

#include <vector>

#include "programs.h"
#include "symbolic/stages.h"

namespace robcogen::test {

// Runs the stage over these arrays, which have its inputs and its outputs.
inline void run_stage(symbolic::Program p, symbolic::Arrays<double>& arrays) {
  using symbolic::Operand;
  const std::vector<symbolic::OutputArray> outputs = p.outputs;
  for (symbolic::OutputArray& output : p.outputs)
    for (Operand& o : output.values)
      if (o == symbolic::kNotWritten) o = {Operand::Kind::input, 0};
  EXPECT_EQ(symbolic::verify(p), "");
  symbolic::Arrays<double> given;
  for (const symbolic::InputArray& input : p.inputs) given[input.name] = arrays.at(input.name);
  const symbolic::Arrays<double> computed = symbolic::interpret<double>(p, given);
  for (const symbolic::OutputArray& output : outputs)
    for (std::size_t k = 0; k < output.values.size(); ++k)
      if (output.values[k] != symbolic::kNotWritten) arrays.at(output.name).at(k) = computed.at(output.name)[k];
}

}  // namespace robcogen::test
