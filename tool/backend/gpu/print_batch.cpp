// Functions over many states that a program on the host calls: their declarations, and the units that start kernels.
#include "backend/gpu/printers.h"
#include "support/concat.h"

namespace robcogen::backend::gpu {
namespace {

const std::string kWorkspace = symbolic::kWorkspace;

std::string signature(const Names& names, const StatesFunction& f, const Scalar& scalar, const std::string& end) {
  std::vector<std::string> arguments = {"void *stream", "ptrdiff_t n"};
  for (const StatesArray& a : f.arrays) arguments.push_back("robcogen_gpu_array " + a.array.name);
  if (f.stages) arguments.push_back("robcogen_gpu_workspace " + kWorkspace);
  return c::wrapped(
      "robcogen_gpu_status " + names.prefix + "_batch_" + f.name + scalar.suffix + "(", arguments, ")" + end);
}

// The overload in C++.
std::string overload(const Names& names, const StatesFunction& f, const Scalar& scalar) {
  std::vector<std::string> arguments = {"robcogen::gpu::Stream stream", "std::ptrdiff_t n"};
  std::vector<std::string> passed = {"stream.handle", "n"};
  for (const StatesArray& a : f.arrays) {
    const std::string kind = a.array.output ? "robcogen::gpu::Out<" : "robcogen::gpu::In<";
    arguments.push_back(kind + scalar.type + "> " + a.array.name);
    passed.push_back(a.array.name + ".array");
  }
  if (f.stages) {
    arguments.push_back("robcogen::gpu::Workspace " + kWorkspace);
    passed.push_back(kWorkspace);
  }
  return c::wrapped("inline robcogen::gpu::Status " + f.name + "(", arguments, ") noexcept {") +
         c::wrapped(
             "  return robcogen::gpu::Status(" + names.prefix + "_batch_" + f.name + scalar.suffix + "(", passed,
             "));") +
         "}\n";
}

std::string documentation(const Names& names, const StatesFunction& f) {
  if (!f.function) return c::comment(kUpdateSummary);
  std::vector<KernelArray> list;
  for (const StatesArray& a : f.arrays) list.push_back(a.array);
  return c::documentation(names, *f.function, list);
}

// Whether the array is a symmetric result, element by element.
bool is_symmetric(const StatesFunction& f, std::size_t array) {
  if (!f.function || f.function->function->solved || f.stages || !f.arrays[array].array.output) return false;
  const symbolic::Program& program = f.function->function->program;
  return program.outputs[array - program.inputs.size()].role == symbolic::Role::inertia_matrix;
}

// The kernel with all arrays of `kind`, as a template argument; `Lower`: tiles, of symmetric results the lower
// triangle. The workspace consists of tiles.
std::string instance(const Names& names, const StatesFunction& f, const StatesKernel& kernel, const std::string& kind) {
  std::vector<std::string> arguments = {"REAL"};
  for (const std::size_t k : kernel.arrays) {
    const StatesArray a = f.array(k);
    const std::string number = a.array.output ? "REAL" : "const REAL";
    if (a.is_often_same)
      arguments.push_back("Strides<" + number + ">");
    else if (kind == "Lower" && is_symmetric(f, k))
      arguments.push_back("LowerTiles<REAL, " + std::to_string(a.rows) + ">");
    else
      arguments.push_back((kind == "Strides" && k < f.arrays.size() ? "Strides<" : "Tiles<") + number + ">");
  }
  return names.prefix + "_kernel_" + kernel.name + "<" + joined(arguments, ", ") + ">";
}

// Starts one kernel of several.
std::string print_run(const Names& names, const StatesFunction& f, const StatesKernel& kernel) {
  std::vector<std::string> places;
  for (const std::size_t k : kernel.arrays) places.push_back(std::to_string(k));
  return c::wrapped(
      "  stages.template run<" + joined(places, ", ") + ">(",
      {std::to_string(kernel.columns ? kernel.columns->runs : 1), instance(names, f, kernel, "Tiles"),
       instance(names, f, kernel, "Strides")},
      ");");
}

std::string print_launch(const Names& names, const StatesFunction& f) {
  std::vector<std::string> arguments;
  for (const StatesArray& a : f.arrays)
    arguments.push_back("{" + a.array.name + ", " + std::to_string(a.size) + (a.array.output ? ", true}" : "}"));
  const std::string count = std::to_string(f.arrays.size());
  const std::vector<StatesKernel> list = f.kernels();
  std::vector<std::string> parameters = {"void *stream", "ptrdiff_t n", "const Argument (&arguments)[" + count + "]"};
  std::string end = "})", body;
  if (f.stages) {
    parameters.push_back("robcogen_gpu_workspace workspace");
    end = "}, workspace)";
    body = c::wrapped(
        "  Stages<REAL, " + count + "> stages(",
        {"stream", "n", "arguments", "workspace", std::to_string(f.stages->workspace)}, ");");
    for (const StatesKernel& kernel : list) body += print_run(names, f, kernel);
    body += "  return stages.status();\n";
  } else {
    std::vector<std::string> passed = {"stream", "n", "arguments", instance(names, f, list[0], "Tiles")};
    if (const std::optional<StatesKernel> kernel = f.kernel_in_lanes())
      body = where_lanes_are(c::wrapped(
          "  ROBCOGEN_GPU_TRY_LANES(" + std::to_string(kernel->lanes) + ", ",
          {instance(names, f, *kernel, "Tiles"), instance(names, f, *kernel, "Strides")}, ");"));
    const std::string lower = instance(names, f, list[0], "Lower");
    if (lower != passed.back()) passed.push_back(lower);
    passed.push_back(instance(names, f, list[0], "Strides"));
    body += c::wrapped("  return start(", passed, ");");
  }
  std::string text = "template <class REAL>\n" +
                     c::wrapped("static robcogen_gpu_status start_" + f.name + "(", parameters, ") {") + body + "}\n";
  for (const Scalar& scalar : kScalars)
    text += signature(names, f, scalar, " {") +
            c::wrapped("  return start_" + f.name + "<" + scalar.type + ">(stream, n, {", arguments, end + ";") + "}\n";
  return text;
}

}  // namespace

std::string print_batch(const Names& names, const std::vector<std::string>& groups) {
  std::string plain, overloads;
  for (const std::string& group : groups) {
    for (const StatesFunction& f : states_functions(names, group)) {
      plain += "\n" + documentation(names, f);
      if (f.stages) {
        const std::string elements = ", " + std::to_string(f.stages->workspace) + ")\n";
        plain += "ROBCOGEN_GPU_WORKSPACE(" + names.prefix + "_batch_" + f.name + elements;
        overloads += "ROBCOGEN_GPU_WORKSPACE_OF(" + f.name + elements;
      }
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
