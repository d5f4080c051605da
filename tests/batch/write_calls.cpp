// write_calls MODEL DESIRED NAME FILE group…: writes a header with a row for each function of the robot's batches.
//
// The functions are those that the generator knows; a new algorithm is included automatically.
#include <fmt/format.h>

#include <cmath>
#include <fstream>

#include "backend/cpp/api.h"
#include "backend/cpp/batch_kernels.h"
#include "backend/cpp/lower.h"
#include "backend/cpp/printers.h"
#include "driver/driver.h"
#include "pass/passes.h"

namespace robcogen::batch_test {
namespace {

using backend::cpp::Api;
using backend::cpp::Callable;
using symbolic::Role;

std::string braced(const std::vector<std::string>& items) {
  return fmt::format("{{{}}}", fmt::join(items, ", "));
}

// `space` is the namespace of the precision: hyl, hyl::f32.
std::string input_type(const std::string& space, const symbolic::InputArray& input) {
  const auto rows = static_cast<int>(std::lround(std::sqrt(static_cast<double>(input.elements.size()))));
  const std::string type =
      input.role == Role::inertia_factor ? backend::cpp::matrix_type(rows, rows) : backend::cpp::type_of(input);
  return fmt::format("{}::{}", space, type);
}

// With `is_lower`, the row of a symmetric matrix is for its lower triangle only.
std::string row(
    const Api& api,
    const std::string& space,
    const Callable& callable,
    bool omits_gravity,
    bool is_lower = false) {
  const symbolic::Program& program = callable.function->program;
  std::vector<std::string> inputs, outputs, kernel, batch = {"a.n"};
  bool has_gravity = false;
  for (const symbolic::InputArray& input : program.inputs) {
    if (input.role == Role::parameters) {
      kernel.push_back("parameters<Scalar>().data()");
      batch.insert(batch.begin(), "parameters<Scalar>()");
      continue;
    }
    const std::size_t k = inputs.size();
    kernel.push_back(fmt::format("in[{}]", k));
    if (input.role == Role::gravity && omits_gravity) {
      has_gravity = true;
      inputs.push_back(fmt::format("-{}", input.elements.size()));
      continue;
    }
    batch.push_back(fmt::format("a.template in<{}>(layout, {})", input_type(space, input), k));
    inputs.push_back(fmt::format("{}", input.elements.size()));
  }
  if (omits_gravity && !has_gravity) return "";
  for (const symbolic::OutputArray& output : program.outputs) {
    const std::size_t k = outputs.size();
    kernel.push_back(fmt::format("out[{}]", k));
    batch.push_back(fmt::format("a.template out<{}::{}>(layout, {})", space, backend::cpp::type_of(output), k));
    outputs.push_back(fmt::format("{}", output.rows * output.columns));
  }
  if (is_lower) batch.push_back("robcogen::batch::Storage::lower");
  batch.push_back("a.level");
  const std::string scope = callable.function->scope.empty() ? "" : callable.function->scope + "::";
  const std::string name = scope + callable.name;
  return fmt::format(
      "      Call<Scalar>(\"{}{}\", {}, {},\n        []([[maybe_unused]] const Scalar* const* in, Scalar* const* out) "
      "{{ "
      "{}::kernel::{}<Scalar>({}); }},\n        [](auto layout, const Arguments<Scalar>& a) {{ {}::batch::{}({}); "
      "}}, {}),\n",
      name,
      omits_gravity ? ", standard gravity"
      : is_lower    ? ", lower triangle"
                    : "",
      braced(inputs), braced(outputs), api.space, callable.kernel, fmt::join(kernel, ", "), space, name,
      fmt::join(batch, ", "), is_lower ? program.outputs.front().rows : 0);
}

bool may_omit_gravity(const Api& api, const Callable& callable) {
  for (const backend::cpp::Overload& o : overloads(api, callable.function->group, callable.function->scope))
    if (o.callable == &callable && o.adds_standard_gravity) return true;
  return false;
}

std::string list(const Api& api, const std::string& scalar, const std::string& space) {
  std::string text = fmt::format(
      "template <>\ninline std::vector<Call<{0}>> calls<{0}>() {{\n  using Scalar = {0};\n  return {{\n", scalar);
  for (const Callable& callable : api.callables) {
    text += row(api, space, callable, false);
    if (may_omit_gravity(api, callable)) text += row(api, space, callable, true);
    if (is_symmetric(callable)) text += row(api, space, callable, false, true);
  }
  return text + "  };\n}\n";
}

std::string header(const backend::Library& library) {
  const Api api = backend::cpp::api(library);
  const std::string include = "#include <" + library.name + "/";
  std::string text = include + library.name + ".h>\n" + include + "batch.h>\n\n";
  text += "namespace robcogen::batch_test {\n\n";
  if (api.is_parametric())
    text += fmt::format(
        "template <class Scalar>\nconst {0}::Parameters<Scalar>& parameters() {{\n  static const "
        "{0}::Parameters<Scalar> defaults;\n  return defaults;\n}}\n\n",
        api.space);
  return text + list(api, "double", api.space) + "\n" + list(api, "float", api.space + "::f32") + "\n}\n";
}

}  // namespace
}  // namespace robcogen::batch_test

int main(int argc, char** argv) {
  using namespace robcogen;
  const std::vector<std::string> arguments(argv, argv + argc);
  if (arguments.size() < 6) return 2;
  driver::LoadOptions reading;
  reading.desired = arguments[2];
  Diagnostics diagnostics;
  const auto robot = driver::load(arguments[1], reading, diagnostics);
  if (!robot) return 1;
  const std::vector<std::string> groups(arguments.begin() + 5, arguments.end());
  const backend::Library library = driver::library(
      *robot, {.names = {arguments[3]}, .groups = groups, .steps = {pass::names(), 0}}, {.caches_parameters = true});
  std::ofstream file(arguments[4]);
  file << batch_test::header(library);
  file.close();
  return file ? 0 : 1;
}
