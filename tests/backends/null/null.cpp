#include "null.h"

namespace robcogen::backend::null {

std::vector<OutputFile> print(const Library& library) {
  std::string text;
  for (const Function& function : library.functions) {
    text += function.kernel + ":";
    for (const symbolic::InputArray& input : function.program.inputs)
      text += " " + input.name + " " + std::to_string(input.elements.size());
    text += " ->";
    for (const symbolic::OutputArray& output : function.program.outputs)
      text += " " + output.name + " " + std::to_string(output.rows) + " x " + std::to_string(output.columns);
    text += "; " + std::to_string(function.program.statements.size()) + " statements\n";
  }
  return {{library.name + ".txt", text}};
}

}  // namespace robcogen::backend::null
