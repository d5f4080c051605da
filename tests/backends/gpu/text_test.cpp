// The text of a small function, and that compilers for GPUs and for C accept the text of robots.
#include <gtest/gtest.h>

#include <fstream>
#include <sstream>

#include "../../unit/backend/programs.h"
#include "robcogen/gpu/bench.h"
#include "states.h"

namespace robcogen::test {
namespace {

using backend::Library;
using backend::gpu::StatesFunction;

const std::string kIncludes = " -I. -I" ROBCOGEN_RUNTIME_DIR " ";

std::string text_of(const Library& library, const std::string& path) {
  for (const OutputFile& file : backend::gpu::print(library))
    if (file.path == path) return file.text;
  return path + " is missing";
}

Library library(const std::string& robot, const std::vector<std::string>& groups) {
  return library_of(kRobots / robot / (robot + ".kindsl"), robot, std::nullopt, {}, groups, kGpuFeatures);
}

TEST(GpuText, OfASmallFunction) {
  Library library = leg_library();
  library.groups = {"leg"};
  library.functions = {function(
      "leg", "leg",
      leg_program("tmp s = sin q[0]\ntmp c = cos q[0]\ntmp a = qd[1] * 0.5\ntmp b = a / s\ntmp r = sqrt c\n"
                  "let sum = b + r\nreturn tau -sum\n"))};
  const std::string header = text_of(library, "leg_gpu/leg.h"), kernels = text_of(library, "leg_gpu/leg_kernels.h");
  EXPECT_EQ(
      header.substr(header.find("RC_FUNCTION")),
      R"(RC_FUNCTION(3) leg_gpu_leg(RC_IN(1, q), RC_IN(2, qd), RC_OUT(3, tau)) {
  RC_SINCOS(RC_AT(q, 0), s_HFE, c_HFE);

  // link hip: velocity
  RC_AT(tau, 0) = -(RC_QUOTIENT(RC(0.5) * RC_AT(qd, 1), s_HFE) + RC_SQRT(c_HFE));
}

#endif
)");
  EXPECT_EQ(
      kernels.substr(kernels.find("RC_KERNEL")),
      R"(RC_KERNEL(3) leg_gpu_kernel_leg(const int rc_n, RC_STATES_IN(1, q), RC_STATES_IN(2, qd), RC_STATES_OUT(3, tau)) {
  RC_FOR_STATES(rc_n) {
    RC_STATE_IN(q, 2);
    RC_STATE_IN(qd, 2);
    RC_STATE_OUT(tau, 1);
    RC_CALL(leg_gpu_leg)(RC_PASS(q), RC_PASS(qd), RC_PASS(tau));
  }
}

#endif
)");
}

// Compared with sines in long double, and with exact quotients.
TEST(GpuScalars, AreAccurate) {
  double worst_in_float = 0, worst = 0, worst_quotient_in_float = 0, worst_quotient = 0;
  std::mt19937_64 engine(3);
  std::uniform_real_distribution<double> unit(-1, 1);
  for (int k = 0; k < 100000; ++k) {
    const float angle = static_cast<float>(1e4 * unit(engine));
    const double large = 1e5 * unit(engine);
    float s, c;
    double sine, cosine;
    robcogen::gpu::sincos(angle, s, c);
    robcogen::gpu::sincos(large, sine, cosine);
    worst_in_float =
        std::max({worst_in_float, std::abs(s - std::sin(double(angle))), std::abs(c - std::cos(double(angle)))});
    using Wide = long double;
    worst = std::max(
        {worst, double(std::abs(Wide(sine) - std::sin(Wide(large)))),
         double(std::abs(Wide(cosine) - std::cos(Wide(large))))});
    // From an estimate as rough as those of GPUs: one unit in the last place of float, 20 bits for double.
    const double b = std::exp(20 * unit(engine)), rough = (1 + 0x1p-20 * unit(engine)) / b;
    const float of_float = static_cast<float>(b), near = (1 + 0x1p-23f * static_cast<float>(unit(engine))) / of_float;
    worst_quotient =
        std::max(worst_quotient, std::abs(robcogen_gpu_refined(b, robcogen_gpu_refined(b, rough)) * b - 1));
    worst_quotient_in_float = std::max(
        worst_quotient_in_float, std::abs(double(robcogen_gpu_refinedf(of_float, near)) * double(of_float) - 1));
  }
  EXPECT_LT(worst_in_float, 1e-7);
  EXPECT_LT(worst, 3e-16);
  EXPECT_LT(worst_quotient_in_float, 0x1p-23);
  EXPECT_LT(worst_quotient, 0x1p-51);
}

// The examples of the guide compile; the first one lets 4,096 quadrupeds fall for 0.1 s. At rest and without torques,
// no joint moves, and every step adds to the velocity and then to the position.
TEST(GpuGuide, ItsExamplesRun) {
  std::vector<std::string> blocks;
  const std::string guide = read_text(std::filesystem::path(ROBCOGEN_RUNTIME_DIR) / ".." / "GPU.md"),
                    fence = "\n```cpp\n";
  for (std::size_t at = 0; (at = guide.find(fence, at)) != std::string::npos; ++at)
    blocks.push_back(guide.substr(at + fence.size(), guide.find("\n```\n", at + 1) + 1 - at - fence.size()));
  ASSERT_EQ(blocks.size(), 2U);
  const Scratch scratch("gpu-guide");
  write_gpu(scratch.path, library("quadruped", {"forward_dynamics"}));
  write_text(scratch.path / "batch.cpp", blocks[1]);
  EXPECT_EQ(run(scratch.path, "g++ -std=c++17 -Wall -Wextra -Werror -fsyntax-only" + kIncludes + "batch.cpp"), "");
  write_text(scratch.path / "main.cpp", blocks[0] + R"(
#include <cmath>
#include <cstdio>
#include <random>
#include <vector>
int main() {
  constexpr int n = 4096;
  std::vector<float> states(n * kState), torques(n * 12);
  const auto at = [&](int i, int k) -> float& { return states[std::size_t(i / 32 * 32 * kState + k * 32 + i % 32)]; };
  std::mt19937 engine(1);
  std::normal_distribution<float> normal;
  for (int i = 0; i < n; ++i) {
    for (int k = 0; k < 12; ++k) at(i, k) = normal(engine);
    float norm = 0;
    for (int k = 24; k < 28; ++k) norm = std::hypot(norm, at(i, k) = normal(engine));
    for (int k = 24; k < 28; ++k) at(i, k) /= norm;
  }
  simulate(n, {states.data()}, {torques.data()});
  float worst = 0;
  for (int i = 0; i < n; ++i) {
    for (int k = 12; k < 24; ++k) worst = std::fmax(worst, std::fabs(at(i, k)));
    worst = std::fmax(worst, std::fabs(at(i, 30) + 9.81f * 1e-6f * 100 * 101 / 2));
    worst = std::fmax(worst, std::hypot(at(i, 28), at(i, 29)));
  }
  if (!(worst < 1e-3f)) std::printf("%g\n", double(worst));
}
)");
  EXPECT_EQ(
      run(scratch.path, "g++ -std=c++17 -O1 -Wall -Wextra -Werror" + kIncludes + "main.cpp -o main && ./main"), "");
}

// Joints with names of OpenCL and of the macros.
TEST(GpuText, AvoidsReservedNames) {
  Library library = leg_library();
  library.groups = {"leg"};
  library.functions = {function(
      "leg", "leg",
      leg_program("let global = q[0] + qd[0]\nlet REAL = global * q[1]\nlet float4 = global + REAL\n"
                  "let RC_AT = float4 * global\nreturn tau RC_AT\n"))};
  const std::string text = text_of(library, "leg_gpu/leg.h");
  for (const char* name : {"global_ = ", "REAL_ = ", "float4_ = "})
    EXPECT_NE(text.find(name), std::string::npos) << text;
}

// Functions of the package in Python: two of them have names of the language and of the package.
TEST(GpuText, AvoidsReservedNamesInPython) {
  Library library = leg_library();
  library.model_file = "a\"\"\"b.kindsl";
  library.groups = {"leg"};
  for (const char* name : {"lambda", "load", "swing"})
    library.functions.push_back(function("leg", name, leg_program("return tau q[0]\n")));
  const std::string text = text_of(library, "leg_gpu/__init__.py");
  for (const char* line :
       {"a\\\"\\\"\\\"b.kindsl; edit", "\nlambda_ = ", "\nload_ = ", "\nswing = ", "\nload = _library.load\n"})
    EXPECT_NE(text.find(line), std::string::npos) << text;
}

// A stage may take all arrays of the function and the workspace.
TEST(GpuText, HasTemplatesForTheArraysOfStages) {
  Library library = leg_library();
  library.groups = {"leg"};
  library.functions = {function("leg", "leg", leg_program("tmp a = q[0] + q[1]\ntmp b = a * a\nreturn tau b\n"))};
  symbolic::Program& program = library.functions.front().program;
  while (program.inputs.size() + program.outputs.size() < 24) {
    symbolic::OutputArray& next = program.outputs.emplace_back(program.outputs.front());
    next.name = "tau_" + std::to_string(program.outputs.size());
  }
  std::string model;
  for (const OutputFile& file : backend::gpu::print(library, {1, 1}))
    if (file.path == "leg_gpu/model.h") model = file.text;
  EXPECT_NE(model.find("#define RC_ARRAYS25 RC_ARRAYS24, class RC_ARRAY25"), std::string::npos) << model;
}

// A result that is NaN only on the device is a difference, whatever the next ones are.
TEST(GpuBench, FindsNaN) {
  const robcogen::gpu::BenchFunction<float> copy = {
      "copy",
      {{"x", 2, false}, {"y", 2, true}},
      0,
      1,
      [](void*, std::ptrdiff_t, const robcogen_gpu_array* a, robcogen_gpu_workspace) {
        const float* const x = static_cast<const float*>(a[0].data);
        float* const y = static_cast<float*>(const_cast<void*>(a[1].data));
        y[0] = std::numeric_limits<float>::quiet_NaN();
        y[32] = x[32];
        return robcogen_gpu_success;
      },
      [](const double* const* in, double* const* out) { std::copy(in[0], in[0] + 2, out[0]); }};
  const robcogen::gpu::BenchStates<float> states(copy, 1, robcogen_gpu_by_tile, 7);
  states.run();
  EXPECT_EQ(states.worst(), HUGE_VAL);
}

// The program that checks a library on a device, here on the host; without a function to check, it fails.
TEST(GpuBench, ChecksALibraryOnTheHost) {
  const Scratch scratch("gpu-bench");
  write_gpu(scratch.path, library("hyl_parametric", {"joint_space_inertia"}));
  const std::string folder = "hyl_parametric_gpu/";
  write_text(
      scratch.path / "all.cpp", "#include \"" + folder + "bench.cu\"\n#include \"" + folder +
                                    "parameters.cu\"\n#include \"" + folder + "joint_space_inertia.cu\"\n");
  ASSERT_EQ(run(scratch.path, "g++ -std=c++17 -O0 -Wall -Wextra -Werror" + kIncludes + "all.cpp -o bench"), "");
  const std::string report = run(scratch.path, "./bench --check");
  EXPECT_NE(report.find("all results agree with the host"), std::string::npos) << report;
  EXPECT_NE(run(scratch.path, "./bench --check gravity || echo refused").find("refused"), std::string::npos);
}

// A unit that makes the compiler print code for the kernels of the first function of each group, over tiles;
// `in_lanes`: for the kernel in which threads share a state.
std::string instances(const Library& library, const std::vector<std::string>& scalars, bool in_lanes = false) {
  const backend::gpu::Names names = backend::gpu::names(library);
  std::string includes, text = "using namespace robcogen::gpu;\n";
  for (const std::string& group : library.groups) {
    includes += "#include \"" + names.folder + "/" + group + "_kernels.h\"\n";
    const std::vector<StatesFunction> functions = backend::gpu::states_functions(names, group);
    if (functions.empty()) continue;
    std::vector<backend::gpu::StatesKernel> kernels = functions[0].kernels();
    if (in_lanes) kernels = {functions[0].kernel_in_lanes().value()};
    for (const backend::gpu::StatesKernel& kernel : kernels) {
      for (const std::string& scalar : scalars) {
        text += "template __global__ void " + names.prefix + "_kernel_" + kernel.name + "<" + scalar + ">(int";
        for (const std::size_t k : kernel.arrays) {
          const backend::gpu::StatesArray a = functions[0].array(k);
          text += std::string(a.is_often_same ? ", Strides<" : ", Tiles<") + (a.array.output ? "" : "const ") + scalar +
                  ">";
        }
        text += ");\n";
      }
    }
  }
  return includes + text;
}

// The largest of the numbers before these words in a report; -1: there is none.
int largest_before(const std::string& report, const std::string& words) {
  int largest = -1;
  for (std::size_t at = 0; (at = report.find(words, at)) != std::string::npos; ++at)
    largest = std::max(largest, std::stoi(report.substr(report.rfind(' ', at - 1) + 1)));
  return largest;
}

class GpuCompilers : public testing::Test {
 protected:
  const Library leg = library("hyl", {"forward_dynamics", "joint_space_inertia_factor"});
  const Scratch scratch{"gpu-compilers"};

  void SetUp() override {
    write_gpu(scratch.path, leg);
    write_text(scratch.path / "all.cu", instances(leg, {"float", "double"}));
  }
  // Compiles for a GPU as the options say; returns the messages.
  std::string compile(const std::string& options) const {
    return run(
        scratch.path, CLANG " -std=c++17 -O1 -Wall -Wextra -Werror -Wno-unknown-cuda-version --cuda-device-only " +
                          options + " -include " TEST_SOURCE_DIR "/stub.h" + kIncludes + "-S all.cu -o all.s");
  }
};

TEST_F(GpuCompilers, ClangTakesItAsCuda) {
  if (std::string(CLANG).empty()) GTEST_SKIP() << "clang was not found";
  EXPECT_EQ(compile("-x cuda --cuda-gpu-arch=sm_80 -nocudainc -nocudalib"), "");
  const std::string code = read_text(scratch.path / "all.s");
  EXPECT_NE(code.find(".visible .entry"), std::string::npos);
  EXPECT_NE(code.find("rcp.approx.ftz.f32"), std::string::npos);
  EXPECT_NE(code.find("rcp.approx.ftz.f64"), std::string::npos);
  EXPECT_EQ(code.find("div.rn"), std::string::npos) << "a quotient has a slow path";
  EXPECT_EQ(code.find("\tcall"), std::string::npos) << "a function was not inlined";
}

TEST_F(GpuCompilers, ClangTakesItAsHip) {
  if (std::string(CLANG).empty()) GTEST_SKIP() << "clang was not found";
  EXPECT_EQ(compile("-x hip --offload-arch=gfx90a -nogpuinc -nogpulib"), "");
  EXPECT_NE(read_text(scratch.path / "all.s").find(".amdhsa_kernel"), std::string::npos);
}

// All lanes fill elements, of which each then writes its own ones.
TEST(GpuLanes, WriteAfterAllHaveFilled) {
  const Scratch scratch("gpu-fill");
  write_text(scratch.path / "main.cpp", R"(
#include "robcogen/gpu/dialect.h"
#include <cstdio>
int main() {
  double numbers[8];
  robcogen::gpu::emulate(4, [&] {
    robcogen::gpu::fill<8>(&numbers[0], 0.0);
    robcogen::gpu::store_lanes<2>(&numbers[0], robcogen::gpu::Lanes<double, 4>::of(1.0, 2.0, 3.0, 4.0));
  });
  for (const double x : numbers) std::printf("%g ", x);
}
)");
  EXPECT_EQ(
      run(scratch.path,
          "g++ -std=c++17 -O0 -Wall -Wextra -Werror -DROBCOGEN_GPU_EMULATES_LANES -include " TEST_SOURCE_DIR
          "/emulated_lanes.h" +
              kIncludes + "main.cpp -o main && ./main"),
      "1 0 2 0 3 0 4 0 ");
}

TEST(GpuLanes, ClangTakesThemAsCudaAndHip) {
  if (std::string(CLANG).empty()) GTEST_SKIP() << "clang was not found";
  const Library robot = library("quadruped", {"joint_space_inertia"});
  const Scratch scratch("gpu-lanes");
  write_gpu(scratch.path, robot);
  write_text(scratch.path / "all.cu", instances(robot, {"float"}, true));
  for (const char* kind :
       {"cuda --cuda-gpu-arch=sm_80 -nocudainc -nocudalib -Xclang -target-feature -Xclang +ptx70",
        "hip --offload-arch=gfx90a -nogpuinc -nogpulib"}) {
    const std::string options =
        " -std=c++17 -O1 -Wall -Wextra -Werror -Wno-unknown-cuda-version --cuda-device-only -x " + std::string(kind) +
        " -include " TEST_SOURCE_DIR "/stub.h";
    EXPECT_EQ(run(scratch.path, CLANG + options + kIncludes + "-S all.cu -o all.s"), "") << kind;
  }
  EXPECT_NE(read_text(scratch.path / "all.s").find("ds_bpermute"), std::string::npos) << "threads exchange nothing";
}

// Also the calls by which the library starts kernels.
TEST_F(GpuCompilers, ClangTakesTheUnitsAsHip) {
  if (std::string(CLANG).empty()) GTEST_SKIP() << "clang was not found";
  EXPECT_EQ(
      run(scratch.path, CLANG " -std=c++17 -x hip --offload-arch=gfx90a -nogpuinc -nogpulib -Wall -Wextra -Werror "
                              "-include " TEST_SOURCE_DIR "/stub.h" +
                            kIncludes + "-fsyntax-only hyl_gpu/forward_dynamics.cu"),
      "");
}

TEST_F(GpuCompilers, GccTakesItAsC) {
  write_text(
      scratch.path / "all.c",
      "#include \"hyl_gpu/forward_dynamics_kernels.h\"\n#include \"hyl_gpu/joint_space_inertia_factor_kernels.h\"\n"
      "#include \"hyl_gpu/batch.h\"\n");
  for (const char* option : {"", "-DROBCOGEN_GPU_DOUBLE ", "-DROBCOGEN_GPU_TILES "})
    EXPECT_EQ(
        run(scratch.path, "gcc -std=c99 -pedantic -Wall -Wextra -Wconversion -Wshadow -Werror -fsyntax-only " +
                              std::string(option) + kIncludes + "all.c"),
        "");
}

// The most registers and spilled bytes of a kernel, as ptxas counts them, are not worse than in the table.
TEST(GpuCode, NeedsNoMoreRegistersThanBefore) {
  if (std::string(NVCC).empty()) GTEST_SKIP() << "nvcc was not found";
  std::ifstream table(TEST_SOURCE_DIR "/registers.txt");
  std::string robot, group, scalar, architecture, line;
  int rows = 0;
  while (std::getline(table, line)) {
    int registers = 0, spilled = 0;
    std::istringstream words(line);
    if (line.starts_with("#") || !(words >> robot >> group >> scalar >> architecture >> registers >> spilled)) continue;
    if (std::string when; words >> when && !ROBCOGEN_TEST_EVERYTHING) continue;
    const bool in_lanes = group.starts_with(backend::gpu::kInLanes);
    const Library library = test::library(robot, {in_lanes ? group.substr(backend::gpu::kInLanes.size()) : group});
    const Scratch scratch("gpu-nvcc");
    write_gpu(scratch.path, library);
    write_text(scratch.path / "all.cu", instances(library, {scalar}, in_lanes));
    const std::string report =
        run(scratch.path,
            NVCC " -std=c++17 -O3 -arch=" + architecture + " -cubin -Xptxas -v" + kIncludes + "all.cu -o all.cubin");
    const std::string name = robot + " " + group + " " + scalar + " " + architecture;
    const int used = largest_before(report, " registers"), stored = largest_before(report, " bytes spill stores");
    ASSERT_GE(used, 0) << report;
    ASSERT_GE(stored, 0) << report;
    EXPECT_LE(used, registers + 8) << name;
    EXPECT_LE(stored, spilled + 64) << name;
    ++rows;
  }
  EXPECT_GT(rows, 0);
}

// The unit that starts kernels compiles with the headers of CUDA.
TEST(GpuCode, NvccTakesTheUnitsOfALibrary) {
  if (std::string(NVCC).empty()) GTEST_SKIP() << "nvcc was not found";
  const Library leg = library("hyl", {"joint_space_inertia"});
  const Scratch scratch("gpu-unit");
  write_gpu(scratch.path, leg);
  EXPECT_EQ(
      run(scratch.path, NVCC " -std=c++17 -arch=sm_90 -Werror all-warnings" + kIncludes +
                            "-c hyl_gpu/joint_space_inertia.cu -o unit.o"),
      "");
}

}  // namespace
}  // namespace robcogen::test
