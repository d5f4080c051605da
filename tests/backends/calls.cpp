#include "calls.h"

#include <stdexcept>

#include "robcogen/reference/samples.h"

namespace robcogen::test {

using symbolic::Arrays;
using symbolic::Program;

backend::Library library_of(
    const std::filesystem::path& document,
    const std::string& name,
    driver::Primitives primitives,
    const std::vector<driver::Derivative>& derivatives,
    const std::vector<std::string>& groups,
    const backend::Features& features) {
  Diagnostics diagnostics;
  driver::LoadOptions reading;
  reading.derivatives = derivatives;
  std::filesystem::path desired = document;
  desired.replace_extension(".dtdsl");
  if (document.extension() == ".kindsl" && std::filesystem::exists(desired)) reading.desired = desired;
  const std::optional<driver::Model> model = driver::load(document, reading, diagnostics);
  if (!model) throw std::runtime_error(diagnostics.render());
  if (!model->robot()) primitives = std::nullopt;
  return driver::library(*model, {.names = {name}, .groups = groups, .primitives = primitives}, features);
}

ColumnLoopLibraries column_loop_libraries(const std::string& robot) {
  const auto library = [&](backend::ColumnLoops loops) {
    return library_of(
        std::filesystem::path(ROBCOGEN_ROBOTS_DIR) / robot / (robot + ".kindsl"), robot, std::nullopt, {},
        {"inverse_dynamics_derivatives", "forward_dynamics_derivatives"}, {.column_loops = loops});
  };
  return {library(backend::ColumnLoops::if_faster), library(backend::ColumnLoops::none)};
}

Arrays<double> random_inputs(const backend::Library& library, const Program& program, std::mt19937_64& engine) {
  constexpr double kLimit = 2, kNear = 0.1;
  Arrays<double> inputs;
  for (const symbolic::InputArray& array : program.inputs) {
    std::vector<double>& values = inputs[array.name];
    for (std::size_t k = 0; k < array.elements.size(); ++k) {
      const bool is_near = !library.tree.loops.empty() && array.role == symbolic::Role::joint_position;
      const double value = reference::uniform(engine, is_near ? kNear : kLimit);
      const bool is_positive =
          array.role == symbolic::Role::parameters || array.role == symbolic::Role::contact_compliance;
      const bool is_closed = array.role == symbolic::Role::contact_activity;
      values.push_back(is_positive ? std::abs(value) + 0.5 : is_closed ? (value > -1 ? 1.0 : 0.0) : value);
    }
    for (const int first : array.quaternions) {
      const reference::Vector<double> unit = reference::unit_vector(engine, 4);
      for (int k = 0; k < 4; ++k) values[static_cast<std::size_t>(first + k)] = unit(k);
    }
  }
  return inputs;
}

std::vector<double> flattened(const Program& program, const Arrays<double>& results) {
  std::vector<double> values;
  for (const symbolic::OutputArray& output : program.outputs) {
    for (int r = 0; r < output.rows; ++r)
      for (int c = 0; c < output.columns; ++c)
        values.push_back(results.at(output.name)[static_cast<std::size_t>(r + c * output.rows)]);
  }
  return values;
}

}  // namespace robcogen::test
