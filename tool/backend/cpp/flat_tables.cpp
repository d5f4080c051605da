#include "backend/cpp/flat_tables.h"

#include <algorithm>
#include <utility>

#include "backend/cpp/layout.h"

namespace robcogen::backend::cpp {
namespace {

std::vector<std::size_t> offsets_of_inputs(const symbolic::Program& program) {
  std::vector<std::size_t> result;
  for (std::size_t i = 0; i < program.inputs.size(); ++i) result.push_back(offset_of(program, i));
  return result;
}

int size_of(const symbolic::OutputArray& output) {
  return output.rows * output.columns;
}

std::size_t index_of_input(const symbolic::Program& program, const std::string& name) {
  std::size_t input = 0;
  while (program.inputs[input].name != name) ++input;
  return input;
}

// `gradient of tau by q`, or only what is differentiated by what.
std::string name_of(const symbolic::Program& program, const symbolic::DerivativeBlock& block) {
  const std::string of = block.results == 1 ? program.outputs[static_cast<std::size_t>(block.of)].name : "all results";
  const std::string form = block.form == symbolic::DerivativeForm::gradient  ? "gradient of "
                           : block.form == symbolic::DerivativeForm::tangent ? "tangent of "
                                                                             : "";
  return form + of + " by " + block.by;
}

// How the derivatives are multiplied, after all other fields.
std::vector<Field> fields_of_vector(const symbolic::Program& program, const symbolic::DerivativeBlock& block) {
  if (block.form == symbolic::DerivativeForm::matrix) return {};
  const bool is_gradient = block.form == symbolic::DerivativeForm::gradient;
  return {
      std::string("robcogen::reflection::Form::") + (is_gradient ? "gradient" : "tangent"),
      static_cast<int>(offset_of(program, index_of_input(program, block.vector)))};
}

std::vector<Field> row_of(
    const Callable& c,
    std::size_t function,
    const symbolic::DerivativeBlock& block,
    bool has_cache) {
  const symbolic::Program& program = c.function->program;
  const bool is_by_rotation = block.by == symbolic::kBaseRotation;
  const std::string& read = is_by_rotation ? symbolic::orientation_of_base(program)->name : block.by;
  const std::size_t input = index_of_input(program, read);
  const bool is_of_pose = program.inputs[input].role == symbolic::Role::base_pose;
  const bool is_cached = has_cache && program.inputs[input].role == symbolic::Role::parameters;
  const std::vector<std::size_t> offsets = offsets_of_outputs(program);
  const auto of = static_cast<std::size_t>(block.of), place = static_cast<std::size_t>(block.place);
  int rows = 0, columns = program.outputs[place].columns;
  for (std::size_t k = of; k < of + static_cast<std::size_t>(block.results); ++k) rows += size_of(program.outputs[k]);
  if (block.form == symbolic::DerivativeForm::gradient) columns = size_of(program.outputs[place]);
  if (block.form == symbolic::DerivativeForm::tangent)
    columns = static_cast<int>(program.inputs[index_of_input(program, block.vector)].elements.size());
  std::vector<Field> row = {
      quoted(c.kernel + ": " + name_of(program, block)),
      static_cast<int>(function),
      is_cached ? "true" : "false",
      static_cast<int>(offset_of(program, input)),
      columns,
      static_cast<int>(offsets[of]),
      rows,
      static_cast<int>(offsets[place])};
  const bool is_of_input = !is_of_pose && !is_by_rotation;
  const std::string variation = is_of_input ? "of_input" : is_of_pose ? "of_base_pose" : "of_gravity_in_base";
  const std::vector<Field> vector = fields_of_vector(program, block);
  if (!is_of_input || !vector.empty()) row.emplace_back("robcogen::reflection::Variation::" + variation);
  row.insert(row.end(), vector.begin(), vector.end());
  return row;
}

// Where the inputs of a part are among those of the function.
std::vector<std::vector<Field>> inputs_of_part(const symbolic::Program& function, const symbolic::Program& part) {
  std::vector<std::vector<Field>> rows;
  for (std::size_t i = 0; i < part.inputs.size(); ++i) {
    std::size_t place = 0;
    while (function.inputs[place].name != part.inputs[i].name) ++place;
    rows.push_back(
        {static_cast<int>(offset_of(function, place)), static_cast<int>(offset_of(part, i)),
         static_cast<int>(part.inputs[i].elements.size())});
  }
  return rows;
}

}  // namespace

Table table(const std::string& type, const std::string& name, const std::vector<std::vector<Field>>& rows) {
  if (rows.empty()) return {"", kNoTable};
  return {
      table("inline constexpr robcogen::reflection::" + type + " " + name + "[]", rows),
      "{" + name + ", " + std::to_string(rows.size()) + "}"};
}

std::string address(const Callable& c) {
  return "&kernel::" + c.kernel + "<double>";
}

std::size_t offset_of(const symbolic::Program& program, std::size_t input) {
  std::size_t offset = 0;
  for (std::size_t i = 0; i < input; ++i) offset += program.inputs[i].elements.size();
  return offset;
}

std::string offset_list(const std::vector<std::size_t>& offsets) {
  // A list that is too long for a line has a line for each element, as clang-format breaks it.
  constexpr std::size_t kIndent = 12, kMaxLength = 100 - kIndent - 2;
  const std::string next_line = ",\n" + std::string(kIndent + 3, ' ');
  std::string list, lines;
  for (const std::size_t offset : offsets) {
    const std::string text = std::to_string(offset);
    list += (list.empty() ? "" : ", ") + text;
    lines += (lines.empty() ? "" : next_line) + text;
  }
  return "At<" + (list.size() + 4 > kMaxLength ? lines : list) + ">";
}

std::vector<std::size_t> offsets_of_outputs(const symbolic::Program& program) {
  std::vector<std::size_t> result;
  std::size_t offset = 0;
  for (const symbolic::OutputArray& output : program.outputs) {
    result.push_back(offset);
    offset += static_cast<std::size_t>(output.rows) * static_cast<std::size_t>(output.columns);
  }
  return result;
}

Field flat(const Callable& c) {
  const symbolic::Program& program = c.function->program;
  return {"kFlat", {address(c), offset_list(offsets_of_inputs(program)), offset_list(offsets_of_outputs(program))}};
}

int output_count(const symbolic::Program& program) {
  int count = 0;
  for (const symbolic::OutputArray& output : program.outputs) count += output.rows * output.columns;
  return count;
}

std::vector<Field> function_row(const Callable& c) {
  const symbolic::Program& program = c.function->program;
  const symbolic::Cost& n = c.count;
  std::vector<std::string> counts;
  for (int k : {n.mul, n.add, n.div, n.sqrt, n.sincos, n.instructions, n.critical_path})
    counts.push_back(std::to_string(k));
  return {quoted(c.kernel), counts, program.input_count(), output_count(program), flat(c)};
}

Table derivatives(const std::vector<const Callable*>& functions, bool has_cache) {
  std::vector<std::vector<Field>> rows;
  for (std::size_t f = 0; f < functions.size(); ++f) {
    const Callable& c = *functions[f];
    for (const symbolic::DerivativeBlock& block : c.function->derivatives)
      rows.push_back(row_of(c, f, block, has_cache));
  }
  return table("Derivative", "kDerivatives", rows);
}

Table parts(const std::vector<const Callable*>& functions) {
  std::vector<std::vector<Field>> inputs, rows;
  for (std::size_t f = 0; f < functions.size(); ++f) {
    const Function& function = *functions[f]->function;
    for (const symbolic::Part& part : function.parts) {
      const auto found = std::find_if(
          functions.begin(), functions.end(), [&](const Callable* c) { return c->function->kernel == part.kernel; });
      if (found == functions.end()) continue;
      const std::size_t first = inputs.size();
      for (std::vector<Field>& row : inputs_of_part(function.program, (*found)->function->program))
        inputs.push_back(std::move(row));
      rows.push_back(
          {quoted(functions[f]->kernel + ": " + (*found)->kernel), static_cast<int>(f),
           static_cast<int>(found - functions.begin()),
           static_cast<int>(offsets_of_outputs(function.program)[static_cast<std::size_t>(part.first_output)]),
           "kPartInputs + " + std::to_string(first), static_cast<int>(inputs.size() - first)});
    }
  }
  Table all = table("Part", "kParts", rows);
  if (!rows.empty()) all.definition = table("PartInput", "kPartInputs", inputs).definition + "\n" + all.definition;
  return all;
}

}  // namespace robcogen::backend::cpp
