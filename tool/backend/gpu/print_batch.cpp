// Functions over many states that a program on the host calls: their declarations, and the units that start kernels.
#include "backend/gpu/printers.h"
#include "support/concat.h"

namespace robcogen::backend::gpu {
namespace {

struct Scalar {
  const char *type, *suffix;
};
constexpr Scalar kScalars[] = {{"double", ""}, {"float", "f"}};

std::string signature(const Names& names, const StatesFunction& f, const Scalar& scalar, const std::string& end) {
  std::vector<std::string> arguments = {"void *stream", "ptrdiff_t n"};
  for (const StatesArray& a : f.arrays) arguments.push_back("robcogen_gpu_array " + a.array.name);
  return c::wrapped(
      "robcogen_gpu_status " + names.prefix + "_batch_" + f.name + scalar.suffix + "(", arguments, ")" + end);
}

// The overload in C++.
std::string overload(const Names& names, const StatesFunction& f, const Scalar& scalar) {
  std::vector<std::string> arguments = {"robcogen::gpu::Stream stream", "std::ptrdiff_t n"};
  std::string passed = "stream.handle, n";
  for (const StatesArray& a : f.arrays) {
    const std::string kind = a.array.output ? "robcogen::gpu::Out<" : "robcogen::gpu::In<";
    arguments.push_back(kind + scalar.type + "> " + a.array.name);
    passed += ", " + a.array.name + ".array";
  }
  return c::wrapped("inline robcogen::gpu::Status " + f.name + "(", arguments, ") noexcept {") +
         c::wrapped(
             "  return static_cast<robcogen::gpu::Status>(" + names.prefix + "_batch_" + f.name + scalar.suffix + "(",
             {passed}, "));") +
         "}\n";
}

std::string documentation(const Names& names, const StatesFunction& f) {
  if (!f.function) return c::comment("Computes the values that functions read in place of the parameters.");
  std::vector<KernelArray> list;
  for (const StatesArray& a : f.arrays) list.push_back(a.array);
  return c::documentation(names, *f.function, list);
}

// The kernel with all arrays of `kind`, as a template argument.
std::string instance(const Names& names, const StatesFunction& f, const std::string& kind) {
  std::vector<std::string> arguments = {"REAL"};
  for (const StatesArray& a : f.arrays)
    arguments.push_back((a.is_often_same ? "Strides" : kind) + (a.array.output ? "<REAL>" : "<const REAL>"));
  return names.prefix + "_kernel_" + f.name + "<" + joined(arguments, ", ") + ">";
}

std::string print_launch(const Names& names, const StatesFunction& f) {
  std::vector<std::string> arguments;
  for (const StatesArray& a : f.arrays) arguments.push_back("{" + a.array.name + ", " + std::to_string(a.size) + "}");
  const std::string count = std::to_string(f.arrays.size());
  std::string text =
      "template <class REAL>\n" +
      c::wrapped(
          "static robcogen_gpu_status start_" + f.name + "(",
          {"void *stream", "ptrdiff_t n", "const Argument (&arguments)[" + count + "]"}, ") {") +
      c::wrapped(
          "  return start(", {"stream", "n", "arguments", instance(names, f, "Tiles"), instance(names, f, "Strides")},
          ");") +
      "}\n";
  for (const Scalar& scalar : kScalars)
    text += signature(names, f, scalar, " {") +
            c::wrapped("  return start_" + f.name + "<" + scalar.type + ">(stream, n, {", arguments, "});") + "}\n";
  return text;
}

}  // namespace

std::string print_batch(const Names& names, const std::vector<std::string>& groups) {
  std::string plain, overloads;
  for (const std::string& group : groups) {
    for (const StatesFunction& f : states_functions(names, group)) {
      plain += "\n" + documentation(names, f);
      for (const Scalar& scalar : kScalars) {
        plain += signature(names, f, scalar, ";");
        overloads += overload(names, f, scalar);
      }
    }
  }
  const std::string space = scoped(names.library.enclosing, names.library.name, "::") + "::gpu";
  return c::header(
      names, "batch.h", "functions over many states",
      "#include <robcogen/gpu/batch.h>\n\n#include \"" + names.folder + "/model.h\"\n\n" +
          c::comment(
              "Each function starts a kernel for n states on the stream, a cudaStream_t or hipStream_t, and returns. "
              "Arrays are memory of the device; the number in brackets is that of the elements of one state.") +
          "#ifdef __cplusplus\nextern \"C\" {\n#endif\n" + plain +
          "\n#ifdef __cplusplus\n}  // extern \"C\"\n\nnamespace " + space + " {\n\n" + overloads +
          "\n}  // namespace " + space + "\n#endif\n");
}

std::string print_launches(const Names& names, const std::string& group) {
  const std::string path = names.folder + "/";
  std::string text = c::banner(names.library, path + group + ".cu", group + " over many states") + "#include \"" +
                     path + group + "_kernels.h\"\n#include \"" + path +
                     "batch.h\"\n#include <robcogen/gpu/launch.h>\n\nusing namespace robcogen::gpu;\n";
  for (const StatesFunction& f : states_functions(names, group)) text += "\n" + print_launch(names, f);
  return text;
}

}  // namespace robcogen::backend::gpu
