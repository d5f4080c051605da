#include "symbolic/stages.h"

#include <algorithm>

#include "support/index.h"

namespace robcogen::symbolic {
namespace {

// By input array: whether the program reads it.
std::vector<bool> reads(const Program& p) {
  std::vector<std::size_t> array_of;  // by element
  for (std::size_t k = 0; k < p.inputs.size(); ++k) array_of.insert(array_of.end(), p.inputs[k].elements.size(), k);
  std::vector<bool> result(p.inputs.size(), false);
  const auto note = [&](const Operand& o) {
    if (o.kind == Operand::Kind::input) result[array_of[at(o.index)]] = true;
  };
  for (const Statement& s : p.statements) for_each_operand(s, note);
  for (const OutputArray& output : p.outputs)
    for (const Operand& o : output.values) note(o);
  return result;
}

}  // namespace

std::vector<std::size_t> arrays_of(const Stage& stage, const Program& function) {
  const std::vector<bool> is_read = reads(stage.program);
  const auto writes = [&](const std::string& array) {
    const std::vector<OutputArray>& outputs = stage.program.outputs;
    return std::any_of(outputs.begin(), outputs.end(), [&](const OutputArray& o) { return o.name == array; });
  };
  const std::size_t inputs = function.inputs.size(), outputs = function.outputs.size();
  std::vector<std::size_t> result;
  for (std::size_t k = 0; k < inputs; ++k)
    if (is_read[k]) result.push_back(k);
  for (std::size_t k = 0; k < outputs; ++k)
    if (writes(function.outputs[k].name)) result.push_back(inputs + k);
  if (is_read.back() || writes(kWorkspace)) result.push_back(inputs + outputs);
  return result;
}

}  // namespace robcogen::symbolic
