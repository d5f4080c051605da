// Properties of every traced program: the program is valid and runs, and so does the result of the passes.
#pragma once

#include "pass/passes.h"
#include "survives_printing.h"
#include "symbolic/interpret.h"
#include "symbolic/text.h"
#include "symbolic/verify.h"

namespace robcogen::fuzz {

inline void is_sound(const symbolic::Program& program) {
  const std::string fault = symbolic::verify(program);
  require(fault.empty(), "the program is not sound", fault + "\n" + symbolic::print(program));
  symbolic::Arrays<double> inputs;
  double value = 0.1;
  for (const symbolic::InputArray& array : program.inputs)
    for (std::size_t k = 0; k < array.elements.size(); ++k) inputs[array.name].push_back(value += 0.3);
  symbolic::interpret(program, inputs);
}

inline void is_sound_through_passes(const symbolic::Program& program) {
  is_sound(program);
  is_sound(pass::run(program));
}

}  // namespace robcogen::fuzz
