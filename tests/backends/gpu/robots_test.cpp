// The text for GPUs, compiled as C++ for the host: every function over many states, with arrays of mixed layouts, gives
// the interpreter's results in double and in single precision.
#include <dlfcn.h>
#include <gtest/gtest.h>

#include <stdexcept>
#include <utility>

#include "algorithm/catalogue/catalogue.h"
#include "driver/derivatives.h"
#include "states.h"

namespace robcogen::test {
namespace {

using backend::Library;
using backend::gpu::StatesFunction;

const std::string kStrict = "-Wall -Wextra -Wconversion -Wshadow -Werror -I. -I" ROBCOGEN_RUNTIME_DIR " ";
constexpr int kStates = 35;

// Calls a compiled function. It does not read arrays beyond its last parameter, which are on the stack; the workspace
// is in registers, wherever it stands among the parameters.
template <std::size_t... k>
int call(
    void* function,
    std::ptrdiff_t n,
    robcogen_gpu_workspace workspace,
    std::vector<robcogen_gpu_array> a,
    std::index_sequence<k...>) {
  a.resize(sizeof...(k), {});
  using F = int (*)(void*, std::ptrdiff_t, robcogen_gpu_workspace, decltype((void)k, robcogen_gpu_array())...);
  return reinterpret_cast<F>(function)(nullptr, n, workspace, a[k]...);
}

int call(
    void* function,
    std::ptrdiff_t n,
    const std::vector<robcogen_gpu_array>& a,
    robcogen_gpu_workspace workspace = {}) {
  EXPECT_LE(a.size(), 80U);
  return call(function, n, workspace, a, std::make_index_sequence<80>());
}

// Returns a line for the first difference between the function and the interpreter. `layouts`: of the arrays in turn.
// `program`: what the function computes.
template <class Real>
std::string differences(
    const Library& library,
    const StatesFunction& f,
    const symbolic::Program& program,
    void* symbol,
    const std::vector<robcogen_gpu_layout>& layouts) {
  if (!symbol) return f.name + " is missing\n";
  const backend::Function& function = *f.function->function;
  std::mt19937_64 engine(7);
  const States<Real> states = random_states<Real>(library, program, kStates, engine);
  std::vector<Memory<Real>> memory = memory_of(f, states, kStates, layouts);
  std::vector<robcogen_gpu_array> arrays;
  for (const Memory<Real>& m : memory) arrays.push_back(m.array());
  std::vector<Real> workspace(workspace_of(f, kStates), std::numeric_limits<Real>::quiet_NaN());
  const std::size_t bytes = workspace.size() * sizeof(Real);
  if (f.stages && call(symbol, kStates, arrays, {workspace.data(), bytes - 1}) != robcogen_gpu_small_workspace)
    return f.name + " takes a workspace that is too small\n";
  if (f.stages) {
    std::vector<robcogen_gpu_array> lower = arrays;
    lower.back().layout = robcogen_gpu_lower_by_tile;
    const int refused = call(symbol, kStates, lower, {workspace.data(), bytes});
    for (std::size_t a = 0; a < f.arrays.size(); ++a)
      if (refused != robcogen_gpu_wrong_layout || (f.arrays[a].array.output && memory[a].touched() > 0))
        return f.name + " in stages starts with a lower triangle\n";
  }
  if (const int status = call(symbol, kStates, arrays, {workspace.data(), bytes}); status != 0)
    return f.name + ": " + robcogen_gpu_message(static_cast<robcogen_gpu_status>(status)) + "\n";
  for (std::size_t a = 0; a < f.arrays.size(); ++a) {
    const std::string wrong = difference(memory[a], states.arrays[a], kStates, tolerance<Real>(function));
    if (!wrong.empty())
      return f.name + (sizeof(Real) == 4 ? " in float: " : ": ") + f.arrays[a].array.name + wrong + "\n";
  }
  return "";
}

// The same for the function that computes the cache.
template <class Real>
std::string differences_of_update(const Library& library, const StatesFunction& f, void* symbol) {
  if (!symbol) return "update is missing\n";
  States<Real> states;
  std::vector<Real> parameters;
  for (const model::Parameter& p : library.parameters())
    parameters.push_back(static_cast<Real>(kOfDefault * p.default_value.value_or(1)));
  states.arrays = {
      std::vector<std::vector<Real>>(kStates, parameters),
      std::vector<std::vector<Real>>(kStates, cache_of<Real>(library))};
  std::vector<Memory<Real>> memory = memory_of(f, states, kStates, {robcogen_gpu_by_state});
  if (call(symbol, kStates, {memory[0].array(), memory[1].array()}) != 0) return "update failed\n";
  const std::string wrong = difference(memory[1], states.arrays[1], kStates, 16 * std::numeric_limits<Real>::epsilon());
  return wrong.empty() ? "" : "update" + wrong + "\n";
}

const std::string kPlain = "g++ -std=c++17 ";
// Threads share the states of functions that have lanes. Unique symbols would keep the library loaded for good.
const std::string kWithLanes =
    kPlain + "-fno-gnu-unique -DROBCOGEN_GPU_EMULATES_LANES -include " TEST_SOURCE_DIR "/emulated_lanes.h ";

bool has_lanes(const Library& library) {
  return std::any_of(library.functions.begin(), library.functions.end(), [](const backend::Function& f) {
    return f.in_lanes.has_value();
  });
}

// The program of the function; where the library solves for columns in a loop, it is in the library written out.
const symbolic::Program& program_of(const backend::Function& function, const Library& written_out) {
  if (!function.solved) return function.program;
  const auto same = std::find_if(
      written_out.functions.begin(), written_out.functions.end(),
      [&](const backend::Function& f) { return f.kernel == function.kernel; });
  if (same == written_out.functions.end()) throw std::runtime_error(function.kernel + " is not written out");
  return same->program;
}

// Between the library that this compiler command makes of the text in the folder, and the interpreter.
std::string differences(
    const Library& library,
    const Library& written_out,
    const std::filesystem::path& folder,
    const backend::gpu::Lengths& lengths,
    const std::string& compiler) {
  std::string all;
  for (const OutputFile& file : backend::gpu::print(library, lengths))
    if (file.path.extension() == ".cu" && file.path.stem() != "bench")
      all += "#include \"" + file.path.string() + "\"\n";
  write_text(folder / "all.cpp", all);
  const std::string errors = run(folder, compiler + kStrict + "-O0 -shared -fPIC all.cpp -o all.so");
  if (!errors.empty()) return errors;
  void* const loaded = dlopen((folder / "all.so").c_str(), RTLD_NOW | RTLD_LOCAL);
  if (!loaded) return dlerror();
  const std::string prefix = library.name + "_gpu";
  const backend::gpu::Names names = backend::gpu::names(library, lengths);
  std::string report;
  for (const std::string& group : library.groups) {
    for (const StatesFunction& f : backend::gpu::states_functions(names, group)) {
      const std::string name = prefix + "_batch_" + f.name;
      const std::vector<robcogen_gpu_layout> mixed = {
          robcogen_gpu_by_element, robcogen_gpu_by_state, robcogen_gpu_by_tile};
      const symbolic::Program& program = program_of(*f.function->function, written_out);
      void* const in_float = dlsym(loaded, (name + "f").c_str());
      report += differences<double>(library, f, program, dlsym(loaded, name.c_str()), {robcogen_gpu_by_tile});
      report += differences<float>(library, f, program, in_float, {robcogen_gpu_by_tile});
      report += differences<float>(library, f, program, in_float, mixed);
    }
  }
  for (const StatesFunction& update : backend::gpu::states_functions(names, backend::c::kParametersGroup)) {
    const std::string name = prefix + "_batch_update";
    report += differences_of_update<double>(library, update, dlsym(loaded, name.c_str()));
    report += differences_of_update<float>(library, update, dlsym(loaded, (name + "f").c_str()));
  }
  dlclose(loaded);
  return report;
}

std::string differences(const Library& library, const Library& written_out, const backend::gpu::Lengths& lengths) {
  const Scratch scratch("gpu-" + library.name);
  write_gpu(scratch.path, library, lengths);
  const std::string report = differences(library, written_out, scratch.path, lengths, kPlain);
  if (!report.empty() || !has_lanes(library)) return report;
  return differences(library, written_out, scratch.path, lengths, kWithLanes);
}

struct Asked {
  std::string robot;
  std::vector<std::string> groups = algorithm::default_groups();
  std::vector<std::string> derivatives = {};
  backend::gpu::Lengths lengths = {};
  std::vector<std::string> contacts = {};
};

Library library(const Asked& asked, backend::ColumnLoops column_loops = kGpuFeatures.column_loops) {
  const std::filesystem::path document = kRobots / asked.robot / (asked.robot + ".kindsl");
  driver::LoadOptions options;
  const std::filesystem::path desired = std::filesystem::path(document).replace_extension("dtdsl");
  if (exists(desired)) options.desired = desired;
  for (const std::string& text : asked.derivatives) options.derivatives.push_back(driver::parse_derivative(text));
  options.contacts = asked.contacts;
  Diagnostics diagnostics;
  const std::optional<driver::Model> model = driver::load(document, options, diagnostics);
  EXPECT_TRUE(model.has_value()) << document;
  backend::Features features = kGpuFeatures;
  features.column_loops = column_loops;
  return model ? driver::library(*model, {.names = {asked.robot}, .groups = asked.groups}, features) : Library();
}

// Columns are solved for in a loop.
std::vector<std::string> with_derivatives() {
  std::vector<std::string> groups = algorithm::default_groups();
  groups.emplace_back("forward_dynamics_derivatives");
  return groups;
}

class GpuRobots : public testing::TestWithParam<Asked> {};

TEST_P(GpuRobots, GiveWhatTheInterpreterGives) {
  const Library robot = library(GetParam());
  ASSERT_FALSE(robot.functions.empty());
  const Library written_out = library(GetParam(), backend::ColumnLoops::none);
  EXPECT_EQ(differences(robot, written_out, GetParam().lengths), "");
}

INSTANTIATE_TEST_SUITE_P(
    Of,
    GpuRobots,
    testing::Values(
        Asked{"hyl", with_derivatives()},
        // In stages that read the values of parameters, and whole.
        Asked{
            "hyl_parametric",
            {"inverse_dynamics", "joint_space_inertia"},
            {"inverse_dynamics:q,parameters"},
            {100, 60}},
#if ROBCOGEN_TEST_EVERYTHING
        // In stages, of which the last ones solve for columns.
        Asked{"geared_leg", {"forward_dynamics_derivatives"}, {}, {1000, 400}},
        Asked{"iiwa14", algorithm::groups()},
        Asked{"centaur", algorithm::groups()},
        Asked{"humanoid"},
        Asked{"hexapod"},
        Asked{"gripper", algorithm::groups()},
        Asked{"puma560"},
        Asked{"scara"},
        Asked{"delta"},
        Asked{"quadruped", {"contacts", "operational_space"}, {}, {}, {"fr_LF_foot", "fr_RH_foot"}},
        Asked{"quadruped", {"inverse_dynamics_derivatives", "forward_dynamics_derivatives"}, {}, {1000, 300}},
        Asked{"five_bar", {"forward_dynamics", "transforms"}},
        Asked{"ball_leg", {"inverse_dynamics", "world"}},
        // Many arrays: the poses of all frames.
        Asked{"quadruped", {"all_frames"}},
#endif
        // Threads share the limbs of a state.
        Asked{"quadruped", {"forward_dynamics", "joint_space_inertia"}}),
    [](const auto& asked) { return asked.param.robot + "_" + std::to_string(asked.index); });

TEST(Gpu, WrongArgumentsAreRefusedAndLowerTrianglesWritten) {
  const Library leg = library({"hyl", {"joint_space_inertia"}});
  const Scratch scratch("gpu-refused");
  write_gpu(scratch.path, leg);
  ASSERT_EQ(
      run(scratch.path,
          "g++ -std=c++17 " + kStrict + "-O0 -shared -fPIC -x c++ hyl_gpu/joint_space_inertia.cu -o all.so"),
      "");
  void* const loaded = dlopen((scratch.path / "all.so").c_str(), RTLD_NOW | RTLD_LOCAL);
  ASSERT_NE(loaded, nullptr) << dlerror();
  void* const inertia = dlsym(loaded, "hyl_gpu_batch_joint_space_inertiaf");
  ASSERT_NE(inertia, nullptr);
  std::vector<float> q(9 * 32), H(9 * 32);
  const auto status = [&](std::ptrdiff_t n, const robcogen_gpu_array& first, const robcogen_gpu_array& second) {
    return static_cast<robcogen_gpu_status>(call(inertia, n, {first, second}));
  };
  const robcogen_gpu_array tiles = {q.data(), robcogen_gpu_by_tile, 0}, results = {H.data(), robcogen_gpu_by_tile, 0};
  const char* const between = reinterpret_cast<const char*>(q.data()) + 1;
  EXPECT_EQ(status(32, tiles, results), robcogen_gpu_success);
  EXPECT_EQ(status(0, {}, {}), robcogen_gpu_success);
  EXPECT_EQ(status(-1, tiles, results), robcogen_gpu_negative_count);
  EXPECT_EQ(status(1, {}, results), robcogen_gpu_misaligned);
  EXPECT_EQ(status(1, {between, robcogen_gpu_by_tile, 0}, results), robcogen_gpu_misaligned);
  EXPECT_EQ(status(8, {q.data(), robcogen_gpu_by_element, 7}, results), robcogen_gpu_wrong_stride);
  EXPECT_EQ(status(8, {q.data(), robcogen_gpu_by_state, 2}, results), robcogen_gpu_wrong_stride);
  EXPECT_EQ(status(std::ptrdiff_t(1) << 31, tiles, results), robcogen_gpu_too_large);
  EXPECT_EQ(status(std::ptrdiff_t(1) << 28, tiles, results), robcogen_gpu_too_large);
  EXPECT_EQ(status(8, {q.data(), robcogen_gpu_by_element, 1 << 30}, results), robcogen_gpu_too_large);
  EXPECT_EQ(status(8, tiles, {H.data(), robcogen_gpu_same_for_all, 0}), robcogen_gpu_wrong_layout);
  EXPECT_EQ(status(8, {q.data(), static_cast<robcogen_gpu_layout>(5), 0}, results), robcogen_gpu_wrong_layout);

  // Lower triangles are those of symmetric results among tiles.
  const std::vector<float> whole = H;
  std::fill(H.begin(), H.end(), 77.0F);
  const robcogen_gpu_array lower = {H.data(), robcogen_gpu_lower_by_tile, 0};
  EXPECT_EQ(status(32, {q.data(), robcogen_gpu_lower_by_tile, 0}, results), robcogen_gpu_wrong_layout);
  EXPECT_EQ(status(32, {q.data(), robcogen_gpu_by_state, 3}, lower), robcogen_gpu_wrong_layout);
  EXPECT_EQ(status(32, tiles, lower), robcogen_gpu_success);
  for (std::size_t k = 0; k < H.size(); ++k) EXPECT_EQ(H[k], k / 32 % 3 >= k / 32 / 3 ? whole[k] : 77.0F) << k;
  dlclose(loaded);
}

TEST(Gpu, WithOneSignWrongIsFoundOut) {
  const Library leg = library({"hyl", {"joint_space_inertia"}});
  const Scratch scratch("gpu-wrong");
  write_gpu(scratch.path, leg);
  const std::filesystem::path file = scratch.path / "hyl_gpu" / "joint_space_inertia.h";
  std::string text = read_text(file);
  text[text.find(" - ") + 1] = '+';
  write_text(file, text);
  EXPECT_EQ(differences(leg, leg, scratch.path, {}, kPlain).find("joint_space_inertia: H: element"), 0U);
}

}  // namespace
}  // namespace robcogen::test
