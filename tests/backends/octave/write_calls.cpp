// write_calls MODEL DESIRED NAME FILE: writes a header with a row for each function of the robot's compiled library.
//
// The functions are those that the generator knows, so a new algorithm is included automatically. Kernels are declared
// but not defined: the library's own object code runs.
#include <fmt/format.h>

#include <fstream>

#include "algorithm/catalogue/catalogue.h"
#include "backend/cpp/api.h"
#include "backend/cpp/cpp.h"
#include "functions.h"

namespace robcogen::octave {
namespace {

std::string braced(const std::vector<std::string>& items) {
  return fmt::format("{{{}}}", fmt::join(items, ", "));
}

std::string row(const backend::cpp::Api& api, const backend::cpp::Callable& callable, bool omits_gravity) {
  const Call call = shape(*api.library, *callable.function);
  std::vector<std::string> arguments, results, pointers;
  for (const Argument& a : call.arguments) {
    pointers.push_back(fmt::format("in[{}]", arguments.size()));
    arguments.push_back(fmt::format("{{\"{}\", {}, {}, \"{}\"}}", a.name, a.rows, a.columns, a.kind));
  }
  for (const Result& r : call.results) {
    pointers.push_back(fmt::format("out[{}]", results.size()));
    results.push_back(fmt::format("{{\"{}\", {}, {}}}", r.name, r.rows, r.columns));
  }
  return fmt::format(
      "    {{\"{}\", {}, {},\n     [](const double* const* in, double* const* out) {{ "
      "{}::kernel::{}<double>({}); }}, {}}},\n",
      call.function, braced(arguments), braced(results), api.space, callable.kernel, fmt::join(pointers, ", "),
      omits_gravity);
}

std::string header(const backend::Library& library) {
  const backend::cpp::Api api = backend::cpp::api(library);
  const std::string folder = backend::cpp::folder(library.name, library.enclosing);
  std::string text = "#pragma once\n#include \"calls.h\"\n#include \"" + folder +
                     "/detail/kernels.h\"\n\ninline const std::vector<robcogen::octave::Call> kCalls = {\n";
  for (const backend::cpp::Callable& callable : api.callables) {
    text += row(api, callable, false);
    if (may_omit_gravity(library, *callable.function)) text += row(api, callable, true);
  }
  return text + "};\n";
}

}  // namespace
}  // namespace robcogen::octave

int main(int argc, char** argv) {
  using namespace robcogen;
  const std::vector<std::string> arguments(argv, argv + argc);
  if (arguments.size() != 5) return 2;
  const auto library =
      octave::load(arguments[1], arguments[2], arguments[3], octave::kNone, algorithm::default_groups(), {});
  if (!library) return 1;
  std::ofstream file(arguments[4]);
  file << octave::header(*library);
  file.close();
  return file ? 0 : 1;
}
