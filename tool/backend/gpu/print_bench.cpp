// The program that checks functions over many states on a device, and measures their times.
#include "backend/gpu/printers.h"
#include "support/concat.h"
#include "support/number.h"

namespace robcogen::backend::gpu {
namespace {

// What the array is filled with, behind a comma; nothing: any numbers.
std::string contents(const StatesFunction& f, std::size_t array) {
  if (f.arrays[array].array.output) return "";
  if (!f.function) return ", parameters";
  const symbolic::Role role = f.function->function->program.inputs[array].role;
  if (role == symbolic::Role::parameters) return ", cache";
  const bool is_positive = role == symbolic::Role::contact_activity || role == symbolic::Role::contact_compliance;
  return is_positive ? ", nullptr, true" : "";
}

std::string print_case(const Names& names, const StatesFunction& f, const Scalar& scalar) {
  std::vector<std::string> arrays, passed;
  std::size_t inputs = 0;
  for (std::size_t k = 0; k < f.arrays.size(); ++k) {
    const StatesArray& a = f.arrays[k];
    arrays.push_back(
        "{\"" + a.array.name + "\", " + std::to_string(a.size) + (a.array.output ? ", true" : ", false") +
        contents(f, k) + "}");
    passed.push_back(a.array.output ? "out[" + std::to_string(k - inputs) + "]" : "in[" + std::to_string(k) + "]");
    if (!a.array.output) ++inputs;
  }
  const Function* function = f.function ? f.function->function : nullptr;
  const double error = function && function->error ? (*function->error).*scalar.error : 0;
  return c::wrapped("  bench.run<" + std::string(scalar.type) + ">({\"" + f.name + "\", {", arrays, "},") + "    " +
         std::to_string(f.stages ? f.stages->workspace : 0) + ", " + print_double(error) + ", StartedBy<" +
         names.prefix + "_batch_" + f.name + scalar.suffix + ">::start,\n" +
         "    [](const double* const* in, double* const* out) {\n" + (inputs == 0 ? "      (void)in;\n" : "") +
         c::wrapped("      " + names.prefix + "_" + f.name + "<double>(", passed, ");") + "    }});\n";
}

// The cache of the default parameters.
std::string print_parameters(const Names& names) {
  if (names.library.updates.empty()) return "";
  std::vector<std::string> values;
  for (const model::Parameter& p : names.library.parameters())
    values.push_back(print_double(p.default_value.value_or(1)));
  return "  static const double parameters[] = " + c::braced(values) + ";\n  static double cache[" + names.prefix +
         "_cache_size];\n  " + names.prefix + "_update<double>(&parameters[0], cache);\n";
}

}  // namespace

std::string print_bench(const Names& names, const std::vector<std::string>& groups) {
  const std::string path = names.folder + "/";
  std::string text = c::banner(names.library, path + "bench.cu", "checks and times") +
                     "#include <robcogen/gpu/bench.h>\n\n#include \"" + path + names.folder + ".h\"\n#include \"" +
                     path +
                     "batch.h\"\n\nusing namespace robcogen::gpu;\n\nint main(int count, char** arguments) {\n"
                     "  Bench bench(count, arguments);\n" +
                     print_parameters(names);
  for (const std::string& group : groups)
    for (const StatesFunction& f : states_functions(names, group))
      for (const Scalar& scalar : kScalars) text += print_case(names, f, scalar);
  return text + "  return bench.status();\n}\n";
}

}  // namespace robcogen::backend::gpu
