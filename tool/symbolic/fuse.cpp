#include "symbolic/fuse.h"

#include <algorithm>
#include <map>
#include <optional>
#include <utility>

#include "support/index.h"
#include "symbolic/expression.h"
#include "symbolic/rebuild.h"

namespace robcogen::symbolic {
namespace {

// Parameters come first and the loads of overloads last, as in all functions; the state is in the order in which
// functions that take it declare it.
int place_of(Role role) {
  switch (role) {
    case Role::parameters:
      return 0;
    case Role::joint_position:
      return 1;
    case Role::joint_velocity:
      return 2;
    case Role::joint_acceleration:
      return 3;
    case Role::joint_force:
      return 4;
    case Role::base_pose:
      return 5;
    case Role::base_velocity:
      return 6;
    case Role::base_acceleration:
      return 7;
    case Role::gravity:
      return 9;
    case Role::link_wrenches:
      return 10;
    default:
      return 8;
  }
}

std::vector<InputArray> inputs_of(const std::vector<Program>& parts) {
  std::vector<InputArray> inputs;
  for (const Program& part : parts)
    for (const InputArray& array : part.inputs)
      if (std::none_of(inputs.begin(), inputs.end(), [&](const InputArray& a) { return a.name == array.name; }))
        inputs.push_back(array);
  std::stable_sort(inputs.begin(), inputs.end(), [](const InputArray& a, const InputArray& b) {
    return place_of(a.role) < place_of(b.role);
  });
  return inputs;
}

// By element of the part: the element of these inputs.
std::vector<int> elements_among(const std::vector<InputArray>& inputs, const Program& part) {
  std::map<std::string, int> first;
  int count = 0;
  for (const InputArray& array : inputs) {
    first[array.name] = count;
    count += static_cast<int>(array.elements.size());
  }
  std::vector<int> elements;
  for (const InputArray& array : part.inputs)
    for (std::size_t k = 0; k < array.elements.size(); ++k)
      elements.push_back(first.at(array.name) + static_cast<int>(k));
  return elements;
}

}  // namespace

Program fused_outline(const std::string& name, const std::vector<Program>& outlines) {
  Program program;
  program.name = name;
  program.inputs = inputs_of(outlines);
  for (const Program& part : outlines)
    program.outputs.insert(program.outputs.end(), part.outputs.begin(), part.outputs.end());
  return program;
}

Program fused(const std::string& name, const std::vector<Program>& parts) {
  const Program outline = fused_outline(name, parts);
  Graph graph;
  std::vector<std::vector<Expression>> values;
  for (const Program& part : parts) {
    const std::vector<int> elements = elements_among(outline.inputs, part);
    Rebuild rebuild(graph, part, [&](const Operand& o) -> std::optional<Expression> {
      if (o.kind != Operand::Kind::input) return std::nullopt;
      return graph.input(elements[at(o.index)]);
    });
    rebuild.keep_all();
    for (std::vector<Expression>& array : rebuild.outputs()) values.push_back(std::move(array));
  }
  std::vector<OutputArray> shapes = outline.outputs;
  for (OutputArray& shape : shapes) shape.values.clear();
  return graph.program(name, outline.inputs, std::move(shapes), values);
}

}  // namespace robcogen::symbolic
